// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>
#include <tinyxml2.h>

#include <string>
#include <vector>

namespace legwright {

/// An option of a robot's file that a scene sets otherwise, as both are written in MJCF.
struct OverriddenOption {
  std::string name, file, scene;
};

/// What the robot's file sets of MuJoCo's steps, solvers and flags, and its scenes set otherwise:
/// files that are tuned for many robots at once on a GPU have a solver of one iteration, with which
/// contacts give way and every robot falls. In the order of MuJoCo's documentation; what the file
/// leaves at MuJoCo's default is not listed.
/// @param time_step of the scenes [s]
std::vector<OverriddenOption> overridden_options(const mjOption& robot, double time_step);

/// Writes step, integrator, cone and impratio of a scene into its own <option>, and every other
/// setting that the robot's file has otherwise than a scene may have it.
/// @param time_step of the scene [s]
void set_solver(tinyxml2::XMLElement& option, const mjOption& robot, double time_step);

/// "scenes have options of their own: iterations 100 (its file has 1), …"; empty where nothing is
/// overridden.
std::string describe_overridden(const std::vector<OverriddenOption>& overridden);

}  // namespace legwright
