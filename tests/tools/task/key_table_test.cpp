// SPDX-License-Identifier: Apache-2.0
// The table of keys and the reader agree: what is listed is read as it is listed, and nothing else.
#include "tools/task/key_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/task/task_file.hpp"
#include "tools/task/task_table.hpp"

namespace legwright {
namespace {

using test::kPuppy;

/// Keys that others need, and what these need, in the order of the file's tables.
const std::map<std::string, std::string> kNeeded = {
    {"gait.touchdown", "gait.duty = 0.75\n"},
    {"gait.touchdown.FOOT", "gait.duty = 0.75\n"},
    {"payload.position", "payload.mass = 0.5\n"},
    {"payload.size", "payload.mass = 0.5\n"},
    {"servos.kd", "servos.kp = 80.0\n"},
    {"outer.weight", "outer.objective = \"mechanical_work\"\n"},
    {"limits.step_over", "limits.swing_height = 0.9\n"},
    {"limits.friction", "limits.floor_friction = 5.0\n"},
    {"limits.floor_friction", "limits.friction = 1e-9\n"},
    {"style.foot_heights.FOOT.weight", "style.foot_heights.FOOT.over_cycle = [0.0]\n"},
    {"style.joint_angles.JOINT.weight", "style.joint_angles.JOINT.over_cycle = [0.0]\n"}};

/// What the reader says of a task with this key; empty where it takes it.
std::string complaint(const TaskKey& key, const std::string& value) {
  const std::string path(key.path);
  const bool within = key.scope == KeyScope::task && key.table().empty();
  std::string text;
  for (const auto& [name, line] :
       std::map<std::string, std::string>{{"robot", "robot = \"robot.xml\"\n"},
                                          {"gait.name", "gait.name = \"walk\"\n"},
                                          {"gait.period", "gait.period = 1.0\n"},
                                          {"travel.velocity", "travel.velocity = [0.0, 0.1]\n"}})
    if (name != path) text = name == "robot" ? line + text : text + line;
  const auto needed = kNeeded.find(path);
  if (needed != kNeeded.end()) text += needed->second;
  if (path == "task") text = "robot = \"robot.xml\"\n";
  text += within ? "" : path + " = " + value + "\n";
  if (within) {  // the same task in a table of its own
    text = text.substr(text.find('\n') + 1);
    std::string moved = "robot = \"robot.xml\"\n[[task]]\nname = \"a\"\n" + text;
    text = moved + path + " = " + value + "\n";
  }
  try {
    (void)parse_task_tables(text, kPuppy / "x.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool is_number(KeyKind kind) { return kind == KeyKind::number || kind == KeyKind::integer; }

std::string shortest(double number) {
  std::array<char, 64> out{};
  const auto end = std::to_chars(out.data(), out.data() + out.size(), number).ptr;
  const std::string text(out.data(), end);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// A number as a value of that form.
std::string value_of(const KeyForm& form, double number) {
  const std::string text =
      form.kind == KeyKind::integer ? std::to_string(static_cast<int>(number)) : shortest(number);
  if (is_number(form.kind)) return text;
  if (form.kind == KeyKind::pairs) return "[[" + text + ", " + text + "]]";
  std::string list;
  for (std::size_t k = 0; k < std::max<std::size_t>(form.count, 1); ++k)
    list += (k ? ", " : "") + text;
  return "[" + list + "]";
}

TEST(KeyTable, NamesEveryKeyOnceWithUnitAndMeaning) {
  std::set<std::string_view> seen;
  for (const TaskKey& key : task_keys()) {
    EXPECT_TRUE(seen.insert(key.path).second) << key.path;
    EXPECT_FALSE(key.forms.empty()) << key.path;
    EXPECT_TRUE(key.meaning.ends_with('.')) << key.path;
    const std::string_view word = key.path.substr(key.path.rfind('.') + 1);
    EXPECT_EQ(find_task_key(key.table(), word), &key) << key.path;
  }
}

TEST(KeyTable, ItsExamplesAreTaken) {
  for (const TaskKey& key : task_keys()) {
    const std::string message = complaint(key, std::string(key.example));
    if (key.path == "task")  // which needs tables of its own
      EXPECT_NE(message.find("gait.period: is missing"), std::string::npos) << message;
    else
      EXPECT_EQ(message, "") << key.path;
  }
}

/// Of every form: the ends are taken as the table says, and what lies beyond is refused.
TEST(KeyTable, ItsBoundsAreThoseOfTheReader) {
  int checked = 0;
  for (const TaskKey& key : task_keys())
    for (const KeyForm& form : key.forms) {
      const Range& range = form.range;
      const bool whole = form.kind == KeyKind::integer;
      const auto expect = [&](double value, bool taken) {
        const std::string message = complaint(key, value_of(form, value));
        EXPECT_EQ(message.empty(), taken) << key.path << " = " << value << ": " << message;
        if (!taken) {
          EXPECT_NE(message.find(key.path.substr(0, key.path.find('.'))), std::string::npos);
        }
        ++checked;
      };
      const auto beyond = [&](double end, double to) {
        return whole ? end + (to > end ? 1 : -1) : std::nextafter(end, to);
      };
      if (std::isfinite(range.low)) {
        expect(range.low, !range.low_open);
        expect(beyond(range.low, -1e300), false);
        if (range.low_open)
          expect(beyond(range.low, 1e300) + (range.low == 0.0 ? 1e-6 : 0.0), true);
      }
      if (std::isfinite(range.high)) {
        expect(range.high, !range.high_open);
        expect(beyond(range.high, 1e300), false);
      }
    }
  EXPECT_GT(checked, 150);
}

TEST(KeyTable, ItsCountsAndTypesAreThoseOfTheReader) {
  for (const TaskKey& key : task_keys())
    for (const KeyForm& form : key.forms) {
      EXPECT_NE(complaint(key, form.kind == KeyKind::text ? "3" : "\"words\""), "") << key.path;
      KeyForm longer = form;
      ++longer.count;
      if (form.kind == KeyKind::numbers && form.count > 0 && key.forms.size() == 1) {
        EXPECT_NE(complaint(key, value_of(longer, 0.1)), "") << key.path;
      }
    }
}

/// Defaults that are numbers are those of the structures that the reader fills.
TEST(KeyTable, ItsNumericDefaultsHold) {
  const TaskFile task = parse_task_file(
      "robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = 1.0\n[travel]\nvelocity = [0, "
      "0.1]\n",
      kPuppy / "x.toml");
  const std::map<std::string_view, double> own = {
      {"gait.knots", task.knots},
      {"travel.turn_rate", task.turn_rate},
      {"travel.aim_speed", task.aim_speed},
      {"travel.aim_turn_rate", task.aim_turn_rate},
      {"style.stance_width", task.stance_width},
      {"limits.friction", task.margins.friction},
      {"limits.floor_friction", task.margins.floor_friction},
      {"limits.min_normal", task.margins.min_normal},
      {"limits.joint_margin", task.margins.joint_margin},
      {"limits.torque_margin", task.margins.torque_margin},
      {"ground.slope_along", task.slope_along},
      {"ground.slope_across", task.slope_across},
      {"style.foot_heights.FOOT.weight", CycleTarget{}.weight},
      {"style.joint_angles.JOINT.weight", CycleTarget{}.weight},
      {"outer.weight", TaskSet{}.outer_weight}};
  std::size_t count = 0;
  for (const TaskKey& key : task_keys()) {
    if (key.fallback.find_first_not_of("0123456789.") != std::string_view::npos ||
        key.fallback.empty())
      continue;
    ASSERT_TRUE(own.contains(key.path)) << key.path;
    EXPECT_EQ(std::stod(std::string(key.fallback)), own.at(key.path)) << key.path;
    ++count;
  }
  EXPECT_EQ(count, own.size());
}

/// The reader cannot take a key, or a type, that is not listed.
TEST(KeyTable, WhatIsNotListedCannotBeRead) {
  const toml::table table = toml::parse("period = 1.0\nwishes = 2.0");
  Problems problems("x.toml");
  std::map<std::string, int> lines;
  TaskTable in(&table, "gait", problems, lines);
  EXPECT_EQ(in.number("period"), 1.0);
  EXPECT_THROW((void)in.number("wishes"), std::logic_error);
  EXPECT_THROW((void)in.has("wishes"), std::logic_error);
  EXPECT_THROW((void)in.integer("period"), std::logic_error);
  EXPECT_THROW((void)in.text("period"), std::logic_error);
  EXPECT_THROW((void)in.numbers_by_name("period"), std::logic_error);
  EXPECT_THROW((void)in.table("tables"), std::logic_error);
}

TEST(KeyTable, ErrorsTellWhereEveryKeyStands) {
  const TaskKey* knots = find_task_key("gait", "knots");
  ASSERT_NE(knots, nullptr);
  const std::string message = complaint(*knots, "7");
  EXPECT_TRUE(
      message.ends_with("is 7; expected 8 <= knots <= 384 (every key: docs/task_file.md, "
                        "`legwright check --keys`)"))
      << message;
}

}  // namespace
}  // namespace legwright
