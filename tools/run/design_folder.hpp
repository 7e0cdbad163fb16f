// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/codesign.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/run/iteration_record.hpp"

namespace legwright {

/// How well a plan does what the task asks for, from the plan alone.
struct PlanQuality {
  Eigen::Vector2d planned_velocity =
      Eigen::Vector2d::Zero();  // of the COM over the cycle, world x and y [m/s]
  double speed_reached =
      0.0;  // along the wanted direction and arc [m/s]; turning on the spot: of the turn [rad/s]
  double speed_wanted = 0.0;   // the same
  double turn_reached = 0.0;   // in the wanted direction, where the task turns [rad/s]
  double turn_wanted = 0.0;    // the same; zero where it does not
  double heading_error = 0.0;  // of the trunk from the wanted heading, largest [rad]
  double ground_error = 0.0;   // of a standing foot from the ground, largest [m]
  double slide_share = 0.0;    // distance that standing feet slide over that of the trunk
  double root_residual =
      0.0;  // root force that the plan does not explain, largest, share of the weight
};

/// All but the root residual, which write_design() knows.
PlanQuality plan_quality(const Objective& objective, const Eigen::VectorXd& s,
                         const Eigen::VectorXd& m);

/// metrics.json of an iteration's task: no times, so equal runs give equal bytes.
/// @param task of `iteration.tasks`
IterationMetrics iteration_metrics(const DesignSpace& space, const DesignIteration& iteration,
                                   int task, const PlanQuality& quality);

/// A design as texts, that of the robot as RobotFiles::text() has it, and the quality of its plan,
/// root residual included.
struct DesignTexts {
  std::string robot_xml, scene_xml, motion_csv;
  PlanQuality quality;
};
DesignTexts design_texts(const RobotModel& robot, const Objective& objective,
                         const Eigen::VectorXd& s, const Eigen::VectorXd& m);

/// Writes a complete, openable design: robot.xml with what it includes and its assets, scene.xml,
/// motion.csv, metrics.json. The folder
/// appears whole: written under a temporary name beside it, then renamed. Throws std::system_error
/// where the disk fails or the folder exists. @param task of `iteration.tasks`, the one that
/// `objective` belongs to. @return the quality of the plan, root residual
/// included.
PlanQuality write_design(const std::filesystem::path& folder, const RobotModel& robot,
                         const Objective& objective, const DesignIteration& iteration, int task,
                         Durability durability = Durability::power);

}  // namespace legwright
