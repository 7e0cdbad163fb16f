// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "optimizer/terms/registry.hpp"
#include "tests/support/term_context.hpp"

namespace legwright::test {

/// Names of all terms in the registry.
inline std::vector<std::string> registered_terms() {
  std::vector<std::string> names;
  for (const TermEntry& entry : term_registry()) names.emplace_back(entry.name);
  return names;
}

/// A term of the turning trot of the puppy, at a point that is drawn at random.
class TermBench {
 public:
  TermBench(std::string_view name, bool printed, Dynamics dynamics = Dynamics::full)
      : setting(printed) {
    setting.task.dynamics = dynamics;
    term = find_term(name)->make(setting.context());
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    x.resize(layout().extended_size());
    for (double& value : x) value = 0.2 * normal(random);
    for (int i = 0; i <= layout().knot_count(); ++i)
      for (int j = 0; j < layout().foot_count(); ++j)
        if (const int slot = layout().force(i, j); slot >= 0) x.segment<3>(slot) *= 5.0 * weight();
    x[layout().mass_share()] = 1.3;
  }

  const Layout& layout() const { return setting.layout; }
  const Morphology& robot() const { return setting.puppy.morphology; }
  const Gait& gait() const { return setting.task.gait; }
  double leg() const { return robot().leg_length; }
  double mass() const {
    return robot().total_mass() * (robot().grows() ? x[layout().mass_share()] : 1.0);
  }
  double weight() const { return robot().total_mass() * 9.81; }
  double h() const { return 0.4 / 8; }
  Eigen::Vector3d at(int slot) const { return x.segment<3>(slot); }
  bool planted(int knot, int foot) const { return gait().planted(knot, foot, 1); }
  /// First knot with `wanted(knot)`.
  static int first(const std::function<bool(int)>& wanted) {
    for (int i = 0; i < 8; ++i)
      if (wanted(i)) return i;
    ADD_FAILURE() << "no such knot";
    return 0;
  }

  // 0.05 m/s forward and 0.1 m/s to the left in a heading that turns by 0.6 rad/s.
  static Eigen::Matrix3d heading(double time) {
    return Eigen::AngleAxisd(0.6 * time, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  static Eigen::Vector3d path(double time) {
    const double s = std::sin(0.6 * time) / 0.6, c = (1.0 - std::cos(0.6 * time)) / 0.6;
    return {0.05 * s - 0.1 * c, 0.05 * c + 0.1 * s, 0.0};
  }
  /// A place of knot −1, before knot 0: that of knot 7, one cycle earlier.
  static Eigen::Vector3d cycle_earlier(const Eigen::Vector3d& p) {
    return heading(-0.4) * (p - path(0.4));
  }

  /// Compares the n-th of a knot's elements that know a slot.
  void expect(int knot, int slot, const Eigen::VectorXd& wanted, int n = 0) const {
    const std::vector<Element>& elements = term->elements();
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const std::vector<int>& slots = elements[e].slots;
      if (elements[e].knot != knot || std::find(slots.begin(), slots.end(), slot) == slots.end() ||
          n-- > 0)
        continue;
      Eigen::VectorXd z(slots.size()), r(elements[e].rows);
      for (std::size_t k = 0; k < slots.size(); ++k) z[static_cast<int>(k)] = x[slots[k]];
      term->residual(static_cast<int>(e), z, r);
      ASSERT_EQ(r.size(), wanted.size());
      EXPECT_LT((r - wanted).norm(), 1e-10 * (1.0 + wanted.norm())) << r << "\n not\n" << wanted;
      return;
    }
    ADD_FAILURE() << "no element at knot " << knot << " knows slot " << slot;
  }
  void expect(int knot, int slot, double wanted, int n = 0) const {
    expect(knot, slot, Eigen::VectorXd::Constant(1, wanted), n);
  }

  TermSetting setting;
  std::unique_ptr<Term> term;
  Eigen::VectorXd x;
};

}  // namespace legwright::test
