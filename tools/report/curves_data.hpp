// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/report/judged_data.hpp"
#include "tools/report/parameter_view.hpp"

namespace legwright {

/// What one roll-out of a run's result measured. Absent: it fell before it could be measured.
struct CurveSample {
  std::optional<double> speed;  // along the wanted direction [m/s]; none where it fell
  std::optional<double> speed_ratio, tilt, saturated_share;  // over wanted; [rad]; of the time
  double touch_share = 0.0;                                  // of the time with limbs in contact
  int touch_count = 0;
  std::optional<double> fall_time;  // [s]
};

/// One validated run: a wanted speed and what became of it.
struct CurvePoint {
  std::filesystem::path run;
  double wanted = 0.0;   // [m/s]
  double cost = 0.0;     // F of the result
  double optimum = 0.0;  // of the optimum of F, which it is unless MuJoCo had another chosen
  bool pass = false;
  std::vector<std::string> reasons;  // why not
  std::array<CurveSample, 3> at_gains;
  std::vector<ParameterView> parameters;

  const CurveSample& at_default() const { return at_gains[1]; }
  /// The largest over the gains of what a sample holds; none where no gain has it.
  std::optional<double> worst(std::optional<double> CurveSample::*value) const;
  bool touches() const;
  bool falls() const;
};

/// Runs that were made in the same way, by rising wanted speed.
struct CurveVariant {
  std::string name;
  bool motion_only = false;
  std::vector<CurvePoint> points;
};

struct Curves {
  std::string robot, way;  // way: of the task, "tripod forward"
  std::vector<CurveVariant> variants;
};

/// A variant that the user named, with its runs.
struct NamedRuns {
  std::string name;
  std::vector<std::filesystem::path> runs;
};

/// Reads validated runs of one robot and groups them: `loose` by what they are ("co-designed",
/// "motion only", and without which terms of F), `named` as they are told. Least worked variant
/// first. Throws InputError where they do not belong together or are not validated, IoError where
/// there is no run.
Curves read_curves(const std::vector<std::filesystem::path>& loose,
                   const std::vector<NamedRuns>& named);

}  // namespace legwright
