// SPDX-License-Identifier: Apache-2.0
// A tightened task as a file that anybody can read, change and run.
#include "tools/choose/tightened_text.hpp"

#include <gtest/gtest.h>

#include "optimizer/terms/registry.hpp"
#include "tests/tools/choose/problems.hpp"
#include "tools/choose/tightened_search.hpp"

namespace legwright {
namespace {

constexpr double kLastBits = 1e-14;

GaitTrial seen() {
  GaitTrial trial;
  trial.speed_ratio = 0.95;
  trial.heading_drift = 0.01;
  return trial;
}

CodesignProblem problem_of_text(const CodesignProblem& like, const std::string& text) {
  return make_problem(parse_task_set(text, "tightened.toml", like.robot.file), like.robot);
}

void expect_same(const Task& read, const Task& tightened) {
  EXPECT_EQ(read.velocity, tightened.velocity);
  EXPECT_EQ(read.turn_rate, tightened.turn_rate);
  EXPECT_EQ(read.planted_margin, tightened.planted_margin);
  EXPECT_EQ(read.follow_hips, tightened.follow_hips);
  EXPECT_NEAR(*read.swing_height, *tightened.swing_height, kLastBits);
  EXPECT_NEAR(read.torque_margin, tightened.torque_margin, kLastBits);
  EXPECT_NEAR(read.min_normal, tightened.min_normal, kLastBits);
  EXPECT_NEAR(read.friction, tightened.friction, kLastBits);
  ASSERT_EQ(read.footprint.has_value(), tightened.footprint.has_value());
  if (read.footprint) {
    EXPECT_EQ(*read.footprint, *tightened.footprint);
  }
  for (const auto& [term, weight] : tightened.weights) {
    const auto found = read.weights.find(term);
    const double without = find_term(term)->default_weight;
    EXPECT_NEAR(found == read.weights.end() ? without : found->second, weight, kLastBits * weight)
        << term;
  }
}

TEST(TightenedText, SaysEachLeverInKeys) {
  const CodesignProblem trot = test::trot();
  for (const Lever lever : all_levers()) {
    const Tightening once = Tightening{}.with(lever, seen()), twice = once.with(lever, seen());
    for (const Tightening& tightening : {once, lever == Lever::short_stance ? once : twice}) {
      SCOPED_TRACE(tightening.words());
      const std::string text = tightened_text(trot, {tightening}, "beside.xml");
      EXPECT_EQ(text.find("name = \"task\"\nrobot = \"beside.xml\"\n"), 0U) << text;
      const CodesignProblem read = problem_of_text(trot, text);
      expect_same(read.objectives[0]->task(), tightened_task(trot, 0, tightening));
      EXPECT_EQ(read.task(0).velocity, trot.task(0).velocity) << "what is wanted stays";
      EXPECT_EQ(read.task(0).turn_rate, trot.task(0).turn_rate);
    }
  }
}

TEST(TightenedText, LeavesWhatIsNotTightenedByteForByte) {
  const CodesignProblem trot = test::trot();
  const std::string text = tightened_text(trot, {Tightening{}}, trot.set.robot.string());
  EXPECT_EQ(text, "name = \"task\"\n" + trot.set.text) << "it is called as before";
}

TEST(TightenedText, IsOfTheTasksOwnTableWhereThereIsOneOfOne) {
  const CodesignProblem one =
      test::problem_of("quadruped",
                       "[[task]]\nname = \"trot\"\n[task.gait]\nname = \"trot\"\nperiod = 0.4\n"
                       "[task.travel]\nvelocity = [0.4, 0.0]\n[task.limits]\nfriction = 0.35\n");
  const Tightening tightening = Tightening{}.with(Lever::margins, seen()).with(Lever::aim, seen());
  const CodesignProblem read = problem_of_text(one, tightened_text(one, {tightening}, "robot.xml"));
  expect_same(read.objectives[0]->task(), tightened_task(one, 0, tightening));
}

TEST(TightenedText, IsNoneWhereAKeyHasNoSuchNumber) {
  const CodesignProblem fast =
      test::problem_of("quadruped",
                       "[gait]\nname = \"trot\"\nperiod = 0.4\n"
                       "[travel]\nvelocity = [0.1, 0.0]\naim_speed = 2.0\n");
  EXPECT_EQ(tightened_text(fast, {Tightening{}.with(Lever::aim, seen())}, "robot.xml"), "");
}

TEST(TightenedText, TightensOneOfSeveralTasks) {
  const CodesignProblem both =
      test::problem_of("quadruped",
                       "[limits]\nfriction = 0.35  # of both\n"
                       "[[task]]\nname = \"trot\"\n[task.gait]\nname = \"trot\"\nperiod = 0.4\n"
                       "[task.travel]\nvelocity = [0.4, 0.0]\n"
                       "[[task]]\nname = \"walk\"\n[task.gait]\nname = \"walk\"\nperiod = 0.8\n"
                       "[task.travel]\nvelocity = [0.0, 0.1]\n");
  Tightening tightening = Tightening{}.with(Lever::margins, seen()).with(Lever::wide, seen());
  tightening = tightening.with(Lever::aim, seen()).with(Lever::quick_legs, seen());
  const std::string text = tightened_text(both, {Tightening{}, tightening}, "robot.xml");
  EXPECT_NE(text.find("friction = 0.35  # of both"), std::string::npos) << text;
  const CodesignProblem read = problem_of_text(both, text);
  expect_same(read.objectives[0]->task(), both.objectives[0]->task());
  expect_same(read.objectives[1]->task(), tightened_task(both, 1, tightening));
}

}  // namespace
}  // namespace legwright
