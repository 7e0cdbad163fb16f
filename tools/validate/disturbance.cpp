// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/disturbance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "mjcf/scene/surroundings.hpp"
#include "optimizer/motion/task.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/validate/delayed_servos.hpp"
#include "tools/validate/floor_friction.hpp"
#include "tools/validate/ground_stiffness.hpp"

namespace legwright {
namespace {

constexpr double kPushDuration = 0.05;  // [s]
constexpr double kFineStep = 0.25e-3;   // [s]; see README.md

// Both geoms where neither has the say: the larger would win.
void set_floor_friction(Scene& scene, double friction) {
  mjModel& model = *scene.model;
  for (const Footing& footing : footings(scene))
    for (const int geom : {footing.ground, footing.foot})
      if (footing.ruling < 0 || geom == footing.ruling)
        model.geom_friction[static_cast<std::ptrdiff_t>(3) * geom] = friction;
}

void scale_masses(mjModel& model, double scale) {
  for (int body = 1; body < model.nbody; ++body) {
    model.body_mass[body] *= scale;
    for (int k = 0; k < 3; ++k) model.body_inertia[3 * body + k] *= scale;
  }
  mj_setConst(&model, make_data(model).get());  // sums of masses, and what contacts make of them
}

// A slope of the floor is a slope of gravity as the floor sees it; on a slope, one more.
void slope_floor(mjModel& model, const Eigen::Vector2d& way, double along, double across) {
  Eigen::Map<Eigen::Vector3d> gravity(model.opt.gravity);
  const double g = gravity.norm();
  const SlopeAngles own = slope_of(way, up_of(model));
  gravity = -g * up_on_slope(way, own.along + along, own.across + across);
}

Scene copy_of(const Scene& scene) {
  Scene copy;
  copy.name = scene.name;
  copy.model.reset(mj_copyModel(nullptr, scene.model.get()));
  copy.trajectory = scene.trajectory;
  copy.t0 = scene.t0;
  copy.gain_scale = scene.gain_scale;
  copy.joints = scene.joints;
  copy.torque_limit = scene.torque_limit;
  copy.motor_line = scene.motor_line;
  copy.tendon_actuator = scene.tendon_actuator;
  copy.foot_geom = scene.foot_geom;
  copy.start_key = scene.start_key;
  return copy;
}

/// Of where the robot faces. @param forward in the heading frame
double heading(const mjtNum* rotation, const Eigen::Vector2d& forward) {
  const double yaw = std::atan2(rotation[3], rotation[0]);
  return forward == Eigen::Vector2d::UnitX() ? yaw : yaw + std::atan2(forward.y(), forward.x());
}

double lowest_foot(const Scene& scene, const mjData& data) {
  double lowest = INFINITY;
  for (const int foot : scene.foot_geom)
    lowest = std::min(lowest, data.geom_xpos[3 * foot + 2] - scene.model->geom_rbound[foot]);
  return lowest;
}

/// Turns the robot, which is at rest, about the ground below its centre of mass and lifts it until
/// its lowest foot is as high as before: it is set down askew.
void tilt(const Scene& scene, mjData& data, double roll, double pitch,
          const Eigen::Vector2d& forward) {
  const mjModel& model = *scene.model;
  mj_kinematics(&model, &data);
  mj_comPos(&model, &data);
  const mjtNum* const trunk = data.xmat + static_cast<std::ptrdiff_t>(9) * scene.joints.root_body;
  const double yaw = heading(trunk, forward);
  const double before = lowest_foot(scene, data);
  const mjtNum* com = data.subtree_com + static_cast<std::ptrdiff_t>(3) * scene.joints.root_body;
  const Eigen::Vector3d pivot(com[0], com[1], 0.0);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()) *
                                Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()));
  mjtNum* root = data.qpos + scene.joints.root_qpos;
  Eigen::Map<Eigen::Vector3d> position(root);
  position = (pivot + turn * (position - pivot)).eval();
  const mjtNum by[4] = {turn.w(), turn.x(), turn.y(), turn.z()};
  mju_mulQuat(root + 3, by, root + 3);
  mj_kinematics(&model, &data);
  root[2] += before - lowest_foot(scene, data);
}

/// A constant force for some steps, ahead and to the left as the robot faces when it begins.
class Push {
 public:
  Push(const Scene& scene, const Disturbance& disturbance, double time,
       const Eigen::Vector2d& forward)
      : scene_(scene),
        forward_(forward),
        impulse_(scene.model->body_subtreemass[scene.joints.root_body] *
                 Eigen::Vector2d(disturbance.push_forward, disturbance.push_left)),
        first_(std::llround(time / scene.model->opt.timestep)),
        steps_(std::max(1LL, std::llround(kPushDuration / scene.model->opt.timestep))) {}

  void apply(mjData& data, double time) {
    const double h = scene_.model->opt.timestep;
    const long long step = std::llround(time / h) - first_;
    if (step < 0 || step > steps_ || impulse_.isZero(0.0)) return;
    const int body = scene_.joints.root_body;
    if (step == 0)
      force_ =
          Eigen::Rotation2Dd(heading(data.xmat + static_cast<std::ptrdiff_t>(9) * body, forward_)) *
          impulse_ / (static_cast<double>(steps_) * h);
    const bool over = step == steps_;
    data.xfrc_applied[static_cast<std::ptrdiff_t>(6) * body] = over ? 0.0 : force_.x();
    data.xfrc_applied[static_cast<std::ptrdiff_t>(6) * body + 1] = over ? 0.0 : force_.y();
  }

 private:
  const Scene& scene_;
  Eigen::Vector2d forward_, impulse_, force_ = Eigen::Vector2d::Zero();
  long long first_, steps_;
};

}  // namespace

DisturbableScene::DisturbableScene(const std::filesystem::path& file, const Eigen::Vector2d& way,
                                   const Eigen::Vector2d& forward)
    : xml_(read_file(file)),
      folder_(file.parent_path()),
      way_(way.norm() > 0.0 ? way.normalized() : forward),
      scene_(parse_scene(xml_, file.string(), 1.0, folder_)) {}

Disturbance DisturbableScene::nothing() const {
  Disturbance out;
  if (const double own = floor_friction(scene_); std::isfinite(own)) out.floor_friction = own;
  return out;
}

Scene DisturbableScene::with(const Disturbance& disturbance, DelayStep delay_step) const {
  // The plugin compares gains with its text, so other gains want another text.
  Scene scene = disturbance.gain_scale == 1.0
                    ? copy_of(scene_)
                    : parse_scene(xml_, scene_.name, disturbance.gain_scale, folder_);
  if (disturbance.floor_friction != nothing().floor_friction)
    set_floor_friction(scene, disturbance.floor_friction);
  if (disturbance.mass_scale != 1.0) scale_masses(*scene.model, disturbance.mass_scale);
  if (disturbance.slope_along != 0.0 || disturbance.slope_across != 0.0)
    slope_floor(*scene.model, way_, disturbance.slope_along, disturbance.slope_across);
  if (disturbance.ground_sink > 0.0) soften_ground(scene, disturbance.ground_sink);
  if (disturbance.delay > 0.0 && delay_step == DelayStep::fine)
    scene.model->opt.timestep = std::min(scene.model->opt.timestep, kFineStep);
  return scene;
}

RolloutOptions disturbed_rollout(Scene& scene, const Disturbance& disturbance, int cycles,
                                 double push_time, const Eigen::Vector2d& forward) {
  RolloutOptions options;
  options.cycles = cycles;
  auto delayed = disturbance.delay > 0.0
                     ? std::make_shared<DelayedServos>(*scene.model, disturbance.delay)
                     : nullptr;
  options.prepare = [&scene, disturbance, delayed, forward](mjData& data) {
    std::fill_n(data.qvel + scene.joints.root_dof, 6, 0.0);
    if (disturbance.roll != 0.0 || disturbance.pitch != 0.0)
      tilt(scene, data, disturbance.roll, disturbance.pitch, forward);
    if (delayed) delayed->take_over();
  };
  if (disturbance.push_forward != 0.0 || disturbance.push_left != 0.0 || delayed) {
    auto push = std::make_shared<Push>(scene, disturbance, push_time, forward);
    options.step = [&scene, push, delayed](mjData& data, double time) {
      push->apply(data, time);
      if (delayed)
        delayed->step(data);
      else
        mj_step(scene.model.get(), &data);
    };
  }
  return options;
}

}  // namespace legwright
