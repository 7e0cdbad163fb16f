// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/point_mass_robot.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "mjcf/text/compile.hpp"

namespace legwright::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

RobotState state_of(const Morphology& morphology, const VectorXd& s, const VectorXd& qpos,
                    const VectorXd& qvel) {
  struct Frame {
    Vector3d p, v, w;
    Matrix3d R;
  };
  std::vector<Frame> frames(morphology.links.size());
  const Matrix3d trunk =
      Eigen::Quaterniond(qpos[3], qpos[4], qpos[5], qpos[6]).normalized().toRotationMatrix();
  frames[0] = {qpos.head<3>(), qvel.head<3>(), trunk * qvel.segment<3>(3), trunk};
  struct Moving {
    double m;
    Vector3d p, v;
  };
  std::vector<Moving> points;
  for (std::size_t l = 0; l < morphology.links.size(); ++l) {
    const Link& link = morphology.links[l];
    if (l > 0) {
      const Frame& up = frames[link.parent];
      const Vector3d arm = up.R * link.origin.at(s), axis = link.joint.axis.at(s);
      const Matrix3d before = up.R * link.orientation;
      frames[l] = {up.p + arm, up.v + up.w.cross(arm), up.w + before * axis * qvel[5 + l],
                   before * Eigen::AngleAxisd(qpos[6 + l], axis).toRotationMatrix()};
    }
    const Frame& at = frames[l];
    for (const PointMass& point : link.masses) {
      const Vector3d arm = at.R * point.position.at(s);
      points.push_back({point.mass * point.growth_at(s), at.p + arm, at.v + at.w.cross(arm)});
    }
  }
  RobotState out;
  Vector3d momentum = Vector3d::Zero();
  for (const Moving& point : points) {
    out.mass += point.m;
    out.com += point.m * point.p;
    momentum += point.m * point.v;
  }
  out.com /= out.mass;
  for (const Moving& point : points) {
    const Vector3d r = point.p - out.com;
    out.angular_momentum += point.m * r.cross(point.v - momentum / out.mass);
    out.second_moments += point.m * r * r.transpose();
  }
  for (const Foot& foot : morphology.feet) {
    const Frame& at = frames[foot.link];
    out.feet.push_back(at.p + at.R * foot.position.at(s));
  }
  for (const LinearActuator& actuator : morphology.linear_actuators) {
    const Frame& low = frames[actuator.joint + 1];
    const Frame& up = frames[morphology.links[actuator.joint + 1].parent];
    out.actuator_lengths.push_back(
        (low.p + low.R * actuator.lower.at(s) - up.p - up.R * actuator.upper.at(s)).norm());
  }
  return out;
}

struct MujocoRobot::Engine {
  ModelPointer model;
  DataPointer data;
};

MujocoRobot::MujocoRobot(const std::string& xml) : engine_(new Engine) {
  engine_->model = compile_mjcf(xml, "robot under test");
  engine_->data.reset(mj_makeData(engine_->model.get()));
}
MujocoRobot::~MujocoRobot() { delete engine_; }
int MujocoRobot::nq() const { return static_cast<int>(engine_->model->nq); }
int MujocoRobot::nv() const { return static_cast<int>(engine_->model->nv); }

RobotState MujocoRobot::state(const Morphology& names, const VectorXd& qpos,
                              const VectorXd& qvel) const {
  const mjModel& m = *engine_->model;
  mjData& d = *engine_->data;
  mju_copy(d.qpos, qpos.data(), m.nq);
  mju_copy(d.qvel, qvel.data(), m.nv);
  mj_fwdPosition(&m, &d);
  mj_fwdVelocity(&m, &d);
  mj_subtreeVel(&m, &d);
  RobotState out;
  out.mass = m.body_subtreemass[0];
  out.com = Vector3d::Map(d.subtree_com);
  out.angular_momentum = Vector3d::Map(d.subtree_angmom);
  for (int b = 1; b < m.nbody; ++b) {
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> R =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(d.ximat + 9 * b);
    const Vector3d inertia = Vector3d::Map(m.body_inertia + 3 * b);
    const Vector3d second = Vector3d::Constant(inertia.sum() / 2) - inertia;
    const Vector3d r = Vector3d::Map(d.xipos + 3 * b) - out.com;
    out.second_moments +=
        R * second.asDiagonal() * R.transpose() + m.body_mass[b] * r * r.transpose();
  }
  for (const Foot& foot : names.feet)
    out.feet.push_back(
        Vector3d::Map(d.geom_xpos + 3 * mj_name2id(&m, mjOBJ_GEOM, foot.name.c_str())));
  for (const LinearActuator& actuator : names.linear_actuators)
    out.actuator_lengths.push_back(
        d.ten_length[mj_name2id(&m, mjOBJ_TENDON, actuator.name.c_str())]);
  return out;
}

double difference(const RobotState& a, const RobotState& b) {
  double worst = std::abs(a.mass - b.mass) / a.mass;
  worst = std::max(worst, (a.com - b.com).norm());
  worst =
      std::max(worst, (a.angular_momentum - b.angular_momentum).norm() / a.angular_momentum.norm());
  worst = std::max(worst, (a.second_moments - b.second_moments).norm() / a.second_moments.norm());
  if (a.feet.size() != b.feet.size()) return 1e9;
  for (std::size_t f = 0; f < a.feet.size(); ++f)
    worst = std::max(worst, (a.feet[f] - b.feet[f]).norm());
  if (a.actuator_lengths.size() != b.actuator_lengths.size()) return 1e9;
  for (std::size_t k = 0; k < a.actuator_lengths.size(); ++k)
    worst = std::max(worst, std::abs(a.actuator_lengths[k] - b.actuator_lengths[k]));
  return worst;
}

}  // namespace legwright::test
