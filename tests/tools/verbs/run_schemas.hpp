// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "tests/support/json_schema.hpp"
#include "tests/support/paths.hpp"
#include "tools/run/events.hpp"

namespace legwright::test {

/// Every JSON file of a run, its tasks and its starts is what docs/schema/ says of it. A file names
/// its schema itself: "legwright/run" is run.schema.json. @return how many files of each there were
inline std::map<std::string, int> expect_schemas(const std::filesystem::path& run) {
  namespace fs = std::filesystem;
  const fs::path stored = fs::path(test::source_dir()) / "docs" / "schema";
  std::map<std::string, int> seen;
  const auto check = [&](const std::string& name, const Json& json, const fs::path& file) {
    const fs::path schema = stored / (name + ".schema.json");
    if (!fs::exists(schema)) return;
    EXPECT_EQ(schema_fault(read_json(schema), json), "") << file;
    ++seen[name];
  };
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    if (entry.path().filename() == "events.jsonl") {
      for (const Json& event : read_events(entry.path())) {
        const bool joint = event.at("event") == "iteration" && event.contains("tasks");
        check((joint ? "event_joint_" : "event_") + event.at("event").get<std::string>(), event,
              entry.path());
      }
    } else if (entry.path().extension() == ".json") {
      const Json json = read_json(entry.path());
      const std::string schema = json.at("schema");
      check(schema.substr(schema.find('/') + 1), json, entry.path());
    }
  }
  return seen;
}

}  // namespace legwright::test
