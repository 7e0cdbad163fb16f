// SPDX-License-Identifier: Apache-2.0
// docs/schema/ holds the schema of each file of a run; LEGWRIGHT_WRITE_SCHEMAS=1 writes it anew.
#include "tools/run/schemas.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/json_schema.hpp"
#include "tools/run/events.hpp"
#include "tools/run/picture_diff_record.hpp"
#include "tools/run/record.hpp"
#include "tools/run/strength_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
const fs::path kStored = fs::path(test::source_dir()) / "docs/schema";
const fs::path kFixture = fs::path(test::source_dir()) / "tests/tools/report/data";

TEST(Schemas, AreStoredAsTheRecordsAre) {
  std::size_t count = 0;
  for (const auto& [name, schema] : record_schemas()) {
    const fs::path file = kStored / (name + ".schema.json");
    if (std::getenv("LEGWRIGHT_WRITE_SCHEMAS") != nullptr) write_json(file, schema);
    ASSERT_TRUE(fs::exists(file)) << "run this test with LEGWRIGHT_WRITE_SCHEMAS=1";
    EXPECT_EQ(read_file(file), to_text(schema))
        << file << ": another schema than that of the record; write it anew with "
        << "LEGWRIGHT_WRITE_SCHEMAS=1, and raise its version where old files are no longer read";
    ++count;
  }
  for (const auto& entry : fs::directory_iterator(kStored))
    count -= entry.path().string().ends_with(".schema.json") ? 1 : 0;
  EXPECT_EQ(count, 0u) << "a schema of no record";
}

/// The stored schema that a document names takes it, and no other one.
void expect_taken_alone(const Json& whole) {
  const std::string schema_key = whole["schema"];
  const std::string kind = schema_key.substr(schema_key.find('/') + 1);
  const Json schema = read_json(kStored / (kind + ".schema.json"));
  EXPECT_EQ(test::schema_fault(schema, whole), "") << kind;
  for (const Json& key : schema["required"]) {
    Json damaged = whole;
    damaged.erase(key.get<std::string>());
    EXPECT_EQ(test::schema_fault(schema, damaged), ": without " + key.dump());
    damaged[key.get<std::string>()] = Json::object({{"x", Json::array({1})}});
    EXPECT_NE(test::schema_fault(schema, damaged), "") << key;
  }
  Json damaged = whole;
  damaged["wishes"] = 3;
  EXPECT_EQ(test::schema_fault(schema, damaged), ": wishes is not known");
}

TEST(Schemas, TakeWhatADiffOfPicturesPrints) {
  PictureDiffRecord diff;
  diff.before = "a.png";
  diff.after = "b.png";
  expect_taken_alone(json_of(diff));
  diff.shown = "d.png";
  EXPECT_EQ(json_of(diff)["shown"], "d.png");
  expect_taken_alone(json_of(diff));
}

TEST(Schemas, TakeWhatPartsTellOfTheirStrength) {
  StrengthRecord strength{25.0, {{"FL_thigh", "bears the gait", 2.66, 2.0, "t = 0.19 s", true}}};
  expect_taken_alone(json_of(strength));
  strength.parts[0].factor = std::nullopt;
  expect_taken_alone(json_of(strength));
}

TEST(Schemas, TakeWhatARunHoldsAndNothingElse) {
  for (const char* name :
       {"run", "result/certificate", "result/metrics", "result/verdict", "result/comparison",
        "result/numerics", "result/robustness", "result/validation_drake"})
    expect_taken_alone(read_json(kFixture / (std::string(name) + ".json")));
  for (const Json& event : read_events(kFixture / "events.jsonl")) {
    const std::string kind = "event_" + event["event"].get<std::string>();
    EXPECT_EQ(test::schema_fault(read_json(kStored / (kind + ".schema.json")), event), "");
  }
}

}  // namespace
}  // namespace legwright
