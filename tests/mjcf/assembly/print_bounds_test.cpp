// SPDX-License-Identifier: Apache-2.0
// Bounds of a printed robot: within them servos keep apart and parts lie on the bed. Distances are
// MuJoCo's own, of the robot as it is written for a design.
#include "mjcf/assembly/print_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/propose/proposals.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/assembly/printed_dog.hpp"
#include "tests/support/text.hpp"

namespace legwright {
namespace {

using test::least_distance;
using test::model_at;
using test::parameter;
using test::printed_dog;
using test::short_dog;

TEST(PrintBounds, OfALinkKeepItClearOfWhatItIsClearOfAsDrawn) {
  const BuiltRobot built = build_robot(printed_dog(), "dog.xml");
  const DesignParameter& shank = parameter(built, "front_knee_link_length");
  const BuiltRobot free = build_robot(short_dog(), "dog.xml");
  ASSERT_GT(shank.lower, parameter(free, shank.name).lower + 1e-3) << "else this shows nothing";
  const ModelPointer drawn = model_at(built, shank.name, shank.initial);
  EXPECT_GE(least_distance(*drawn, *model_at(built, shank.name, shank.lower)), 1e-3 - 1e-6);
  EXPECT_LT(least_distance(*drawn, *model_at(free, shank.name, shank.lower - 1e-4)), 1e-3 - 1e-6)
      << "a tenth of a millimetre less is too short";
}

/// A proposal of the length of these links as if it were 0.055 m: its scale counts.
Proposal length_of(const std::string& links) {
  return {"length", 0.055, 0.03, 0.08, "m", "stretch link: " + links, ""};
}

double least_of(const Assembly& assembly, const std::string& links) {
  return print_bounds(assembly, {length_of(links)}).proposals.at(0).lower;
}

TEST(PrintBounds, OfALinkKnowWhatCarriesItsServo) {
  Assembly far = printed_dog();
  far.limbs[0].hip.y() = 0.2;
  EXPECT_GT(least_of(printed_dog(), "FL_hip_link"), least_of(far, "FL_hip_link") + 1e-3)
      << "the trunk";
  EXPECT_EQ(least_of(printed_dog(), "FL_hip_link"), least_of(printed_dog(), "FR_hip_link"))
      << "mirror images";
}

/// Left and right are alike only where the trunk is its own mirror image.
TEST(PrintBounds, OfALinkKnowATrunkThatIsLargerOnOneSide) {
  Assembly dog = printed_dog();
  OutlineShape block;  // below the right front knee, 4 mm from its servo as drawn
  block.size = {0.02, 0.02, 0.02};
  block.position = {0.09, -0.053, -0.118};
  dog.trunk.outline.push_back(block);
  const auto most = [&](const char* link) {
    return print_bounds(dog, {length_of(link)}).proposals.at(0).upper;
  };
  EXPECT_EQ(most("FL_hip_link"), length_of("FL_hip_link").upper);
  EXPECT_GT(most("FR_hip_link"), 0.055);
  EXPECT_LT(most("FR_hip_link"), 0.06);
}

TEST(PrintBounds, OfLinksInProportionAreThoseOfTheTightest) {
  Assembly dog = printed_dog();
  dog.limbs.push_back(dog.limbs[0]);
  dog.limbs[0].names = {"F"};
  dog.limbs[1].names = {"H"};
  dog.limbs[1].hip.x() *= -1.0;
  dog.limbs[1].foot_offset *= 0.9;
  const double front = least_of(dog, "FL_knee_link"), hind = least_of(dog, "HL_knee_link");
  EXPECT_GT(hind, front + 1e-3);
  EXPECT_EQ(least_of(dog, "FL_knee_link 0.9*HL_knee_link"), hind);
}

TEST(PrintBounds, OfAShankAreTheSameWhereverItsFootsFrameIs) {
  Assembly moved = printed_dog();
  const Eigen::Vector3d by(0.02, 0.0, -0.01);
  moved.limbs[0].foot_offset += by;
  moved.limbs[0].foot.outline[0].position -= by;
  moved.limbs[0].foot.attachments[0].position -= by;
  EXPECT_NEAR(least_of(moved, "FL_knee_link"), least_of(printed_dog(), "FL_knee_link"), 1e-6);
}

TEST(PrintBounds, OfServosThatAreTooNearAsDrawnLetThemComeNoNearer) {
  Assembly near = printed_dog();
  near.link_clearance = 0.06;
  EXPECT_NEAR(least_of(near, "FL_hip_link"), 0.055, 1e-5);
}

/// The largest distance of two corners of a leg's parts below the hip [m].
double span_of_thigh(const mjModel& model) {
  const DataPointer data = kinematics_at(model, nullptr, "dog.xml");
  std::vector<Eigen::Vector3d> points;
  for (int mesh = 0; mesh < static_cast<int>(model.nmesh); ++mesh) {
    const std::string name = model.names + model.name_meshadr[mesh];
    if (!name.starts_with("FL_hip_link")) continue;
    int geom = 0;
    while (model.geom_type[geom] != mjGEOM_MESH || model.geom_dataid[geom] != mesh) ++geom;
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(
        data->geom_xmat + std::ptrdiff_t{9} * geom);
    const Eigen::Map<const Eigen::Vector3d> at(data->geom_xpos + std::ptrdiff_t{3} * geom);
    for (int v = 0; v < model.mesh_vertnum[mesh]; ++v) {
      const float* const corner =
          model.mesh_vert + std::ptrdiff_t{3} * (model.mesh_vertadr[mesh] + v);
      points.emplace_back(at + turn * Eigen::Vector3d(corner[0], corner[1], corner[2]));
    }
  }
  EXPECT_FALSE(points.empty());
  double most = 0.0;
  for (const Eigen::Vector3d& a : points)
    for (const Eigen::Vector3d& b : points) most = std::max(most, (a - b).norm());
  return most;
}

TEST(PrintBounds, OfALinkLetItsPartLieOnTheBed) {
  const BuiltRobot free = build_robot(printed_dog(), "dog.xml");
  const std::string name = "front_hip_link_length";
  const DesignParameter& as_proposed = parameter(free, name);
  const double bed = 0.3 * span_of_thigh(*model_at(free, name, as_proposed.upper)) +
                     0.7 * span_of_thigh(*model_at(free, name, as_proposed.initial));
  const BuiltRobot built = build_robot(printed_dog({1.0, bed + 0.008}, 0.004), "dog.xml");
  const double upper = parameter(built, name).upper;
  EXPECT_LT(upper, as_proposed.upper);
  EXPECT_GT(upper, as_proposed.initial);
  EXPECT_NEAR(span_of_thigh(*model_at(built, name, upper)), bed, 2e-5);
}

/// The dog whose axes of hips are no parameters, as they would take of the bed, too.
std::vector<Proposal> without_axes(const Assembly& dog) {
  Assembly free = dog;
  free.print.reset();
  std::vector<Proposal> out;
  for (const Proposal& proposal : propose_parameters(assembly_xml(free, 0.2), "dog.xml").proposals)
    if (!proposal.binding.starts_with("axis")) out.push_back(proposal);
  return out;
}

Proposal bounds_of(const Assembly& dog, const std::string& name) {
  for (const Proposal& proposal : print_bounds(dog, without_axes(dog)).proposals)
    if (proposal.name == name) return proposal;
  throw std::out_of_range(name);
}

TEST(PrintBounds, OfTheTrunkLetItLieOnTheBedAndKeepItsServosApart) {
  const BuiltRobot free = build_robot(printed_dog({1.0, 1.0}), "dog.xml");
  const DesignParameter& length = parameter(free, "body_length");
  // As long as servos at both ends, with 2.7 mm around them.
  const double drawn = 0.18 + 2.0 * (0.014 + 2.7e-3);
  const double most = bounds_of(printed_dog({0.19, drawn + 0.004}), "body_length").upper;
  EXPECT_NEAR(most, 0.184, 2e-5) << "lies across the bed";
  EXPECT_LT(most, length.upper);
  const BuiltRobot stays = build_robot(printed_dog({0.1, 0.1}), "dog.xml");
  EXPECT_TRUE(std::any_of(stays.notes.begin(), stays.notes.end(), [](const std::string& note) {
    return note.starts_with("larger than the bed as drawn") && note.ends_with("the trunk");
  }));
  EXPECT_LE(parameter(stays, "body_length").upper, 0.18) << "larger than the bed as drawn";
  EXPECT_LT(parameter(stays, "body_length").lower, 0.18);

  const auto bounds = [](const Eigen::Vector2d& bed, double margin) {
    const BuiltRobot built = build_robot(printed_dog(bed, margin), "dog.xml");
    return std::pair(parameter(built, "body_length").upper, parameter(built, "body_width").upper);
  };
  EXPECT_EQ(bounds({0.4, drawn + 0.004}, 0.0), bounds({drawn + 0.004, 0.4}, 0.0));

  EXPECT_EQ(bounds({0.4, drawn + 0.004}, 0.0), bounds({0.41, drawn + 0.014}, 0.005))
      << "less the margin at each side";

  Assembly near = printed_dog({1.0, 1.0});
  near.limbs[0].hip.x() = 0.01475;  // servos of front and hind legs are 1.5 mm apart
  near.limbs[0].step.x() = -0.0295;
  near.limbs[0].joints[0].roll = 0.5 * std::numbers::pi;
  const Proposal as_drawn{"body_length", 0.0295, 0.028, 0.031, "m", "stretch x: trunk", ""};
  EXPECT_NEAR(print_bounds(near, {as_drawn}).proposals.at(0).lower, 0.029, 2e-6);
}

/// What touches as drawn, or is into each other by less than is told, comes no nearer.
TEST(PrintBounds, OfTheTrunkPushNoServoIntoABatteryThatItTouches) {
  const Proposal width{"body_width", 0.14, 0.12, 0.16, "m", "stretch y: trunk", ""};
  for (const double into : {-1e-3, 0.0, 2e-4}) {
    Assembly dog = printed_dog({1.0, 1.0});
    dog.parts[0].module.outline[0].size = {0.19, 0.072 + 2.0 * into, 0.02};  // hips at y = 0.036
    EXPECT_NEAR(print_bounds(dog, {width}).proposals.at(0).lower, 0.14, 1e-5) << into;
  }
}

}  // namespace
}  // namespace legwright
