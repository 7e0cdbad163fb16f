// SPDX-License-Identifier: Apache-2.0
// Bounds of a printed robot: within them servos keep apart and parts lie on the bed. Distances are
// MuJoCo's own, of the robot as it is written for a design.
#include "mjcf/assembly/print_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/propose/proposals.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"
#include "tests/support/text.hpp"

namespace legwright {
namespace {

/// Of short shanks, so that half of a proposed range is too near.
Assembly short_dog() {
  Assembly out = test::hulled_dog();
  out.limbs[0].foot_offset = {0.0, 0.0, -0.055};
  return out;
}

Assembly printed_dog(const Eigen::Vector2d& bed = PrintLimits{}.bed) {
  Assembly out = short_dog();
  out.print = PrintLimits{bed};
  return out;
}

const DesignParameter& parameter(const BuiltRobot& built, const std::string& name) {
  const int k = built.found.model.space.find(name);
  if (k < 0) throw std::out_of_range(name);
  return built.found.model.space.parameters[static_cast<std::size_t>(k)];
}

/// The robot with one parameter at a value.
ModelPointer model_at(const BuiltRobot& built, const std::string& name, double value) {
  Eigen::VectorXd s = built.found.model.space.initial();
  s[built.found.model.space.find(name)] = value;
  return compile_mjcf(rewrite_robot(built.found.model, s), "dog.xml", MeshDetail::triangles);
}

/// The geoms of a body's shapes, or of one; none where there is no such thing.
std::vector<int> geoms_of(const mjModel& model, const char* name) {
  const int body = mj_name2id(&model, mjOBJ_BODY, name),
            geom = mj_name2id(&model, mjOBJ_GEOM, name);
  std::vector<int> out;
  if (geom >= 0) out.push_back(geom);
  for (int k = 0; body >= 0 && k < model.body_geomnum[body]; ++k)
    out.push_back(model.body_geomadr[body] + k);
  return out;
}

/// Distances of what the shank carries, over the knee's range, from what carries the knee [m].
std::vector<double> distances(const mjModel& model) {
  const int joint = mj_name2id(&model, mjOBJ_JOINT, "FL_knee");
  const double* range = model.jnt_range + std::ptrdiff_t{2} * joint;
  std::vector<double> qpos(model.qpos0, model.qpos0 + model.nq), out;
  for (int k = 0; k <= 60; ++k) {
    qpos[static_cast<std::size_t>(model.jnt_qposadr[joint])] =
        range[0] + (range[1] - range[0]) * k / 60.0;
    const DataPointer data = kinematics_at(model, qpos.data(), "dog.xml");
    for (const char* far : {"FL", "FL_knee_link_arm", "FL_knee_link_boss"})
      for (const char* near : {"FL_knee_servo", "FL_hip_link_arm", "FL_hip_link_boss"})
        for (const int a : geoms_of(model, far))
          for (const int b : geoms_of(model, near))
            out.push_back(mj_geomDistance(&model, data.get(), a, b, 1.0, nullptr));
  }
  return out;
}

/// The least of those that are 1 mm as drawn [m].
double least_distance(const mjModel& drawn, const mjModel& model) {
  const std::vector<double> before = distances(drawn), now = distances(model);
  EXPECT_EQ(before.size(), now.size());
  EXPECT_GT(now.size(), 61U * 3U);
  double least = 1.0;
  for (std::size_t k = 0; k < now.size(); ++k)
    if (before[k] >= 1e-3) least = std::min(least, now[k]);
  return least;
}

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
  const BuiltRobot built = build_robot(printed_dog({1.0, bed}), "dog.xml");
  const double upper = parameter(built, name).upper;
  EXPECT_LT(upper, as_proposed.upper);
  EXPECT_GT(upper, as_proposed.initial);
  EXPECT_NEAR(span_of_thigh(*model_at(built, name, upper)), bed, 2e-5);
}

TEST(PrintBounds, OfTheTrunkLetItLieOnTheBedAndKeepItsServosApart) {
  const BuiltRobot free = build_robot(printed_dog({1.0, 1.0}), "dog.xml");
  const DesignParameter& length = parameter(free, "body_length");
  // As long as servos at both ends, with 2.7 mm around them.
  const double drawn = 0.18 + 2.0 * (0.014 + 2.7e-3);
  const BuiltRobot built = build_robot(printed_dog({0.19, drawn + 0.004}), "dog.xml");
  EXPECT_NEAR(parameter(built, "body_length").upper, 0.184, 2e-5) << "lies across the bed";
  EXPECT_LT(parameter(built, "body_length").upper, length.upper);
  const BuiltRobot stays = build_robot(printed_dog({0.1, 0.1}), "dog.xml");
  EXPECT_TRUE(std::any_of(stays.notes.begin(), stays.notes.end(), [](const std::string& note) {
    return note.starts_with("larger than the bed as drawn") && note.ends_with("the trunk");
  }));
  EXPECT_LE(parameter(stays, "body_length").upper, 0.18) << "larger than the bed as drawn";
  EXPECT_LT(parameter(stays, "body_length").lower, 0.18);

  const auto bounds = [](const Eigen::Vector2d& bed) {
    const BuiltRobot robot = build_robot(printed_dog(bed), "dog.xml");
    return std::pair(parameter(robot, "body_length").upper, parameter(robot, "body_width").upper);
  };
  EXPECT_EQ(bounds({0.4, drawn + 0.004}), bounds({drawn + 0.004, 0.4}));

  Assembly near = printed_dog({1.0, 1.0});
  near.limbs[0].hip.x() = 0.01475;  // servos of front and hind legs are 1.5 mm apart
  near.limbs[0].step.x() = -0.0295;
  near.limbs[0].joints[0].roll = 0.5 * std::numbers::pi;
  const Proposal as_drawn{"body_length", 0.0295, 0.028, 0.031, "m", "stretch x: trunk", ""};
  EXPECT_NEAR(print_bounds(near, {as_drawn}).proposals.at(0).lower, 0.029, 2e-6);
}

TEST(PrintBounds, LeaveAxesOutAndSaySo) {
  const BuiltRobot built = build_robot(printed_dog(), "dog.xml");
  EXPECT_LT(built.found.model.space.find("front_hip_axis_yaw"), 0);
  const auto has = [](const std::vector<std::string>& lines, const char* words) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(words) != line.npos; });
  };
  EXPECT_TRUE(has(built.found.left_out, "front_hip_axis_yaw: the parts are to be printed"));
  EXPECT_TRUE(has(built.notes, "axes of joints are no design parameters"));
  EXPECT_TRUE(has(built.notes, "front_knee_link_length 0.0"));
  EXPECT_EQ(build_robot(printed_dog(), "dog.xml").xml, built.xml) << "same input, same bytes";

  EXPECT_NE(built.xml.find("<text name=\"legwright_print\" data=\"bed "), std::string::npos);
  // Nor does `init` offer them for the file.
  const ProposedParameters again = propose_parameters(built.xml, "dog.xml");
  EXPECT_TRUE(again.proposals.empty());
  EXPECT_TRUE(has(again.left_out, "front_hip_axis_yaw: the parts are to be printed"));
}

}  // namespace
}  // namespace legwright
