// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/initial_guess.hpp"

#include <algorithm>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"

namespace legwright {
namespace {

/// COM and feet of the robot in its home pose, with the trunk at a place and heading.
struct Standing {
  Eigen::VectorXd q;
  Eigen::Vector3d com;
  std::vector<Eigen::Vector3d> feet;
};

Standing stand(const Morphology& morphology, const GeometryAtDesign& geometry,
               const Eigen::Vector3d& place, double heading) {
  PoseKinematics kinematics;
  Standing standing{Eigen::VectorXd::Zero(morphology.pose_size()), {}, {}};
  standing.q.head<3>() = place;
  standing.q[5] = heading;
  standing.q.tail(morphology.joint_count()) = morphology.nominal_joints();
  kinematics.compute(morphology, geometry, standing.q, PoseDetail::place);
  standing.com = kinematics.first_moment(0) / geometry.total_mass;
  for (int j = 0; j < morphology.foot_count(); ++j)
    standing.feet.push_back(foot_place(morphology, geometry, kinematics, j));
  return standing;
}

}  // namespace

Eigen::VectorXd initial_guess(const Morphology& morphology, const Layout& layout, const Gait& gait,
                              const WantedPath& path, const Eigen::VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  const int n = layout.design_size();
  Eigen::Vector3d lift = Eigen::Vector3d::Zero();  // so that the lowest foot touches the ground
  const Standing home = stand(morphology, geometry, lift, 0.0);
  lift.z() = -1e300;
  for (int j = 0; j < morphology.foot_count(); ++j)
    lift.z() = std::max(lift.z(), morphology.feet[j].radius - home.feet[j].z());
  Eigen::VectorXd m = Eigen::VectorXd::Zero(layout.motion_size());
  for (int i = 0; i <= layout.knot_count(); ++i) {
    const double time = i * gait.time_step();
    const Standing at =
        stand(morphology, geometry, path.position(time) + lift, path.heading(time));
    m.segment(layout.pose(i) - n, layout.pose_size()) = at.q;
    m.segment<3>(layout.com(i) - n) = at.com;
    int stance = 0;
    for (int j = 0; j < layout.foot_count(); ++j) {
      m.segment<3>(layout.foot(i, j) - n) = at.feet[j];
      stance += gait.in_contact(i, j) ? 1 : 0;
    }
    for (int j = 0; j < layout.foot_count(); ++j)
      if (layout.force(i, j) >= 0)
        m[layout.force(i, j) - n + 2] = morphology.total_mass() * kGravity / std::max(1, stance);
  }
  return m;
}

}  // namespace legwright
