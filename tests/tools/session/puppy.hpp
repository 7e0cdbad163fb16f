// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "tests/support/paths.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/session/state.hpp"

/// The robot that sessions are tested with, and how their states are compared.
namespace legwright::test {

inline const std::filesystem::path kPuppy = test::source_dir() + "/examples/puppy";
inline const std::filesystem::path kSideways = kPuppy / "sideways.toml";
/// Planned at half the points: how a session goes on does not hang on them, its time does.
inline std::string sideways() {
  std::string text = read_file(kSideways);
  const std::string fine = "knots = 24";
  return text.replace(text.find(fine), fine.size(), "knots = 12");
}

inline constexpr const char* kThigh = "front_thigh_length";
inline RobotModel puppy() { return read_robot(kPuppy / "robot.xml"); }

/// All that a state says, to the last bit.
inline std::vector<double> bits(const SessionState& state) {
  std::vector<double> out;
  const auto add = [&](const Eigen::VectorXd& x) {
    out.insert(out.end(), x.data(), x.data() + x.size());
  };
  add(state.s());
  add(state.lower);
  add(state.upper);
  add(state.design_gradient());
  out.insert(out.end(), state.weights.begin(), state.weights.end());
  out.insert(out.end(), state.frozen.begin(), state.frozen.end());
  out.push_back(state.iterations);
  for (const TaskIterate& task : state.now->tasks) {
    add(task.m);
    out.push_back(task.value);
  }
  return out;
}

}  // namespace legwright::test
