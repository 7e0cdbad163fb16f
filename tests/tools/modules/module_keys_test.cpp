// SPDX-License-Identifier: Apache-2.0
// The table of keys of a module file and its reader agree.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/modules/linear_text.hpp"
#include "tests/tools/modules/servo_text.hpp"
#include "tools/modules/module_file.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

const std::string kWholeFoot = R"(name = "ball"
kind = "foot"
maker = "printed"
mass = 0.01
[[outline]]
shape = "sphere"
size = [0.01]
[foot]
friction = 0.8
[[assumption]]
figures = ["mass", "outline", "foot.friction"]
why = "one's own"
)";

/// Names from the root on; the first of each array of tables is meant.
std::vector<std::string> path_of(const TaskKey& key) {
  static const std::set<std::string> arrays{"outline", "attachment", "source", "assumption"};
  const std::string table(key.table());
  if (table.empty()) return {std::string(key.path)};
  const std::string word(key.path.substr(table.size() + 1));
  if (arrays.contains(table)) return {table, "0", word};
  return {table, word};
}

/// What the reader says of a whole module with another value of a key; empty where it takes it.
std::string told_of(const TaskKey& key, const std::string& value) {
  const bool slides = key.path.starts_with("slide.") || key.path == "outline.on";
  const std::string whole = key.path.starts_with("foot.") ? kWholeFoot
                            : slides                      ? test::kWholeLinear
                                                          : test::kWholeServo;
  try {
    (void)parse_module(with_key(whole, path_of(key), value), "x.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ModuleKeys, AreListedOnceAndTheirExamplesAreTaken) {
  std::set<std::string_view> seen;
  for (const TaskKey& key : module_keys()) {
    EXPECT_TRUE(seen.insert(key.path).second) << key.path;
    EXPECT_TRUE(key.meaning.ends_with('.')) << key.path;
    const bool clashes = key.path == "unknown" || key.path == "cable" ||
                         key.path.ends_with("figures") ||
                         key.forms[0].kind == KeyKind::tables;  // with what the whole servo says
    const std::string told = told_of(key, std::string(key.example));
    if (clashes)
      EXPECT_EQ(told.find("expected"), std::string::npos) << key.path << ": " << told;
    else
      EXPECT_EQ(told, "") << key.path;
  }
}

TEST(ModuleKeys, BoundsAreThoseOfTheReader) {
  int checked = 0;
  for (const TaskKey& key : module_keys()) {
    const KeyForm& form = key.forms[0];
    if (form.kind != KeyKind::number) continue;
    for (const double end : {form.range.low, form.range.high}) {
      const double beyond = end == form.range.low ? end - 1.0 : end + 1.0;
      const std::string told = told_of(key, std::to_string(beyond));
      EXPECT_NE(told.find(key.path), std::string::npos) << key.path << " = " << beyond << told;
      ++checked;
    }
  }
  EXPECT_GE(checked, 20);
}

TEST(ModuleKeys, ValuesOfAnotherTypeAreRefused) {
  for (const TaskKey& key : module_keys()) {
    const bool is_text = key.forms[0].kind == KeyKind::text;
    const std::string told = told_of(key, is_text ? "3" : "\"words\"");
    EXPECT_NE(told.find(key.path), std::string::npos) << key.path << ": " << told;
  }
}

}  // namespace
}  // namespace legwright
