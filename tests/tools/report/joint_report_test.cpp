// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "mjcf/text/input_error.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/image/png.hpp"
#include "tools/report/html.hpp"
#include "tools/report/report.hpp"
#include "tools/run/matrix_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A joint run of invented numbers: two tasks, each a copy of the fixture of single runs.
class JointReportTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    run_ = fs::path(testing::TempDir()) / ("joint_report_" + test);
    fs::remove_all(run_);
    fs::create_directories(run_ / "result");
    fs::create_directories(run_ / "tasks");
    for (const char* task : {"ahead", "sideways"})
      fs::copy(fs::path(test::source_dir()) / "tests/tools/report/data", run_ / "tasks" / task,
               fs::copy_options::recursive);
    write_run("ahead");
    write_results("ahead");
  }
  void TearDown() override { fs::remove_all(run_); }

  static Json costs(const std::string& first, double ahead, double sideways) {
    return {{first, ahead}, {"sideways", sideways}};
  }

  Json start(const std::string& from, const std::string& first, double F) const {
    return {{"start", from},
            {"tasks", {first, "sideways"}},
            {"status", "converged"},
            {"F_start", 2 * F},
            {"F", F},
            {"F_tasks_start", costs(first, 3.25, 10.5)},
            {"F_tasks", costs(first, F, F)},
            {"design_iterations", 9},
            {"newton_iterations", 90},
            {"seconds", 1.25},
            {"s", {{"body_width", 0.111}}}};
  }

  /// @param first name of the first task; its folder stays tasks/ahead
  void write_run(const std::string& first) {
    Json run = read_json(run_ / "tasks" / "ahead" / "run.json");
    Json task = run["task"];
    for (const char* key : {"task", "put_back"}) run.erase(key);
    run["name"] = "both";
    run["tasks"] = Json::array();
    for (const std::string& name : {first, std::string("sideways")}) {
      task["name"] = name;
      task["weight"] = 0.5;
      task["folder"] = run["tasks"].empty() ? "tasks/ahead" : "tasks/sideways";
      task["F_initial"] = 51.5;
      task["F"] = 4.75;
      run["tasks"].push_back(task);
    }
    run["best_start"] = first;
    run["starts"] = {start("initial", first, 6.25), start(first, first, 4.5)};
    run["alone"] = Json::array({start("initial", first, 2.5)});
    run["alone"][0]["tasks"] = Json::array({first});
    write_json(run_ / "run.json", run, Durability::process);
  }

  static Json cell(double F, bool pass) {
    GainMetrics falls, walks;
    falls.fall = {1.69, "the trunk sank"};
    walks.speed_ratio = 0.985;
    return json_of(MatrixCellRecord{
        F, pass, "told", {{"half", falls}, {"default", walks}, {"double", walks}}});
  }

  void write_results(const std::string& first) {
    Json cells = Json::object();
    for (const std::string& task : {first, std::string("sideways")})
      cells[task] = {cell(51.5, false), cell(3.25, false), cell(4.75, true)};
    const Json body{{"name", "a body"}, {"start", "initial"}};
    write_json(run_ / "result" / "matrix.json",
               {{"schema", "legwright/matrix"},
                {"version", 1},
                {"designs", {body, body, body}},
                {"cells", cells},
                {"pass", true}},
               Durability::process);
    Json points = Json::array();
    for (const double weight : {0.0, 0.5, 1.0})
      points.push_back(point(weight, costs(first, 6.0 - weight, 2.0 + 8.0 * weight)));
    write_front(first, points);
  }

  static Json point(double weight, const Json& costs) {
    return {{"weight", weight},
            {"F", 1.0},
            {"F_tasks", costs},
            {"status", "converged"},
            {"s", {{"body_width", 0.1}}}};
  }
  void write_front(const std::string& first, const Json& points) const {
    write_json(
        run_ / "result" / "front.json",
        {{"schema", "legwright/front"}, {"version", 1}, {"weight_of", first}, {"points", points}},
        Durability::process);
  }

  std::string page() { return joint_report_page(joint_data_of(read_run(run_))); }

  fs::path run_;
};

TEST_F(JointReportTest, ShowsEveryBodyInEveryTask) {
  const std::string page = this->page();
  expect_well_formed(page);
  for (const char* part :
       {"fixture-puppy · both", "One body for 2 tasks: ahead (weight 0.5)", "for ahead alone",
        "for both tasks", "F 4.75", "✓ pass", "✗ fail", "fell, 1.69 s", "99 %", "111.0 mm",
        "the best: this is the result", "the body for ahead alone", "F of ahead", "The trade-off",
        "key b3 ring", "initial body (51.5 and 51.5)", "sideways: slip of stance feet −7.14",
        "href=\"tasks/ahead/report.html\""})
    EXPECT_TRUE(has(page, part)) << part;
  EXPECT_TRUE(in_order(page, {"F by task: ahead costs 4.75", "3.25"}));
  EXPECT_EQ(page, this->page());
}

TEST_F(JointReportTest, EndsOfTheFrontDoNotSqueezeIt) {
  Json points = Json::array();
  for (const double weight : {0.0, 0.25, 0.5, 0.75, 1.0})
    points.push_back(
        point(weight, costs("ahead", weight == 0.0 ? 90.0 : 3.0 - weight, 2.0 + weight)));
  write_front("ahead", points);
  EXPECT_TRUE(has(page(), "the point of weight 0 (90 and 2)"));
  EXPECT_FALSE(has(page(), "the point of weight 1"));
}

TEST_F(JointReportTest, NamesTheCommandForWhatIsMissing) {
  fs::remove(run_ / "result" / "matrix.json");
  fs::remove(run_ / "result" / "front.json");
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "legwright validate " + run_.generic_string()));
  EXPECT_TRUE(has(page, "legwright render " + run_.generic_string()));
  EXPECT_TRUE(has(page, "--front 7"));
  EXPECT_TRUE(has(page, "Nothing has been proven"));
  EXPECT_FALSE(has(page, "✓ pass"));
  EXPECT_TRUE(has(page, "F 4.75")) << "known from run.json";
}

TEST_F(JointReportTest, AMatrixOfAnotherResultIsNotShown) {
  const fs::path file = run_ / "result" / "matrix.json";
  EXPECT_TRUE(has(page(), "without sums"));
  Json matrix = read_json(file);
  matrix["of"] = json_of(sums_of(run_, read_record_file<RunRecord>(run_ / "run.json")));
  matrix["with"] = {{"tasks/ahead/result/verdict.json",
                     sha256_hex(read_file(run_ / "tasks/ahead/result/verdict.json"))}};
  write_json(file, matrix, Durability::process);
  EXPECT_TRUE(has(page(), "✓ pass"));
  EXPECT_FALSE(has(joint_report_page(joint_data_of(read_run(run_))), "The verdicts are without"));
  Json of_others = matrix;
  of_others["with"]["tasks/ahead/result/verdict.json"] = "0";
  write_json(file, of_others, Durability::process);
  EXPECT_TRUE(has(page(), "matrix.json: not of the verdicts of its tasks: judge again"));
  write_json(file, matrix, Durability::process);
  const fs::path motion = run_ / "tasks/ahead/result/motion.csv";
  write_file(motion, read_file(motion) + "\n", Durability::process);
  const std::string page = this->page();
  EXPECT_FALSE(has(page, "✓ pass"));
  EXPECT_TRUE(has(page, "result/matrix.json is not of this result: judge again."));
}

TEST_F(JointReportTest, StaysSmallWhateverThePictures) {
  const Image picture(64, 48, {200, 120, 40});
  for (const char* task : {"ahead", "sideways"}) {
    write_png(run_ / "tasks" / task / "result" / "strip_physics.png", picture);
    write_file(run_ / "tasks" / task / "result" / "strip_before_after.png",
               std::string(2'500'000, 'x'));
  }
  const std::string page = this->page();
  EXPECT_LT(page.size(), 5'000'000U);
  EXPECT_TRUE(has(page, "ahead: what was planned."));
  EXPECT_FALSE(has(page, "sideways: what was planned."));
  EXPECT_TRUE(has(page, "sideways: what physics did."));
  EXPECT_TRUE(has(page, "More pictures are in the reports of the tasks."));
}

TEST_F(JointReportTest, WritesAPageForTheWholeAndForEachTask) {
  fs::remove(run_ / "tasks" / "sideways" / "run.json");
  const auto pages = write_report(run_);
  ASSERT_EQ(pages.size(), 2U) << "what cannot be read has no page";
  EXPECT_EQ(pages[0], run_ / "report.html");
  EXPECT_EQ(pages[1], run_ / "tasks" / "ahead" / "report.html");
  EXPECT_TRUE(has(read_file(pages[0]), "Could not be used: "));
  const std::string summary = read_file(run_ / "result" / "summary.md");
  EXPECT_TRUE(has(summary, "| for both tasks | 4.75, PASS | 4.75, PASS |")) << summary;
}

TEST_F(JointReportTest, SaysWhichGaitsWereChangedAfterTheirF) {
  const std::string words = "changed the gait of sideways";
  EXPECT_FALSE(has(page(), words));
  Json run = read_json(run_ / "run.json");
  run["tasks"][0]["physics_steps"] = physics_steps(false);
  run["tasks"][1]["physics_steps"] = physics_steps(true);
  write_json(run_ / "run.json", run, Durability::process);
  write_file(run_ / "result" / "certificate.json",
             R"({"schema":"legwright/certificate","version":1,"projected_gradient_norm":0,)"
             R"("worst_gradient_error":0,"design_curvatures":[],"active_bounds":[],"tasks":{}})");
  EXPECT_TRUE(has(page(), words));
  EXPECT_TRUE(has(page(), "It is of the gait"));
  EXPECT_TRUE(has(joint_report_summary(joint_data_of(read_run(run_))), words));
}

TEST_F(JointReportTest, RefusesTasksOutsideOfTheRun) {
  Json run = read_json(run_ / "run.json");
  run["tasks"][0]["folder"] = "../other";
  write_json(run_ / "run.json", run, Durability::process);
  EXPECT_THROW(write_report(run_), InputError);
}

TEST_F(JointReportTest, NamesTheKeyOfAMutilatedRun) {
  const Json whole = read_json(run_ / "run.json");
  for (const char* key : {"starts", "alone", "best_start", "final_F", "seconds"}) {
    Json run = whole;
    run.erase(key);
    write_json(run_ / "run.json", run, Durability::process);
    EXPECT_TRUE(has(refusal_of(run_), std::string("run.json: ") + key + ": expected a value"));
  }
  Json run = whole;
  run["tasks"][1]["F"] = "x";
  write_json(run_ / "run.json", run, Durability::process);
  EXPECT_TRUE(has(refusal_of(run_), "run.json: tasks[1].F: expected a number, found \"x\""));
}

TEST_F(JointReportTest, NotesFilesOfWrongTypes) {
  for (const char* text : {R"({"cells":{"ahead":[1,2,3],"sideways":{}}})", "["}) {
    for (const char* file : {"matrix.json", "front.json"}) write_file(run_ / "result" / file, text);
    const std::string page = this->page();
    expect_well_formed(page);
    for (const char* file : {"matrix.json: ", "front.json: "}) EXPECT_TRUE(has(page, file));
    EXPECT_TRUE(has(page, "Speeds and verdicts are not known yet."));
    EXPECT_NO_THROW(joint_report_summary(joint_data_of(read_run(run_))));
  }
}

TEST_F(JointReportTest, HostileNamesStayText) {
  const auto elements = [](const std::string& page) {
    return std::count(page.begin(), page.end(), '<');
  };
  write_run("plain");
  write_results("plain");
  const auto expected = elements(page());
  for (const std::string& raw : hostile_names()) {
    const std::string name = clean_utf8(raw);
    write_run(name);
    write_results(name);
    const std::string page = this->page();
    expect_well_formed(page);
    EXPECT_EQ(elements(page), expected) << name;
  }
  EXPECT_EQ(href_of("tasks/a b\"<'%/report.html"), "tasks/a%20b%22%3C%27%25/report.html");
}

}  // namespace
}  // namespace legwright
