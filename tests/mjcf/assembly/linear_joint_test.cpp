// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/linear_joint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/assembly/link_sizes.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/mjcf/assembly/piston_dog.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using test::piston_dog;

AssemblyJoint knee() { return piston_dog().limbs[0].joints[1]; }

TEST(LinearJoint, StandsAtHalfItsStrokeAlongTheLinkAbove) {
  const AssemblyJoint joint = knee();
  const LinearPivots pivots = pivots_of(joint);
  const Vector3d above = -joint.offset.normalized();
  EXPECT_NEAR(pivots.lever.norm(), 0.025, 1e-12) << "half the stroke";
  EXPECT_NEAR(pivots.lever.dot(joint.axis), 0.0, 1e-12);
  EXPECT_NEAR(pivots.lever.dot(above), 0.0, 1e-12);
  EXPECT_GT(pivots.lever.x(), 0.0) << "to the front";
  EXPECT_TRUE((pivots.mount - pivots.lever).isApprox(0.145 * above, 1e-12));
  EXPECT_NEAR(length_at(joint, 0.0), 0.145, 1e-12);
  EXPECT_NEAR(std::abs(moment_arm_at(joint, 0.0)), 0.025, 1e-12);
}

TEST(LinearJoint, ItsMomentArmIsTheSlopeOfItsLength) {
  AssemblyJoint joint = knee();
  joint.lever = {0.02, 0.003, -0.01};
  joint.mount = {0.03, -0.004, 0.12};
  for (const double angle : {-0.6, 0.0, 0.4}) {
    constexpr double kStep = 1e-6;
    EXPECT_NEAR((length_at(joint, angle + kStep) - length_at(joint, angle - kStep)) / (2 * kStep),
                moment_arm_at(joint, angle), 1e-9);
  }
}

TEST(LinearJoint, TurnsAsFarAsStrokeAndMomentArmLetIt) {
  AssemblyJoint joint = knee();
  const ModuleSlide& slide = *joint.servo.slide;
  const auto [low, high] = linear_range(joint);
  EXPECT_LT(low, -0.5);
  EXPECT_GT(high, 0.5);
  double most = 0.0;
  for (double angle = low; angle <= high + 1e-9; angle += 0.01) {
    EXPECT_GE(length_at(joint, angle), slide.retracted - 1e-9);
    EXPECT_LE(length_at(joint, angle), slide.extended() + 1e-9);
    most = std::max(most, std::abs(moment_arm_at(joint, angle)));
  }
  for (const double end : {low, high}) {
    EXPECT_GE(std::abs(moment_arm_at(joint, end)), 0.24 * most);
    const double beyond = end + std::copysign(0.02, end), length = length_at(joint, beyond);
    EXPECT_TRUE(length < slide.retracted || length > slide.extended() ||
                std::abs(moment_arm_at(joint, beyond)) < 0.25 * most)
        << "no farther than it could at " << end;
  }
  joint.range = std::array{-0.2, 3.0};
  EXPECT_EQ(linear_range(joint)[0], -0.2);
  EXPECT_EQ(linear_range(joint)[1], high) << "no file stretches it";
}

TEST(LinearJoint, PutsTheBodyOnItsMountAndTheRodTowardsTheLever) {
  AssemblyJoint joint = knee();
  const LinearPivots pivots = pivots_of(joint);
  for (const double roll : {0.0, 0.7}) {
    joint.roll = roll;
    const Eigen::Isometry3d pose = linear_pose(joint);
    const ModuleSlide& slide = *joint.servo.slide;
    EXPECT_TRUE((pose * slide.position).isApprox(pivots.mount, 1e-12));
    EXPECT_TRUE((pose * (slide.position + 0.145 * slide.axis)).isApprox(pivots.lever, 1e-12));
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
  }
}

TEST(LinearJoint, ReflectedMassIsKnownOrFollowsFromForceAndSpeed) {
  ModuleSlide slide = *knee().servo.slide;
  EXPECT_NEAR(*reflected_mass(slide), 0.03 * 100.0 / 0.05, 1e-12);
  slide.reflected_mass = 12.0;
  EXPECT_EQ(*reflected_mass(slide), 12.0);
  slide.reflected_mass.reset();
  slide.no_load_speed.reset();
  EXPECT_FALSE(reflected_mass(slide));
}

TEST(LinearJoint, TellsWhyItCannotBeTurned) {
  AssemblyJoint joint = knee();
  EXPECT_EQ(why_not_turned(joint), "");
  joint.mount = Vector3d(0.0, 0.0, 0.3);
  EXPECT_NE(why_not_turned(joint).find("it is 120 to 170 mm long"), std::string::npos)
      << why_not_turned(joint);
  joint.lever = Vector3d(0.0, 0.01, 0.0);
  joint.mount = Vector3d(0.0, 0.01, 0.15);
  EXPECT_NE(why_not_turned(joint).find("a moment arm of 0 mm"), std::string::npos)
      << why_not_turned(joint);
}

double mass_of_dog(const mjModel& model) {
  double mass = 0.0;
  for (int b = 0; b < static_cast<int>(model.nbody); ++b) mass += model.body_mass[b];
  return mass;
}

TEST(PistonDog, WeighsItsActuatorsAndTheArmsToThem) {
  const Assembly dog = piston_dog();
  const auto capsule = [&](double length) {
    const double r = link_radius(dog);
    return dog.link_density * std::numbers::pi * r * r * (length + 4.0 / 3.0 * r);
  };
  const ModelPointer model = compile_mjcf(assembly_xml(dog, 0.2), "dog.xml");
  const double thigh = std::hypot(0.05, 0.08), lever = 0.025;
  // The mount's arm ends at the nearest point of the link above, here its upper end.
  const LinearPivots pivots = pivots_of(dog.limbs[0].joints[1]);
  const double mount = (pivots.mount + dog.limbs[0].joints[1].offset).norm();
  EXPECT_NEAR(
      mass_of_dog(*model),
      0.6 + 4 * (0.06 + 0.06 + 0.01) + 4 * (2 * capsule(thigh) + capsule(lever) + capsule(mount)),
      1e-9);
}

TEST(PistonDog, IsReadBackWithStrokeForceAndSpeed) {
  const Assembly dog = piston_dog();
  const BuiltRobot built = build_robot(dog, "dog.xml");
  const RobotModel robot = parse_robot(built.xml, "dog.xml");
  const auto& pistons = robot.morphology.linear_actuators;
  ASSERT_EQ(pistons.size(), 4u);
  for (const LinearActuator& piston : pistons) {
    EXPECT_NEAR(piston.shortest, 0.12, 1e-9);
    EXPECT_NEAR(piston.longest, 0.17, 1e-9);
    EXPECT_NEAR(piston.force_limit, 60.0, 1e-9);
    const Joint& joint = robot.morphology.links[static_cast<std::size_t>(piston.joint) + 1].joint;
    ASSERT_TRUE(joint.line);
    EXPECT_NEAR(joint.line->stall_torque, 100.0, 1e-9);
    EXPECT_NEAR(joint.line->no_load_speed, 0.05, 1e-9);
    EXPECT_NEAR(joint.armature, 60.0 * 0.025 * 0.025, 1e-6) << "reflected mass at the moment arm";
  }
  const std::string words = fmt::format("{}", fmt::join(built.notes, "\n"));
  EXPECT_NE(words.find("60 kg of A, "), std::string::npos) << words;
}

/// The body of an actuator stays where it is, and its joint's axis; the rod's pivot may move.
TEST(PistonDog, MayChangeLeversAndLengths) {
  const BuiltRobot built = build_robot(piston_dog(), "dog.xml");
  int levers = 0, lengths = 0;
  for (const DesignParameter& parameter : built.found.model.space.parameters) {
    EXPECT_EQ(parameter.name.find("mount"), std::string::npos) << parameter.name;
    EXPECT_EQ(parameter.name.find("knee_axis"), std::string::npos) << parameter.name;
    levers += parameter.name.find("knee_lever") != std::string::npos;
    lengths += parameter.name.ends_with("_length");
  }
  EXPECT_EQ(levers, 4) << "x and z, front and hind";
  EXPECT_EQ(lengths, 5);
  const std::string left = fmt::format("{}", fmt::join(built.found.left_out, "\n"));
  EXPECT_NE(left.find("stays where mount says"), std::string::npos) << left;
}

/// Its keyframe holds the rods as long as drawn, and left is the mirror image of right.
TEST(PistonDog, StandsAtHalfItsStroke) {
  const BuiltRobot built = build_robot(piston_dog(), "dog.xml");
  const ModelPointer model = compile_mjcf(built.xml, "dog.xml");
  const DataPointer data = kinematics_at(*model, model->key_qpos, "dog.xml");
  mj_fwdPosition(model.get(), data.get());
  for (const char* name : {"FL_knee", "FR_knee", "HL_knee", "HR_knee"}) {
    const std::string own = name;
    const int rod = mj_name2id(model.get(), mjOBJ_TENDON, (own + "_rod").c_str()),
              servo = mj_name2id(model.get(), mjOBJ_ACTUATOR, (own + "_servo").c_str());
    ASSERT_TRUE(rod >= 0 && servo >= 0) << own;
    EXPECT_NEAR(data->ten_length[rod], 0.145, 1e-6) << own;
    EXPECT_NEAR(model->key_ctrl[servo], 0.145, 1e-6) << own;
  }
}

}  // namespace
}  // namespace legwright
