// SPDX-License-Identifier: Apache-2.0
// Where the numbers come from: sizes, times, versions, hashes.
#include <fmt/format.h>

#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

std::string shown(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return short_number(value.get<double>());
  if (!value.is_array()) return to_text(value);
  std::string out;
  for (const Json& part : value) out += fmt::format("{}{}", out.empty() ? "" : " ", shown(part));
  return out;
}

void add_row(Html& page, const std::string& name, const std::string& value, bool code = false) {
  page.open("tr").element("td", name).open("td");
  if (code) {
    page.element("code", value);
  } else {
    page.text(value);
  }
  page.close().close();
}

void add_numbers(Html& page, const RunData& data) {
  const auto whole = [&](const char* key) {
    const auto value = number_at(data.run, {key});
    return value ? fmt::format("{:.0f}", *value) : std::string("–");
  };
  add_row(page, "status", spaced(text_at(data.run, {"status"})));
  add_row(page, "unknowns",
          whole("design_size") + " of the body, " + whole("motion_size") + " of the motion");
  add_row(page, "iterations",
          whole("design_iterations") + " of the body, " + whole("newton_iterations") +
              " Newton steps of the motion");
  std::string seconds;
  const Json& phases = value_at(data.run, {"seconds"});
  if (phases.is_object()) {
    for (const auto& [phase, value] : phases.items()) {
      if (value.is_number())
        seconds += fmt::format("{}{} {}", seconds.empty() ? "" : ", ", phase,
                               short_number(value.get<double>()));
    }
  }
  if (!seconds.empty()) add_row(page, "seconds", seconds);
  const auto memory = number_at(data.run, {"peak_rss_mib"});
  if (memory) add_row(page, "largest memory", fmt::format("{:.0f} MiB", *memory));
}

}  // namespace

void add_origin(Html& page, const RunData& data) {
  page.open("section").element("h2", "Where this comes from");
  page.open("div", {{"class", "scroll"}}).open("table", {{"class", "origin"}}).open("tbody");
  add_numbers(page, data);
  const Json& versions = value_at(data.run, {"versions"});
  if (versions.is_object()) {
    for (const auto& [name, value] : versions.items()) add_row(page, name, shown(value));
  }
  const Json& hashes = value_at(data.run, {"sha256"});
  if (hashes.is_object()) {
    for (const auto& [name, value] : hashes.items())
      add_row(page, "SHA-256 of " + name, shown(value), true);
  }
  const Json& argv = value_at(data.run, {"argv"});
  if (argv.is_array()) add_row(page, "command", shown(argv), true);
  page.close().close().close();
  for (const std::string& note : data.notes) {
    page.open("p", {{"class", "hint"}}).text("Could not be used: " + note).close();
  }
  page.close();
}

}  // namespace legwright
