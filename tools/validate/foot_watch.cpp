// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/foot_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace legwright {

FootWatch::FootWatch(const Trajectory& trajectory, int foot, double contacts_until, double start)
    : period_(trajectory.period),
      contacts_until_(start + contacts_until),
      counts_from_(start + trajectory.period) {
  out_.name = trajectory.foot_names[static_cast<std::size_t>(foot)];
  const int knots = trajectory.knot_count;
  const double step = period_ / knots;
  const auto contact = [&](int knot) {
    return trajectory.at((knot % knots + knots) % knots, trajectory.contact_column(foot)) > 0.5;
  };
  for (int knot = 0; knot < knots; ++knot) {
    if (!contact(knot) || contact(knot - 1)) continue;
    int last = knot,
        swing = knot - 1;  // last knot of this stance; knot before the swing that leads to it
    while (contact(last + 1)) ++last;
    while (!contact(swing)) --swing;
    out_.planned.emplace_back(knot * step, last * step);
    const double touchdown = knot * step, begin = (swing + knot) * step / 2;
    const double wrapped = begin < 0 ? begin + period_ : begin;
    const double shift = wrapped - begin;
    strides_.push_back({wrapped, touchdown + shift, last * step + shift});
  }
  if (strides_.empty() &&
      contact(0)) {  // stands all the time: one endless stance, looked at cycle by cycle
    out_.planned.emplace_back(0.0, period_);
    strides_.push_back({0.0, 0.0, period_});
  }
  std::sort(strides_.begin(), strides_.end(),
            [](const Stride& a, const Stride& b) { return a.begin < b.begin; });
}

FootWatch::Stride FootWatch::stride(long long index) const {
  const auto count = static_cast<long long>(strides_.size());
  Stride out = strides_[static_cast<std::size_t>(index % count)];
  const double shift = static_cast<double>(index / count) * period_;
  out.begin += shift;
  out.touchdown += shift;
  out.liftoff += shift;
  return out;
}

void FootWatch::Tally::add(double value) {
  sum += value;
  largest = std::max(largest, std::abs(value));
  ++count;
}

void FootWatch::close(double time) {
  if (!now_ || !now_->counts) return;
  ++out_.stances;
  slip_.add(now_->slip);
  const bool always_down = now_->planned.touchdown == now_->planned.begin;
  if (!always_down) {
    clearance_.add(now_->clearance);
    least_clearance_ = std::min(least_clearance_, now_->clearance);
  }
  const bool never_off = !now_->was_off;
  if (never_off) now_->touched = now_->planned.begin;
  if (!now_->touched) {
    ++out_.missed;
    return;
  }
  const double lifted = now_->is_down ? time : now_->lifted.value_or(time);
  touchdown_.add(always_down ? 0.0 : *now_->touched - now_->planned.touchdown);
  liftoff_.add(always_down ? 0.0 : lifted - now_->planned.liftoff);
  roll_.add(now_->roll.norm());
  if (!never_off) landing_.add(now_->landing_speed);
}

// From the last moment on the ground to the first on it again, both included.
void FootWatch::follow_flight(const FootMoment& moment) {
  flight_.add(moment.sole);
  if (!moment.in_contact) return;
  if (now_ && flight_.size() > now_->longest_flight && flight_.size() > 2) {
    now_->longest_flight = flight_.size();
    now_->clearance = flight_.clearance();
  }
  flight_.clear();
  flight_.add(moment.sole);
}

void FootWatch::observe(double time, double step, const FootMoment& moment) {
  const bool in_contact = moment.in_contact;
  if (in_contact && !contact_since_) contact_since_ = time;
  if (!in_contact && contact_since_) {
    if (*contact_since_ < contacts_until_)
      out_.contacts.emplace_back(*contact_since_, std::min(time, contacts_until_));
    contact_since_.reset();
  }
  if (strides_.empty()) return;
  if (const Stride upcoming = stride(next_); time >= upcoming.begin - step / 2) {
    close(time);
    now_ = Now{upcoming, upcoming.begin >= counts_from_ - step / 2};
    ++next_;
  }
  const double sink_speed = std::exchange(sink_speed_, moment.sink_speed);
  follow_flight(moment);
  if (!now_) return;
  if (!in_contact) now_->was_off = true;
  if (in_contact && now_->was_off && !now_->touched) {
    now_->touched = time;
    now_->landing_speed = sink_speed;
  }
  if (now_->is_down && !in_contact) now_->lifted = time;
  now_->is_down = in_contact;
  if (!in_contact) return;
  now_->slip += moment.slip_speed * step;
  now_->roll += moment.roll_rate * step;
}

FootMeasures FootWatch::finish(double end_time) {
  if (contact_since_ && *contact_since_ < contacts_until_) {
    out_.contacts.emplace_back(*contact_since_, std::min(end_time, contacts_until_));
  }
  out_.slip_mean = slip_.mean();
  out_.slip_max = slip_.largest;
  out_.touchdown_mean = touchdown_.mean();
  out_.touchdown_max = touchdown_.largest;
  out_.liftoff_mean = liftoff_.mean();
  out_.liftoff_max = liftoff_.largest;
  out_.landing_mean = landing_.mean();
  out_.landing_max = landing_.largest;
  out_.roll_mean = roll_.mean();
  out_.roll_max = roll_.largest;
  out_.swings = clearance_.count;
  out_.clearance_mean = clearance_.mean();
  out_.clearance_min = clearance_.count > 0 ? least_clearance_ : 0.0;
  return out_;
}

}  // namespace legwright
