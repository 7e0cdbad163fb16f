// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/gait.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace legwright {
namespace {

void check(const GaitPattern& pattern, double period, int knot_count,
           const std::vector<int>& order) {
  if (!(period > 0.0) || !std::isfinite(period))
    throw std::invalid_argument("gait: the period must be a positive number of seconds");
  if (knot_count < 2) throw std::invalid_argument("gait: at least two knots are needed");
  if (pattern.touchdown.size() != order.size())
    throw std::invalid_argument("gait '" + pattern.name + "' has " +
                                std::to_string(pattern.touchdown.size()) + " feet, the robot has " +
                                std::to_string(order.size()));
  if (!pattern.foot_duty.empty() && pattern.foot_duty.size() != order.size())
    throw std::invalid_argument("gait '" + pattern.name + "' has " +
                                std::to_string(pattern.foot_duty.size()) +
                                " duties, the robot has " + std::to_string(order.size()) + " feet");
  for (std::size_t place = 0; place < order.size(); ++place)
    if (const double duty = pattern.duty_of(place); !(duty > 0.0 && duty <= 1.0))
      throw std::invalid_argument("gait: expected 0 < duty <= 1");
  for (double touchdown : pattern.touchdown)
    if (!(touchdown >= 0.0 && touchdown < 1.0))
      throw std::invalid_argument("gait: expected 0 <= touchdown < 1");
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (int i = 0; i < static_cast<int>(sorted.size()); ++i)
    if (sorted[i] != i) throw std::invalid_argument("gait: the foot order is no permutation");
}

}  // namespace

bool GaitPattern::stands(std::size_t place, double phase) const {
  const double since = phase - touchdown[place] + kPhaseTolerance;
  return since - std::floor(since) < duty_of(place);
}

Gait::Gait(const GaitPattern& pattern, double period, int knot_count, const std::vector<int>& order)
    : name_(pattern.name), period_(period), knot_count_(knot_count) {
  check(pattern, period, knot_count, order);
  contact_.setConstant(knot_count, static_cast<Eigen::Index>(order.size()), false);
  for (std::size_t place = 0; place < order.size(); ++place) {
    auto column = contact_.col(order[place]);
    for (int knot = 0; knot < knot_count; ++knot)
      column(knot) = pattern.stands(place, static_cast<double>(knot) / knot_count);
    if (!column.any())
      throw std::invalid_argument("gait '" + pattern.name + "': foot " +
                                  std::to_string(order[place]) + " has no stance knot");
  }
}

bool Gait::planted(int knot, int foot, int margin) const {
  for (int offset = -margin; offset <= margin; ++offset)
    if (in_contact(knot + offset, foot)) return true;
  return false;
}

Stance Gait::stance_around(int knot, int foot, int margin) const {
  Stance stance{knot, knot};
  while (knot - stance.first < knot_count_ && planted(stance.first - 1, foot, margin))
    --stance.first;
  while (stance.last - knot < knot_count_ && planted(stance.last + 1, foot, margin)) ++stance.last;
  return stance;
}

SupportRange support_range(const Gait& gait) {
  SupportRange range{gait.foot_count(), 0};
  for (int knot = 0; knot < gait.knot_count(); ++knot) {
    int support = 0;
    for (int foot = 0; foot < gait.foot_count(); ++foot) support += gait.in_contact(knot, foot);
    range.least = std::min(range.least, support);
    range.most = std::max(range.most, support);
  }
  return range;
}

std::vector<int> footfall_order(const std::vector<Eigen::Vector3d>& feet) {
  std::vector<int> order(feet.size());
  std::iota(order.begin(), order.end(), 0);
  if (feet.empty()) return order;
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return feet[a].x() > feet[b].x(); });

  Eigen::Vector3d low = feet[0], high = feet[0];
  for (const Eigen::Vector3d& foot : feet) {
    low = low.cwiseMin(foot);
    high = high.cwiseMax(foot);
  }
  const double row_depth = (high - low).head<2>().maxCoeff() / 5.0;

  for (auto row = order.begin(); row != order.end();) {
    const double front = feet[*row].x();
    const auto end = std::find_if(row, order.end(),
                                  [&](int foot) { return front - feet[foot].x() > row_depth; });
    std::stable_sort(row, end, [&](int a, int b) { return feet[a].y() > feet[b].y(); });
    row = end;
  }
  return order;
}

std::string footfall_diagram(const Gait& gait, const std::vector<std::string>& foot_names) {
  std::size_t width = 0;
  for (const std::string& name : foot_names) width = std::max(width, name.size());
  std::string text;
  for (int foot = 0; foot < gait.foot_count(); ++foot) {
    const std::string name = foot < static_cast<int>(foot_names.size()) ? foot_names[foot] : "";
    text += name + std::string(width - name.size() + 2, ' ');
    for (int knot = 0; knot < gait.knot_count(); ++knot)
      text += gait.in_contact(knot, foot) ? '#' : '.';
    text += '\n';
  }
  return text;
}

}  // namespace legwright
