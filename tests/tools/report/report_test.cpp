// SPDX-License-Identifier: Apache-2.0
#include "tools/report/report.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/report/sections.hpp"

#include <filesystem>

#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/files/io_error.hpp"
#include "tools/report/html.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

using ReportTest = RunFixture;

/// Nothing that a browser would fetch.
void expect_self_contained(const std::string& page) {
  for (const char* reference :
       {"http:", "https:", "src=\"/", "href=", "url(", "@import", "<link", "<iframe", "<object"}) {
    EXPECT_FALSE(has(page, reference)) << reference;
  }
  for (std::size_t at = page.find("src=\""); at != std::string::npos;
       at = page.find("src=\"", at + 1)) {
    const std::string begin = page.substr(at + 5, 23);
    EXPECT_TRUE(begin.starts_with("data:image/png;base64,") || begin == "data:image/webp;base64,");
  }
}

TEST_F(ReportTest, ShowsEveryPartOfACompleteRun) {
  add_pictures();
  const std::string page = this->page();
  expect_well_formed(page);
  expect_self_contained(page);
  for (const char* part : {"✗ Fail",
                           "✓ Pass",
                           "falls after 1.29 s",
                           "98 % of planned speed",
                           "What physics did.",
                           "What was planned.",
                           "front hip axis roll",
                           "+80.2°",
                           "at its upper bound",
                           "Cost F by design iteration",
                           "gait alone, initial body",
                           "iteration 0",
                           "forces carry the body",
                           "98.1 %",
                           "Footfalls after",
                           "SHA-256 of robot.xml",
                           "3.17.0",
                           "default-src 'none'",
                           "Why it changed.",
                           "0.05 … 4.06",
                           "3.2 × 10⁻⁸",
                           "0.219 mm",
                           "0.00177 N·m",
                           "57.3° to spare",
                           "0.32 s",
                           "2.709600 × 10⁻⁵"}) {
    EXPECT_TRUE(has(page, part) || has(page, escape_attribute(part))) << part;
  }
  EXPECT_TRUE(in_order(page, {"slip of stance feet −14.3", "body off its place +2.61"}));
  EXPECT_TRUE(in_order(page, {"<h2>Certificate", "mark good", "curvatures of F along the motion"}));
  EXPECT_TRUE(in_order(page, {"upper bound, 80.2°", "96.3°", "0.42"}));
  EXPECT_FALSE(has(page, "class=\"hint\""));
  EXPECT_LT(page.size(), 5'000'000U);
}

TEST_F(ReportTest, ShowsTheGaitInMotionAndAStillForThoseWhoWantNone) {
  add_pictures();
  fs::create_directories(run_ / "iterations" / "0003");
  write_png(run_ / "iterations" / "0003" / "frame.png", Image(64, 48, {1, 2, 3}));
  write_png(run_ / "result" / "overlay.png", Image(64, 48, {4, 5, 6}));
  const std::string head("RIFF\0\0\0\0WEBP", 12);
  write_file(run_ / "result" / "gait.webp", head + std::string(1'000'000, 'x'));
  std::string page = this->page();
  expect_well_formed(page);
  expect_self_contained(page);
  EXPECT_TRUE(has(page, "data:image/webp;base64,"));
  EXPECT_TRUE(has(page, "media=\"print, (prefers-reduced-motion: reduce)\""));
  EXPECT_TRUE(has(page, "Simulation and plan in one picture."));
  write_file(run_ / "result" / "gait.webp", head + std::string(1'600'000, 'x'));
  page = this->page();
  EXPECT_FALSE(has(page, "data:image/webp"));
  EXPECT_TRUE(has(page, "too large for this page: result/gait.webp"));
  write_file(run_ / "result" / "gait.webp", "no picture");
  EXPECT_FALSE(has(this->page(), "data:image/webp"));
}

TEST_F(ReportTest, LeavesOutPicturesOfAnotherResult) {
  const auto draw = [&](const JudgedSums& result, const JudgedSums& design) {
    const Image picture(64, 48, {200, 120, 40});
    write_png(run_ / "result/strip_physics.png", picture, origin_text(result));
    write_png(run_ / "iterations/0000/frame.png", picture, origin_text(design));
  };
  for (const char* scene : {"result/scene.xml", "iterations/0000/scene.xml"})
    write_file(run_ / scene, "<mujoco/>");
  const JudgedSums here = sums_of_run(run_), design = sum_of_scene(run_ / "iterations/0000");
  draw(here, design);
  std::string page = this->page();
  EXPECT_FALSE(has(page, "render again"));
  EXPECT_TRUE(has(page, "iteration 0\""));
  JudgedSums other = here, other_design = design;
  other.front().second[0] = other.front().second[0] == '0' ? '1' : '0';
  other_design.of("scene.xml") = "0";
  draw(other, other_design);
  page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "result/strip_physics.png is not of this result: render again"));
  EXPECT_TRUE(has(page, "Left out: 1 frame.png of iterations"));
  EXPECT_FALSE(has(page, "data:image/png"));
}

TEST_F(ReportTest, StaysBelowFiveMegabytesWhateverThePictures) {
  const std::string head("RIFF\0\0\0\0WEBP", 12);
  write_file(run_ / "result" / "gait.webp", head + std::string(1'400'000, 'x'));
  for (const char* strip : {"strip_physics.png", "strip_before_after.png", "overlay.png"})
    write_file(run_ / "result" / strip, std::string(1'400'000, 'x'));
  const std::string page = this->page();
  EXPECT_LT(page.size(), 5'000'000U);
  EXPECT_TRUE(has(page, "too large for this page"));
}

TEST_F(ReportTest, OfAGaitAloneNothingIsBefore) {
  edit_run([](Json& run) { run["motion_only"] = true; });
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "the initial body: only its gait was optimised"));
  for (const char* part : {"What changed in the body", "<h2>Before</h2>", "<h3>Before</h3>",
                           "Footfalls before", "The same before the body changed"})
    EXPECT_FALSE(has(page, part)) << part;
}

TEST_F(ReportTest, IsTheSameEachTime) {
  add_pictures();
  EXPECT_EQ(page(), page());
}

TEST_F(ReportTest, NamesTheCommandForWhatIsMissing) {
  for (const char* file :
       {"metrics.json", "verdict.json", "comparison.json", "numerics.json", "robustness.json"})
    fs::remove(run_ / "result" / file);
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "legwright validate " + run_.generic_string()));
  EXPECT_TRUE(has(page, "legwright render " + run_.generic_string()));
  EXPECT_TRUE(has(page, "Not validated"));
  EXPECT_FALSE(has(page, "✓ Pass"));
  for (const char* section : {"Limits", "Plan against physics", "Robustness", "Second opinion"}) {
    const std::size_t begin = page.find(std::string("<h2>") + section);
    ASSERT_NE(begin, std::string::npos) << section;
    const std::string own = page.substr(begin, page.find("</section>", begin) - begin);
    EXPECT_TRUE(in_order(own, {"class=\"hint\"", "legwright validate "})) << section;
  }
  EXPECT_TRUE(has(page, "Planned normal forces")) << "of the plan alone";
}

TEST_F(ReportTest, SaysWhereNothingIsProven) {
  fs::remove(run_ / "result" / "certificate.json");
  const std::string page = this->page();
  EXPECT_TRUE(has(page, "Nothing has been proven of this result"));
  EXPECT_FALSE(has(page, "0.05 … 4.06"));
}

TEST_F(ReportTest, ACertificateThatFailsSaysSo) {
  Json proof = read_json(run_ / "result" / "certificate.json");
  proof["design_curvatures"][0] = -0.02;
  proof["worst_gradient_error"] = 0.3;
  proof["tasks"]["sideways"]["motion_hessian_positive"] = false;
  proof["tasks"]["sideways"]["motions_resolved"] = false;
  write_json(run_ / "result" / "certificate.json", proof);
  const std::string page = this->page();
  std::size_t bad = 0;
  for (std::size_t at = page.find("mark bad", page.find("<h2>Certificate"));
       at != std::string::npos; at = page.find("mark bad", at + 1))
    ++bad;
  EXPECT_EQ(bad, 4U);  // and the status, which is not "converged" in the fixture
  EXPECT_TRUE(has(page, "−0.02 … 4.06"));
  EXPECT_TRUE(has(page, "came to rest only roughly"));
}

TEST_F(ReportTest, APartOfAJointRunLinksToTheWholeAndNowhereElse) {
  edit_run([](Json& run) { run["joint_run"] = "../.."; });
  EXPECT_TRUE(has(page(), "href=\"../../report.html\""));
  EXPECT_TRUE(has(page(), "They are of this task alone"));
  edit_run([](Json& run) { run["joint_run"] = "https://example.org"; });
  expect_self_contained(page());
}

TEST_F(ReportTest, TakesTheDesignMetricsForNoValidation) {
  write_file(run_ / "result" / "metrics.json", R"({"schema":"legwright/iteration","F":1})");
  EXPECT_TRUE(has(page(), "have not been played in MuJoCo yet"));
}

TEST_F(ReportTest, WorksWithNothingButRunJson) {
  fs::remove_all(run_ / "result");
  fs::remove_all(run_ / "iterations");
  fs::remove(run_ / "events.jsonl");
  expect_well_formed(page());
  EXPECT_NO_THROW(report_summary(read_run(run_)));
  edit_run([](Json& run) {  // as it stands while the optimizer works
    run["status"] = "running";
    const Json whole = run;
    bool later = false;  // than what is known at the start
    for (const auto& [key, value] : whole.items()) {
      if (later) run.erase(key);
      later = later || key == "motion_only";
    }
  });
  expect_well_formed(page());
  EXPECT_NO_THROW(report_summary(read_run(run_)));
  write_file(run_ / "run.json", "{}");
  EXPECT_ANY_THROW(read_run(run_)) << "a foreign run.json makes no run";
}

TEST_F(ReportTest, NotesBrokenFilesAndGoesOn) {
  write_file(run_ / "result" / "verdict.json", "{\"initial\":");
  write_file(run_ / "result" / "motion.csv", "time_s\nnan\n");
  const std::string page = this->page();
  expect_well_formed(page);
  const std::size_t first = page.find("verdict.json: "), cards = page.find("class=\"cards\""),
                    last = page.rfind("verdict.json: ");
  EXPECT_LT(first, cards) << "at the top of the page";
  EXPECT_GT(last, cards) << "and where the files are listed";
  EXPECT_TRUE(has(page, "run `legwright validate`, which writes it again"));
  EXPECT_FALSE(has(page, "No verdict yet")) << "it is there, but damaged";
}

TEST_F(ReportTest, NamesTheKeyOfAMutilatedRun) {
  const Json whole = read_json(run_ / "run.json");
  for (const auto& item : whole.items()) {
    const std::string& key = item.key();
    if (key == "schema" || key == "version" || key == "put_back") continue;
    const std::string where = "run.json: " + key;
    edit_run([&](Json& run) { run = whole, run.erase(key); });
    EXPECT_TRUE(has(refusal_of(run_), where + ": expected a value, found no such key")) << key;
    edit_run([&](Json& run) { run = whole, run[key] = Json::array({"x", 1, nullptr}); });
    EXPECT_TRUE(has(refusal_of(run_), where)) << refusal_of(run_);
    EXPECT_TRUE(has(refusal_of(run_), "run `legwright optimize`, which writes it again")) << key;
  }
  edit_run([&](Json& run) { run = whole, run["wishes"] = 3; });
  EXPECT_TRUE(has(refusal_of(run_), "run.json: wishes: expected no such key, found 3"));
  edit_run([&](Json& run) { run = whole, run["version"] = 2; });
  EXPECT_TRUE(has(refusal_of(run_), "expected \"version\": 1, found 2"));
}

TEST_F(ReportTest, NotesFilesOfWrongTypes) {
  write_file(run_ / "result" / "verdict.json", "[1]");
  write_file(run_ / "result" / "certificate.json",
             R"({"schema":"legwright/certificate","version":1,"projected_gradient_norm":"x"})");
  write_file(
      run_ / "result" / "metrics.json",
      R"({"schema":"legwright/validation","result":{"default":{"feet":[3,{"name":"FL","contacts_s":[1,["a"]]}]}}})");
  expect_well_formed(page());
  EXPECT_TRUE(has(page(), "certificate.json: projected_gradient_norm: expected a number"));
  EXPECT_TRUE(has(page(), "Nothing has been proven of this result"));
}

TEST_F(ReportTest, RefusesAFolderWithoutARun) {
  EXPECT_THROW(read_run(run_ / "result"), IoError);
  edit_run([](Json& run) { run["schema"] = "other/run"; });
  EXPECT_THROW(read_run(run_), IoError);
  write_file(run_ / "run.json", "[]");
  EXPECT_THROW(read_run(run_), IoError);
}

TEST_F(ReportTest, HostileNamesStayText) {
  add_pictures();
  const auto rows = [](const std::string& name) {
    PutBackRecord row;
    row.parameter = name;
    row.F = 20.0;
    row.terms = {{name, 20.0}};
    return Json::array({json_of(row)});
  };
  edit_run([&](Json& run) {
    run["parameters"][0]["name"] = "plain";
    run["robot"] = "plain";
    run["task"]["gait"] = "plain";
    run["parameters"][0]["sentence"] = run["status"] = run["sha256"]["robot.xml"] = "plain";
    run["put_back"] = rows("plain");
  });
  const auto prove = [&](const std::string& name) {
    Json proof = read_json(run_ / "result" / "certificate.json");
    const Json task = proof["tasks"].begin().value();
    proof["tasks"] = {{name, task}};
    for (const char* key : {"term", "where", "unit", "equation"})
      proof["tasks"][name]["violations"][0][key] = name;
    write_json(run_ / "result" / "certificate.json", proof);
  };
  prove("plain");
  const std::size_t expected = tags_of(page());
  for (const std::string& raw : hostile_names()) {
    const std::string name = clean_utf8(raw);  // JSON cannot carry other bytes
    edit_run([&](Json& run) {
      run["robot"] = run["task"]["gait"] = run["status"] = run["sha256"]["robot.xml"] = name;
      run["parameters"][0]["name"] = run["parameters"][0]["sentence"] = name;
      run["put_back"] = rows(name);
    });
    prove(name);
    const std::string page = this->page();
    expect_well_formed(page);
    EXPECT_EQ(tags_of(page), expected) << name;  // not one tag more, nor fewer
  }
}

TEST_F(ReportTest, TellsHowFewChangesWouldDo) {
  EXPECT_FALSE(has(page(), "How few changes would do"));
  FewestChangesRecord fewest;
  fewest.share = 0.95;
  fewest.initial_F = 11.0;
  fewest.fewest = 1;
  fewest.designs = {{{"a", "b", "c"}, 1.0, {}}, {{"hip_yaw", "b"}, 1.4, {}}, {{"b"}, 9.0, {}}};
  edit_run([&](Json& run) { run["fewest_changes"] = json_of(fewest); });
  const std::string words =
      "2 of 3 changes buy 96 % of the fall of F (F 1.4 instead of 1; 11 without any): hip yaw and "
      "b.";
  EXPECT_EQ(fewest_words(read_run(run_).run), words);
  EXPECT_TRUE(has(page(), words));
  RunRecord tightened = read_run(run_).run;
  tightened.choice.emplace().chosen = "tightened: larger margins";
  EXPECT_TRUE(has(fewest_words(tightened), words + " F is that of the tightened search"));
  EXPECT_TRUE(has(page(), "F by number of changed parameters"));
  expect_well_formed(page());
  EXPECT_TRUE(has(report_summary(read_run(run_)), "2 of 3 changes buy 96 %"));
  EXPECT_FALSE(has(page(), "of these 3 bodies")) << "nothing was played";
  fewest.designs[0].played = fewest.designs[1].played = {0.0, true, "PASS"};
  fewest.designs[2].played = {3.0, false, "FAIL"};
  edit_run([&](Json& run) { run["fewest_changes"] = json_of(fewest); });
  EXPECT_TRUE(has(page(),
                  "MuJoCo passes 2 of these 3 bodies for a few cycles, of which the least "
                  "changed has 2 changes."));
  fewest.designs[0].played = fewest.designs[1].played = {3.0, false, "FAIL"};
  edit_run([&](Json& run) { run["fewest_changes"] = json_of(fewest); });
  EXPECT_TRUE(has(page(), "MuJoCo passes none of these 3 bodies for a few cycles."));
  fewest.kept = true;
  fewest.fewest = 2;
  edit_run([&](Json& run) { run["fewest_changes"] = json_of(fewest); });
  EXPECT_TRUE(has(page(), "1 of 3 changes buys 20 % of the fall"));
  EXPECT_TRUE(has(page(), "This is the result (--few)."));
  fewest.fewest = 3;  // of a damaged file
  edit_run([&](Json& run) { run["fewest_changes"] = json_of(fewest); });
  EXPECT_EQ(fewest_words(read_run(run_).run), "");
}

TEST_F(ReportTest, BoundsAreWorthWideningFromOnePercentOfTheCostOn) {
  EXPECT_FALSE(has(page(), "Worth more room")) << "0.42 of 327";
  edit_run([](Json& run) { run["final_F"] = 40.0; });
  EXPECT_TRUE(has(page(), "Worth more room, if the robot can be built so: front hip axis roll."));
  EXPECT_TRUE(has(page(), "[design.bounds]"));
}

TEST_F(ReportTest, TellsHowUniqueTheResultIs) {
  EXPECT_FALSE(has(page(), "How unique the result is"));
  const auto start = [](const char* name, double F, double width) {
    StartRecord one;
    one.start = name;
    one.F = F;
    one.s = {{"front_hip_axis_roll", 0.5}, {"body_width", width}};
    return one;
  };
  edit_run([&](Json& run) {
    run["starts"] = Json::array();
    for (const StartRecord& one :
         {start("initial", 2.12, 0.14), start("random-1", 2.0, 0.1), start("random-2", NAN, 0.1)})
      run["starts"].push_back(json_of(one));
  });
  const RunRecord run = read_run(run_).run;
  const std::string words = other_starts_words(run);
  EXPECT_TRUE(
      has(words, "1 other start ends within 6 % of the least F; their bodies differ in 1 of"))
      << words;
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, words));
  EXPECT_LT(page.find("from random-1"), page.find("from initial")) << "the least F first";
  EXPECT_TRUE(has(page, "100.0 mm"));
}

TEST_F(ReportTest, WritesPageAndSummary) {
  const auto pages = write_report(run_);
  ASSERT_EQ(pages.size(), 1U);
  const fs::path page = pages.front();
  EXPECT_EQ(page, run_ / "report.html");
  expect_well_formed(read_file(page));
  const std::string summary = read_file(run_ / "result" / "summary.md");
  EXPECT_TRUE(has(summary, "front hip axis roll (+10.5) | 0° | 80.2°")) << summary;
  EXPECT_TRUE(has(summary, "FAIL"));
  EXPECT_FALSE(has(summary, "\n\n\n"));
}

}  // namespace
}  // namespace legwright
