// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/handles.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/compile.hpp"
#include "tools/drawables/drawn_design.hpp"

namespace legwright {
namespace {

const Handle& handle_of(const RobotModel& robot, const std::vector<Handle>& all,
                        const std::string& name) {
  return all.at(static_cast<std::size_t>(robot.space.find(name)));
}

class HandlesTest : public testing::TestWithParam<const char*> {
 protected:
  RobotModel robot_ = read_robot(std::string(test::source_dir() + "/") + GetParam());
};

TEST_P(HandlesTest, EachParameterHasOneAndItGoesWhereItsDirectionSays) {
  Eigen::VectorXd s = robot_.space.initial();
  const std::vector<Handle> handles = find_handles(robot_, s);
  for (int i = 0; i < robot_.space.size(); ++i) {
    const DesignParameter& one = robot_.space.parameters[static_cast<std::size_t>(i)];
    const Handle& handle = handles[static_cast<std::size_t>(i)];
    ASSERT_FALSE(handle.anchors.empty()) << one.name;
    EXPECT_EQ(handle.kind == HandleKind::turn, one.kind == ParameterKind::axis_angle) << one.name;
    EXPECT_EQ(static_cast<int>(handle.anchors.size()) % one.tied_count, 0) << one.name;
    if (handle.kind == HandleKind::turn) continue;
    Eigen::VectorXd moved = s;
    const double step =
        0.3 * (one.upper - s[i] > s[i] - one.lower ? one.upper - s[i] : one.lower - s[i]);
    moved[i] += step;
    const ModelPointer before = drawn_model(robot_, s), after = drawn_model(robot_, moved);
    for (const HandleAnchor& anchor : handle.anchors) {
      const Eigen::Vector3d way = place_of(*after, anchor) - place_of(*before, anchor);
      // Faces follow the boxes round the geoms, of which some keep their shape.
      const double slack = handle.kind == HandleKind::scale ? 0.5 : 1e-6;
      EXPECT_LT((way - step * anchor.direction).norm(),
                slack * std::abs(step) * anchor.direction.norm() + 1e-9)
          << one.name << " of " << name_of(*before, mjOBJ_BODY, anchor.body);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, HandlesTest,
                         testing::Values("examples/puppy/robot.xml", "examples/quadruped/robot.xml",
                                         "examples/hexapod/robot.xml",
                                         "examples/piston_puppy/robot.xml",
                                         "examples/biped/robot.xml"));

TEST(HandleTest, LinksTrunkAndAxesOfThePuppyAreTakenHoldOfWhereTheyAre) {
  const RobotModel robot = read_robot(test::source_dir() + "/examples/puppy/robot.xml");
  const std::vector<Handle> handles = find_handles(robot, robot.space.initial());
  const ModelPointer model = drawn_model(robot, robot.space.initial());
  const Handle& thigh = handle_of(robot, handles, "front_thigh_length");
  EXPECT_EQ(thigh.kind, HandleKind::move);
  EXPECT_EQ(name_of(*model, mjOBJ_BODY, thigh.anchors[0].body), "FL_thigh");
  EXPECT_TRUE(place_of(*model, thigh.anchors[0]).isApprox(Eigen::Vector3d(0, 0, -0.06), 1e-9));
  const Handle& foot = handle_of(robot, handles, "front_foot_length");
  EXPECT_EQ(name_of(*model, mjOBJ_BODY, foot.anchors[0].body), "FL_foot");
  const Handle& width = handle_of(robot, handles, "body_width");
  EXPECT_EQ(width.kind, HandleKind::scale);
  ASSERT_EQ(width.anchors.size(), 2U);
  EXPECT_NEAR(place_of(*model, width.anchors[0]).y(), -place_of(*model, width.anchors[1]).y(),
              1e-9);
  EXPECT_NEAR(std::abs(place_of(*model, width.anchors[0]).y()), 0.07, 1e-9);
}

}  // namespace
}  // namespace legwright
