// SPDX-License-Identifier: Apache-2.0
// legwright pick: another design of a run becomes its result.
#include <gtest/gtest.h>

#include "tests/tools/verbs/program.hpp"
#include "tests/tools/verbs/run_schemas.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCanter =
    "[gait]\nname = \"canter\"\nperiod = 0.25\n[travel]\nvelocity = [0.1, 0.0]\n";

class Pick : public testing::Test, protected test::CallsInFolder {
 protected:
  void optimize(const std::vector<std::string>& more, int code = 0) {
    write_file(
        folder_.path() / "canter.toml",
        "robot = \"" + (test::kExamples / "quadruped/robot.xml").string() + "\"\n" + kCanter);
    std::vector<std::string> words{"optimize", "canter.toml",   "-o",
                                   "run",      "--no-pictures", "--no-certificate"};
    words.insert(words.end(), more.begin(), more.end());
    const test::Outcome outcome = call(words);
    ASSERT_EQ(outcome.code, code) << outcome.err;
  }
  Json run() const { return Json::parse(read_file(folder_.path() / "run" / "run.json")); }
  std::string file(const std::string& name) const {
    return read_file(folder_.path() / "run" / name);
  }
};

TEST_F(Pick, MakesAnIterationTheResultAndTheRecordSaysSo) {
  optimize({"--plan-only"});
  EXPECT_FALSE(run().contains("choice"));  // nothing was played
  ASSERT_EQ(call({"report", "run"}).code, 0);
  const test::Outcome picked = call({"pick", "run", "--iteration", "0"});
  ASSERT_EQ(picked.code, 0) << picked.err;
  for (const char* name : {"robot.xml", "scene.xml", "motion.csv", "metrics.json"})
    EXPECT_EQ(file(std::string("result/") + name), file(std::string("iterations/0000/") + name));
  const Json record = run();
  EXPECT_EQ(record["picked"], "iteration 0");
  EXPECT_EQ(record["final_F"], record["motion_only_F"]);
  for (const char* key : {"put_back", "fewest_changes", "certificate"})
    EXPECT_FALSE(record.contains(key)) << key << " is of the design before";
  for (const Json& parameter : record["parameters"])
    EXPECT_EQ(parameter["final"], parameter["initial"]) << parameter["name"];
  EXPECT_EQ(test::expect_schemas(folder_.path() / "run")["run"], 1);
  EXPECT_FALSE(fs::exists(folder_.path() / "run/report.html")) << "of the design before";
  EXPECT_LE(call({"validate", "run", "--quick"}).code, 1);
  EXPECT_EQ(call({"report", "run"}).code, 0);
}

TEST_F(Pick, FindsTheOptimumWherePhysicsChoseAnotherDesign) {
  optimize({});
  const std::string chosen = file("result/robot.xml");
  const Json choice = run()["choice"];
  ASSERT_NE(choice["chosen"], "optimum");
  EXPECT_TRUE(choice["pass"].get<bool>());
  EXPECT_EQ(call({"validate", "run", "--quick"}).code, 0);

  const test::Outcome picked = call({"pick", "run", "--candidate", "optimum"});
  ASSERT_EQ(picked.code, 0) << picked.err;
  EXPECT_TRUE(test::contains(picked.out, "back: legwright pick run --candidate '" +
                                             choice["chosen"].get<std::string>() + "'\n"))
      << picked.out;
  EXPECT_EQ(run()["picked"], "optimum");
  EXPECT_EQ(run()["final_F"], choice["candidates"][0]["F"]);
  EXPECT_FALSE(run()["feasible"].get<bool>());
  EXPECT_TRUE(test::contains(run()["reasons"].dump(), "MuJoCo does not pass it"));
  EXPECT_EQ(call({"validate", "run", "--quick"}).code, 1);  // as the roll-outs had said
  EXPECT_EQ(test::expect_schemas(folder_.path() / "run")["run"], 1);

  // And back: what physics had chosen is not lost.
  ASSERT_EQ(call({"pick", "run", "--candidate", choice["chosen"].get<std::string>()}).code, 0);
  EXPECT_EQ(file("result/robot.xml"), chosen);
  EXPECT_TRUE(run()["feasible"].get<bool>());
  EXPECT_EQ(call({"validate", "run", "--quick"}).code, 0);
}

TEST_F(Pick, IsDoneAgainWhereItWasKilledOnTheWay) {
  optimize({"--plan-only"});
  write_file(folder_.path() / "run/.result-picking", "iteration 0\n");  // as a killed one leaves it
  fs::copy_file(folder_.path() / "run/iterations/0000/scene.xml",
                folder_.path() / "run/result/scene.xml", fs::copy_options::overwrite_existing);
  for (const char* reader : {"validate", "report", "export"}) {
    const test::Outcome refused = call({reader, "run"});
    EXPECT_EQ(refused.code, 3) << reader;
    EXPECT_TRUE(test::contains(refused.err, "between two results")) << refused.err;
  }
  ASSERT_EQ(call({"pick", "run", "--iteration", "0"}).code, 0);
  EXPECT_FALSE(fs::exists(folder_.path() / "run/.result-picking"));
  EXPECT_EQ(run()["picked"], "iteration 0");
  EXPECT_EQ(call({"report", "run"}).code, 0);
}

TEST_F(Pick, PutsARunsOwnDesignInThePlaceOfAnEditedOne) {
  optimize({"--plan-only", "--max-iterations", "1"});
  const auto edit = [&](const std::string& name) {
    const std::string scene = file(name);
    const std::size_t at = scene.find("friction=\"0.8 ");
    ASSERT_NE(at, std::string::npos);
    write_file(folder_.path() / "run" / name,
               std::string(scene).replace(at, 14, "friction=\"0.4 "));
  };
  edit("result/scene.xml");
  const std::string before = file("run.json");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"validate", "run", "--quick"}, {"export", "run", "-o", "mine"}, {"render", "run"}}) {
    const test::Outcome refused = call(words);
    EXPECT_EQ(refused.code, 2) << words[0] << refused.err;
    EXPECT_TRUE(test::contains(refused.err, "run/result/scene.xml: was edited since the run"))
        << refused.err;
  }
  for (const char* written : {"mine", "run/result/verdict.json", "run/iterations/0000/frame.png"})
    EXPECT_FALSE(fs::exists(folder_.path() / written)) << written;
  EXPECT_EQ(file("run.json"), before);
  ASSERT_EQ(call({"pick", "run", "--iteration", "0"}).code, 0);
  EXPECT_LE(call({"validate", "run", "--quick"}).code, 1);
  const std::string picked = file("run.json");
  edit("iterations/0000/scene.xml");
  const test::Outcome refused = call({"pick", "run", "--iteration", "0"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(test::contains(refused.err, "run/iterations/0000/scene.xml: was edited"))
      << refused.err;
  EXPECT_EQ(file("run.json"), picked);
}

TEST_F(Pick, RefusesWhatThereIsNotAndChangesNothing) {
  optimize({"--plan-only", "--max-iterations", "1"});
  const std::string before = file("run.json");
  const auto refused = [&](const std::vector<std::string>& words, const std::string& why) {
    std::vector<std::string> all{"pick", "run"};
    all.insert(all.end(), words.begin(), words.end());
    const test::Outcome outcome = call(all);
    EXPECT_EQ(outcome.code, 2) << outcome.out;
    EXPECT_TRUE(test::contains(outcome.err, why)) << outcome.err;
  };
  refused({}, "--iteration, --start, --front and --candidate");
  refused({"--iteration", "1", "--front", "0"}, "one of");
  refused({"--iteration", "99"}, "no such design");
  refused({"--start", "random-1"}, "no start 'random-1'");
  refused({"--front", "0"}, "--front N");
  refused({"--candidate", "optimum"}, "keeps no candidates");
  EXPECT_EQ(file("run.json"), before);
}

}  // namespace
}  // namespace legwright
