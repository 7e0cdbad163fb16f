// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <vector>

#include "plugin/trajectory.hpp"

namespace legwright {

struct EngineDeleter {
  void operator()(mjSpec* s) const { mj_deleteSpec(s); }
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using SpecPointer = std::unique_ptr<mjSpec, EngineDeleter>;
using ModelPointer = std::unique_ptr<mjModel, EngineDeleter>;
using DataPointer = std::unique_ptr<mjData, EngineDeleter>;

/// A compiled model, or the reason why there is none.
struct Loaded {
  ModelPointer model;
  std::string error;
};
Loaded load(const std::string& xml);

/// The text with each `old_part` replaced; a test fails where there is none.
std::string replace_all(std::string text, const std::string& old_part, const std::string& part);

/// Steps a model. Returns qpos and the sensors after each step, one after another.
std::vector<double> roll_out(const mjModel* m, mjData* d, int steps);

/// Loads the plugin's library and routes MuJoCo's log to a list: nothing is printed or written to
/// files, mju_error throws std::runtime_error, and a warning that the test did not take away fails
/// it.
class EngineTest : public testing::Test {
 protected:
  static void SetUpTestSuite();
  void SetUp() override;
  void TearDown() override;
  /// Warnings since the start or the last call.
  static std::vector<std::string> take_warnings();
};

/// What a model of the toy chain is made of. Strings go into the XML as they are.
struct ChainOptions {
  std::string kp = "4", kd = "0.1";            // attributes of the plugin
  std::string bias_kp = "4", bias_kd = "0.1";  // in the default class
  std::string trajectory;                      // text
  std::string more_config;                     // further <config …/>
  std::string integrator = "implicitfast";
  std::string timestep = "0.001";
  std::string option;  // further attributes of <option>
  std::string joint_type = "hinge";
  std::string actuator;  // further attributes of each plugin actuator
  std::string sensor = R"(<plugin name="tracking" plugin="legwright.gait" instance="gait"/>)";
  std::string more_actuators;
};

/// A light chain of three hinges a, b, c that hangs from the world, driven by the plugin.
std::string plugin_chain(const ChainOptions& options);
/// The same chain driven by native servos `<pid input="pos vel ff">`.
std::string native_chain(const ChainOptions& options);
/// What the chain plays unless told otherwise: 12 knots, 0.6 s, joints a, b, c.
Trajectory chain_trajectory();
/// Of a chain that plays it.
ChainOptions valid_options();

}  // namespace legwright
