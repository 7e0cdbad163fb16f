// SPDX-License-Identifier: Apache-2.0
// What stands for a mesh is within the hull with which MuJoCo lets it collide, and is as near to
// other shapes as that.
#include "mjcf/shape/hull_cover.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/segment_distance.hpp"
#include "tests/mjcf/robots/mjcf_builder.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

/// Corners of a prism, half as wide as a and b and as high as c, its upper end `taper` times as
/// wide as its lower.
std::string prism(double a, double b, double c, int corners, double taper) {
  std::string text;
  for (const double z : {-c, c})
    for (int k = 0; k < corners; ++k) {
      const double turn = 2 * std::numbers::pi * (k + 0.5) / corners, wide = z > 0 ? taper : 1.0;
      text += fmt::format("{} {} {}  ", wide * a * std::cos(turn), wide * b * std::sin(turn), z);
    }
  return text;
}

std::string two(const std::string& first, const std::string& second, double apart) {
  return fmt::format(
      R"(<mujoco><compiler angle="radian"/><asset><mesh name="first" vertex="{}"/><mesh name="second" vertex="{}"/></asset>
<worldbody><body><freejoint/><geom name="a" type="mesh" mesh="first"/></body>
<body pos="{} 0 0"><freejoint/><geom name="b" type="mesh" mesh="second"/></body></worldbody></mujoco>)",
      first, second, apart);
}

const std::string kShapes[] = {prism(0.05, 0.05, 0.02, 24, 1.0), prism(0.2, 0.1, 0.05, 4, 1.0),
                               prism(0.03, 0.02, 0.15, 12, 0.5), prism(0.1, 0.06, 0.03, 4, 0.6)};

// What was covered before is not covered again; other hulls in between change nothing.
TEST(HullCover, IsTheSameWhenAskedAgain) {
  const auto numbers_of = [](const mjModel& model, int most) {
    std::vector<double> out;
    for (const HullCapsule& each : cover_hull(model, 0, most, 0.0))
      out.insert(out.end(), {each.from.x(), each.from.y(), each.from.z(), each.to.x(), each.to.y(),
                             each.to.z(), each.radius});
    return out;
  };
  const ModelPointer model = compile_mjcf(two(kShapes[0], kShapes[0], 1.0), "two.xml");
  const std::vector<double> first = numbers_of(*model, 4);
  EXPECT_EQ(first, numbers_of(*model, 4));
  for (int k = 0; k < 40; ++k) {  // more than are kept
    const std::string wider = prism(0.05 + 1e-3 * (k + 1), 0.05, 0.02, 24, 1.0);
    EXPECT_NE(first, numbers_of(*compile_mjcf(two(wider, wider, 1.0), "two.xml"), 4));
  }
  EXPECT_EQ(first, numbers_of(*model, 4));
}

TEST(HullCover, IsWithinTheHullAndNearItsSurface) {
  for (const std::string& shape : kShapes) {
    const ModelPointer model = compile_mjcf(two(shape, shape, 1.0), "two.xml");
    const double size = Vector3d::Map(model->geom_aabb + 3).minCoeff();
    double last = 1.0;
    for (const int most : {1, 4, 12}) {
      const std::vector<HullCapsule> cover = cover_hull(*model, 0, most, 0.0);
      ASSERT_FALSE(cover.empty());
      ASSERT_LE(static_cast<int>(cover.size()), most);
      double least = 1.0, sum = 0.0;
      int count = 0;
      std::mt19937 random(1);
      std::normal_distribution<double> normal;
      for (int k = 0; k < 300; ++k) {
        // How much farther the hull reaches than the capsules do, that way.
        const Vector3d way = Vector3d(normal(random), normal(random), normal(random)).normalized();
        double hull = -1.0, reach = -1.0;
        for (int v = 0; v < model->mesh_vertnum[0]; ++v)
          hull = std::max(hull, way.dot(Eigen::Map<const Eigen::Vector3f>(
                                            model->mesh_vert + 3 * (model->mesh_vertadr[0] + v))
                                            .cast<double>()));
        for (const HullCapsule& capsule : cover)
          reach = std::max({reach, way.dot(capsule.from) + capsule.radius,
                            way.dot(capsule.to) + capsule.radius});
        least = std::min(least, hull - reach);
        sum += hull - reach;
        ++count;
      }
      EXPECT_GT(least, -1e-6) << "beyond the hull";
      EXPECT_LT(sum / count, last);
      last = sum / count;
    }
    EXPECT_LT(last, 0.25 * size);
  }
}

TEST(HullCover, StopsWhereItIsNearEnough) {
  const ModelPointer model = compile_mjcf(two(kShapes[0], kShapes[1], 1.0), "two.xml");
  EXPECT_EQ(cover_hull(*model, 0, 12, 1.0).size(), 1u);
  EXPECT_GT(cover_hull(*model, 0, 12, 0.01).size(), 1u);
  EXPECT_TRUE(cover_hull(*model, 0, 0, 0.01).empty());
}

TEST(HullCover, NoMoreThanABoxWithSmallCornersCutOffOverlapsItsNeighbour) {
  // A wedge whose bounding box reaches into the other's, while the hulls are apart.
  const ModelPointer model = compile_mjcf(
      two(prism(0.1, 0.1, 0.05, 4, 0.2), prism(0.1, 0.1, 0.05, 4, 0.2), 0.145), "two.xml");
  const DataPointer data = kinematics_at(*model, nullptr, "two.xml");
  const double real = mj_geomDistance(model.get(), data.get(), 0, 1, 1.0, nullptr);
  ASSERT_GT(real, 0.0);
  double least = 1.0;
  const auto world = [&](int geom, const Vector3d& p) -> Vector3d {
    return Vector3d::Map(data->geom_xpos + 3 * geom) +
           Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data->geom_xmat +
                                                                          9 * geom) *
               p;
  };
  for (const HullCapsule& a : cover_hull(*model, 0, 8, 0.0))
    for (const HullCapsule& b : cover_hull(*model, 1, 8, 0.0))
      least = std::min(least, segment_distance(world(0, a.from), world(0, a.to), world(1, b.from),
                                               world(1, b.to), 1e-9, DistanceDetail::value)
                                      .value -
                                  a.radius - b.radius);
  EXPECT_GT(least, real - 1e-6);
  EXPECT_LT(least, real + 0.02);
}

/// Two legs beside a trunk; all are meshes, `gap` apart.
std::string beside(double gap) {
  std::string legs;
  for (const char* const side : {"L", "R"})
    legs += test::roll_pitch_knee_leg(
        side, 0.05, 0.1, {test::inertial("0 0 0", 0.3, "1e-4 1e-4 1e-4")},
        {fmt::format(R"(<geom name="{{}}_plate" type="mesh" mesh="plate" pos="0 {} -0.1"/>)",
                     *side == 'L' ? gap - 0.03 : 0.03 - gap)});
  return R"(<mujoco model="beside"><compiler angle="radian"/>
<asset><mesh name="hull" vertex=")" +
         prism(0.2, 0.1 * std::sqrt(2.0), 0.05, 4, 0.7) + R"("/><mesh name="plate" vertex=")" +
         prism(0.02, 0.02 * std::sqrt(2.0), 0.1, 4, 1.0) + R"("/></asset>
<worldbody><body name="trunk" pos="0 0 0.4"><freejoint/><geom name="hull" type="mesh" mesh="hull"/>)" +
         legs + R"(</body></worldbody>
<actuator>)" +
         test::roll_pitch_knee_motors() + R"(</actuator></mujoco>)";
}

TEST(TrunkCapsules, OfMeshesAreAsFarApartAtHomeAsMujocoFindsTheHulls) {
  for (const double gap : {0.03, 0.001}) {
    const std::string xml = beside(gap);
    const RobotModel robot = parse_robot(xml, "robot.xml");
    const ModelPointer model = compile_mjcf(xml, "robot.xml");
    const DataPointer data = kinematics_at(*model, nullptr, "robot.xml");
    const int hull = mj_name2id(model.get(), mjOBJ_GEOM, "hull");
    const Morphology& morphology = robot.morphology;
    const GeometryAtDesign geometry(morphology, robot.space.initial());
    PoseKinematics pose;
    pose.compute(morphology, geometry, Eigen::VectorXd::Zero(morphology.pose_size()),
                 PoseDetail::place);
    for (const char* const name : {"L_plate", "R_plate"}) {
      const int plate = mj_name2id(model.get(), mjOBJ_GEOM, name);
      const double real = mj_geomDistance(model.get(), data.get(), hull, plate, 1.0, nullptr);
      ASSERT_NEAR(real, gap, 1e-6);
      ASSERT_GT(real, 0.0);
      double least = 1.0;
      for (const CapsulePair& pair : morphology.capsule_pairs) {
        const Capsule &a = morphology.capsules[static_cast<std::size_t>(pair.trunk)],
                      &b = morphology.capsules[static_cast<std::size_t>(pair.limb)];
        if (a.part != hull || b.part != plate) continue;
        EXPECT_GE(pair.hidden, 0.0);
        least = std::min(
            least,
            segment_distance(capsule_end_place(morphology, geometry, pose, 2 * pair.trunk),
                             capsule_end_place(morphology, geometry, pose, 2 * pair.trunk + 1),
                             capsule_end_place(morphology, geometry, pose, 2 * pair.limb),
                             capsule_end_place(morphology, geometry, pose, 2 * pair.limb + 1), 1e-9,
                             DistanceDetail::value)
                    .value -
                a.radius - b.radius - pair.hidden);
      }
      EXPECT_NEAR(least, real, 1e-6) << name << gap;
    }
  }
}

TEST(TrunkCapsules, OfVeryManyMeshesAreFewer) {
  const auto each = [](int count) {
    std::string parts, xml = beside(0.03);
    for (int k = 0; k < count; ++k)
      parts += "<geom type=\"mesh\" mesh=\"hull\" pos=\"0 0 0.2\" mass=\"0\"/>";
    xml.insert(xml.find("<body name=\"L_hip\""), parts);
    return static_cast<double>(parse_robot(xml, "robot.xml").morphology.capsule_pairs.size()) /
           (count + 1);
  };
  EXPECT_EQ(each(1), each(100));  // 404 pairs of shapes
  EXPECT_LT(each(200), 0.5 * each(100));
  EXPECT_LE(each(700), 0.5 * each(200));  // 2804 pairs
}

TEST(TrunkCapsules, HullsThatTouchAtHomeAreLeftOut) {
  const auto pairs = [](double gap) {
    return parse_robot(beside(gap), "robot.xml").morphology.capsule_pairs.size();
  };
  EXPECT_GT(pairs(0.01), pairs(-0.02));
  EXPECT_GT(pairs(-0.02), 0u);  // shanks
}

}  // namespace
}  // namespace legwright
