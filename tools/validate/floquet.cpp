// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/floquet.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "optimizer/base/parallel.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/rollout.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using RowMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kLevel = 1e-9;  // share of gravity along the ground that counts as none

/// Coordinates of a state that do not change where the robot is moved or turned on the ground: the
/// root's height, roll and pitch and its velocity in the heading frame, all other joints; then the
/// heading, where it matters.
class ReducedState {
 public:
  explicit ReducedState(const CycleStart& start) : model_(*start.model), body_(start.root_body) {
    if (body_ > 0) {
      joint_ = model_.body_jntadr[body_];
      qpos_ = model_.jnt_qposadr[joint_];
      dof_ = model_.jnt_dofadr[joint_];
      const Eigen::Map<const Vector3d> gravity(model_.opt.gravity);
      heading_counts_ = gravity.head<2>().norm() > kLevel * gravity.norm();
      height_ = std::max(std::abs(start.data->qpos[qpos_ + 2]), 1e-3);
      const double g = gravity.norm();
      time_ = g > 0.0 ? std::sqrt(height_ / g) : 1.0;
    }
    for (int dof = 0; dof < model_.nv; ++dof)
      if (body_ == 0 || dof < dof_ || dof >= dof_ + 6) others_.push_back(dof);
  }

  int size() const {
    const int joints = 2 * static_cast<int>(others_.size());
    return joints + (body_ > 0 ? 9 : 0) + (heading_counts_ ? 1 : 0);
  }

  /// Moves a state along one coordinate by so many units of it.
  void disturb(mjData& data, int k, double by) const {
    const int count = static_cast<int>(others_.size());
    if (k < 2 * count)
      return disturb_joint(data, others_[static_cast<std::size_t>(k / 2)], k % 2, by);
    disturb_root(data, k - 2 * count, by);
  }

  /// Where `to` is as seen from `from`, in units of the coordinates.
  VectorXd difference(const mjData& from, const mjData& to) const {
    VectorXd out(size());
    VectorXd positions(model_.nv);
    mj_differentiatePos(&model_, positions.data(), 1.0, from.qpos, to.qpos);
    Eigen::Index k = 0;
    for (const int dof : others_) {
      out[k++] = positions[dof];
      out[k++] = (to.qvel[dof] - from.qvel[dof]) * time_;
    }
    if (body_ == 0) return out;
    out[k++] = (to.qpos[qpos_ + 2] - from.qpos[qpos_ + 2]) / height_;
    const Eigen::AngleAxisd turn(level_rotation(to) * level_rotation(from).transpose());
    out[k++] = turn.angle() * turn.axis().x();
    out[k++] = turn.angle() * turn.axis().y();
    const Vector3d speed = (own_velocity(to) - own_velocity(from)) * (time_ / height_);
    for (int i = 0; i < 3; ++i) {
      out[k++] = speed[i];
      out[k++] = (to.qvel[dof_ + 3 + i] - from.qvel[dof_ + 3 + i]) * time_;
    }
    if (heading_counts_) out[k] = std::remainder(heading(to) - heading(from), 2 * M_PI);
    return out;
  }

 private:
  RowMatrix3 rotation(const mjData& data) const {
    RowMatrix3 out;
    mju_quat2Mat(out.data(), data.qpos + qpos_ + 3);
    return out;
  }
  double heading(const mjData& data) const {
    const RowMatrix3 turn = rotation(data);
    return std::atan2(turn(1, 0), turn(0, 0));
  }
  static Eigen::Matrix3d about_vertical(double angle) {
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
  }
  Eigen::Matrix3d level_rotation(const mjData& data) const {
    return about_vertical(-heading(data)) * rotation(data);
  }
  Vector3d own_velocity(const mjData& data) const {
    return about_vertical(-heading(data)) * Eigen::Map<const Vector3d>(data.qvel + dof_);
  }

  void disturb_joint(mjData& data, int dof, int speed, double by) const {
    if (speed != 0) {
      data.qvel[dof] += by / time_;
      return;
    }
    VectorXd way = VectorXd::Zero(model_.nv);
    way[dof] = by;
    mj_integratePos(&model_, data.qpos, way.data(), 1.0);
  }

  void disturb_root(mjData& data, int k, double by) const {
    const Eigen::Matrix3d own = about_vertical(heading(data));
    if (k == 0) {
      data.qpos[qpos_ + 2] += by * height_;
    } else if (k <= 2 || k == 9) {
      turn_root(data, k == 9 ? Vector3d::UnitZ() : Vector3d(own.col(k - 1)), by);
    } else if ((k - 3) % 2 == 0) {
      Eigen::Map<Vector3d>(data.qvel + dof_) += own.col((k - 3) / 2) * (by * height_ / time_);
    } else {
      data.qvel[dof_ + 3 + (k - 3) / 2] += by / time_;
    }
  }

  // The velocity in the heading frame stays what it was.
  void turn_root(mjData& data, const Vector3d& axis, double by) const {
    const Vector3d velocity = own_velocity(data);
    mjtNum turn[4];
    mju_axisAngle2Quat(turn, axis.data(), by);
    mju_mulQuat(data.qpos + qpos_ + 3, turn, data.qpos + qpos_ + 3);
    Eigen::Map<Vector3d>(data.qvel + dof_) = about_vertical(heading(data)) * velocity;
  }

  const mjModel& model_;
  int body_, joint_ = -1, qpos_ = -1, dof_ = -1;
  bool heading_counts_ = false;
  double height_ = 1.0, time_ = 1.0;  // units
  std::vector<int> others_;
};

/// What one cycle makes of a disturbance and of its opposite, over twice its size.
VectorXd response(const CycleStart& start, const ReducedState& state, int coordinate, double step) {
  const MujocoMessages messages;
  DataPointer ends[2];
  for (const int side : {0, 1}) {
    ends[side] = make_data(*start.model);
    mj_copyData(ends[side].get(), start.model, start.data);
    state.disturb(*ends[side], coordinate, side == 0 ? -step : step);
    for (int n = 0; n < start.steps; ++n) mj_step(start.model, ends[side].get());
    if (Health::diverged(*ends[side])) return VectorXd::Constant(state.size(), std::nan(""));
  }
  return state.difference(*ends[0], *ends[1]) / (2 * step);
}

std::optional<double> largest_eigenvalue(const MatrixXd& jacobian) {
  if (!jacobian.allFinite()) return std::nullopt;
  if (jacobian.size() == 0) return 0.0;
  const Eigen::EigenSolver<MatrixXd> solver(jacobian, false);
  if (solver.info() != Eigen::Success) return std::nullopt;
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

/// The gait of a scene once it is on its way; no data where it falls before.
struct SettledGait {
  DataPointer data;
  CycleStart start;
};

SettledGait settle(const Scene& scene, const FloquetOptions& from) {
  mjModel& model = *scene.model;
  SettledGait out;
  const double period = scene.trajectory.period;
  const int steps = std::max(1, static_cast<int>(std::lround(period / model.opt.timestep)));
  model.opt.timestep = period / steps;
  out.data = make_data(model);
  RolloutOptions options;
  options.cycles = from.settle_cycles;
  options.stop = from.stop;
  const long long last = static_cast<long long>(from.settle_cycles) * steps - 1;
  long long n = 0;
  const Rollout played = rollout(scene, options, [&](const RolloutSample& sample) {
    if (n++ == last) mj_copyData(out.data.get(), &model, &sample.data);
  });
  if (played.fall || played.diverged) return {};
  out.start = {&model, out.data.get(), steps, scene.joints.root_body};
  return out;
}

}  // namespace

std::optional<double> floquet_multiplier(const CycleStart& start, const FloquetOptions& options) {
  const ReducedState state(start);
  MatrixXd jacobian(state.size(), state.size());
  parallel_for(state.size(), options.threads, [&](int k) {
    if (options.stop && options.stop()) throw RolloutStopped();
    jacobian.col(k) = response(start, state, k, options.step);
  });
  return largest_eigenvalue(jacobian);
}

std::optional<double> floquet_multiplier(const Scene& scene, const FloquetOptions& options) {
  const SettledGait gait = settle(scene, options);
  if (!gait.data) return std::nullopt;
  return floquet_multiplier(gait.start, options);
}

std::vector<std::optional<double>> floquet_multipliers(const std::vector<Scene>& scenes,
                                                       const FloquetOptions& options) {
  std::vector<std::optional<double>> out(scenes.size());
  StageProgress progress(options.progress, "stability", static_cast<int>(scenes.size()));
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    out[k] = floquet_multiplier(scenes[k], options);
    progress.one_more();
  }
  return out;
}

}  // namespace legwright
