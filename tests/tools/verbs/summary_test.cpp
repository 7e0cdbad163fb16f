// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/summary.hpp"

#include <gtest/gtest.h>

#include "tools/run/run_record.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

/// A body that was found.
RunRecord found_run() {
  RunRecord run;
  run.robot = "puppy";
  run.task.emplace().name = "walk";
  run.status = "converged";
  run.motion_only = false;
  run.design_iterations = 3;
  run.newton_iterations = 40;
  run.motion_only_F = 2.0;
  run.final_F = 1.0;
  run.speed_reached = run.speed_wanted = 0.1;
  run.peak_rss_mib = 100.0;
  run.reasons.emplace();
  run.feasible = true;
  return run;
}

TEST(OptimizeSummary, TellsTheWholeCommandAndItsParts) {
  RunRecord run = found_run();
  run.seconds = {{"total", 1.2},      {"motion", 1.0}, {"adjoint", 0.1},
                 {"predictor", 0.05}, {"files", 0.2},  {"command", 6.25},
                 {"reading", 0.5},    {"search", 1.5}, {"certificate", 4.25}};
  FewestChangesRecord& fewest = run.fewest_changes.emplace();
  fewest.share = 0.95;
  fewest.fewest = 1;
  fewest.designs = {{{"a", "b", "c"}, 1.0, {}}, {{"a", "b"}, 1.04, {}}, {{"b"}, 1.8, {}}};
  const std::string changes = "  changes  2 of 3 keep 95 % of the fall of F (F 1.04)";
  EXPECT_NE(optimize_summary(run, "runs/a").find(changes + "\n"), std::string::npos);
  fewest.designs[0].played = fewest.designs[2].played = {0.0, true, "PASS"};
  fewest.designs[1].played = {1.0, false, "FAIL"};
  const std::string text = optimize_summary(run, "runs/a");
  EXPECT_NE(
      text.find(
          changes +
          "; of these bodies the least changed that MuJoCo passes, for some cycles: 1 (F 1.8)\n"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("  time     6.25 s: reading 0.50, search 1.50 (motion 1.00, adjoint 0.10, "
                      "predictor 0.05, files 0.20), certificate 4.25\n"),
            std::string::npos)
      << text;
}

TEST(OptimizeSummary, OfAStoppedSearchTellsHowItGoesOn) {
  RunRecord run = found_run();
  run.status = "interrupted";
  run.final_F = run.motion_only_F;
  run.reasons = std::vector<std::string>{"a foot slips"};
  run.feasible = false;
  const std::string text = optimize_summary(run, "runs/a");
  EXPECT_NE(text.find("  not yet: a foot slips\n"), std::string::npos) << text;
  EXPECT_NE(text.find("next: legwright optimize --resume runs/a"), std::string::npos) << text;
  EXPECT_EQ(text.find("motion-only"), std::string::npos) << text;
  run.status = "converged";
  const std::string whole = optimize_summary(run, "runs/a");
  EXPECT_NE(whole.find("  INFEASIBLE: a foot slips\n"), std::string::npos) << whole;
  EXPECT_NE(whole.find("next: legwright validate runs/a"), std::string::npos) << whole;
}

/// Not a design whose start is called after a task of that name, nor one that was picked instead.
TEST(OptimizeSummary, TellsWhenFOfFewerChangesIsThatOfATightenedSearch) {
  RunRecord run;
  run.task.emplace().name = "walk";
  run.status = "converged";
  run.reasons.emplace();
  run.feasible = true;
  run.seconds.emplace();
  FewestChangesRecord& fewest = run.fewest_changes.emplace();
  fewest.share = 0.95;
  fewest.fewest = 1;
  fewest.designs = {{{"a", "b"}, 1.0, {}}, {{"a"}, 1.04, {}}};
  const auto told = [&] {
    return optimize_summary(run, "runs/a").find("(F 1.04) of the tightened search") !=
           std::string::npos;
  };
  EXPECT_FALSE(told());
  for (const char* name : {"tightened: larger margins", "initial, tightened motion: more clearance",
                           "from pace, tightened: wider stance"}) {
    run.choice.emplace().chosen = name;
    EXPECT_TRUE(told()) << name;
  }
  run.picked = "optimum";
  EXPECT_FALSE(told());
  run.picked.reset();
  for (const char* name : {"optimum", "from tightened_walk-alone"}) {
    run.choice->chosen = name;
    EXPECT_FALSE(told()) << name;
  }
}

TEST(ViewerCure, SaysWhatStandsInTheWay) {
  EXPECT_FALSE(is_packaged());  // that one is python/tests/test_wheel.py's
  const std::string cure = viewer_cure();
  EXPECT_TRUE(cure.find("--target legwright_viewer") != std::string::npos ||
              cure.find("configured without viewers: ") != std::string::npos)
      << cure;
}

TEST(RunCommand, PassesWordsUntouchedAndTellsTheExitStatus) {
  std::string output;
  EXPECT_EQ(run_command({"printf", "%s|", "a b", "$HOME", "'"}, &output), 0);
  EXPECT_EQ(output, "a b|$HOME|'|");
  EXPECT_EQ(run_command({"sh", "-c", "exit 7"}), 7);
  EXPECT_EQ(run_command({"no-such-program-of-legwright"}), -1);
}

TEST(ViewerCommand, SurvivesQuotesInPaths) {
  const auto command = viewer_command("python3", "/a/it's/p.so", "/b \\ c/scene.xml");
  ASSERT_EQ(command.size(), 3u);
  EXPECT_NE(command[2].find("mj_loadPluginLibrary('/a/it\\'s/p.so')"), std::string::npos)
      << command[2];
  EXPECT_NE(command[2].find("from_xml_path('/b \\\\ c/scene.xml')"), std::string::npos)
      << command[2];
}

}  // namespace
}  // namespace legwright
