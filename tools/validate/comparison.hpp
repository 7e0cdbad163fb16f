// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/motion/path.hpp"
#include "tools/validate/compared_rows.hpp"
#include "tools/validate/foot_touch.hpp"
#include "tools/validate/inverse_dynamics.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/phase_curves.hpp"

namespace legwright {

/// A quantity of the whole robot over the cycle.
struct NamedCurve {
  std::string name, label, unit;
  Curve curve;
};

/// Mean and largest magnitude over the stances of a foot.
struct MeanAndWorst {
  double mean = 0.0, worst = 0.0;
};

struct FootComparison {
  std::string name;
  Curve normal, tangential;         // force of the ground [N]
  Curve height;                     // of its lowest point above the ground [m]
  Curve slip_speed;                 // [m/s]; 0 in the air
  Curve friction;                   // tangential over normal force; 0 where the foot does not stand
  Curve contact;                    // share of the time
  MeanAndWorst touchdown, liftoff;  // actual minus planned time [s]: positive is late
  MeanAndWorst landing_speed, slip;  // [m/s], [m]
  MeanAndWorst roll;                 // angle by which the foot rolled in a stance [rad]
  double slip_planned = 0.0, roll_planned = 0.0;
};

struct JointComparison {
  std::string name;
  Curve angle, torque, power;  // [rad], [N m] (planned: feed-forward), [W]
  double torque_limit = 0.0;   // [N m], infinite if there is none
};

struct CycleComparison {
  int cycle = 0;
  std::optional<double> speed_ratio, turn_ratio;  // over what the task wants
  double heading = 0.0;                           // at its end, less what the plan has there [rad]
  double tilt_max = 0.0;                          // [rad]
  double power = 0.0;                             // positive, of all joints, mean [W]
  std::optional<double> cost_of_transport;
  double saturated_share = 0.0;  // of the time with any servo at its limit
};

/// The plan beside what physics made of it. Frames: x ahead and y to the left of the heading, which
/// is the trunk's at the start of each cycle and turns with the plan.
struct Comparison {
  double gain_scale = 1.0;
  int first_cycle = 0, last_cycle = 0;  // whose curves are taken in
  double period = 0.0;                  // [s]
  Eigen::VectorXd phases;               // centres of the bins, share of the period
  std::vector<NamedCurve> curves;
  std::vector<FootComparison> feet;
  std::vector<JointComparison> joints;
  std::vector<CycleComparison> cycles;                       // all complete ones
  std::vector<Eigen::Vector2d> planned_path, measured_path;  // of the COM, world [m]
  std::vector<HealthWarning> warnings;
  InverseDynamics inverse_dynamics;
};

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
  std::vector<Eigen::Vector2d> planned_path_, measured_path_;
};

}  // namespace legwright
