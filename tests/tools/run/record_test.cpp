// SPDX-License-Identifier: Apache-2.0
#include "tools/run/record.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

struct Leg {
  std::string name;
  double length = 0.0;
  std::optional<double> mass;
};
void fields(Fields& f, Leg& leg) {
  f("name", leg.name);
  f("length_m", leg.length, "of the whole leg");
  f("mass_kg", leg.mass);
}

struct Walker {
  static constexpr RecordKind kKind{"legwright/walker", 3};
  std::string gait;
  int knots = 0;
  bool stands = false;
  std::vector<Leg> legs;
  ByName<double> s;
  std::map<std::string, std::string> notes;
  std::optional<double> limit;
  std::array<double, 2> velocity{};
  std::optional<Leg> tail;
};
void fields(Fields& f, Walker& walker) {
  f.one_of("gait", walker.gait, {"trot", "walk"});
  f("knots", walker.knots);
  f("stands", walker.stands);
  f("legs", walker.legs);
  f("s", walker.s);
  f("notes", walker.notes);
  f.nullable("limit_Nm", walker.limit);
  f("velocity", walker.velocity);
  f.required_if(walker.gait == "walk", "tail", walker.tail);
}

Walker puppy() {
  Walker walker{"trot", 12, true, {{"FL", 0.1, {}}, {"FR", 0.25, 1.5}}, {}, {}, {}, {}, {}};
  walker.s = {{"thigh", 0.5}, {"shank", 2.0}};
  walker.notes["b"] = "late";
  walker.notes["a"] = "early";
  return walker;
}

constexpr const char* kText =
    R"({"schema":"legwright/walker","version":3,"gait":"trot","knots":12,"stands":true,)"
    R"("legs":[{"name":"FL","length_m":0.1},{"name":"FR","length_m":0.25,"mass_kg":1.5}],)"
    R"("s":{"thigh":0.5,"shank":2.0},"notes":{"a":"early","b":"late"},"limit_Nm":null,)"
    R"("velocity":[0.0,0.0]})";

/// What reading says of the walker after `change`; empty where it takes it.
template <class Change>
std::string complaint_after(const Change& change) {
  Json json = Json::parse(kText);
  change(json);
  try {
    record_of<Walker>(json, "walker.json");
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

bool names(const std::string& message, const char* part) {
  return message.starts_with("walker.json: ") && message.find(part) != std::string::npos;
}

TEST(Record, IsWrittenInTheOrderOfItsFields) {
  EXPECT_EQ(json_of(puppy()).dump(), kText);
  EXPECT_EQ(json_of(Leg{"FL", 0.1, {}}).dump(), R"({"name":"FL","length_m":0.1})");
  EXPECT_EQ(json_of(Leg{"FL", NAN, {}}).dump(), R"({"name":"FL","length_m":null})");
}

TEST(Record, IsReadBackToTheSameBytes) {
  const Walker walker = record_of<Walker>(Json::parse(kText), "walker.json");
  EXPECT_EQ(json_of(walker).dump(), kText);
  ASSERT_NE(walker.s.find("shank"), nullptr);
  EXPECT_EQ(*walker.s.find("shank"), 2.0);
  EXPECT_EQ(walker.s.find("neck"), nullptr);
  Walker other = walker;
  other.s.of("shank") = 3.0;
  other.s.of("neck") = 1.0;
  EXPECT_EQ(json_of(other)["s"].dump(), R"({"thigh":0.5,"shank":3.0,"neck":1.0})");
  EXPECT_FALSE(walker.limit || walker.tail);
  EXPECT_TRUE(
      std::isnan(record_of<Leg>(Json::parse(R"({"name":"FL","length_m":null})"), "").length));
}

TEST(Record, RefusesWhatItDoesNotKnowByKey) {
  EXPECT_EQ(complaint_after([](Json&) {}), "");
  EXPECT_EQ(complaint_after([](Json& j) { j["limit_Nm"] = 2; }), "");
  EXPECT_TRUE(names(complaint_after([](Json& j) { j.erase("knots"); }), "knots: expected a value"));
  EXPECT_TRUE(names(complaint_after([](Json& j) { j.erase("limit_Nm"); }), "limit_Nm: "));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j["legs"][1].erase("name"); }), "legs[1].name: "));
  EXPECT_TRUE(names(complaint_after([](Json& j) { j["legs"][0]["toes"] = 5; }),
                    "legs[0].toes: expected no such key, found 5"));
  EXPECT_TRUE(names(complaint_after([](Json& j) { j["s"]["thigh"] = "long"; }),
                    "s.thigh: expected a number, found \"long\""));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j["knots"] = 1.5; }), "knots: expected a whole number"));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j["knots"] = 1ll << 40; }), "knots: expected a whole"));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j["stands"] = 1; }), "stands: expected true or false"));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j["legs"] = Json::object(); }), "legs: expected a list"));
  EXPECT_TRUE(names(complaint_after([](Json& j) { j["gait"] = "crawl"; }),
                    R"(gait: expected "trot" or "walk", found "crawl")"));
  EXPECT_TRUE(names(complaint_after([](Json& j) { j["velocity"] = {1.0}; }),
                    "velocity: expected a list of 2"));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j["gait"] = "walk"; }), "tail: expected a value"));
  EXPECT_TRUE(names(complaint_after([](Json& j) { j["schema"] = "other"; }),
                    R"(expected "schema": "legwright/walker", found "other")"));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j["version"] = 4; }), "found 4; the file is damaged"));
  EXPECT_TRUE(names(complaint_after([](Json& j) { j.erase("version"); }), "found no such key"));
  EXPECT_TRUE(
      names(complaint_after([](Json& j) { j = Json::array(); }), "expected an object, found []"));
}

TEST(Record, TellsItsSchema) {
  const Json schema = schema_of<Walker>();
  EXPECT_EQ(schema["required"].dump(), R"(["schema","version","gait","knots","stands","legs","s",)"
                                       R"("notes","limit_Nm","velocity"])");
  const Json& own = schema["properties"];
  EXPECT_EQ(own["schema"].dump(), R"({"const":"legwright/walker"})");
  EXPECT_EQ(own["gait"].dump(), R"({"type":"string","enum":["trot","walk"]})");
  EXPECT_EQ(own["limit_Nm"].dump(), R"({"type":["number","null"]})");
  EXPECT_EQ(own["tail"]["type"].dump(), R"(["object","null"])");
  EXPECT_EQ(own["s"].dump(),
            R"({"type":"object","additionalProperties":{"type":["number","null"]}})");
  EXPECT_EQ(own["legs"]["items"]["properties"]["length_m"].dump(),
            R"({"description":"of the whole leg","type":["number","null"]})");
  EXPECT_EQ(own["legs"]["items"]["additionalProperties"], false);
}

}  // namespace
}  // namespace legwright
