// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/planned_curves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "optimizer/motion/path.hpp"
#include "plugin/spline.hpp"
#include "tools/simulate/planned_vectors.hpp"
#include "tools/validate/compared_rows.hpp"
#include "tools/validate/foot_touch.hpp"

namespace legwright {
namespace {

using R = ComparedRows;

TrunkAngles planned_angles(const Scene& scene, const PlayedState& state) {
  mjtNum rotation[9];
  mju_quat2Mat(rotation, state.qpos.data() + scene.joints.root_qpos + 3);
  return trunk_angles(rotation);
}

class PlannedColumn {
 public:
  PlannedColumn(const Scene& scene, const WantedMotion& wanted)
      : scene_(scene),
        plan_(scene.trajectory),
        rows_(plan_),
        direction_(speed_direction(wanted)),
        path_(wanted.velocity, wanted.turn_rate, plan_.period),
        start_yaw_(planned_yaw(scene)),
        start_(planned_point(plan_, phase_at(plan_, 0.0), plan_.com_column(0)).value) {}

  void fill(double share, Eigen::Ref<Eigen::VectorXd> out) const {
    const double time = share * plan_.period;
    const SplinePhase phase = phase_at(plan_, time);
    const PlayedState state = played_state(*scene_.model, scene_.joints, plan_, time);
    out.setConstant(std::numeric_limits<double>::quiet_NaN());
    whole(share, phase, state, out);
    for (int j = 0; j < rows_.feet; ++j) foot(j, phase, share, out);
    joints(phase, state, out);
  }

 private:
  void whole(double share, const SplinePhase& phase, const PlayedState& state,
             Eigen::Ref<Eigen::VectorXd> out) const {
    const PlannedPoint com = planned_point(plan_, phase, plan_.com_column(0));
    const Eigen::Rotation2Dd start(-start_yaw_), heading(-start_yaw_ - plan_.turn * share);
    const Eigen::Vector2d moved =
        start * (com.value - start_).head<2>() - path_.position(share * plan_.period).head<2>();
    const TrunkAngles angles = planned_angles(scene_, state);
    out[R::speed] = direction_.dot(heading * com.rate.head<2>());
    out[R::heading_error] = 0.0;
    out[R::com_x] = moved.x();
    out[R::com_y] = moved.y();
    out[R::com_height] = com.value.z();
    out[R::trunk_height] = state.qpos[scene_.joints.root_qpos + 2];
    out[R::roll] = angles.roll;
    out[R::pitch] = angles.pitch;
    out[R::yaw] =
        std::remainder(angles.yaw - start_yaw_ - plan_.turn * share, 2 * std::numbers::pi);
    out[R::saturated] = 0.0;
  }

  void foot(int j, const SplinePhase& phase, double share, Eigen::Ref<Eigen::VectorXd> out) const {
    const Eigen::Vector3d force = planned_force(plan_, phase, j);
    const Eigen::Rotation2Dd heading(-start_yaw_ - plan_.turn * share);
    const Eigen::Vector2d along = heading * force.head<2>();
    const int geom = scene_.foot_geom[static_cast<std::size_t>(j)];
    const int nearest = phase.fraction < 0.5 ? phase.knot[1] : phase.knot[2];
    const bool stands = plan_.at(nearest, plan_.contact_column(j)) > 0.5;
    const auto at = [&](R::Foot part) -> double& { return out[rows_.foot(j, part)]; };
    at(R::ahead) = along.x();
    at(R::left) = along.y();
    at(R::normal) = force.z();
    at(R::tangential) = along.norm();
    at(R::height) = planned_point(plan_, phase, plan_.foot_column(j, 0)).value.z() -
                    foot_radius(*scene_.model, geom);
    at(R::slip_speed) = 0.0;
    at(R::friction) = stands && force.z() > 0 ? along.norm() / force.z() : 0.0;
    at(R::contact) = stands ? 1.0 : 0.0;
  }

  void joints(const SplinePhase& phase, const PlayedState& state,
              Eigen::Ref<Eigen::VectorXd> out) const {
    double power = 0.0;
    for (int a = 0; a < rows_.joints; ++a) {
      const auto joint = static_cast<std::size_t>(a);
      const double torque = linear_value(plan_, phase, plan_.torque_column(a));
      const double own = torque * state.qvel[scene_.joints.dof[joint]];
      out[rows_.joint(a, R::angle)] = state.qpos[scene_.joints.qpos[joint]];
      out[rows_.joint(a, R::torque)] = torque;
      out[rows_.joint(a, R::joint_power)] = own;
      power += std::max(0.0, own);
    }
    out[R::power] = power;
  }

  const Scene& scene_;
  const Trajectory& plan_;
  ComparedRows rows_;
  Eigen::Vector2d direction_;
  WantedPath path_;
  double start_yaw_;
  Eigen::Vector3d start_;
};

}  // namespace

TrunkAngles trunk_angles(const mjtNum* rotation) {
  return {std::atan2(rotation[7], rotation[8]), -std::asin(std::clamp(rotation[6], -1.0, 1.0)),
          std::atan2(rotation[3], rotation[0])};
}

Eigen::Vector2d speed_direction(const WantedMotion& wanted) {
  return wanted.travels() ? Eigen::Vector2d(wanted.velocity.normalized()) : Eigen::Vector2d(1, 0);
}

double planned_yaw(const Scene& scene) {
  return planned_angles(scene, played_state(*scene.model, scene.joints, scene.trajectory, 0.0)).yaw;
}

Eigen::MatrixXd planned_curves(const Scene& scene, const WantedMotion& wanted, int bins) {
  const PlannedColumn column(scene, wanted);
  Eigen::MatrixXd out(ComparedRows(scene.trajectory).count(), bins);
  for (int bin = 0; bin < bins; ++bin) column.fill((bin + 0.5) / bins, out.col(bin));
  return out;
}

}  // namespace legwright
