// SPDX-License-Identifier: Apache-2.0
#include "tools/render/film_strip.hpp"

#include <cmath>
#include <filesystem>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/render/toy_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/render/poses.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {
namespace {

Trajectory toy_plan(double heading = 0.3) {
  Trajectory plan = blank_trajectory({"left", "right"}, {"L", "R"}, 8, 0.8);
  plan.travel = {0.0, 0.08, 0.0};
  for (int k = 0; k < 8; ++k) {
    plan.at(k, plan.root_column(1)) = 0.01 * k;
    plan.at(k, plan.root_column(2)) = 0.28;
    plan.at(k, plan.root_column(5)) = heading;
    plan.at(k, plan.target_column(0)) = 0.25;
    plan.at(k, plan.foot_column(0, 1)) = 0.06 + 0.01 * k;
    plan.at(k, plan.foot_column(1, 1)) = -0.06 + 0.01 * k;
    plan.at(k, plan.contact_column(0)) = k < 4 ? 1 : 0;
    plan.at(k, plan.contact_column(1)) = k < 4 ? 0 : 1;
  }
  return plan;
}

TEST(PlannedPoses, AreTheSplineInTheOrderOfTheModel) {
  const ModelPointer model = toy_model();
  const Poses poses = planned_poses(*model, toy_plan(), 4, "toy.xml");
  ASSERT_EQ(poses.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_EQ(poses[k].size(), 9U);
    EXPECT_NEAR(poses[k][1], 0.02 * static_cast<double>(k),
                1e-12);  // a straight line, also over the cycle's end
    EXPECT_NEAR(poses[k][2], 0.28, 1e-12);
    EXPECT_NEAR(poses[k][3], std::cos(0.15), 1e-12);  // quaternion of a turn about z
    EXPECT_NEAR(poses[k][6], std::sin(0.15), 1e-12);
    EXPECT_NEAR(poses[k][7], 0.25, 1e-12);
    EXPECT_NEAR(poses[k][8], 0.0, 1e-12);
  }
}

TEST(PlannedPoses, GoRoundTheCircleAsThePluginDoes) {
  const ModelPointer model = toy_model();
  for (const double turn : {0.0, 0.25, -1.3}) {
    Trajectory plan = toy_plan();
    plan.travel = {0.1, 0.02, 0.0};
    plan.turn = turn;
    for (int k = 0; k < 8; ++k) {
      plan.at(k, plan.root_column(0)) = 0.5 + 0.0125 * k;
      plan.at(k, plan.root_column(3)) = 0.1 * std::sin(k);  // roll, so that turns do not just add
      plan.at(k, plan.root_column(5)) = turn * k / 8;
    }
    const JointMap map = map_joints(*model, plan.joint_names);
    for (const double cycle : {0.0, 0.3, 5.0, 5.9}) {
      const double time = cycle * plan.period;
      const auto pose = planned_poses(*model, plan, std::vector<double>{time}, "toy.xml").front();
      const auto played = played_state(*model, map, plan, time).qpos;
      double same = 0.0;  // a quaternion and its negative are one rotation
      for (Eigen::Index i = 3; i < 7; ++i) same += pose[static_cast<std::size_t>(i)] * played[i];
      EXPECT_NEAR(std::abs(same), 1.0, 1e-12) << turn << " cycle " << cycle;
      for (const Eigen::Index i : {0, 1, 2, 7, 8})
        EXPECT_NEAR(pose[static_cast<std::size_t>(i)], played[i], 1e-12)
            << i << ", turn " << turn << " cycle " << cycle;
    }
  }
}

TEST(PlannedPoses, NameTheJointThatIsMissing) {
  const ModelPointer model = toy_model();
  const Trajectory plan = blank_trajectory({"tail"}, {"L"}, 8, 0.8);
  try {
    planned_poses(*model, plan, 4, "toy.xml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("tail"), std::string::npos);
  }
}

TEST(Playback, IsCheckedAgainstTheModel) {
  const ModelPointer model = toy_model();
  const auto file = std::filesystem::path(testing::TempDir()) / "playback.csv";
  write_file(file, "time_s,a,b,c,d,e,f,g,h,i\n0,0,0,0.3,1,0,0,0,0,0\n0.5,0,1,0.3,1,0,0,0,0,0\n");
  const Playback playback = read_playback(*model, file);
  EXPECT_EQ(record_at(playback, 0.2), 0U);
  EXPECT_EQ(record_at(playback, 9.0), 1U);
  EXPECT_EQ(playback.qpos[1][1], 1.0);
  write_file(file, "time_s,a\n0,0\n");
  EXPECT_THROW(read_playback(*model, file), InputError);
}

TEST(ContactMarks, ShowFeetWhereTheyAre) {
  const auto marks = contact_marks(toy_plan(0.0), 2);
  ASSERT_EQ(marks.size(), 2U);
  ASSERT_EQ(marks[0].feet.size(), 2U);
  EXPECT_NEAR(marks[0].feet[0].left, 1.0, 1e-9);
  EXPECT_NEAR(marks[0].feet[1].left, -1.0, 1e-9);
  for (int turn = 0; turn < 2;
       ++turn) {  // seen from the robot, whichever way it faces in the world
    Trajectory rotated = toy_plan();
    for (int k = 0; k < 8; ++k) {
      const double facing = 0.3 + 1.1 * turn;
      rotated.at(k, rotated.root_column(5)) = facing;
      for (int f = 0; f < 2; ++f) {
        const double left = f == 0 ? 0.06 : -0.06;
        rotated.at(k, rotated.foot_column(f, 0)) = -std::sin(facing) * left;
        rotated.at(k, rotated.foot_column(f, 1)) =
            std::cos(facing) * left + rotated.at(k, rotated.root_column(1));
      }
    }
    const auto seen = contact_marks(rotated, 1);
    EXPECT_NEAR(seen[0].feet[0].left, 1.0, 1e-9);
    EXPECT_NEAR(seen[0].feet[0].forward, 0.0, 1e-9);
  }
  EXPECT_TRUE(marks[0].feet[0].down);
  EXPECT_FALSE(marks[0].feet[1].down);
  EXPECT_FALSE(marks[1].feet[0].down);
  EXPECT_TRUE(marks[1].feet[1].down);
}

TEST(FilmStrip, HasTheWidthItSaysAndEachCellInIt) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer model = toy_model();
  Renderer letters(context, *model, 64, 48, RenderStyle::cheap);
  const StripLayout layout{4, 300, 100};
  StripRow row;
  row.title = "Before";
  for (int k = 0; k < 4; ++k)
    row.cells.emplace_back(300, 100, Rgb{static_cast<std::uint8_t>(10 + k), 0, 0});
  const Image strip = compose_strip(layout, {row, row}, {"a", "b", "c", "d"}, letters);
  EXPECT_EQ(strip.width, kStripWidth);
  int seen[4] = {};
  for (int x = 0; x < strip.width; ++x) {
    const auto* p = strip.pixel(x, 90);
    if (p[1] == 0 && p[0] >= 10 && p[0] < 14) ++seen[p[0] - 10];
  }
  for (const int count : seen) EXPECT_EQ(count, 300);
  row.good = false;
  EXPECT_NE(compose_strip(layout, {row, row}, {"a", "b", "c", "d"}, letters),
            strip);  // the dot of the verdict
}

}  // namespace
}  // namespace legwright
