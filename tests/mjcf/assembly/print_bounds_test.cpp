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

using Names = std::vector<const char*>;

/// Distances of what a joint moves, over its range, from what carries it [m].
std::vector<double> distances(const mjModel& model, const char* hinge, const Names& moved,
                              const Names& still) {
  const int joint = mj_name2id(&model, mjOBJ_JOINT, hinge);
  const double* range = model.jnt_range + std::ptrdiff_t{2} * joint;
  std::vector<double> qpos(model.qpos0, model.qpos0 + model.nq), out;
  for (int k = 0; k <= 60; ++k) {
    qpos[static_cast<std::size_t>(model.jnt_qposadr[joint])] =
        range[0] + (range[1] - range[0]) * k / 60.0;
    const DataPointer data = kinematics_at(model, qpos.data(), "dog.xml");
    for (const char* far : moved)
      for (const char* near : still)
        for (const int a : geoms_of(model, far))
          for (const int b : geoms_of(model, near))
            out.push_back(mj_geomDistance(&model, data.get(), a, b, 1.0, nullptr));
  }
  return out;
}

Eigen::Isometry3d pose_at(const mjtNum* positions, const mjtNum* turns, int k) {
  const mjtNum *p = positions + std::ptrdiff_t{3} * k, *q = turns + std::ptrdiff_t{4} * k;
  return Eigen::Translation3d(p[0], p[1], p[2]) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
}

/// Those of the shank from the knee and what carries it, and of that from hip and trunk.
std::vector<double> distances(const mjModel& model, bool with_hip) {
  const Names hip_link{"FL_knee_servo", "FL_hip_link_arm", "FL_hip_link_boss"};
  std::vector<double> out =
      distances(model, "FL_knee", {"FL", "FL_knee_link_arm", "FL_knee_link_boss"}, hip_link);
  if (!with_hip) return out;
  const std::vector<double> more = distances(model, "FL_hip", hip_link, {"FL_hip_servo", "trunk"});
  out.insert(out.end(), more.begin(), more.end());
  return out;
}

/// The least of those that are 1 mm as drawn [m].
double least_distance(const mjModel& drawn, const mjModel& model, bool with_hip = false) {
  const std::vector<double> before = distances(drawn, with_hip), now = distances(model, with_hip);
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

  const auto bounds = [](const Eigen::Vector2d& bed) {
    return std::pair(bounds_of(printed_dog(bed), "body_length").upper,
                     bounds_of(printed_dog(bed), "body_width").upper);
  };
  EXPECT_EQ(bounds({0.4, drawn + 0.004}), bounds({drawn + 0.004, 0.4}));

  Assembly near = printed_dog({1.0, 1.0});
  near.limbs[0].hip.x() = 0.01475;  // servos of front and hind legs are 1.5 mm apart
  near.limbs[0].step.x() = -0.0295;
  near.limbs[0].joints[0].roll = 0.5 * std::numbers::pi;
  const Proposal as_drawn{"body_length", 0.0295, 0.028, 0.031, "m", "stretch x: trunk", ""};
  EXPECT_NEAR(print_bounds(near, {as_drawn}).proposals.at(0).lower, 0.029, 2e-6);
}

/// Of legs as they are used: not folded up to the trunk.
Assembly ranged_dog() {
  Assembly out = printed_dog();
  out.limbs[0].joints[0].range = {-0.8, 1.6};
  out.limbs[0].joints[1].range = {-2.2, 0.4};
  out.print->turn = 1.0;
  return out;
}

TEST(PrintBounds, OfAnAxisKeepServosClearThatTurnWithIt) {
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
TEST(PrintBounds, OfHipsLetTheTrunkLieOnTheBedWithAllOfThemAtOnce) {
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

TEST(PrintBounds, OfAnAxisOnTheTrunkKnowTheServosBesideIt) {
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

TEST(PrintBounds, AreTold) {
  const BuiltRobot built = build_robot(ranged_dog(), "dog.xml");
  const auto has = [](const std::vector<std::string>& lines, const char* words) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(words) != line.npos; });
  };
  EXPECT_TRUE(has(built.notes, "front_hip_link_length 0.0"));
  EXPECT_TRUE(has(built.notes, "hind_knee_axis_roll -"));
  EXPECT_EQ(build_robot(ranged_dog(), "dog.xml").xml, built.xml) << "same input, same bytes";
  EXPECT_NE(built.xml.find("<text name=\"legwright_print\" data=\"bed "), std::string::npos);
}

TEST(PrintBounds, LeaveAxesOutAndSaySoUnlessTheyMayTurn) {
  const BuiltRobot built = build_robot(printed_dog(), "dog.xml");
  EXPECT_LT(built.found.model.space.find("front_hip_axis_yaw"), 0);
  EXPECT_TRUE(built.found.model.turning_parts.empty());
  const auto has = [](const std::vector<std::string>& lines, const char* words) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(words) != line.npos; });
  };
  EXPECT_TRUE(has(built.found.left_out, "front_hip_axis_yaw: the parts are to be printed"));
  EXPECT_TRUE(has(built.notes, "axes of joints are no design parameters"));
  EXPECT_TRUE(has(built.notes, "`turn` under [print]"));
  // Nor does `init` offer them for the file.
  const ProposedParameters again = propose_parameters(built.xml, "dog.xml");
  EXPECT_TRUE(again.proposals.empty());
  EXPECT_TRUE(has(again.left_out, "front_hip_axis_yaw: the parts are to be printed"));
}

TEST(PrintBounds, OfAnAxisAreNoWiderThanItMayTurn) {
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
