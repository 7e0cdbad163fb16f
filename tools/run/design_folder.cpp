// SPDX-License-Identifier: Apache-2.0
#include "tools/run/design_folder.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/by_name.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mjcf/scene/emit_scene.hpp"
#include "mjcf/scene/surroundings.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/motion/motion.hpp"
#include "tools/files/unfinished_folder.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/simulate/plan.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Where the trunk points, seen from above, at each knot; without jumps from knot to knot [rad].
std::vector<double> headings(const MotionView& motion, int knot_count) {
  std::vector<double> result;
  for (int knot = 0; knot <= knot_count; ++knot) {
    const Eigen::Vector3d turn = motion.pose(knot).segment<3>(3);
    const double angle = turn.norm();
    const Eigen::Vector3d forward =
        angle > 0.0 ? Eigen::AngleAxisd(angle, turn / angle) * Eigen::Vector3d::UnitX()
                    : Eigen::Vector3d::UnitX();
    const double heading = std::atan2(forward.y(), forward.x());
    const double before = result.empty() ? 0.0 : result.back();
    result.push_back(before + std::remainder(heading - before, 2.0 * std::numbers::pi));
  }
  return result;
}

/// Where the links are at each knot of a plan.
std::vector<PoseKinematics> poses_of(const Objective& objective, const Eigen::VectorXd& s,
                                     const MotionView& motion) {
  const GeometryAtDesign geometry(objective.morphology(), s);
  std::vector<PoseKinematics> poses(objective.layout().knot_count() + 1);
  for (int knot = 0; knot <= objective.layout().knot_count(); ++knot)
    poses[knot].compute(objective.morphology(), geometry, motion.pose(knot), PoseDetail::place);
  return poses;
}

/// How far standing feet slide, over how far the robot travels in that time. That a ball rolls on
/// is no sliding, eq (14); a plan that cannot take steps slides its feet along and comes close to
/// one.
double slide_share(const Objective& objective, const Eigen::VectorXd& s, const MotionView& motion,
                   double speed) {
  const Task& task = objective.task();
  const Morphology& morphology = objective.morphology();
  const std::vector<PoseKinematics> poses = poses_of(objective, s, motion);
  double slid = 0.0, travelled = 0.0;
  for (int knot = 0; knot < objective.layout().knot_count(); ++knot)
    for (int foot = 0; foot < objective.layout().foot_count(); ++foot) {
      if (!task.gait.in_contact(knot, foot) || !task.gait.in_contact(knot + 1, foot)) continue;
      const Eigen::Vector3d turn =
          PairDerivatives::foot_turn(morphology, foot, poses[knot], poses[knot + 1]);
      const Eigen::Vector3d rolled =
          morphology.feet[foot].radius * turn.cross(Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d moved = motion.foot_W(knot + 1, foot) - motion.foot_W(knot, foot);
      slid += (moved - rolled).head<2>().norm();
      travelled += speed * task.gait.time_step();
    }
  return travelled > 0.0 ? slid / travelled : 0.0;
}

}  // namespace

PlanQuality plan_quality(const Objective& objective, const Eigen::VectorXd& s,
                         const Eigen::VectorXd& m) {
  const Task& task = objective.task();
  const Layout& layout = objective.layout();
  const MotionView motion(layout, m);
  const int last = layout.knot_count();
  const std::vector<double> heading = headings(motion, last);
  PlanQuality quality;
  const Eigen::Vector2d moved = (motion.com_W(last) - motion.com_W(0)).head<2>();
  const double turned = heading.back() - heading.front(), period = task.gait.period();
  quality.planned_velocity = moved / period;
  quality.speed_wanted = task.velocity.norm();
  if (task.turn_rate != 0.0) {
    quality.turn_wanted = std::abs(task.turn_rate);
    quality.turn_reached = std::copysign(1.0, task.turn_rate) * turned / period;
  }
  if (quality.speed_wanted > 1e-9) {
    quality.slide_share = slide_share(objective, s, motion, quality.speed_wanted);
    const Eigen::Vector2d velocity = WantedPath::velocity_along_arc(
        moved, task.turn_rate != 0.0 ? turned : 0.0, period);  // of the arc, not its chord
    quality.speed_reached = velocity.dot(task.velocity) / quality.speed_wanted;
  } else {  // on the spot
    quality.speed_wanted = quality.turn_wanted;
    quality.speed_reached = quality.turn_reached;
  }
  for (int knot = 0; knot <= last; ++knot) {
    const double wanted_heading = objective.path().heading(knot * task.gait.time_step());
    quality.heading_error =
        std::max(quality.heading_error, std::abs(heading[knot] - wanted_heading));
  }
  for (int knot = 0; knot <= last; ++knot)
    for (int foot = 0; foot < layout.foot_count(); ++foot)
      if (task.gait.in_contact(knot, foot)) {
        const double height =
            motion.foot_W(knot, foot).z() - objective.morphology().feet[foot].radius;
        quality.ground_error = std::max(quality.ground_error, std::abs(height));
      }
  return quality;
}

IterationMetrics iteration_metrics(const DesignSpace& space, const DesignIteration& iteration,
                                   int task, const PlanQuality& quality) {
  const TaskIterate& own = iteration.tasks.at(task);
  IterationMetrics metrics;
  metrics.index = iteration.index;
  metrics.F = own.value;
  metrics.J = own.outer_value;
  metrics.terms = by_term(own);
  metrics.s = by_name(space, iteration.s);
  metrics.planned_velocity = {quality.planned_velocity.x(), quality.planned_velocity.y()};
  metrics.speed_reached = quality.speed_reached;
  metrics.speed_wanted = quality.speed_wanted;
  metrics.heading_error = quality.heading_error;
  metrics.ground_error = quality.ground_error;
  metrics.slide_share = quality.slide_share;
  metrics.root_residual = quality.root_residual;
  metrics.design_gradient = by_name(space, own.design_gradient);
  metrics.projected_gradient_norm = iteration.projected_gradient_norm;
  metrics.newton_iterations = own.newton_iterations;
  metrics.motion_status = to_string(own.motion_status);
  return metrics;
}

DesignTexts design_texts(const RobotModel& robot, const Objective& objective,
                         const Eigen::VectorXd& s, const Eigen::VectorXd& m) {
  DesignTexts texts;
  texts.robot_xml = rewrite_robot(robot, s);
  const std::string played = in_surroundings(robot, texts.robot_xml, objective.task());
  const PlayablePlan plan = make_playable(robot, played, objective, m);
  texts.quality = plan_quality(objective, s, m);
  texts.quality.root_residual = plan.root_residual;
  SceneSettings scene;
  scene.trajectory = plan.trajectory;
  scene.period = objective.task().gait.period();
  scene.travel = plan.travel;
  scene.turn = plan.turn;
  scene.start_qpos = plan.start_qpos;
  scene.start_qvel = plan.start_qvel;
  scene.floor_friction = objective.task().floor_friction;
  texts.scene_xml = emit_scene(with_task_servos(robot, objective.task()), played, scene);
  texts.motion_csv = plan.motion_csv;
  return texts;
}

PlanQuality write_design(const fs::path& folder, const RobotModel& robot,
                         const Objective& objective, const DesignIteration& iteration, int task,
                         Durability durability) {
  const DesignTexts texts = design_texts(robot, objective, iteration.s, iteration.tasks.at(task).m);
  UnfinishedFolder temporary(folder);
  write_robot_files(temporary.path(), robot.files.with_text(texts.robot_xml), durability);
  write_file(temporary.path() / "scene.xml", texts.scene_xml, durability);
  write_file(temporary.path() / "motion.csv", texts.motion_csv, durability);
  write_json(temporary.path() / "metrics.json",
             json_of(iteration_metrics(robot.space, iteration, task, texts.quality)), durability);
  temporary.appear();
  if (durability == Durability::power) sync_folder(folder.parent_path());
  return texts.quality;
}

}  // namespace legwright
