// SPDX-License-Identifier: Apache-2.0
#include "python/core/second_engine.hpp"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "mjcf/text/input_error.hpp"
#include "python/core/followed_call.hpp"
#include "tools/files/json_file.hpp"
#include "tools/simulate/rollout.hpp"
#include "tools/simulate/servo_gait.hpp"
#include "tools/validate/limits_file.hpp"
#include "tools/verbs/judge_in_engine.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace legwright {
namespace {

/// A number of each servo.
Eigen::VectorXd of_servos(const ServoGait& gait, double SceneServo::*number) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(gait.servos.size()));
  for (std::size_t k = 0; k < gait.servos.size(); ++k)
    out[static_cast<Eigen::Index>(k)] = gait.servos[k].*number;
  return out;
}

/// @param start called with a ServoGait; what it returns is called with the time of each step
EngineStart started_by(const nb::callable& start) {
  return [start](const Scene& scene) -> EngineStepper {
    nb::object step = start(ServoGait(scene));
    return [step = std::move(step)](double time) {
      using Answer = std::tuple<Eigen::VectorXd, Eigen::VectorXd, Eigen::VectorXd,
                                std::map<int, Eigen::Vector3d>>;
      Answer answer;
      if (!nb::try_cast(step(time), answer))
        throw nb::type_error(
            "a step of the engine: expected qpos, qvel, torques and forces by geom, as arrays of "
            "floats and a dict");
      auto& [qpos, qvel, torque, force] = answer;
      return EngineStep{std::move(qpos), std::move(qvel), std::move(torque), std::move(force)};
    };
  };
}

EngineOptions options_of(int cycles, std::vector<double> gains, std::filesystem::path limits,
                         bool write) {
  return {cycles, std::move(gains), std::move(limits), write};
}

std::string text_of(const EngineRecord& record) { return to_text(json_of(record)); }

std::string in_mujoco(const std::filesystem::path& folder, EngineOptions options) {
  std::string text;
  FollowedCall call;
  options.stop = [&] { return call.signal != 0; };
  follow(call, [&] {
    text = text_of(
        judge_in_engine(ResultFolder::open(folder), {"mujoco", mj_versionString(), {}}, options));
  });
  return text;
}

}  // namespace

void bind_engine(nb::module_& module) {
  nb::class_<ServoGait>(module, "ServoGait", "A gait and its servos, as a scene has them.")
      .def_ro("timestep", &ServoGait::timestep, "Of the scene [s].")
      .def_ro("gain_scale", &ServoGait::gain_scale)
      .def_prop_ro("joint_names", &ServoGait::joint_names, "In the order of all that follows.")
      .def_ro("joints", &ServoGait::joints, "In the model.")
      .def_prop_ro(
          "actuators",
          [](const ServoGait& gait) {
            std::vector<int> out;
            for (const SceneServo& servo : gait.servos) out.push_back(servo.actuator);
            return out;
          },
          "In the model.")
      .def_prop_ro(
          "linear",
          [](const ServoGait& gait) {
            std::vector<bool> out;
            for (const SceneServo& servo : gait.servos) out.push_back(servo.linear);
            return out;
          },
          "Whether a servo pulls along a tendon.")
      .def_prop_ro(
          "kp", [](const ServoGait& gait) { return of_servos(gait, &SceneServo::kp); },
          "[N m/rad], of linear ones [N/m].")
      .def_prop_ro(
          "kd", [](const ServoGait& gait) { return of_servos(gait, &SceneServo::kd); },
          "[N m s/rad], of linear ones [N s/m].")
      .def_prop_ro(
          "limit", [](const ServoGait& gait) { return of_servos(gait, &SceneServo::limit); },
          "Of torque or force; infinite where there is none.")
      .def_prop_ro("period", &ServoGait::period, "Of a cycle [s].")
      .def(
          "command",
          [](const ServoGait& gait, double time) {
            ServoCommand now = gait.command(time);
            return std::make_tuple(std::move(now.target), std::move(now.velocity),
                                   std::move(now.torque));
          },
          "time"_a,
          "Targets [rad], their velocities and feed-forward torques [N m] at a time [s] since the "
          "start, as the plugin has them.");
  module.def(
      "validate_in_engine",
      [](const std::filesystem::path& folder, std::string engine, std::string version,
         const nb::callable& start, int cycles, std::vector<double> gains,
         std::filesystem::path limits, bool write) {
        return text_of(judge_in_engine(
            ResultFolder::open(folder), {std::move(engine), std::move(version), started_by(start)},
            options_of(cycles, std::move(gains), std::move(limits), write)));
      },
      "folder"_a, "engine"_a, "version"_a, "start"_a, "cycles"_a, "gains"_a, "limits"_a, "write"_a,
      "Plays a result in an engine that Python steps, measures and judges it: a JSON text.");
  module.def(
      "validate",
      [](const std::filesystem::path& folder, int cycles, std::vector<double> gains,
         std::filesystem::path limits) {
        return in_mujoco(folder, options_of(cycles, std::move(gains), std::move(limits), false));
      },
      "folder"_a, "cycles"_a, "gains"_a, "limits"_a,
      "The same in MuJoCo, with the plugin. Signals stop it.");
}

}  // namespace legwright
