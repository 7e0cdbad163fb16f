// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/foot_watch.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {

FootWatch::FootWatch(const Trajectory& trajectory, int foot, double contacts_until)
    : period_(trajectory.period), contacts_until_(contacts_until) {
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
    strides_.push_back({wrapped, touchdown + (wrapped - begin)});
  }
  if (strides_.empty() &&
      contact(0)) {  // stands all the time: one endless stance, looked at cycle by cycle
    out_.planned.emplace_back(0.0, period_);
    strides_.push_back({0.0, 0.0});
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
  return out;
}

void FootWatch::close() {
  if (!now_ || !now_->counts) return;
  ++out_.stances;
  slip_sum_ += now_->slip;
  out_.slip_max = std::max(out_.slip_max, now_->slip);
  if (!now_->was_off) now_->touched = now_->begin;
  if (!now_->touched) {
    ++out_.missed;
    return;
  }
  const bool always_down = now_->touchdown == now_->begin;
  const double error = always_down ? 0.0 : *now_->touched - now_->touchdown;
  touchdown_sum_ += error;
  ++touchdowns_;
  out_.touchdown_max = std::max(out_.touchdown_max, std::abs(error));
}

void FootWatch::observe(double time, double step, bool in_contact, double slip_speed) {
  if (in_contact && !contact_since_) contact_since_ = time;
  if (!in_contact && contact_since_) {
    if (*contact_since_ < contacts_until_)
      out_.contacts.emplace_back(*contact_since_, std::min(time, contacts_until_));
    contact_since_.reset();
  }
  if (strides_.empty()) return;
  if (const Stride upcoming = stride(next_); time >= upcoming.begin - step / 2) {
    close();
    now_ = Now{upcoming.begin, upcoming.touchdown, upcoming.begin >= period_ - step / 2};
    ++next_;
  }
  if (!now_) return;
  if (!in_contact) now_->was_off = true;
  if (in_contact && now_->was_off && !now_->touched) now_->touched = time;
  if (in_contact) now_->slip += slip_speed * step;
}

FootMeasures FootWatch::finish(double end_time) {
  if (contact_since_ && *contact_since_ < contacts_until_) {
    out_.contacts.emplace_back(*contact_since_, std::min(end_time, contacts_until_));
  }
  if (out_.stances > 0) out_.slip_mean = slip_sum_ / out_.stances;
  if (touchdowns_ > 0) out_.touchdown_mean = touchdown_sum_ / touchdowns_;
  return out_;
}

}  // namespace legwright
