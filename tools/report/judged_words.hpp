// SPDX-License-Identifier: Apache-2.0
// What validate found, in words that the page, the summary and the page of two runs share.
#pragma once

#include <string>
#include <vector>

#include "tools/report/judged_data.hpp"
#include "tools/report/words.hpp"

namespace legwright {

/// A verdict's line without what stands before its first colon, which a mark beside it says; angles
/// in degrees, too.
std::string verdict_details(const std::string& line);
/// A sentence of validate with its angles in degrees, as the tables of the report have them:
/// "tilt 0.6° (0.01 rad)".
std::string with_degrees(const std::string& sentence);
/// What a limit is of.
inline std::string label_of(const LimitRow& row) {
  return row.what.empty() ? spaced(row.name) : row.what;
}
/// "All 12 limits are kept."
std::string limits_kept(const std::vector<LimitRow>& rows);
/// What was measured against a limit: "98.2 %", "0.6°", "not measured".
std::string measured_words(const LimitRow& row);
/// "95 % … 105 %", "at most 20°", "none"
std::string bound_words(const LimitRow& row);
/// The unit in which a factor's values are told.
ShownUnit unit_of(const RobustnessFactor& factor);
/// "survives from 0.3 to 1.6"
std::string margin_words(const RobustnessFactor& factor);
/// "187 of 200 draws survived: 93.5 % (95 % interval 89.2 % … 96.2 %)."; empty without numbers.
std::string survival_words(const MonteCarlo& drawn);
/// Why there are no margins, if the gait fails undisturbed; empty otherwise.
std::string no_margins_words(const JudgedData& data);
/// One sentence on numerics.json; empty without.
std::string numerics_words(const NumericsRecord& numerics);
/// The engine as it is called: "Drake 1.51.1".
std::string engine_name(const EngineRecord& record);
/// One sentence on validation_drake.json: at which gains it passes and at which not, and why.
std::string engine_words(const EngineRecord& record);
/// What inverse dynamics says of the plan, in words.
std::string inverse_dynamics_words(const InverseDynamics& plan);

}  // namespace legwright
