// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/motion/path.hpp"
#include "tools/run/comparison_record.hpp"
#include "tools/validate/compared_rows.hpp"
#include "tools/validate/foot_touch.hpp"
#include "tools/validate/inverse_dynamics.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/phase_curves.hpp"

namespace legwright {

/// One line: "plan against physics: normal forces within 17 % of the weight (HR at phase 0.76), …".
std::string describe(const Comparison& comparison);

/// Watches a roll-out for comparison with its plan.
class ComparisonWatch {
 public:
  /// @param scene must outlive this @param settle_cycles left out of the curves where enough follow
  ComparisonWatch(const Scene& scene, const WantedMotion& wanted, int settle_cycles = 2);

  void observe(const RolloutSample& sample);
  /// @param measured in the same roll-out. Nothing where it ended before two complete cycles.
  std::optional<Comparison> finish(const Measurements& measured) const;

 private:
  struct Mark {                // the robot at the start of a cycle
    Eigen::Vector2d position;  // of its COM
    double yaw;
    double work;  // of its servos so far [J]
  };
  struct CycleSums {
    double tilt_max = 0.0;
    long long samples = 0, saturated = 0;
  };
  void start_cycle(int cycle, const Mark& now);
  CycleComparison row(const Mark& end) const;
  void derive(Eigen::MatrixXd& means) const;
  void watch_trunk(const mjData& data, double share);
  void watch_feet(const mjData& data, double share);
  void watch_joints(const mjData& data);
  void watch_path(double time, const Eigen::Vector2d& com);

  const Scene& scene_;
  const mjModel& model_;
  WantedMotion wanted_;
  WantedPath path_;
  int settle_cycles_;
  double weight_;
  ComparedRows rows_;
  Eigen::MatrixXd planned_;  // quantities × bins
  double planned_yaw_;       // of the trunk at the start of the plan
  PhaseCurves curves_;
  Eigen::VectorXd values_;  // of the present moment
  std::vector<FootTouch> touches_;
  int cycle_ = -1;  // that is being watched from its start; −1: none yet
  Mark mark_{};
  CycleSums sums_;
  double yaw_ = 0.0, work_ = 0.0;
  std::optional<Eigen::Vector3d> com_;  // a step ago
  Eigen::VectorXd qpos_, qvel_;         // at the sample's time: its data are one step ahead
  std::vector<CycleComparison> cycles_;
  ComparedPaths paths_;
};

}  // namespace legwright
