// SPDX-License-Identifier: Apache-2.0
#include "plugin/trajectory.hpp"

#include <cstring>

#include "plugin/number_text.hpp"
#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"

namespace legwright::test {
namespace {

/// Takes `!PERIOD X Y Z TURN` and its line end off the text; words that are no numbers count as
/// none.
CycleSettings cut_settings(std::string_view& text) {
  CycleSettings cycle;
  if (!text.starts_with('!')) return cycle;
  const std::size_t end = std::min(text.find('\n'), text.size());
  const auto words = split_blanks(text.substr(1, end - 1));
  const auto number = [&](std::size_t k) {
    return k < words.size() ? read_number(words[k]) : std::nullopt;
  };
  cycle.period = number(0);
  for (std::size_t axis = 0; axis < 3; ++axis) cycle.travel[axis] = number(1 + axis).value_or(0.0);
  cycle.turn = number(4).value_or(0.0);
  text.remove_prefix(std::min(end + 1, text.size()));
  return cycle;
}

bool same_tables(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

bool fuzz_trajectory(std::string_view text) {
  const CycleSettings cycle = cut_settings(text);
  Trajectory read;
  try {
    read = parse_trajectory(text, cycle);
  } catch (const TrajectoryError& error) {
    promise_reason(error.what(), "trajectory: ");
    return false;
  }
  check_trajectory(read);
  const std::string written = write_trajectory(read);
  const Trajectory again = parse_trajectory(written, {read.period, read.travel, read.turn});
  promise(same_tables(again.table, read.table) && again.header() == read.header() &&
              again.knot_count == read.knot_count && again.period == read.period,
          "a trajectory is another when it is written and read again");
  promise(write_trajectory(again) == written, "the same trajectory is another text");
  promise(!write_motion_csv(read).empty(), "a table without rows");
  return true;
}

}  // namespace legwright::test
