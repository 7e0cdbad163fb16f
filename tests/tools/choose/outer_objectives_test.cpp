// SPDX-License-Identifier: Apache-2.0
// An outer objective lowers what MuJoCo measures, at all gains: the same task co-designed without J
// and with it, at weight 1, on two robots.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

#include "tests/tools/choose/problems.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/run/outer_measured.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/validate/measure.hpp"

namespace legwright {
namespace {

constexpr int kCycles = 6;

/// A body with its gait, as the search for F or F + J hands it back.
struct Found {
  CodesignProblem problem;
  DesignIteration best;

  double plan(const std::string& objective) const {
    const CodesignProblem measured =
        test::problem_of(problem.robot.file.parent_path().filename(), task_text(objective));
    return measured.outers[0]->amount_at(best.s, best.tasks[0].m);
  }
  static std::string task_text(const std::string& objective) {
    const std::string walk =
        "[gait]\nname = \"walk\"\nperiod = 1.0\nknots = 24\n[travel]\nvelocity = [0.1, 0.0]\n"
        "[limits]\nswing_height = 0.015\n";
    return objective.empty() ? walk : walk + "[outer]\nobjective = \"" + objective + "\"\n";
  }
};

Found search(const std::string& robot, const std::string& objective) {
  Found found{test::problem_of(robot, Found::task_text(objective)), {}};
  const ProblemCosts costs(found.problem);
  const DesignSpace& space = found.problem.robot.space;
  const JointTask& task = costs.tasks()[0];
  const CodesignResult result =
      codesign({weighted(task, 1.0, task.guess(space.initial()))}, space, space.initial());
  EXPECT_NE(result.status, SolveStatus::not_finite);
  found.best = result.best;
  return found;
}

class OuterObjectives : public testing::TestWithParam<const char*> {
 protected:
  static void SetUpTestSuite() { load_gait_plugin(); }
  /// Without J, found once for each robot.
  static const Found& plain() {
    static std::map<std::string, Found> known;
    const auto [at, isnew] = known.try_emplace(GetParam());
    if (isnew) at->second = search(GetParam(), "");
    return at->second;
  }
  /// What MuJoCo measures at half, default and double gains.
  static std::array<double, 3> measured(const Found& found, const std::string& objective) {
    const CodesignProblem& problem = found.problem;
    const DesignTexts texts =
        design_texts(problem.robot, *problem.objectives[0], found.best.s, found.best.tasks[0].m);
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Scene scene = parse_scene(texts.scene_xml, "scene.xml", std::array{0.5, 1.0, 2.0}[k],
                                      problem.robot.files.folder());
      RolloutOptions options;
      options.cycles = kCycles;
      GainMetrics metrics;
      const Measurements run =
          measure(scene, {problem.task(0).velocity, 0.0}, texts.quality.planned_velocity, options);
      static_cast<RolloutMetrics&>(metrics) = run;
      const auto amount = measured_amount(objective, metrics);
      EXPECT_TRUE(amount) << "it falls at " << run.gain_scale << " of the gains";
      out[k] = amount.value_or(0.0);
    }
    return out;
  }
  static void expect_falls(const std::string& objective) {
    const Found lowered = search(GetParam(), objective);
    EXPECT_LT(lowered.plan(objective), plain().plan(objective));
    const auto before = measured(plain(), objective), after = measured(lowered, objective);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_LT(after[k], before[k]) << "gains " << std::array{0.5, 1.0, 2.0}[k];
  }
};

TEST_P(OuterObjectives, PeakTorqueFallsAtAllGains) { expect_falls("peak_torque"); }

TEST_P(OuterObjectives, MechanicalWorkFallsAtAllGains) { expect_falls("mechanical_work"); }

class PrintedObjectives : public OuterObjectives {};

// Nothing that gains have a say in: what the written robot's parts have, by MuJoCo's own masses.
TEST_P(PrintedObjectives, PrintedVolumeFallsWithTheMassOfTheRobot) {
  const Found lowered = search(GetParam(), "printed_volume");
  EXPECT_LT(lowered.plan("printed_volume"), plain().plan("printed_volume"));
  const auto mass = [](const Found& found) {
    const CodesignProblem& problem = found.problem;
    const DesignTexts texts =
        design_texts(problem.robot, *problem.objectives[0], found.best.s, found.best.tasks[0].m);
    const Scene scene =
        parse_scene(texts.scene_xml, "scene.xml", 1.0, problem.robot.files.folder());
    return scene.model->body_subtreemass[scene.joints.root_body];
  };
  EXPECT_LT(mass(lowered), mass(plain()));
}

INSTANTIATE_TEST_SUITE_P(Robots, OuterObjectives, testing::Values("printed_quadruped", "puppy"),
                         [](const auto& instance) { return std::string(instance.param); });

INSTANTIATE_TEST_SUITE_P(Robots, PrintedObjectives,
                         testing::Values("printed_quadruped", "piston_puppy"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace legwright
