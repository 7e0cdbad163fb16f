// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/validate/limits.hpp"
#include "tools/validate/robustness.hpp"

namespace legwright {

/// For a terminal, without line breaks at the ends: one line per factor, then the survival share.
std::vector<std::string> robustness_lines(const Robustness& robustness);

/// What the name of a factor's limit starts with.
inline constexpr const char* kMarginPrefix = "margin.";

/// "survival", and "margin.NAME" for each factor: what the limits file calls them.
std::vector<std::string> robustness_limit_names();
/// Those of them that have bounds. A margin's low bound is a value down to which, its high bound
/// one up to which it must walk.
std::vector<JudgedLimit> judge_robustness(const Robustness& robustness, const Limits& limits);
/// How far factors must be tried for these limits to be judged.
std::map<std::string, std::pair<double, double>> tested_for(const Limits& limits);

}  // namespace legwright
