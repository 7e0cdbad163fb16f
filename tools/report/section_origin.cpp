// SPDX-License-Identifier: Apache-2.0
// Where the numbers come from: sizes, times, versions, hashes.
#include <fmt/format.h>

#include "tools/report/number_words.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

void add_origin_row(Html& page, const std::string& name, const std::string& value,
                    bool code = false) {
  page.open("tr").element("td", name).open("td");
  if (code) {
    page.element("code", value);
  } else {
    page.text(value);
  }
  page.close().close();
}

void add_numbers(Html& page, const RunRecord& run) {
  const auto whole = [](std::optional<int> value) {
    return value ? fmt::format("{}", *value) : std::string("–");
  };
  add_origin_row(page, "status", spaced(run.status));
  add_origin_row(page, "unknowns",
                 fmt::format("{} of the body, {} of the motion", run.design_size, run.motion_size));
  add_origin_row(page, "iterations",
                 whole(run.design_iterations) + " of the body, " + whole(run.newton_iterations) +
                     " Newton steps of the motion");
  std::string seconds;
  if (run.seconds)
    for (const auto& [phase, value] : *run.seconds)
      seconds += fmt::format("{}{} {}", seconds.empty() ? "" : ", ", phase, short_number(value));
  if (!seconds.empty()) add_origin_row(page, "seconds", seconds);
  if (run.peak_rss_mib)
    add_origin_row(page, "largest memory", fmt::format("{:.0f} MiB", *run.peak_rss_mib));
}

}  // namespace

void add_origin(Html& page, const RunData& data) {
  page.open("section").element("h2", "Where this comes from");
  page.open("div", {{"class", "scroll"}}).open("table", {{"class", "origin"}}).open("tbody");
  add_numbers(page, data.run);
  for (const auto& [name, value] : data.run.versions) add_origin_row(page, name, value);
  for (const auto& [name, value] : data.run.sha256)
    add_origin_row(page, "SHA-256 of " + name, value, true);
  add_origin_row(page, "command", fmt::format("{}", fmt::join(data.run.argv, " ")), true);
  page.close().close().close();
  add_notes(page, data);
  page.close();
}

}  // namespace legwright
