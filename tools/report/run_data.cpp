// SPDX-License-Identifier: Apache-2.0
#include "tools/report/run_data.hpp"

#include <fmt/format.h>

#include "mjcf/text/safe_path.hpp"
#include "tools/files/io_error.hpp"
#include "tools/report/if_present.hpp"
#include "tools/report/words.hpp"
#include "tools/run/motion_csv.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace fs = std::filesystem;

namespace {

/// The robot, and its task or the name of a joint run.
std::string title_of(const RunRecord& run) {
  const std::string task = run.task ? run.task->name : run.name.value_or("");
  const bool both = !run.robot.empty() && !task.empty();
  const std::string title = run.robot + (both ? " · " : "") + spaced(task);
  return title.empty() ? "Legwright run" : title;
}

}  // namespace

fs::path RunData::iteration(int index) const {
  return root / "iterations" / fmt::format("{:04}", index);
}

RunData read_run(const fs::path& root) {
  RunData data;
  data.root = root;
  data.run = read_record_file<RunRecord>(ResultFolder::open(root).run_json());
  data.title = title_of(data.run);
  if_present(root / "events.jsonl", data.notes, [&](const fs::path& file) {
    Iterations found = read_iterations(file);
    data.iterations = std::move(found.single);
    data.joint_iterations = std::move(found.joint);
  });
  const fs::path result = root / "result";
  static_cast<JudgedData&>(data) = read_judged(root, data.notes);
  if (data.run.joint()) data.sums = sums_of_joint_run(root, data.run);
  if_present(result / "certificate.json", data.notes, [&](const fs::path& file) {
    data.certificate = read_record_file<CertificateRecord>(file);
  });
  if_present(result / "matrix.json", data.notes, [&](const fs::path& file) {
    MatrixRecord matrix = read_record_file<MatrixRecord>(file);
    data.of_another = standing_of(matrix.of, data.sums) == Standing::of_another;
    refuse_of_another(file, matrix.of, data.sums);
    data.without_sums = !matrix.of;
    for (const auto& [verdict, sum] : matrix.with.value_or(JudgedSums()))
      if (!names_bytes(*matrix.with, verdict, root / path_below(verdict)))
        throw IoError(file.string() + ": not of the verdicts of its tasks: judge again");
    data.matrix = std::move(matrix);
  });
  if_present(result / "front.json", data.notes,
             [&](const fs::path& file) { data.front = read_record_file<FrontRecord>(file); });
  if_present(result / "strength.json", data.notes,
             [&](const fs::path& file) { data.strength = read_record_file<StrengthRecord>(file); });
  if_present(data.iteration(0) / "motion.csv", data.notes,
             [&](const fs::path& file) { data.initial_plan = read_motion_csv(file); });
  if_present(result / "motion.csv", data.notes,
             [&](const fs::path& file) { data.result_plan = read_motion_csv(file); });
  return data;
}

bool motion_only(const RunData& data) { return data.run.motion_only; }

}  // namespace legwright
