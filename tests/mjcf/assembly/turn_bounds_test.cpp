// SPDX-License-Identifier: Apache-2.0
// Bounds of axes of a printed robot: within them servos that turn with the axes keep apart, and the
// trunk lies on the bed.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "mjcf/assembly/print_bounds.hpp"
#include "mjcf/propose/proposals.hpp"
#include "tests/mjcf/assembly/printed_dog.hpp"

namespace legwright {
namespace {

using test::least_distance;
using test::model_at;
using test::parameter;
using test::pose_at;
using test::printed_dog;
using test::ranged_dog;

bool has(const std::vector<std::string>& lines, const char* words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != line.npos; });
}

TEST(TurnBounds, OfAnAxisKeepServosClearThatTurnWithIt) {
  const BuiltRobot built = build_robot(ranged_dog(), "dog.xml");
  Assembly free = ranged_dog();
  free.print.reset();
  const BuiltRobot unbound = build_robot(free, "dog.xml");
  int bounded = 0;
  for (const char* const name :
       {"front_hip_axis_yaw", "front_knee_axis_yaw", "front_knee_axis_roll"}) {
    const DesignParameter &axis = parameter(built, name), &most = parameter(unbound, name);
    const ModelPointer drawn = model_at(built, name, 0.0);
    const auto least_at = [&](double angle) {
      return least_distance(*drawn, *model_at(unbound, name, angle), true);
    };
    EXPECT_GE(least_at(axis.lower), 1e-3 - 1e-6) << name;
    EXPECT_GE(least_at(axis.upper), 1e-3 - 1e-6) << name;
    if (axis.upper < most.upper) {
      EXPECT_LT(least_at(axis.upper + 0.02), 1e-3) << name;
      ++bounded;
    }
  }
  EXPECT_GE(bounded, 2) << "else this shows nothing";
}

/// With the axes of all hips at either bound, and the trunk as long and wide as may be.
TEST(TurnBounds, OfHipsLetTheTrunkLieOnTheBedWithAllOfThemAtOnce) {
  Assembly dog = ranged_dog();
  dog.print->bed = {0.225, 0.225};
  const BuiltRobot built = build_robot(dog, "dog.xml");
  const DesignSpace& space = built.found.model.space;
  std::vector<int> hips;
  for (int k = 0; k < space.size(); ++k)
    if (space.parameters[k].name.find("_hip_axis_") != std::string::npos) hips.push_back(k);
  ASSERT_EQ(hips.size(), 4U);
  double largest = 0.0;
  for (unsigned corner = 0; corner < 16; ++corner) {
    Eigen::VectorXd s = space.initial();
    for (std::size_t k = 0; k < 4; ++k) {
      const DesignParameter& axis = space.parameters[hips[k]];
      s[hips[k]] = corner >> k & 1U ? axis.upper : axis.lower;
    }
    for (const char* const name : {"body_length", "body_width"})
      if (const int k = space.find(name); k >= 0) s[k] = space.parameters[k].upper;
    const ModelPointer model = compile_mjcf(rewrite_robot(built.found.model, s), "dog.xml");
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1.0), high = -low;
    for (const char* const name :
         {"FL_hip_servo", "FR_hip_servo", "HL_hip_servo", "HR_hip_servo"}) {
      const int body = mj_name2id(model.get(), mjOBJ_BODY, name), geom = model->body_geomadr[body];
      const Eigen::Isometry3d of_body = pose_at(model->body_pos, model->body_quat, body),
                              of_geom = pose_at(model->geom_pos, model->geom_quat, geom);
      for (unsigned way = 0; way < 8; ++way) {
        Eigen::Vector3d at;
        for (unsigned k = 0; k < 3; ++k)  // with 2.7 mm around it
          at[k] = (way >> k & 1U ? 1.0 : -1.0) * (model->geom_size[3 * geom + k] + 2.7e-3);
        at = of_body * (of_geom * at);
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
      }
    }
    const Eigen::Vector3d size = high - low;
    largest = std::max(largest, size.head<2>().maxCoeff());
  }
  EXPECT_LE(largest, 0.225 + 1e-6);
  EXPECT_GT(largest, 0.22) << "there is no more room than needed";
}

TEST(TurnBounds, OfAnAxisOnTheTrunkKnowTheServosBesideIt) {
  const auto bounds = [](const Assembly& dog) {
    const Proposal yaw{"yaw", 0.0, -1.0, 1.0, "rad", "axis z: FL_hip ~FR_hip", ""};
    return print_bounds(dog, {yaw}).proposals.at(0);
  };
  Assembly apart = ranged_dog(), near = apart;
  near.limbs[0].hip.x() = 0.01475;  // servos of front and hind legs are 1.5 mm apart
  near.limbs[0].step.x() = -0.0295;
  near.limbs[0].joints[0].roll = 0.5 * std::numbers::pi;
  apart.limbs[0].joints[0].roll = 0.5 * std::numbers::pi;
  const Proposal a = bounds(apart), b = bounds(near);
  EXPECT_LT(b.upper - b.lower, a.upper - a.lower - 0.1);
}

/// Each leg by itself, those of one side tied to those of the other, as the file gives them.
TEST(TurnBounds, OfAnAxisAreTheSameWithoutAMirror) {
  const Proposal yaw{"yaw", 0.0, -1.0, 1.0, "rad", "axis z: FL_hip ~FR_hip", ""};
  Assembly dog = ranged_dog();
  const Proposal mirrored = print_bounds(dog, {yaw}).proposals.at(0);
  AssemblyLimb right = dog.limbs[0];
  dog.limbs[0].mirrored = right.mirrored = false;
  dog.limbs[0].names = {"FL", "HL"};
  right.names = {"FR", "HR"};
  right.hip.y() *= -1.0;
  for (AssemblyJoint& joint : right.joints) joint.axis *= -1.0;  // its horns look outwards, too
  for (AssemblyJoint& joint : right.joints) joint.range = {-(*joint.range)[1], -(*joint.range)[0]};
  dog.limbs.push_back(right);
  const Proposal alone = print_bounds(dog, {yaw}).proposals.at(0);
  EXPECT_LT(mirrored.upper - mirrored.lower, 2.0);
  EXPECT_NEAR(alone.lower, mirrored.lower, 5e-3);
  EXPECT_NEAR(alone.upper, mirrored.upper, 5e-3);
}

/// Of twelve legs each with an axis of its own, pair by pair: all at once they were 2^12 trunks.
TEST(TurnBounds, OfManyHipsAreFound) {
  Assembly dog = ranged_dog();
  dog.print->bed = {1.0, 1.0};
  dog.limbs[0].names = {"A", "B", "C", "D", "E", "F"};
  dog.limbs[0].hip.x() = 0.25;
  dog.limbs[0].step.x() = -0.1;
  std::vector<Proposal> all;
  for (const char* const limb :
       {"AL", "AR", "BL", "BR", "CL", "CR", "DL", "DR", "EL", "ER", "FL", "FR"})
    all.push_back({limb, 0.0, -0.3, 0.3, "rad", std::string("axis x: ") + limb + "_hip", ""});
  EXPECT_EQ(print_bounds(dog, all).proposals.size(), all.size());
}

TEST(TurnBounds, AreTold) {
  const BuiltRobot built = build_robot(ranged_dog(), "dog.xml");
  EXPECT_TRUE(has(built.notes, "front_hip_link_length 0.0"));
  EXPECT_TRUE(has(built.notes, "hind_knee_axis_roll -"));
  EXPECT_EQ(build_robot(ranged_dog(), "dog.xml").xml, built.xml) << "same input, same bytes";
  EXPECT_NE(built.xml.find("<text name=\"legwright_print\" data=\"bed 0.22 0.22 m margin 0 m\"/>"),
            std::string::npos);
}

/// Servos of the dog turn by 2.5 rad either way unless the assembly says less.
TEST(TurnBounds, AreSmallWithoutRangesAndSaySo) {
  constexpr const char* kNote = "give it a `range` no larger than it needs: hip, knee";
  Assembly dog = printed_dog();
  dog.print->turn = 1.0;
  const BuiltRobot free = build_robot(dog, "dog.xml"),
                   ranged = build_robot(ranged_dog(), "dog.xml");
  EXPECT_TRUE(has(free.notes, kNote));
  EXPECT_FALSE(has(ranged.notes, "give it a `range`"));
  const auto room = [](const BuiltRobot& built) {
    double out = 0.0;
    for (const DesignParameter& each : built.found.model.space.parameters)
      if (each.kind == ParameterKind::axis_angle) out += each.upper - each.lower;
    return out;
  };
  EXPECT_GT(room(ranged), 2.0 * room(free));
}

TEST(TurnBounds, LeaveAxesOutAndSaySoUnlessTheyMayTurn) {
  const BuiltRobot built = build_robot(printed_dog(), "dog.xml");
  EXPECT_LT(built.found.model.space.find("front_hip_axis_yaw"), 0);
  EXPECT_TRUE(built.found.model.turning_parts.empty());
  EXPECT_TRUE(has(built.found.left_out, "front_hip_axis_yaw: the parts are to be printed"));
  EXPECT_TRUE(has(built.notes, "axes of joints are no design parameters"));
  EXPECT_TRUE(has(built.notes, "`turn` under [print]"));
  // Nor does `init` offer them for the file.
  const ProposedParameters again = propose_parameters(built.xml, "dog.xml");
  EXPECT_TRUE(again.proposals.empty());
  EXPECT_TRUE(has(again.left_out, "front_hip_axis_yaw: the parts are to be printed"));
}

TEST(TurnBounds, OfAnAxisAreNoWiderThanItMayTurn) {
  Assembly dog = ranged_dog();
  dog.print->turn = 0.1;
  const BuiltRobot built = build_robot(dog, "dog.xml");
  int axes = 0;
  for (const DesignParameter& parameter : built.found.model.space.parameters) {
    if (parameter.kind != ParameterKind::axis_angle) continue;
    ++axes;
    EXPECT_GE(parameter.lower, -0.1) << parameter.name;
    EXPECT_LE(parameter.upper, 0.1) << parameter.name;
  }
  EXPECT_GE(axes, 6);
}

}  // namespace
}  // namespace legwright
