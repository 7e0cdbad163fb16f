// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>
#include <vector>

#include "plugin/trajectory.hpp"

namespace legwright {

/// A valid trajectory of seeded random numbers: joints "a", "b", …, feet "A", "B", …
/// @param amplitude of joint targets [rad] and torques [N·m].
inline Trajectory toy_trajectory(int joints, int feet, int knots, double period, unsigned seed,
                                 double amplitude = 1.0) {
  std::vector<std::string> joint_names, foot_names;
  for (int i = 0; i < joints; ++i) joint_names.emplace_back(1, static_cast<char>('a' + i));
  for (int i = 0; i < feet; ++i) foot_names.emplace_back(1, static_cast<char>('A' + i));
  Trajectory t = blank_trajectory(joint_names, foot_names, knots, period);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  for (int knot = 0; knot < knots; ++knot) {
    for (int column = 1; column < t.column_count(); ++column) t.at(knot, column) = uniform(random);
    for (int foot = 0; foot < feet; ++foot) {
      t.at(knot, t.contact_column(foot)) = (knot + foot) % 2;
    }
  }
  return t;
}

}  // namespace legwright
