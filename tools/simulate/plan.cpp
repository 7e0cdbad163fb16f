// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/plan.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/motion.hpp"
#include "plugin/trajectory.hpp"
#include "tools/simulate/feed_forward.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {
namespace {

std::vector<std::string> joint_names(const Morphology& morphology) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < morphology.links.size(); ++i)
    names.push_back(morphology.links[i].joint.name);
  return names;
}

std::vector<std::string> feet_names(const Morphology& morphology) {
  std::vector<std::string> names;
  for (const auto& foot : morphology.feet) names.push_back(foot.name);
  return names;
}

std::vector<FootOnLink> feet_on_links(const Morphology& morphology) {
  std::vector<FootOnLink> feet;
  for (const auto& foot : morphology.feet) {
    const auto link = static_cast<std::size_t>(foot.link);
    feet.push_back({link == 0 ? std::string() : morphology.links[link].joint.name, foot.radius});
  }
  return feet;
}

// One knot of m as a row of the table; time and torques are left alone.
void write_knot(const MotionView& view, const Gait& gait, int knot, const Trajectory& columns,
                double* row) {
  const Eigen::VectorXd pose = view.pose(knot);
  for (int a = 0; a < columns.joint_count(); ++a) row[columns.target_column(a)] = pose[6 + a];
  for (int k = 0; k < 6; ++k) row[columns.root_column(k)] = pose[k];
  for (int k = 0; k < 3; ++k) row[columns.com_column(k)] = view.com_W(knot)[k];
  for (int j = 0; j < columns.foot_count(); ++j) {
    for (int k = 0; k < 3; ++k) {
      row[columns.foot_column(j, k)] = view.foot_W(knot, j)[k];
      row[columns.force_column(j, k)] = view.force_W(knot, j)[k];
    }
    row[columns.contact_column(j)] = gait.in_contact(knot, j) ? 1.0 : 0.0;
  }
}

Trajectory make_trajectory(const Morphology& morphology, const Layout& layout, const Gait& gait,
                           const Eigen::VectorXd& m) {
  const int knots = layout.knot_count();
  Trajectory out =
      blank_trajectory(joint_names(morphology), feet_names(morphology), knots, gait.period());
  const MotionView view(layout, m);
  for (int knot = 0; knot < knots; ++knot) write_knot(view, gait, knot, out, &out.at(knot, 0));
  // Joints, height, roll and pitch repeat each cycle: their small misfit at knot T is not played.
  const Eigen::VectorXd drift = view.pose(knots) - view.pose(0);
  out.travel = {drift[0], drift[1], 0.0};
  out.turn = drift[5];
  return out;
}

// @param arms of the tendons, knot by joint [m].
double torque_share(const Morphology& morphology, const Trajectory& trajectory,
                    const Eigen::MatrixXd& arms) {
  double share = 0.0;
  for (const LinearActuator& actuator : morphology.linear_actuators)
    for (int knot = 0; knot < trajectory.knot_count; ++knot) {
      const double torque = trajectory.at(knot, trajectory.torque_column(actuator.joint));
      const double limit = actuator.force_limit * std::abs(arms(knot, actuator.joint));
      share = std::max(share, std::abs(torque) / limit);
    }
  for (int knot = 0; knot < trajectory.knot_count; ++knot) {
    for (int a = 0; a < trajectory.joint_count(); ++a) {
      const double limit = morphology.links[static_cast<std::size_t>(a) + 1].joint.torque_limit;
      share = std::max(share, std::abs(trajectory.at(knot, trajectory.torque_column(a))) / limit);
    }
  }
  return share;
}

// Knot T as it is in m: shows how well the plan closes.
std::vector<double> last_row(const Trajectory& trajectory, const Layout& layout, const Gait& gait,
                             const Eigen::VectorXd& m) {
  const double* first = trajectory.table.data();
  std::vector<double> row(first, first + trajectory.column_count());
  row[0] = trajectory.period;
  write_knot(MotionView(layout, m), gait, layout.knot_count(), trajectory, row.data());
  return row;
}

}  // namespace

Trajectory planned_trajectory(const Objective& objective, const Eigen::VectorXd& m) {
  return make_trajectory(objective.morphology(), objective.layout(), objective.task().gait, m);
}

PlayablePlan make_playable(const Morphology& morphology, const std::string& robot_xml,
                           const Layout& layout, const Gait& gait, const Eigen::VectorXd& m,
                           const std::filesystem::path& folder) {
  try {
    Trajectory trajectory = make_trajectory(morphology, layout, gait, m);
    const ModelPointer model = compile_model(robot_xml, morphology.name, folder);
    const RootResidual residual = fill_feed_forward(*model, feet_on_links(morphology), trajectory);
    const JointMap map = map_joints(*model, trajectory.joint_names);
    const PlayedState start = played_state(*model, map, trajectory, 0.0);
    PlayablePlan plan;
    plan.trajectory = write_trajectory(trajectory);
    plan.motion_csv = write_motion_csv(trajectory, last_row(trajectory, layout, gait, m));
    plan.start_qpos = start.qpos;
    plan.start_qvel = start.qvel;
    plan.root_residual = residual.force;
    plan.torque_share = torque_share(morphology, trajectory, residual.arms);
    plan.travel = Eigen::Map<const Eigen::Vector3d>(trajectory.travel.data());
    plan.turn = trajectory.turn;
    return plan;
  } catch (const TrajectoryError& error) {
    throw InputError(morphology.name + ": " + error.what());
  } catch (const MujocoError& error) {
    throw InputError(error.what());
  }
}

PlayablePlan make_playable(const RobotModel& robot, const std::string& robot_xml,
                           const Objective& objective, const Eigen::VectorXd& m) {
  return make_playable(objective.morphology(), played_robot(robot, robot_xml), objective.layout(),
                       objective.task().gait, m, robot.file.parent_path());
}

}  // namespace legwright
