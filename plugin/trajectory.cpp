// SPDX-License-Identifier: Apache-2.0
#include "plugin/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "plugin/number_text.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr int kFewestKnots = 4;  // the support of a cubic B-spline
constexpr int kMostKnots = 10000;
constexpr int kMostColumns = 10000;
constexpr std::size_t kLongestName = 200;
constexpr double kTimeTolerance = 1e-6;                         // share of the period
constexpr double kShortestPeriod = 1e-6, kLongestPeriod = 1e6;  // s

constexpr std::array<const char*, 6> kRootColumns = {"root_x_m",    "root_y_m",    "root_z_m",
                                                     "root_rx_rad", "root_ry_rad", "root_rz_rad"};
constexpr std::array<const char*, 3> kComColumns = {"com_x_m", "com_y_m", "com_z_m"};

template <typename... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
  throw TrajectoryError("trajectory: " + fmt::format(format, std::forward<Args>(args)...));
}

/// "row 3 (knot 2), column 1 (time_s)": the header is row 0, columns count from 1.
std::string place(const Trajectory& t, int knot, int column) {
  return fmt::format("row {} (knot {}), column {} ({})", knot + 1, knot, column + 1,
                     t.header()[static_cast<std::size_t>(column)]);
}

void check_names(const std::vector<std::string>& names, const char* kind) {
  for (const std::string& name : names) {
    const bool blank = std::any_of(name.begin(), name.end(), [](char c) {
      return static_cast<unsigned char>(c) <= ' ' || c == ';' || c == ',' || c == 0x7f;
    });
    if (name.empty()) fail("a {} without a name", kind);
    if (name.size() > kLongestName)
      fail("{} {}: longer than {} bytes", kind, quoted(name), kLongestName);
    if (blank)
      fail("{} {}: names with white space, ';' or ',' cannot be written; rename it", kind,
           quoted(name));
  }
  std::vector<std::string> sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) fail("{} {} is named twice", kind, quoted(*twice));
}

void check_sizes(const Trajectory& t) {
  check_names(t.joint_names, "joint");
  check_names(t.foot_names, "foot");
  if (t.joint_names.empty()) fail("no joint; expected a column q:JOINT_rad after time_s");
  if (t.joint_names.size() + t.foot_names.size() > kMostColumns ||
      t.column_count() > kMostColumns) {
    fail("more than {} columns", kMostColumns);
  }
  if (t.knot_count < kFewestKnots)
    fail("{} knots; expected at least {}", t.knot_count, kFewestKnots);
  if (t.knot_count > kMostKnots) fail("{} knots; expected at most {}", t.knot_count, kMostKnots);
}

void check_cycle(const Trajectory& t) {
  if (!(t.period >= kShortestPeriod && t.period <= kLongestPeriod)) {
    fail("period = {} s; expected {} to {}", t.period, kShortestPeriod, kLongestPeriod);
  }
  for (const double distance : t.travel) {
    if (!(std::abs(distance) <= kLargestNumber))
      fail("travel has {}; expected finite numbers", distance);
  }
  if (!(std::abs(t.turn) <= kLargestNumber)) fail("turn = {}; expected a finite number", t.turn);
}

void check_times(const Trajectory& t) {
  const double step = t.period / t.knot_count;
  for (int knot = 0; knot < t.knot_count; ++knot) {
    const double time = t.at(knot, 0);
    if (knot > 0 && !(time > t.at(knot - 1, 0))) {
      fail("{}: got {}, not later than the row before it ({})", place(t, knot, 0), time,
           t.at(knot - 1, 0));
    }
    if (!(std::abs(time - knot * step) <= kTimeTolerance * t.period)) {
      fail(
          "{}: got {}, expected {} ({} knots in uniform steps over a period of {} s, the first at "
          "0)",
          place(t, knot, 0), time, knot * step, t.knot_count, t.period);
    }
  }
}

void check_values(const Trajectory& t) {
  for (int knot = 0; knot < t.knot_count; ++knot) {
    for (int column = 0; column < t.column_count(); ++column) {
      if (!(std::abs(t.at(knot, column)) <= kLargestNumber)) {
        fail("{}: got {}, expected a finite number", place(t, knot, column), t.at(knot, column));
      }
    }
    for (int foot = 0; foot < t.foot_count(); ++foot) {
      const double contact = t.at(knot, t.contact_column(foot));
      if (contact != 0.0 && contact != 1.0) {
        fail("{}: got {}, expected 0 or 1", place(t, knot, t.contact_column(foot)), contact);
      }
    }
  }
}

/// What stands between prefix and suffix, if the token has both and something between them.
std::optional<std::string> name_within(std::string_view token, std::string_view prefix,
                                       std::string_view suffix) {
  if (token.size() <= prefix.size() + suffix.size()) return std::nullopt;
  if (!token.starts_with(prefix) || !token.ends_with(suffix)) return std::nullopt;
  token.remove_prefix(prefix.size());
  token.remove_suffix(suffix.size());
  return std::string(token);
}

/// Finds the names of joints and feet in the header, then asks for exactly the header they imply.
void read_header(std::string_view row, Trajectory& t) {
  const std::vector<std::string_view> tokens = split_blanks(row);
  if (tokens.size() > static_cast<std::size_t>(kMostColumns))
    fail("more than {} columns", kMostColumns);
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    auto name = name_within(tokens[i], "q:", "_rad");
    const bool slides = !name;
    if (slides) name = name_within(tokens[i], "q:", "_m");
    if (!name) break;
    t.joint_names.push_back(*name);
    t.joint_slides.push_back(slides);
  }
  for (auto i = static_cast<std::size_t>(t.com_column(3)); i < tokens.size(); i += 7) {
    const auto name = name_within(tokens[i], "foot:", "_x_m");
    if (!name) break;
    t.foot_names.push_back(*name);
  }
  if (t.joint_names.empty() && !tokens.empty() && tokens[0] == "time_s") {
    fail("header, column 2: got {}, expected q:JOINT_rad",
         tokens.size() > 1 ? quoted(tokens[1]) : "the end of the row");
  }
  const std::vector<std::string> expected = t.header();
  for (std::size_t i = 0; i < std::min(tokens.size(), expected.size()); ++i) {
    if (tokens[i] != expected[i]) {
      fail("header, column {}: got {}, expected {}", i + 1, quoted(tokens[i]), quoted(expected[i]));
    }
  }
  if (tokens.size() < expected.size()) {
    fail("header: {} columns, the next should be {}", tokens.size(),
         quoted(expected[tokens.size()]));
  }
  if (tokens.size() > expected.size()) {
    fail("header, column {}: got {}, expected the end of the row or foot:NAME_x_m",
         expected.size() + 1, quoted(tokens[expected.size()]));
  }
}

void read_row(std::string_view row, Trajectory& t) {
  const std::vector<std::string_view> tokens = split_blanks(row);
  const int knot = t.knot_count;
  if (knot >= kMostKnots) fail("more than {} rows of numbers", kMostKnots);
  for (std::size_t i = 0; i < std::min(tokens.size(), static_cast<std::size_t>(t.column_count()));
       ++i) {
    const auto value = read_number(tokens[i]);
    if (!value) {
      fail("{}: got {}, expected a finite decimal number", place(t, knot, static_cast<int>(i)),
           quoted(tokens[i]));
    }
    t.table.push_back(*value);
  }
  if (tokens.size() != static_cast<std::size_t>(t.column_count())) {
    fail("row {} (knot {}): {} values, expected {} as in the header", knot + 1, knot, tokens.size(),
         t.column_count());
  }
  ++t.knot_count;
}

void append_row(std::string& text, std::span<const double> row, char separator) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) text += separator;
    fmt::format_to(std::back_inserter(text), "{}", row[i]);
  }
}

std::span<const double> row_of(const Trajectory& t, int knot) {
  return {&t.table[static_cast<std::size_t>(knot * t.column_count())],
          static_cast<std::size_t>(t.column_count())};
}

}  // namespace

std::vector<std::string> Trajectory::header() const {
  std::vector<std::string> names = {"time_s"};
  for (int j = 0; j < joint_count(); ++j)
    names.push_back("q:" + joint_names[static_cast<std::size_t>(j)] + (slides(j) ? "_m" : "_rad"));
  for (int j = 0; j < joint_count(); ++j)
    names.push_back("tau:" + joint_names[static_cast<std::size_t>(j)] + (slides(j) ? "_N" : "_Nm"));
  names.insert(names.end(), kRootColumns.begin(), kRootColumns.end());
  names.insert(names.end(), kComColumns.begin(), kComColumns.end());
  for (const std::string& foot : foot_names) {
    for (const char* const suffix : {"_x_m", "_y_m", "_z_m", "_fx_N", "_fy_N", "_fz_N"}) {
      names.push_back("foot:" + foot + suffix);
    }
    names.push_back("contact:" + foot);
  }
  return names;
}

Trajectory blank_trajectory(std::vector<std::string> joint_names,
                            std::vector<std::string> foot_names, int knot_count, double period) {
  Trajectory t;
  t.period = period;
  t.joint_names = std::move(joint_names);
  t.foot_names = std::move(foot_names);
  t.knot_count = knot_count;
  check_sizes(t);
  check_cycle(t);
  t.table.assign(static_cast<std::size_t>(knot_count) * static_cast<std::size_t>(t.column_count()),
                 0.0);
  for (int knot = 0; knot < knot_count; ++knot) t.at(knot, 0) = knot * period / knot_count;
  return t;
}

Trajectory parse_trajectory(std::string_view text, const CycleSettings& cycle) {
  if (text.size() > kMostBytes) fail("{} bytes; expected at most {}", text.size(), kMostBytes);
  Trajectory t;
  bool header_read = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(";\n"), text.size());
    const std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.find_first_not_of(" \t\r") == std::string_view::npos)
      continue;  // as between ";" and "\n"
    if (header_read) {
      read_row(row, t);
    } else {
      read_header(row, t);
      header_read = true;
    }
  }
  if (!header_read) fail("empty; expected a row of column names, then one row for each knot");
  check_sizes(t);
  t.travel = cycle.travel;
  t.turn = cycle.turn;
  // check_times finds times that do not fit this period.
  t.period = cycle.period.value_or(t.at(t.knot_count - 1, 0) / (t.knot_count - 1) * t.knot_count);
  if (!cycle.period && !(t.period > 0.0)) {
    fail("{}: got {}, expected times that rise from 0", place(t, t.knot_count - 1, 0),
         t.at(t.knot_count - 1, 0));
  }
  check_trajectory(t);
  return t;
}

void check_trajectory(const Trajectory& t) {
  check_sizes(t);
  check_cycle(t);
  const auto expected =
      static_cast<std::size_t>(t.knot_count) * static_cast<std::size_t>(t.column_count());
  if (t.table.size() != expected)
    fail("table of {} numbers, expected {}", t.table.size(), expected);
  check_values(t);
  check_times(t);
}

std::string write_trajectory(const Trajectory& t) {
  check_trajectory(t);
  std::string text = fmt::format("{}", fmt::join(t.header(), " "));
  for (int knot = 0; knot < t.knot_count; ++knot) {
    text += ";\n";
    append_row(text, row_of(t, knot), ' ');
  }
  return text;
}

std::string write_motion_csv(const Trajectory& t, std::span<const double> last_knot) {
  check_trajectory(t);
  const auto first = row_of(t, 0);
  std::vector<double> last(first.begin(), first.end());
  const auto move_on = [&last](int column, double distance) {
    last[static_cast<std::size_t>(column)] += distance;
  };
  move_on(0, t.period);
  move_on(t.root_column(5), t.turn);
  for (int axis = 0; axis < 3; ++axis) {
    const double distance = t.travel[static_cast<std::size_t>(axis)];
    move_on(t.root_column(axis), distance);
    move_on(t.com_column(axis), distance);
    for (int foot = 0; foot < t.foot_count(); ++foot) move_on(t.foot_column(foot, axis), distance);
  }
  if (last_knot.empty()) last_knot = last;
  if (last_knot.size() != last.size()) {
    fail("last knot of {} numbers, expected {}", last_knot.size(), last.size());
  }
  std::string text = fmt::format("{}\n", fmt::join(t.header(), ","));
  for (int knot = 0; knot <= t.knot_count; ++knot) {
    append_row(text, knot < t.knot_count ? row_of(t, knot) : last_knot, ',');
    text += '\n';
  }
  return text;
}

}  // namespace legwright
