// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/stand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/write/model_diff.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/rollout.hpp"

namespace legwright {
namespace {

/// With includes and assets found from its folder.
ModelPointer load_model(const std::filesystem::path& file) {
  MujocoMessages messages;
  std::array<char, 1000> error{};
  const SpecPointer spec(
      mj_parseXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  if (!spec)
    throw MujocoError(fmt::format("{}: MuJoCo cannot read it: {}", file.string(), error.data()));
  ModelPointer model(mj_compile(spec.get(), nullptr));
  if (!model)
    throw MujocoError(
        fmt::format("{}: MuJoCo cannot compile it: {}", file.string(), mjs_getError(spec.get())));
  return model;
}

int free_body(const mjModel& model) {
  for (int j = 0; j < model.njnt; ++j)
    if (model.jnt_type[j] == mjJNT_FREE) return model.jnt_bodyid[j];
  return model.nbody - 1;
}

/// How deep the deepest contact between the robot and the world is [m].
double depth_in_world(const mjModel& model, const mjData& data) {
  double depth = 0.0;
  for (int c = 0; c < data.ncon; ++c) {
    const int a = data.contact[c].geom[0], b = data.contact[c].geom[1];
    if (a < 0 || b < 0) continue;
    if ((model.geom_bodyid[a] == 0) != (model.geom_bodyid[b] == 0))
      depth = std::max(depth, -data.contact[c].dist);
  }
  return depth;
}

/// What the position servos are told in the pose that `data` holds.
void look_at_commands(const mjModel& model, const mjData& data, StandingResult& out) {
  constexpr double kTurned = 0.05, kMoved = 0.005;  // [rad], [m]: elsewhere
  for (int a = 0; a < static_cast<int>(model.nactuator); ++a) {
    const int type = model.actuator_trntype[a], of = model.actuator_trnid[std::ptrdiff_t{2} * a],
              at = model.actuator_ctrladr[a];
    if ((type != mjTRN_JOINT && type != mjTRN_TENDON) ||
        model.actuator_biastype[a] != mjBIAS_AFFINE ||
        !(model.actuator_biasprm[mjNBIAS * a + 1] < 0.0))
      continue;
    ++out.servos;
    const double length =
                     type == mjTRN_TENDON ? data.ten_length[of] : data.qpos[model.jnt_qposadr[of]],
                 gear = model.actuator_gear[std::ptrdiff_t{6} * model.actuator_outadr[a]];
    const mjtNum* const range = model.actuator_ctrlrange + std::ptrdiff_t{2} * at;
    const double command = model.actuator_ctrllimited[at]
                               ? std::clamp(data.ctrl[at], range[0], range[1])
                               : data.ctrl[at];
    const bool turns = type == mjTRN_JOINT && model.jnt_type[of] == mjJNT_HINGE;
    if (std::abs(command - gear * length) > std::abs(gear) * (turns ? kTurned : kMoved))
      ++out.commanded_elsewhere;
  }
}

StandingResult stand(mjModel& model, double seconds) {
  const MujocoMessages messages;
  model.opt.disableflags |= mjDSBL_AUTORESET;
  const DataPointer data = make_data(model);
  if (model.nkey > 0) mj_resetDataKeyframe(&model, data.get(), std::max(home_keyframe(model), 0));
  mj_forward(&model, data.get());
  const int trunk = free_body(model);
  StandingResult out;
  out.trunk_before = out.highest = trunk_com_height(model, *data, trunk);
  out.sunk_in = depth_in_world(model, *data);
  look_at_commands(model, *data, out);
  Health health;
  const auto steps = std::llround(seconds / model.opt.timestep);
  for (long long n = 1; n <= steps && !out.diverged; ++n) {
    mj_step(&model, data.get());
    out.seconds = static_cast<double>(n) * model.opt.timestep;
    health.look(*data, out.seconds);
    if (const double height = trunk_com_height(model, *data, trunk); !(height <= out.highest))
      out.highest = height;
    out.diverged = Health::diverged(*data);
  }
  out.trunk_after = trunk_com_height(model, *data, trunk);
  out.warnings = health.warnings(*data);
  return out;
}

}  // namespace

StandingResult stand(const std::filesystem::path& scene, double seconds) {
  const ModelPointer model = load_model(scene);
  return stand(*model, seconds);
}

std::vector<HealthWarning> warnings_in_gait(const std::filesystem::path& file, double seconds) {
  const Scene scene = load_scene(file);
  RolloutOptions options;
  options.cycles = static_cast<int>(std::ceil(seconds / scene.trajectory.period));
  return rollout(scene, options).warnings;
}

std::vector<std::string> differences_in_scene(const std::filesystem::path& robot,
                                              const std::filesystem::path& scene) {
  const ModelPointer alone = load_model(robot), whole = load_model(scene);
  std::vector<std::string> out;
  for (const Difference& difference : model_differences(*alone, *whole))
    if (difference.quantity != "only in B")
      out.push_back(difference.element + ": " + difference.quantity);
  return out;
}

}  // namespace legwright
