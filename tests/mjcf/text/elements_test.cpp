// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/elements.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mjcf/text/compile.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

class Orientation : public testing::TestWithParam<const char*> {};

/// What MuJoCo makes of the same attribute is the reference, also of half turns, about any axis.
TEST_P(Orientation, IsThatOfTheCompiledModel) {
  const std::string text = fmt::format(
      "<mujoco><worldbody><body name=\"a\" pos=\"1 2 3\" {}><geom size=\"0.1\"/></body>"
      "</worldbody></mujoco>",
      GetParam());
  const auto xml = load_xml(text, "robot.xml");
  const ModelPointer model = compile_mjcf(text, "robot.xml");
  const TreeElements elements = find_elements(*xml, *model);
  const double* const quat = model->body_quat + 4;
  const Eigen::Quaterniond expected(quat[0], quat[1], quat[2], quat[3]);
  const Eigen::Isometry3d pose = pose_of(*xml, *elements.bodies.at(1));
  EXPECT_LT((pose.linear() - expected.toRotationMatrix()).norm(), 1e-14) << pose.linear();
  EXPECT_EQ(pose.translation(), Eigen::Vector3d(1, 2, 3));
}

INSTANTIATE_TEST_SUITE_P(Forms, Orientation,
                         testing::Values("", "quat=\"0.5 0.1 -0.7 0.2\"", "axisangle=\"1 2 -1 40\"",
                                         "euler=\"10 -20 30\"", "xyaxes=\"1 0.2 0 0 1 0.3\"",
                                         "zaxis=\"0.3 -2 0.7\"", "zaxis=\"0 0 2\"",
                                         "zaxis=\"0 0 -1\""));

}  // namespace
}  // namespace legwright
