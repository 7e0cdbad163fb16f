// SPDX-License-Identifier: Apache-2.0
// The printed parts of the example robots: how near they come to the servos that turn them, and how
// far F's polynomials are from hulls made anew at the ends of the bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/read/connectors.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/growth.hpp"
#include "optimizer/design/inertia.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/modules/installed_modules.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/modules/assembly_file.hpp"

namespace legwright {
namespace {

Assembly example(const std::string& name) {
  const auto file = test::kExamples / "assemblies" / (name + ".toml");
  return parse_assembly(read_file(file), file, test::installed_modules());
}

class ExampleConnectors : public testing::TestWithParam<const char*> {};

TEST_P(ExampleConnectors, KeepTheirClearance) {
  const Assembly assembly = example(GetParam());
  for (const PlacedLimb& limb : placed_limbs(assembly))
    for (const LinkHulls& link : limb_hulls(assembly, limb)) {
      ASSERT_FALSE(link.hulls.empty());
      EXPECT_GE(link.clearance, assembly.link_clearance - 1e-9) << limb.name;
    }
}

/// How far F's printed volume is from that of hulls made anew, of itself.
double error_at(const RobotModel& robot, double share) {
  Eigen::VectorXd s = robot.space.initial();
  for (int k = 0; k < robot.space.size(); ++k) {
    const DesignParameter& parameter = robot.space.parameters[k];
    if (parameter.kind == ParameterKind::length)
      s[k] = (1.0 - share) * parameter.lower + share * parameter.upper;
  }
  EXPECT_NO_THROW((void)rewrite_robot(robot, s));
  const double taken = growth_sum(robot.morphology, Amount::printed_volume, s).value;
  return std::abs(taken / growth_sum(with_hulls_at(robot, s), Amount::printed_volume, s).value - 1);
}

/// docs/limitations.md tells what this measures.
TEST_P(ExampleConnectors, AreInFWhatTheyWeighWhereFacetsStay) {
  const BuiltRobot built = build_robot(example(GetParam()), "robot.xml");
  const RobotModel& robot = built.found.model;
  for (const double share : {0.3, 0.4, 0.5, 0.6, 0.7}) EXPECT_LE(error_at(robot, share), 0.005);
  for (const double share : {0.0, 1.0}) EXPECT_LE(error_at(robot, share), 0.16);
}

/// Likewise told there: F leaves connectors as the file has them where axes turn.
TEST_P(ExampleConnectors, AreInFNearlyWhatTheyWeighWhereAxesTurn) {
  const BuiltRobot built = build_robot(example(GetParam()), "robot.xml");
  const RobotModel& robot = built.found.model;
  Eigen::VectorXd s = robot.space.initial();
  for (int k = 0; k < robot.space.size(); ++k) {
    const DesignParameter& parameter = robot.space.parameters[k];
    if (parameter.kind == ParameterKind::axis_angle) s[k] = 0.5 * parameter.upper;
  }
  EXPECT_NO_THROW((void)rewrite_robot(robot, s));
  const GeometryAtDesign taken(robot.morphology, s), written(with_hulls_at(robot, s), s);
  EXPECT_NEAR(taken.total_mass, written.total_mass, 0.04 * written.total_mass);
  double shift = 0.0;  // of the centre of mass, at most [m]
  for (std::size_t l = 0; l < taken.links.size(); ++l)
    shift += (taken.links[l].moments - written.links[l].moments).topRightCorner<3, 1>().norm() /
             written.total_mass;
  EXPECT_LT(shift, 2e-3);
  EXPECT_GT(shift, 1e-6) << "else this shows nothing";
}

INSTANTIATE_TEST_SUITE_P(All, ExampleConnectors, testing::Values("puppy", "hexapod"));

}  // namespace
}  // namespace legwright
