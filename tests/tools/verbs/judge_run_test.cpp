// SPDX-License-Identifier: Apache-2.0
// A judgement is of what was played: never of a run that took its place, nor of one that it was
// copied to.
#include "tools/verbs/judge_run.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/io_error.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/rollout.hpp"
#include "tools/studio/verdict_lines.hpp"
#include "tools/verbs/export_facts.hpp"
#include "tools/verbs/judge_in_engine.hpp"
#include "tools/verbs/optimize_run.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

const fs::path kTask = fs::path(test::source_dir()) / "examples" / "puppy" / "sideways.toml";

/// A run of a gait alone.
void make_run(const fs::path& root) {
  OptimizeOptions options;
  options.quiet = options.one_start = options.motion_only = options.plan_only = true;
  options.no_pictures = options.no_reasons = options.no_certificate = true;
  options.threads = 1;
  CodesignProblem problem = read_problem(kTask.string(), "");
  CommandTimes times;
  (void)optimize_into(ResultFolder::create(root, false), problem, options, {}, times);
}

class JudgeRun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    load_gait_plugin();
    base_ = new test::TemporaryFolder;
    make_run(base_->path() / "run");
  }
  static void TearDownTestSuite() { delete base_; }
  JudgeRun() {
    fs::copy(base_->path() / "run", run_, fs::copy_options::recursive);
    options_.validation.cycles = 4;
    options_.validation.threads = 1;
    options_.numerics = options_.robustness = options_.stability = false;
  }
  /// The puppy's run as it stands by the next moment: with another result.
  void replace() const {
    write_file(run_ / "result/motion.csv", read_file(run_ / "result/motion.csv") + "\n");
  }
  VerdictRecord verdict() const {
    return read_record_file<VerdictRecord>(run_ / "result/verdict.json");
  }

  static inline test::TemporaryFolder* base_ = nullptr;
  const test::TemporaryFolder folder_;
  const fs::path run_ = folder_.path() / "run";
  JudgeOptions options_;
};

TEST_F(JudgeRun, WhatWasJudgedIsNamedByItsSums) {
  const JudgedRun judged = judge_run(ResultFolder::open(run_), options_);
  const VerdictRecord verdict = this->verdict();
  ASSERT_TRUE(verdict.of && verdict.with);
  EXPECT_EQ(standing_of(verdict.of, sums_of_run(run_)), Standing::of_this);
  EXPECT_EQ(verdict.of->find(kLimitsSum)->size(), 64U);
  EXPECT_EQ(*verdict.of->find("result/scene.xml"),
            sha256_hex(read_file(run_ / "result/scene.xml")));
  for (const char* name :
       {"metrics.json", "comparison.json", "playback_initial.csv", "playback_result.csv"})
    EXPECT_TRUE(names_bytes(*verdict.with, name, run_ / "result" / name)) << name;
  EXPECT_EQ(verdict.with->size(), 4U);
  for (const char* name : {"metrics.json", "comparison.json"})
    EXPECT_EQ(read_json(run_ / "result" / name)["of"], json_of(*verdict.of)) << name;
  EXPECT_NE(verdict_lines(run_)["verdict"]["word"], "UNKNOWN");

  JudgeOptions others = options_;
  others.validation.limits["tilt_max_rad"].high = 0.5;
  (void)judge_run(ResultFolder::open(run_), others);
  EXPECT_NE(*this->verdict().of->find(kLimitsSum), *verdict.of->find(kLimitsSum));
}

TEST_F(JudgeRun, NothingIsWrittenIntoARunThatWasReplacedMeanwhile) {
  const ResultFolder folder = ResultFolder::open(run_);
  JudgedRun judged = play_and_judge(folder, {}, options_);
  const std::string metrics = read_file(run_ / "result/metrics.json");
  replace();
  try {
    write_judged(folder, judged);
    FAIL() << "a verdict on another run";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("the run was replaced meanwhile: judge again"),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists(run_ / "result/verdict.json"));
  EXPECT_EQ(read_file(run_ / "result/metrics.json"), metrics);
}

TEST_F(JudgeRun, ASecondEngineDoesNotWriteIntoOneEither) {
  const ResultFolder folder = ResultFolder::open(run_);
  bool replaces = false;
  const Engine gives_up{
      "mine", "1", [&](const Scene& scene) -> EngineStepper {
        if (replaces) replace();
        const auto numbers = [](int count) -> Eigen::VectorXd {
          return Eigen::VectorXd::Constant(count, std::nan(""));
        };
        const mjModel& model = *scene.model;
        return [=, &model](double) {
          return EngineStep{numbers(model.nq), numbers(model.nv), numbers(model.nu), {}};
        };
      }};
  EngineOptions options;
  options.cycles = 4;
  options.write = true;
  (void)judge_in_engine(folder, gives_up, options);
  const fs::path file = run_ / "result/validation_mine.json";
  EXPECT_EQ(standing_of(read_record_file<EngineRecord>(file).of, sums_of_result(run_)),
            Standing::of_this);
  fs::remove(file);
  const std::string scene = read_file(run_ / "result/scene.xml");
  write_file(run_ / "result/scene.xml", scene + "\n");
  EXPECT_THROW(judge_in_engine(folder, gives_up, options), InputError) << "an edited scene";
  write_file(run_ / "result/scene.xml", scene);
  replaces = true;
  EXPECT_THROW(judge_in_engine(folder, gives_up, options), IoError);
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(JudgeRun, APlayInAnEngineIsStoppedOnTheWay) {
  EngineOptions options;
  options.cycles = 4;
  int asked = 0;
  options.stop = [&] { return ++asked > 1; };
  EXPECT_THROW((void)judge_in_engine(ResultFolder::open(run_), {"mujoco", "1", {}}, options),
               RolloutStopped);
  EXPECT_EQ(asked, 2);
}

TEST_F(JudgeRun, FilesThatDoNotBelongTogetherAreNotJudged) {
  const auto refusal = [&] {
    try {
      (void)judge_run(ResultFolder::open(run_), options_);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("judged");
  };
  const auto changed = [&](const char* name, const std::string& from, const std::string& to) {
    const fs::path file = run_ / name;
    const std::string good = read_file(file);
    const std::size_t at = good.find(from);
    EXPECT_NE(at, std::string::npos) << name;
    write_file(file, std::string(good).replace(at, from.size(), to));
    const std::string told = refusal();
    write_file(file, good);
    return told;
  };
  EXPECT_NE(changed("inputs/task.toml", "0.1]", "0.2]").find("not what the run started from"),
            std::string::npos);
  EXPECT_NE(changed("inputs/robot.xml", "<mujoco", "<!-- mine --><mujoco").find("not what the run"),
            std::string::npos);
  EXPECT_NE(changed("result/robot.xml", "mass=\"1\"", "mass=\"3\"").find("is not the robot of"),
            std::string::npos);
  for (const char* scene : {"iterations/0000/scene.xml", "result/scene.xml"})
    EXPECT_NE(changed(scene, "friction=\"0.8 ", "friction=\"0.4 ").find("was edited since"),
              std::string::npos)
        << scene;
  const fs::path motion = run_ / "result/motion.csv";
  const std::string good = read_file(motion);
  std::string other = good;
  for (std::size_t at = 0; (at = other.find("FL_hip", at)) != std::string::npos;)
    other.replace(at, 6, "FL_hop");
  write_file(motion, other);
  EXPECT_NE(refusal().find("number 1 is 'FL_hop' in one and 'FL_hip' in the other"),
            std::string::npos);
  write_file(motion, good);
  EXPECT_EQ(refusal(), "judged");
}

TEST_F(JudgeRun, LinksInARunAreNotWrittenThrough) {
  const fs::path other = folder_.path() / "other.json";
  write_file(other, "mine\n");
  fs::create_symlink(other, run_ / "result/verdict.json");
  EXPECT_THROW((void)ResultFolder::open_to_write(run_), InputError);
  EXPECT_EQ(read_file(other), "mine\n");
  fs::remove(run_ / "result/verdict.json");
  fs::create_symlink(other, run_ / "report.html");
  EXPECT_THROW((void)ResultFolder::open_to_write(run_), InputError);
  fs::remove(run_ / "report.html");
  for (const char* mine : {"notes.md", "result/skin.png"})  // nobody writes there
    fs::create_symlink(other, run_ / mine);
  EXPECT_NO_THROW((void)ResultFolder::open_to_write(run_));
  fs::rename(run_ / "iterations", folder_.path() / "elsewhere");
  fs::create_directory_symlink(folder_.path() / "elsewhere", run_ / "iterations");
  EXPECT_THROW((void)ResultFolder::open_to_write(run_), InputError);
}

TEST_F(JudgeRun, LinksThatCannotTouchAreTold) {
  (void)judge_run(ResultFolder::open(run_), options_);
  ASSERT_TRUE(verdict().never_touch);
  EXPECT_EQ(verdict().never_touch->links.size(), 9U);
  EXPECT_EQ(verdict().never_touch->line.find("9 of 13 links have no shape"), 0U);
}

TEST_F(JudgeRun, AVerdictFromElsewhereIsBelievedByNobody) {
  (void)judge_run(ResultFolder::open(run_), options_);
  const std::string line = verdict().result.line;
  const auto told = [&] {
    const ExportFacts facts = facts_of(read_exported_run(run_), run_, "puppy");
    return facts.verdicts.at(0);
  };
  EXPECT_EQ(told(), line);
  Json old = json_of(verdict());
  for (const char* key : {"of", "with"}) old.erase(key);
  const std::string ours = read_file(run_ / "result/verdict.json");
  write_json(run_ / "result/verdict.json", old);
  EXPECT_NE(told().find(line + " (without sums"), std::string::npos) << told();
  EXPECT_NE(verdict_lines(run_)["verdict"]["words"].get<std::string>().find("without sums"),
            std::string::npos);
  write_file(run_ / "result/verdict.json", ours);
  replace();
  EXPECT_EQ(told(), "result/verdict.json is not of this result: judge again");
  const Json lines = verdict_lines(run_);
  EXPECT_EQ(lines["verdict"]["word"], "UNKNOWN");
  EXPECT_EQ(lines["verdict"]["words"], "not of this result: judge again");
  EXPECT_TRUE(lines["lines"].empty());
}

TEST_F(JudgeRun, WhatElseStandsBesideTheResultStays) {
  (void)judge_run(ResultFolder::open(run_), options_);
  const fs::path result = run_ / "result";
  fs::create_directory(result / "mine");
  write_file(result / "mine/notes.txt", "mine\n");
  fs::create_symlink("../run.json", result / "skin.png");
  fs::permissions(result, fs::perms::owner_all | fs::perms::group_exec);
  options_.validation.cycles = 5;
  (void)judge_run(ResultFolder::open(run_), options_);
  EXPECT_EQ(read_json(result / "metrics.json")["cycles"], 5);
  EXPECT_EQ(read_file(result / "mine/notes.txt"), "mine\n");
  EXPECT_EQ(read_file(result / "skin.png"), read_file(run_ / "run.json"));
  EXPECT_EQ(fs::read_symlink(result / "skin.png"), "../run.json");
  EXPECT_EQ(fs::status(result).permissions(), fs::perms::owner_all | fs::perms::group_exec);
  for (const auto& entry : fs::directory_iterator(run_))
    EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST_F(JudgeRun, WhoStandsInTheResultStillStandsInIt) {
  const fs::path before = fs::current_path();
  fs::current_path(run_ / "result");
  (void)judge_run(ResultFolder::open(".."), options_);
  EXPECT_TRUE(fs::exists("verdict.json"));
  EXPECT_TRUE(fs::equivalent(".", run_ / "result"));
  fs::current_path(before);
}

TEST_F(JudgeRun, PicturesOfAnotherJudgementGoAway) {
  const ResultFolder folder = ResultFolder::open(run_);
  const fs::path picture = run_ / "result/strip_physics.png";
  write_file(run_ / "result/gait.webp", "drawn before it was judged");
  (void)judge_run(folder, options_);
  EXPECT_TRUE(fs::exists(run_ / "result/gait.webp"));
  write_file(picture, "of this judgement");
  (void)judge_run(folder, options_);
  EXPECT_TRUE(fs::exists(picture)) << "the same again";
  options_.validation.cycles = 5;
  (void)judge_run(folder, options_);
  EXPECT_FALSE(fs::exists(picture));
  EXPECT_FALSE(fs::exists(run_ / "result/gait.webp"));
}

}  // namespace
}  // namespace legwright
