// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/simulate/standing_puppy.hpp"
#include "tests/support/paths.hpp"

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {
namespace {

constexpr int kStandKnots = 8;
constexpr double kStandPeriod = 0.8;

/// The smallest vertical forces at these places that carry the weight without torque about the COM.
Eigen::VectorXd share_weight(const std::vector<Eigen::Vector3d>& feet, const Eigen::Vector3d& com,
                             double weight) {
  Eigen::MatrixXd balance(3, static_cast<Eigen::Index>(feet.size()));
  for (std::size_t j = 0; j < feet.size(); ++j) {
    balance.col(static_cast<Eigen::Index>(j)) << 1.0, feet[j].x() - com.x(), feet[j].y() - com.y();
  }
  return balance.completeOrthogonalDecomposition().solve(Eigen::Vector3d(weight, 0.0, 0.0));
}

}  // namespace

StandingPuppy::StandingPuppy(double bounce)
    : robot(read_robot(test::source_dir() + "/examples/puppy/robot.xml")),
      gait({"stand", std::vector<double>(4, 0.0), 1.0}, kStandPeriod, kStandKnots, {0, 1, 2, 3}),
      layout(robot.morphology, robot.space.size(), gait, 1) {
  const auto model = compile_model(robot.xml, "puppy");
  const auto data = make_data(*model);
  std::vector<std::string> names;
  for (std::size_t i = 1; i < robot.morphology.links.size(); ++i)
    names.push_back(robot.morphology.links[i].joint.name);
  const JointMap map = map_joints(*model, names);
  const Eigen::VectorXd nominal = robot.morphology.nominal_joints();
  for (std::size_t a = 0; a < names.size(); ++a)
    data->qpos[map.qpos[a]] = nominal[static_cast<Eigen::Index>(a)];
  for (int k = 0; k < 7; ++k) data->qpos[map.root_qpos + k] = k == 3 ? 1.0 : 0.0;
  mj_forward(model.get(), data.get());
  std::vector<Eigen::Vector3d> feet;
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& foot : robot.morphology.feet) {
    const int geom = mj_name2id(model.get(), mjOBJ_GEOM, foot.name.c_str());
    feet.emplace_back(Eigen::Map<const Eigen::Vector3d>(data->geom_xpos + 3 * geom));
    lowest = std::min(lowest, feet.back().z() - foot.radius);
  }
  const Eigen::Vector3d com =
      Eigen::Map<const Eigen::Vector3d>(data->subtree_com + 3 * map.root_body);
  weight = model->body_subtreemass[map.root_body] * 9.81;
  const Eigen::VectorXd share = share_weight(feet, com, 1.0);
  const double step = gait.time_step();
  m = Eigen::VectorXd::Zero(layout.motion_size());
  const auto place = [&](int slot) { return slot - layout.design_size(); };
  const auto height = [&](int knot) {
    return bounce * std::sin(2 * std::numbers::pi * knot / kStandKnots) - lowest;
  };
  for (int knot = 0; knot <= kStandKnots; ++knot) {
    const Eigen::Vector3d shift(0, 0, height(knot));
    const double acceleration =
        (height(knot - 1) - 2 * height(knot) + height(knot + 1)) / (step * step);
    m.segment<3>(place(layout.pose(knot))) = shift;
    m.segment(place(layout.pose(knot)) + 6, nominal.size()) = nominal;
    m.segment<3>(place(layout.com(knot))) = com + shift;
    for (int j = 0; j < layout.foot_count(); ++j) {
      m.segment<3>(place(layout.foot(knot, j))) = feet[static_cast<std::size_t>(j)] + shift;
      m[place(layout.force(knot, j)) + 2] = share[j] * weight * (1 + acceleration / 9.81);
    }
  }
}

}  // namespace legwright
