// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/verdict_record.hpp"
#include "tools/validate/measure.hpp"

namespace legwright {

/// What passes, both ends included; an absent one lets everything pass.
struct Bounds {
  std::optional<double> low, high;
  bool by_file = false;             // a limits file asks for it; else it holds by default
  int low_line = 0, high_line = 0;  // of that file, where it gives them

  bool any() const { return low || high; }
};

/// Bounds by the name of the quantity (limits file: README.md). What is not in it is not judged.
using Limits = std::map<std::string, Bounds>;

/// How the values of a quantity are told.
enum class Told { plain, thousandths, percent };

/// Something that is measured in a roll-out and that a limit may be set on.
struct LimitedQuantity {
  std::string name, what, unit;
  std::string verb;  // "reaches", before the value in a reason
  std::string note;  // after it, before what would pass; may be empty
  Told told = Told::plain;
  bool below = false;  // the upper bound itself does not pass
  double least = 0.0;  // that it can be; what is counted or has no sign is not below nothing
  double most = 1e9;
  Bounds by_default = {};  // none: judged only where the limits file asks for it
  /// Whether the task asks for it.
  std::function<bool(const WantedMotion&)> asked = [](const WantedMotion&) { return true; };
  /// Absent where it could not be measured: that never passes.
  std::function<std::optional<double>(const Measurements&)> value;
  /// Whose value it is, the worst first; none where it is the whole robot's.
  std::function<std::vector<WorstPart>(const Measurements&)> worst = [](const Measurements&) {
    return std::vector<WorstPart>{};
  };
};

/// All of them, in the order in which they are judged.
const std::vector<LimitedQuantity>& limited_quantities();

/// The bounds that hold where the limits file says nothing.
Limits default_limits();
/// The same, and what a task asks for: that every foot passes over a bar of this height [m].
/// Nothing for 0; a limits file that names a low of its own has the say.
Limits with_step_over(Limits limits, double height);

/// A value that is no number lies in no bounds.
bool within(const std::optional<double>& value, const Bounds& bounds, bool below = false);

/// A value against its limit: a row of verdict.json, a JUnit case, a line of the report.
struct JudgedLimit {
  std::string name, what, unit;
  Bounds bounds;
  std::optional<double> value;  // the worst; absent where it could not be measured
  std::string where;            // "half gains", where that is
  bool pass = false;
  std::string reason;                 // why it fails, as a sentence; empty if it passes
  bool strict = false;                // the upper bound itself does not pass
  std::vector<WorstPart> worst = {};  // at those gains, the worst first
};

/// Each asked quantity that has bounds, over all roll-outs that came to their end.
std::vector<JudgedLimit> judge_limits(const std::vector<Measurements>& at_gains,
                                      const WantedMotion& wanted, const Limits& limits);

/// "half", "default", "double", or the number.
std::string gain_name(double scale);
/// "0.95 to 1.05 m passes", "less than 0.1 rad passes", "at least 0 and less than 0.1 rad passes";
/// percent and its plural where it is told so. @param below the upper bound itself does not pass
std::string what_passes(const Bounds& bounds, const std::string& unit, Told told, bool below);

}  // namespace legwright
