// SPDX-License-Identifier: Apache-2.0
// The printed parts of the example robots: how near they come to the servos that turn them, and
// that F weighs them as the file of each design does.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/mujoco_pointers.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/growth.hpp"
#include "optimizer/design/home_inertia.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/modules/assembly_file.hpp"

namespace legwright {
namespace {

Assembly example(const std::string& name) {
  static const ModuleLibrary library({test::kSource / "modules"});
  const auto file = test::kExamples / "assemblies" / (name + ".toml");
  return parse_assembly(read_file(file), file, library);
}

class ExampleConnectors : public testing::TestWithParam<const char*> {};

class ClearConnectors : public ExampleConnectors {};

TEST_P(ClearConnectors, KeepTheirClearance) {
  const Assembly assembly = example(GetParam());
  for (const PlacedLimb& limb : placed_limbs(assembly))
    for (const LinkHulls& link : limb_hulls(assembly, limb)) {
      ASSERT_FALSE(link.hulls.empty());
      EXPECT_GE(link.clearance, assembly.link_clearance - 1e-9) << limb.name;
    }
}

/// A robot's mass [kg], and its centre [m] and inertia about that [kg m2] in its home pose, in the
/// frame of the trunk.
struct HomeWeight {
  double mass = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// As MuJoCo weighs the file of a design.
HomeWeight written_weight(const RobotModel& robot, const Eigen::VectorXd& s) {
  const ModelPointer model = compile_mjcf(rewrite_robot(robot, s), "robot.xml");
  const DataPointer data(mj_makeData(model.get()));
  for (const Link& link : robot.morphology.links)
    if (const int joint = mj_name2id(model.get(), mjOBJ_JOINT, link.joint.name.c_str()); joint >= 0)
      data->qpos[model->jnt_qposadr[joint]] = link.joint.nominal;
  mj_kinematics(model.get(), data.get());
  const int trunk = mj_name2id(model.get(), mjOBJ_BODY, robot.root_body.c_str());
  const auto axes_at = [](const mjtNum* numbers, int body) -> Eigen::Matrix3d {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers + 9 * body);
  };
  const Eigen::Matrix3d home = axes_at(data->xmat, trunk);
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  for (int body = trunk; body < static_cast<int>(model->nbody); ++body) {
    const Eigen::Vector3d inertia = vector_at(model->body_inertia, body),
                          place = home.transpose() *
                                  (vector_at(data->xipos, body) - vector_at(data->xpos, trunk));
    const Eigen::Matrix3d axes = home.transpose() * axes_at(data->ximat, body);
    const Eigen::Vector3d second = Eigen::Vector3d::Constant(inertia.sum() / 2) - inertia;
    const Eigen::Vector4d point = place.homogeneous();
    moments += model->body_mass[body] * point * point.transpose();
    moments.topLeftCorner<3, 3>() += axes * second.asDiagonal() * axes.transpose();
  }
  HomeWeight out{moments(3, 3), moments.topRightCorner<3, 1>() / moments(3, 3), {}};
  const Eigen::Matrix3d second =
      moments.topLeftCorner<3, 3>() - out.mass * out.centre * out.centre.transpose();
  out.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  return out;
}

/// As F does.
HomeWeight taken_weight(const RobotModel& robot, const Eigen::VectorXd& s) {
  const GeometryAtDesign geometry(robot.morphology, s);
  HomeWeight out{geometry.total_mass, {}, {}};
  out.centre = home_pose(robot.morphology, geometry).first_moment(0) / geometry.total_mass;
  std::vector<int> all(static_cast<std::size_t>(s.size()));
  std::iota(all.begin(), all.end(), 0);
  out.inertia = symmetric_matrix(home_inertia(robot.morphology, all, s).value);
  return out;
}

void expect_same_weight(const RobotModel& robot, const Eigen::VectorXd& s) {
  const HomeWeight taken = taken_weight(robot, s), written = written_weight(robot, s);
  EXPECT_NEAR(taken.mass, written.mass, 1e-10 * written.mass);
  EXPECT_NEAR((taken.centre - written.centre).norm(), 0.0, 1e-9);
  EXPECT_NEAR((taken.inertia - written.inertia).norm(), 0.0, 1e-8 * written.inertia.norm());
}

long count_of(const RobotModel& robot, ParameterKind kind) {
  const auto& parameters = robot.space.parameters;
  return std::count_if(parameters.begin(), parameters.end(),
                       [kind](const DesignParameter& one) { return one.kind == kind; });
}

/// Lengths and axes anywhere within their bounds: facets change, axes turn.
TEST_P(ExampleConnectors, WeighInFAsInTheFileOfEachDesign) {
  const RobotModel robot = build_robot(example(GetParam()), "robot.xml").found.model;
  // Building leaves out what cannot be rewritten as F takes it.
  EXPECT_GE(count_of(robot, ParameterKind::length), 6) << "of all links, and of the trunk";
  EXPECT_GE(count_of(robot, ParameterKind::axis_angle), 8);
  const Eigen::VectorXd lower = robot.space.lower(), upper = robot.space.upper();
  expect_same_weight(robot, lower);
  expect_same_weight(robot, upper);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double least = growth_sum(robot.morphology, Amount::mass, lower).value, most = least;
  for (int trial = 0; trial < 8; ++trial) {
    Eigen::VectorXd s = lower;
    for (Eigen::Index k = 0; k < s.size(); ++k) s[k] += share(random) * (upper[k] - lower[k]);
    SCOPED_TRACE(trial);
    expect_same_weight(robot, s);
    const double mass = growth_sum(robot.morphology, Amount::mass, s).value;
    least = std::min(least, mass);
    most = std::max(most, mass);
  }
  EXPECT_GT(most, 1.005 * least) << "else designs weigh alike, and this shows nothing";
}

INSTANTIATE_TEST_SUITE_P(All, ClearConnectors, testing::Values("puppy", "hexapod"));
INSTANTIATE_TEST_SUITE_P(All, ExampleConnectors,
                         testing::Values("puppy", "hexapod", "quadruped", "sideways_puppy"));

}  // namespace
}  // namespace legwright
