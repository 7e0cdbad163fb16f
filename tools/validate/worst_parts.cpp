// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/worst_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace legwright {
namespace {

constexpr std::size_t kMostParts = 3;
constexpr double kShareOfWorst = 0.5;

double value_of(const WorstPart& part) { return part.value.value_or(0.0); }

std::vector<WorstPart> worst_of(std::vector<WorstPart> parts) {
  // What is no number goes first: it has no place in an order.
  std::erase_if(parts, [](const WorstPart& part) { return !(value_of(part) > 0.0); });
  std::stable_sort(parts.begin(), parts.end(), [](const WorstPart& a, const WorstPart& b) {
    return value_of(a) > value_of(b);
  });
  if (parts.size() > kMostParts) parts.resize(kMostParts);
  const double least = parts.empty() ? 0.0 : kShareOfWorst * value_of(parts.front());
  std::erase_if(parts, [&](const WorstPart& part) { return value_of(part) < least; });
  return parts;
}

}  // namespace

WorstParts worst_joints(std::function<double(const JointMetrics&)> value) {
  return [value = std::move(value)](const Measurements& run) {
    std::vector<WorstPart> parts;
    for (const JointMetrics& joint : run.joints)
      parts.push_back({"joint", joint.name, value(joint)});
    return worst_of(std::move(parts));
  };
}

WorstParts worst_feet(std::function<double(const FootMeasures&)> value) {
  return [value = std::move(value)](const Measurements& run) {
    std::vector<WorstPart> parts;
    for (const FootMeasures& foot : run.feet) parts.push_back({"foot", foot.name, value(foot)});
    return worst_of(std::move(parts));
  };
}

std::vector<WorstPart> saturated_joints(const Measurements& run) {
  std::vector<WorstPart> parts;
  for (const JointMetrics& joint : run.joints)
    parts.push_back({"joint", joint.name, joint.saturated_share, joint.saturated_time});
  return worst_of(std::move(parts));
}

std::vector<WorstPart> touching_bodies(const Measurements& run) {
  const SelfContact& touch = run.self_contact;
  if (touch.first.empty()) return {};
  return {{"body", touch.first, {}, touch.force_time},
          {"body", touch.second, {}, touch.force_time}};
}

std::vector<WorstPart> least_lifted_foot(const Measurements& run) {
  const FootMeasures* lowest = nullptr;
  for (const FootMeasures& foot : run.feet)
    if (foot.swings > 0 && (lowest == nullptr || foot.clearance_min < lowest->clearance_min))
      lowest = &foot;
  if (lowest == nullptr) return {};
  return {{"foot", lowest->name, lowest->clearance_min}};
}

double torque_share(const JointMetrics& joint) {
  return std::isfinite(joint.torque_limit) ? joint.torque_peak / joint.torque_limit : 0.0;
}

}  // namespace legwright
