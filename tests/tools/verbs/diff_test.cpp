// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/json_schema.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/image/png.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

using test::call;
using test::contains;
using test::kExamples;
using test::Outcome;

TEST(Diff, OfPicturesCountsPixels) {
  const TemporaryFolder folder;
  const auto call_there = [&](const std::vector<std::string>& words) {
    return test::call_in(folder.path(), words);
  };
  Image picture(20, 10);
  write_png(folder.path() / "a.png", picture);
  for (const int x : {3, 4, 5}) picture.pixel(x, 2)[1] = 7;
  write_png(folder.path() / "b.png", picture);
  write_png(folder.path() / "wide.png", Image(21, 10));
  write_file(folder.path() / "text.png", "no picture\n");
  EXPECT_EQ(call_there({"diff", "a.png", "a.png"}).code, 0);
  EXPECT_EQ(call_there({"diff", "a.png", "b.png", "--pixels", "3", "-o", "d.png"}).code, 0);
  EXPECT_FALSE(fs::exists(folder.path() / "d.png"));
  const Outcome other = call_there({"diff", "a.png", "b.png", "--pixels", "2", "-o", "d.png"});
  EXPECT_EQ(other.code, 1);
  EXPECT_TRUE(contains(other.out, "3 of 200 pixels differ, 2 may; before | after | difference: d"))
      << other.out;
  const Image shown = read_png(folder.path() / "d.png");
  EXPECT_EQ(shown.width, 3 * 20 + 2 * 8);
  EXPECT_EQ(shown.pixel(2 * 28 + 4, 2)[0], 255);
  EXPECT_EQ(shown.pixel(2 * 28 + 4, 2)[1], 0);
  EXPECT_EQ(Json::parse(call_there({"diff", "a.png", "b.png", "--json"}).out)["different"], 3);
  const Outcome wide = call_there({"diff", "a.png", "wide.png"});
  EXPECT_EQ(wide.code, 1);
  EXPECT_EQ(wide.out, "20 x 10 pixels and 21 x 10 pixels: other sizes\n");
  const Outcome none = call_there({"diff", "a.png", "text.png"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "text.png: is no PNG")) << none.err;
  EXPECT_EQ(call_there({"diff", "a.png", "nowhere.png"}).code, 3);
}

TEST(Diff, ThePictureThatShowsPicturesIsOfTheseTwo) {
  const TemporaryFolder folder;
  const auto call_there = [&](const std::vector<std::string>& words) {
    return test::call_in(folder.path(), words);
  };
  const fs::path shown = folder.path() / "d.png";
  Image picture(20, 10);
  write_png(folder.path() / "a.png", picture);
  picture.pixel(3, 2)[1] = 7;
  write_png(folder.path() / "b.png", picture);
  write_png(folder.path() / "tall.png", Image(21, 14, {0, 0, 255}));
  EXPECT_EQ(call_there({"diff", "a.png", "b.png", "-o", "d.png"}).code, 1);
  EXPECT_TRUE(fs::exists(shown));
  EXPECT_EQ(call_there({"diff", "a.png", "a.png", "-o", "d.png"}).code, 0);
  EXPECT_FALSE(fs::exists(shown)) << "of an earlier comparison";

  const Outcome tall = call_there({"diff", "a.png", "tall.png", "-o", "d.png", "--json"});
  EXPECT_EQ(tall.code, 1);
  const Image both = read_png(shown);
  EXPECT_EQ(both.width, 20 + 8 + 21);
  EXPECT_EQ(both.height, 14);
  EXPECT_EQ(both.pixel(19, 9)[1], 255);
  EXPECT_EQ(both.pixel(19, 10)[1], 128) << "no picture there";
  EXPECT_EQ(both.pixel(28, 13)[2], 255);
  const Json json = Json::parse(tall.out);
  EXPECT_EQ(
      test::schema_fault(
          read_json(fs::path(test::source_dir()) / "docs/schema/picture_diff.schema.json"), json),
      "");
  EXPECT_EQ(json["after_size"]["height"], 14);
  EXPECT_EQ(json["shown"], "d.png");
  EXPECT_TRUE(contains(call_there({"diff", "a.png", "tall.png", "-o", "d.png"}).out,
                       "20 x 10 pixels and 21 x 14 pixels: other sizes; before | after: d.png"));

  write_file(folder.path() / "notes.txt", "mine\n");
  for (const char* taken : {"a.png", "./b.png", "notes.txt"}) {
    const std::string before = read_file(folder.path() / taken);
    const Outcome refused = call_there({"diff", "a.png", "b.png", "-o", taken});
    EXPECT_EQ(refused.code, 2) << taken << refused.out;
    EXPECT_TRUE(contains(refused.err, "name another file")) << refused.err;
    EXPECT_EQ(read_file(folder.path() / taken), before);
  }
}

TEST(Diff, TellsWhatADesignChanged) {
  const std::string puppy = (kExamples / "puppy" / "robot.xml").string(),
                    biped = (kExamples / "biped" / "robot.xml").string();
  const Outcome same = call({"diff", puppy, puppy});
  EXPECT_EQ(same.code, 0);
  EXPECT_TRUE(contains(same.out, "0 differences; mass")) << same.out;
  const Outcome other = call({"diff", puppy, biped});
  EXPECT_EQ(other.code, 1);
  EXPECT_TRUE(contains(other.out, "only in A")) << other.out;
  EXPECT_EQ(Json::parse(call({"diff", puppy, biped, "--json"}).out)["schema"], "legwright/diff");
  EXPECT_EQ(call({"diff", puppy, "/nowhere.xml"}).code, 2);
}

TEST(Diff, PassesOverRoundingErrorsAndSaysSo) {
  const test::TemporaryFolder folder;
  const std::string puppy = (kExamples / "puppy" / "robot.xml").string(),
                    other = (folder.path() / "other.xml").string();
  const auto moved_to = [&](const std::string& place) {
    std::string xml = read_file(puppy);
    const std::string from = "<body name=\"eyes\" pos=\"0.095 0 0\">";
    const std::size_t at = xml.find(from);
    EXPECT_NE(at, std::string::npos);
    write_file(other, xml.replace(at, from.size(), "<body name=\"eyes\" pos=\"" + place + "\">"));
    return call({"diff", puppy, other});
  };
  const Outcome dust = moved_to("0.095 1e-17 0");
  EXPECT_EQ(dust.code, 0);
  EXPECT_TRUE(contains(dust.out, "0 differences; mass")) << dust.out;
  EXPECT_TRUE(contains(dust.out, " more below 1e-09 of their quantity passed over")) << dust.out;
  EXPECT_EQ(call({"diff", puppy, other, "--tolerance", "0"}).code, 1);
  EXPECT_GE(Json::parse(call({"diff", puppy, other, "--json"}).out)["passed_over"], 1);

  const Outcome moved = moved_to("0.1 1e-17 0");  // twin; what is rounding beside it is told as 0
  EXPECT_EQ(moved.code, 1);
  EXPECT_TRUE(contains(moved.out, "0.095 0 0 -> 0.1 0 0 m")) << moved.out;
  const Outcome little = moved_to("0.09500001 0 0");  // what six digits cannot tell
  EXPECT_TRUE(contains(little.out, "0.095 0 0 -> 0.09500001 0 0 m")) << little.out;
}

}  // namespace
}  // namespace legwright
