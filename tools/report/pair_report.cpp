// SPDX-License-Identifier: Apache-2.0
#include "tools/report/pair_report.hpp"

#include <fmt/format.h>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/report/page_parts.hpp"

namespace legwright {
namespace {

RunData read_single(const std::filesystem::path& root) {
  RunData data = read_run(root);
  if (!data.run.joint()) return data;
  std::string folders;
  for (const TaskRecord& task : *data.run.tasks)
    if (task.folder)
      folders += fmt::format("{}{}", folders.empty() ? "" : ", ",
                             clean_utf8((root / *task.folder).generic_string()));
  throw InputError(fmt::format(
      "{}: found a joint run of several tasks, expected runs of one task; name a task's folder "
      "instead: {}",
      root.generic_string(), folders));
}

/// The last part of a path, as it may stand in a file's name.
std::string plain_name(const std::filesystem::path& folder) {
  std::filesystem::path normal = std::filesystem::absolute(folder).lexically_normal();
  if (!normal.has_filename()) normal = normal.parent_path();
  std::string name = normal.filename().generic_string();
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '-' || c == '_';
    if (!plain) c = '_';
  }
  return name.empty() ? "other" : name.substr(0, 80);
}

}  // namespace

RunPair read_pair(const std::filesystem::path& a, const std::filesystem::path& b) {
  return {read_single(a), read_single(b)};
}

std::filesystem::path pair_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  return a / fmt::format("compare_{}.html", plain_name(b));
}

std::string pair_page(const RunPair& pair) {
  const std::string &a = pair.a.title, &b = pair.b.title;
  PageFrame frame;
  frame.title = a == b ? a + ", two runs" : "A: " + a + ", B: " + b;
  frame.line = "Two runs of Legwright side by side";
  frame.footer =
      "Made by legwright report from the files of these runs; nothing is fetched from elsewhere.";
  frame.island = {{"schema", "legwright/report-pair"}, {"version", 1}};
  for (const auto& [name, run] : {std::pair{"a", &pair.a}, {"b", &pair.b}}) {
    frame.island[name] = island_of(*run);
    frame.island[name]["verdict"] = run->verdict ? json_of(*run->verdict) : Json();
  }
  return framed_page(frame, [&](Html& page) {
    add_pair_verdicts(page, pair);
    add_pair_pictures(page, pair);
    add_pair_numbers(page, pair);
    add_pair_bodies(page, pair);
    add_pair_limits(page, pair);
    add_pair_margins(page, pair);
    add_pair_terms(page, pair);
    add_pair_origin(page, pair);
  });
}

std::filesystem::path write_pair_report(const std::filesystem::path& a,
                                        const std::filesystem::path& b,
                                        const std::filesystem::path& output) {
  std::filesystem::path file = output.empty() ? pair_file(a, b) : output;
  const RunPair pair = read_pair(a, b);
  const std::string page = pair_page(pair);
  for (const RunData* run : {&pair.a, &pair.b})
    check_unchanged(run->root, run->sums, sums_of_run(run->root), "write the report");
  write_file(file, page);
  return file;
}

}  // namespace legwright
