// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mjcf/scene/emit_scene.hpp"
#include "mjcf/text/input_error.hpp"
#include "plugin/spline.hpp"
#include "plugin/trajectory.hpp"
#include "tests/tools/simulate/standing_puppy.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {
namespace {

PlayablePlan playable(const StandingPuppy& puppy, const Eigen::VectorXd& m) {
  return make_playable(puppy.robot.morphology, puppy.robot.xml, puppy.layout, puppy.gait, m);
}

Trajectory trajectory_of(const PlayablePlan& plan) { return parse_trajectory(plan.trajectory); }

// ∂/∂q of potential energy minus the work of the planned forces, by differences: statics without
// any Jacobian.
Eigen::VectorXd static_torques(const StandingPuppy& puppy, const Trajectory& trajectory,
                               const Eigen::VectorXd& qpos) {
  const auto model = compile_model(puppy.robot.xml, "puppy");
  const auto data = make_data(*model);
  model->opt.enableflags |= mjENBL_ENERGY;
  const JointMap map = map_joints(*model, trajectory.joint_names);
  const auto set = [&](const Eigen::VectorXd& q) {
    std::copy_n(q.data(), q.size(), data->qpos);
    mj_forward(model.get(), data.get());
  };
  set(qpos);
  struct Contact {
    int body;
    Eigen::Vector3d in_body, force;
  };
  using Rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  using Vector = Eigen::Map<const Eigen::Vector3d>;
  std::vector<Contact> contacts;
  for (int j = 0; j < trajectory.foot_count(); ++j) {
    const int geom = mj_name2id(model.get(), mjOBJ_GEOM,
                                trajectory.foot_names[static_cast<std::size_t>(j)].c_str());
    const int body = model->geom_bodyid[geom];
    const Eigen::Vector3d point =
        Vector(data->geom_xpos + 3 * geom) - Eigen::Vector3d(0, 0, model->geom_size[3 * geom]);
    const Eigen::Vector3d force(trajectory.at(0, trajectory.force_column(j, 0)),
                                trajectory.at(0, trajectory.force_column(j, 1)),
                                trajectory.at(0, trajectory.force_column(j, 2)));
    contacts.push_back(
        {body,
         Rotation(data->xmat + 9 * body).transpose() * (point - Vector(data->xpos + 3 * body)),
         force});
  }
  const auto potential = [&](const Eigen::VectorXd& q) {
    set(q);
    double out = data->energy[0];
    for (const auto& c : contacts) {
      out -= c.force.dot(Rotation(data->xmat + 9 * c.body) * c.in_body +
                         Vector(data->xpos + 3 * c.body));
    }
    return out;
  };
  Eigen::VectorXd torque(trajectory.joint_count());
  for (int a = 0; a < torque.size(); ++a) {
    constexpr double kStep = 1e-5;
    Eigen::VectorXd up = qpos, down = qpos;
    up[map.qpos[static_cast<std::size_t>(a)]] += kStep;
    down[map.qpos[static_cast<std::size_t>(a)]] -= kStep;
    torque[a] = (potential(up) - potential(down)) / (2 * kStep);
  }
  return torque;
}

TEST(Plan, FeedForwardOfAStandingRobotIsStatics) {
  const StandingPuppy puppy;
  const PlayablePlan plan = playable(puppy, puppy.m);
  const Trajectory trajectory = trajectory_of(plan);
  const Eigen::VectorXd expected = static_torques(puppy, trajectory, plan.start_qpos);
  EXPECT_GT(expected.norm(), 0.1);  // bent legs need torque
  for (int knot = 0; knot < trajectory.knot_count; ++knot) {
    for (int a = 0; a < trajectory.joint_count(); ++a) {
      EXPECT_NEAR(trajectory.at(knot, trajectory.torque_column(a)), expected[a], 1e-8)
          << "joint " << a;
    }
  }
}

TEST(Plan, FeedForwardHasWhatDryFrictionTakesWhereJointsTurn) {
  StandingPuppy puppy;
  for (int knot = 0; knot <= puppy.layout.knot_count(); ++knot)  // one leg swings, the others stand
    puppy.m[puppy.layout.pose(knot) - puppy.layout.design_size() + 6] +=
        0.2 * std::sin(2 * M_PI * knot / puppy.layout.knot_count());
  const Trajectory without = trajectory_of(playable(puppy, puppy.m));
  const std::string given = "armature=\"0.0005\"";
  const std::size_t at = puppy.robot.xml.find(given);
  ASSERT_NE(at, std::string::npos);
  puppy.robot.xml.insert(at, "frictionloss=\"0.3\" ");
  const Trajectory with = trajectory_of(playable(puppy, puppy.m));
  double least = 0.0, most = 0.0;
  for (int knot = 0; knot < with.knot_count; ++knot) {
    const SplinePhase phase = phase_at(with, with.period * knot / with.knot_count);
    for (int a = 0; a < with.joint_count(); ++a) {
      const int column = with.torque_column(a);
      const double rate = spline_point(with, phase, with.target_column(a)).rate,
                   more = with.at(knot, column) - without.at(knot, column);
      EXPECT_NEAR(more, 0.3 * std::tanh(rate / 0.1), 1e-6) << "knot " << knot << ", joint " << a;
      least = std::min(least, more);
      most = std::max(most, more);
    }
  }
  EXPECT_LT(least, -0.29);
  EXPECT_GT(most, 0.29);
}

TEST(Plan, TellsHowMuchOfTheServosItNeeds) {
  StandingPuppy puppy;
  const PlayablePlan plan = playable(puppy, puppy.m);
  const Trajectory trajectory = trajectory_of(plan);
  double largest = 0.0;
  for (int knot = 0; knot < trajectory.knot_count; ++knot) {
    for (int a = 0; a < trajectory.joint_count(); ++a) {
      largest = std::max(largest, std::abs(trajectory.at(knot, trajectory.torque_column(a))));
    }
  }
  EXPECT_NEAR(plan.torque_share, largest / 3.0, 1e-12);  // servos of 3 N m
  EXPECT_LT(plan.torque_share, 1.0);
}

TEST(Plan, StandingRobotLeavesNothingToExplain) {
  const StandingPuppy puppy;
  EXPECT_LT(playable(puppy, puppy.m).root_residual, 1e-12);
}

TEST(Plan, PlayedAccelerationIsThePlannersDifference) {
  const StandingPuppy puppy(0.02);
  EXPECT_LT(playable(puppy, puppy.m).root_residual, 1e-10);
}

TEST(Plan, WrongForcesShowInTheResidual) {
  StandingPuppy puppy;
  for (int knot = 0; knot <= puppy.layout.knot_count(); ++knot) {
    for (int j = 0; j < puppy.layout.foot_count(); ++j) {
      puppy.m[puppy.layout.force(knot, j) - puppy.layout.design_size() + 2] *= 1.1;
    }
  }
  EXPECT_NEAR(playable(puppy, puppy.m).root_residual, 0.1, 1e-9);
}

TEST(Plan, TravelAndTurnAreWhatThePlanReached) {
  StandingPuppy puppy;
  const int first = puppy.layout.pose(0) - puppy.layout.design_size();
  const int last = puppy.layout.pose(puppy.layout.knot_count()) - puppy.layout.design_size();
  puppy.m.segment<3>(last) += Eigen::Vector3d(0.01, 0.08, 0.003);
  puppy.m[last + 5] = puppy.m[first + 5] + 0.02;
  const PlayablePlan plan = playable(puppy, puppy.m);
  EXPECT_TRUE(plan.travel.isApprox(Eigen::Vector3d(0.01, 0.08, 0.0), 1e-12));
  EXPECT_NEAR(plan.turn, 0.02, 1e-15);
}

TEST(Plan, StartIsThePlayedPoseNotTheKnot) {
  const StandingPuppy puppy(0.02);
  const PlayablePlan plan = playable(puppy, puppy.m);
  const Trajectory trajectory = trajectory_of(plan);
  const auto z = [&](int knot) { return trajectory.at(knot, trajectory.root_column(2)); };
  EXPECT_NEAR(plan.start_qpos[2], (z(7) + 4 * z(0) + z(1)) / 6, 1e-14);
  EXPECT_NEAR(plan.start_qvel[2], (z(1) - z(7)) / (2 * puppy.gait.time_step()), 1e-12);
  EXPECT_DOUBLE_EQ(plan.start_qpos[3], 1.0);
}

TEST(Plan, CsvHasKnotT) {
  const StandingPuppy puppy;
  const std::string csv = playable(puppy, puppy.m).motion_csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
            puppy.layout.knot_count() + 2);  // header, knots 0 … T
}

TEST(Plan, RobotThatMujocoRefusesIsBadInput) {
  const StandingPuppy puppy;
  EXPECT_THROW(make_playable(puppy.robot.morphology, "<mujoco", puppy.layout, puppy.gait, puppy.m),
               InputError);
}

class PlayedPuppy : public testing::Test {
 protected:
  Measurements play(const std::string& trajectory) const {
    SceneSettings settings;
    settings.trajectory = trajectory;
    settings.period = puppy.gait.period();
    settings.start_qpos = plan.start_qpos;
    settings.start_qvel = plan.start_qvel;
    const std::string xml = emit_scene(puppy.robot, puppy.robot.xml, settings);
    return measure(parse_scene(xml, "puppy"), {}, Eigen::Vector2d::Zero(), {.cycles = 5});
  }

  StandingPuppy puppy;
  PlayablePlan plan = playable(puppy, puppy.m);
};

TEST_F(PlayedPuppy, StandsWhereItWasPut) {
  const Measurements run = play(plan.trajectory);
  ASSERT_FALSE(run.fall) << run.fall->cause;
  EXPECT_TRUE(judge({run}, {}, "stand").pass) << judge({run}, {}, "stand").line;
  EXPECT_LT(run.tilt_max, 0.01);
  EXPECT_EQ(run.self_contact.share, 0.0);
}

TEST_F(PlayedPuppy, FeedForwardTakesTheSagOutOfTheLegs) {
  Trajectory without = trajectory_of(plan);
  for (int knot = 0; knot < without.knot_count; ++knot) {
    for (int a = 0; a < without.joint_count(); ++a)
      without.at(knot, without.torque_column(a)) = 0.0;
  }
  const double with = play(plan.trajectory).tracking_rms,
               sag = play(write_trajectory(without)).tracking_rms;
  EXPECT_LT(with, 0.3 * sag);
}

}  // namespace
}  // namespace legwright
