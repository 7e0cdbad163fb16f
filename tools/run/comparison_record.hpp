// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics_record.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// One quantity over the cycle, a number for each phase bin: what was planned, and of the played
/// cycles the mean and the extremes of their means within the bin.
struct Curve {
  std::optional<Eigen::VectorXd> planned;
  Eigen::VectorXd mean, low, high;
};

/// A quantity of the whole robot over the cycle.
struct NamedCurve {
  std::string name, label, unit;
  Curve curve;
};

/// Mean and largest magnitude over the stances of a foot, and what the plan itself does where that
/// is known.
struct MeanAndWorst {
  double mean = 0.0, worst = 0.0;
  std::optional<double> planned = {};
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
};

struct JointComparison {
  std::string name;
  Curve angle, torque, power;  // [rad], [N m] (planned: feed-forward), [W]
  double torque_limit = 0.0;   // [N m], not finite if there is none
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

/// What MuJoCo's own equations of motion say of a plan before anything is played: how much force
/// and torque the played motion needs at the trunk beyond gravity and planned contact forces, where
/// nothing can give it, and how near the contact forces come to their limits. Phases are shares of
/// the period.
struct InverseDynamics {
  double force_max = 0.0, force_rms = 0.0;    // residual force, share of the weight
  double torque_max = 0.0, torque_rms = 0.0;  // residual torque, share of weight × trunk height
  double worst_phase = 0.0;                   // of the residual force
  Eigen::VectorXd force;                      // residual at the bins' centres, share of the weight

  double friction_max = 0.0;  // tangential over normal planned force
  double friction_coefficient = 0.0;
  std::string friction_foot;
  double friction_phase = 0.0;
  double normal_min = 0.0;        // [N], of feet that the plan has on the ground
  double normal_min_share = 0.0;  // of the weight
  std::string normal_foot;
  double normal_phase = 0.0;
};

/// Of the COM, world [m].
struct ComparedPaths {
  std::vector<Eigen::Vector2d> planned, measured;
};

/// The plan beside what physics made of it. Frames: x ahead and y to the left of the heading, which
/// is the trunk's at the start of each cycle and turns with the plan.
struct Comparison {
  double gain_scale = 1.0;
  std::pair<int, int> cycles{0, 0};  // first and last whose curves are taken in
  double period = 0.0;               // [s]
  Eigen::VectorXd phases;            // centres of the bins, share of the period
  std::vector<NamedCurve> curves;
  std::vector<FootComparison> feet;
  std::vector<JointComparison> joints;
  std::vector<CycleComparison> cycle_table;  // all complete ones
  ComparedPaths paths;
  std::vector<HealthWarning> warnings;
  InverseDynamics inverse_dynamics;
};

/// result/comparison.json: plan against physics over the cycle; nothing of a design that fell
/// before two cycles.
struct ComparisonRecord {
  static constexpr RecordKind kKind{"legwright/comparison", 1, "validate"};
  std::optional<Comparison> initial, result;
  std::optional<JudgedSums> of = {};
};

void fields(Fields& f, ComparisonRecord& comparison);

/// Reads the file and checks that all curves of a design are as long as its phases. Throws as
/// read_record_file.
ComparisonRecord read_comparison(const std::filesystem::path& file);

/// Curves and paths rounded to six digits, because hundreds of numbers for each quantity are for
/// looking at.
Comparison rounded_curves(Comparison comparison);

}  // namespace legwright
