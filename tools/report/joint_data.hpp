// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/report/number_words.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// One task of a joint run.
struct JointTaskData {
  std::string name;
  std::filesystem::path relative;  // tasks/NAME
  TaskRecord task;                 // its entry in run.json
  std::optional<RunData> run;      // nothing where its folder cannot be read
};

/// A design of the matrix: its parameters and what it costs in each task.
struct MatrixDesign {
  std::string name;
  ByName<double> s;                         // by parameter
  std::vector<std::optional<double>> cost;  // F, in the order of the tasks
  // Of matrix.json, in the order of the tasks; none before validate.
  std::vector<std::optional<MatrixCellRecord>> cells;
};

/// What a joint run holds, read for a report as leniently as a single one.
struct JointData {
  RunData whole;
  std::vector<JointTaskData> tasks;
  std::vector<MatrixDesign> designs;  // the initial body, each task's own, the common one

  /// Whether matrix.json is there.
  bool judged() const { return whole.matrix.has_value(); }
  /// Points of result/front.json; none where it was not asked for.
  std::vector<FrontPointRecord> front() const {
    return whole.front ? whole.front->points : std::vector<FrontPointRecord>{};
  }
};

/// Reads the tasks of a joint run (RunRecord::joint). Throws InputError where they lie outside.
JointData joint_data_of(RunData whole);

/// A relative path as an address: percent signs for all that is not plain.
std::string href_of(const std::filesystem::path& relative);

}  // namespace legwright
