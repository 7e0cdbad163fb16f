// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/report/number_words.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

/// "front_hip_axis_yaw" → "front hip axis yaw".
std::string spaced(std::string_view name);
/// ": hip yaw, length and width" of up to six names, spaced; empty of none or more.
std::string named_if_few(const std::vector<std::string>& names);
/// What a factor or a run of numerics is called; its name, spaced, where it has no label.
template <class Row>
std::string label_of(const Row& row) {
  return row.label.empty() ? spaced(row.name) : row.label;
}
/// A term of F in a few words; its own name, spaced, where it is not known here.
std::string term_words(const std::string& name);
/// What a term of F punishes, as a noun: "slip of stance feet"; its own name, spaced, where it is
/// not known here.
std::string cost_words(const std::string& name);
/// What the task asks for: "walk, 0.1 m/s to the left, period 1 s".
std::string task_words(const RunRecord& run);
/// The same of a run.json's "task" or of one of its "tasks".
std::string way_words(const TaskRecord& task);

/// What was done to the robot: "body and gait co-designed".
std::string result_words(const RunRecord& run);

}  // namespace legwright
