// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/files/json_file.hpp"

namespace legwright {

/// What was planned and measured of one quantity over the cycle; NaN where there is no number.
struct Band {
  std::vector<double> planned;  // empty without a plan
  std::vector<double> mean, low, high;
};

/// A quantity of the whole robot over the cycle.
struct ComparedCurve {
  std::string name, label, unit;
  Band band;
};

/// Mean and worst over the strides of a foot, and what the plan itself does where that is known.
struct MeanWorst {
  std::optional<double> mean, worst, planned;
};

struct ComparedFoot {
  std::string name;
  Band force_normal, force_tangential, height;  // [N], [N], [m]
  Band slip_speed, friction_used;               // [m/s], [1]
  MeanWorst touchdown, liftoff;                 // actual minus planned time [s]
  MeanWorst landing_speed, slip, roll;          // [m/s], [m], [rad]
};

struct ComparedJoint {
  std::string name;
  Band angle, torque;           // [rad], [N m]
  std::optional<double> limit;  // of the torque [N m]
};

/// One side of result/comparison.json, checked: every curve is as long as `phases`.
struct ComparisonView {
  std::optional<double> first_cycle, last_cycle, period;  // [1], [1], [s]
  std::vector<double> phases;                             // share of the cycle
  std::vector<ComparedCurve> curves;
  std::vector<ComparedFoot> feet;
  std::vector<ComparedJoint> joints;
  std::vector<double> planned_x, planned_y, measured_x, measured_y;  // path seen from above [m]
  Json cycle_table, inverse_dynamics;                                // as they stand in the file
};

/// A side of comparison.json; nothing where it is null. What has another form, or is larger than a
/// page can show, is left out with a note.
std::optional<ComparisonView> comparison_of(const Json& document, const char* side,
                                            std::vector<std::string>& notes);

/// One factor of result/robustness.json.
struct RobustnessFactor {
  std::string name, label, unit;
  std::optional<double> nominal, low, high;     // low, high: the last values that walk
  std::optional<double> low_fails, high_fails;  // the first that do not
  double tested_low = 0.0, tested_high = 0.0;
  std::string low_cause, high_cause;
};
/// The factors that can be drawn; the others are noted.
std::vector<RobustnessFactor> factors_of(const Json& robustness, std::vector<std::string>& notes);

/// One row of verdict.json's "limits".
struct LimitRow {
  std::string name, what, unit, where;
  std::optional<double> low, high, value;
  bool pass = false;
  bool strict = false;  // a value equal to a bound does not keep it
};
/// The limits of a side ("initial" or "result"), failing ones first, otherwise in the order of the
/// file; without "pass" a row is left out with a note.
std::vector<LimitRow> limits_of(const Json& verdict, const char* side,
                                std::vector<std::string>& notes);

}  // namespace legwright
