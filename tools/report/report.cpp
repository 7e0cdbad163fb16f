// SPDX-License-Identifier: Apache-2.0
#include "tools/report/report.hpp"

#include <utility>

#include "tools/files/atomic_file.hpp"

namespace legwright {

std::vector<std::filesystem::path> write_report(const std::filesystem::path& run) {
  RunData data = read_run(run);
  const RunRecord record = data.run;
  const JudgedSums before = data.sums;
  const auto write = [&](const std::filesystem::path& folder, const std::string& page,
                         const std::string& summary) {
    check_unchanged(run, before, sums_of(run, record), "write the report");
    write_file(folder / "report.html", page);
    std::filesystem::create_directories(folder / "result");
    write_file(folder / "result" / "summary.md", summary);
    return folder / "report.html";
  };
  if (!data.run.joint()) return {write(run, report_page(data), report_summary(data))};
  const JointData joint = joint_data_of(std::move(data));
  std::vector<std::filesystem::path> pages{
      write(run, joint_report_page(joint), joint_report_summary(joint))};
  for (const JointTaskData& task : joint.tasks) {
    if (task.run)
      pages.push_back(
          write(run / task.relative, report_page(*task.run), report_summary(*task.run)));
  }
  return pages;
}

}  // namespace legwright
