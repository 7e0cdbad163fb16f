// SPDX-License-Identifier: Apache-2.0
#include "tools/report/run_data.hpp"

#include <fmt/format.h>

#include "tools/report/if_present.hpp"
#include "tools/report/words.hpp"
#include "tools/run/motion_csv.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace fs = std::filesystem;

fs::path RunData::iteration(int index) const {
  return root / "iterations" / fmt::format("{:04}", index);
}

RunData read_run(const fs::path& root) {
  RunData data;
  data.root = root;
  data.run = read_record_file<RunRecord>(ResultFolder::open(root).run_json());
  if_present(root / "events.jsonl", data.notes, [&](const fs::path& file) {
    Iterations found = read_iterations(file);
    data.iterations = std::move(found.single);
    data.joint_iterations = std::move(found.joint);
  });
  const fs::path result = root / "result";
  static_cast<JudgedData&>(data) = read_judged(result, data.notes);
  if_present(result / "certificate.json", data.notes, [&](const fs::path& file) {
    data.certificate = read_record_file<CertificateRecord>(file);
  });
  if_present(data.iteration(0) / "motion.csv", data.notes,
             [&](const fs::path& file) { data.initial_plan = read_motion_csv(file); });
  if_present(result / "motion.csv", data.notes,
             [&](const fs::path& file) { data.result_plan = read_motion_csv(file); });
  return data;
}

std::string title_of(const RunData& data) {
  const std::string &robot = data.run.robot, task = data.run.task ? data.run.task->name : "";
  const std::string title = robot.empty()  ? task
                            : task.empty() ? robot
                                           : robot + " · " + spaced(task);
  return title.empty() ? "Legwright run" : title;
}

bool motion_only(const RunData& data) { return data.run.motion_only; }

}  // namespace legwright
