// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/files/escape.hpp"

namespace legwright {
namespace {

std::string shortest_number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "not measured";
}

/// "largest tilt of the trunk: 0.04 rad (half gains), less than 0.1"; "at least 0.95, at most 1.05"
std::string facts(const JudgedLimit& row) {
  std::string out = row.what + ": " + shortest_number(row.value);
  if (row.unit != "1" && row.value) out += " " + row.unit;
  if (!row.where.empty()) out += " (" + row.where + ")";
  if (row.bounds.low) out += ", at least " + shortest_number(row.bounds.low);
  if (row.bounds.high)
    out += (row.strict ? ", less than " : ", at most ") + shortest_number(row.bounds.high);
  return out;
}

std::string case_xml(const std::string& suite, const JudgedLimit& row) {
  const std::string head = fmt::format("    <testcase classname=\"legwright.{}\" name=\"{}\"",
                                       escape_attribute(suite), escape_attribute(row.name));
  if (row.pass)
    return fmt::format("{}>\n      <system-out>{}</system-out>\n    </testcase>\n", head,
                       escape_text(facts(row)));
  const std::string message =
      row.reason.empty() ? "not measured: the robot did not get that far" : row.reason;
  return fmt::format(
      "{}>\n      <failure type=\"limit\" message=\"{}\">{}</failure>\n    </testcase>\n", head,
      escape_attribute(message), escape_text(facts(row)));
}

/// "of result/scene.xml": its SHA-256, and so on.
std::string properties_xml(const JudgedSums& of) {
  std::string out;
  for (const auto& [name, sum] : of)
    out += fmt::format("      <property name=\"of {}\" value=\"{}\"/>\n", escape_attribute(name),
                       escape_attribute(sum));
  return out.empty() ? "" : "    <properties>\n" + out + "    </properties>\n";
}

}  // namespace

std::string junit_xml(const std::vector<JunitSuite>& suites) {
  std::string body;
  std::size_t all = 0, all_failures = 0;
  for (const auto& suite : suites) {
    const auto& rows = suite.verdict.limits;
    const auto failures = static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [](const auto& row) { return !row.pass; }));
    body += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
                        escape_attribute(suite.name), rows.size(), failures);
    body += properties_xml(suite.of);
    for (const auto& row : rows) body += case_xml(suite.name, row);
    body += fmt::format("    <system-out>{}</system-out>\n  </testsuite>\n",
                        escape_text(suite.verdict.line));
    all += rows.size();
    all_failures += failures;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"legwright validate\" "
      "tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}</testsuites>\n",
      all, all_failures, body);
}

std::string junit_error_xml(const std::string& suite, const std::string& message) {
  const std::string name = escape_attribute(suite);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"legwright validate\" "
      "tests=\"1\" failures=\"0\" errors=\"1\">\n"
      "  <testsuite name=\"{0}\" tests=\"1\" failures=\"0\" errors=\"1\">\n"
      "    <testcase classname=\"legwright.{0}\" name=\"judged\">\n"
      "      <error type=\"legwright\" message=\"{1}\">{2}</error>\n"
      "    </testcase>\n  </testsuite>\n</testsuites>\n",
      name, escape_attribute(message), escape_text(message));
}

}  // namespace legwright
