// SPDX-License-Identifier: Apache-2.0
// Sizes of printed links where the file gives none: wide enough for screws and horns, thick enough
// for the torque of their servos and the weight on their feet.
#include "mjcf/assembly/link_sizes.hpp"

#include <gtest/gtest.h>

#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright::test {
namespace {

using Eigen::Vector3d;

Assembly dog_to_print() {
  Assembly out = hulled_dog();
  out.print = PrintLimits{};
  return out;
}

TEST(LinkSizes, ToBePrintedHasPadsAsWideAsItsServosScrewsNeed) {
  Assembly assembly = boxy_dog();
  assembly.link_shape = LinkShape::hull;
  Attachment horn{"horn", true, {0.0, 0.009, 0.017}, Vector3d::UnitZ(), "M2", {}};
  for (const double side : {-0.008, 0.008}) {
    horn.holes.push_back(horn.position + side * Vector3d::UnitX());
    horn.holes.push_back(horn.position + side * Vector3d::UnitY());
  }
  Attachment back = horn;
  back.screws = "";  // not known
  back.holes = {Vector3d::Ones()};
  assembly.limbs[0].joints[1].servo.attachments = {back, horn};
  EXPECT_EQ(link_radius(assembly), 0.006) << "not to be printed";
  assembly.print = PrintLimits{};
  // 8 mm to the holes, 1.2 of their own, 1.2 around them: 10.4 mm to the flat sides of an octagon.
  EXPECT_EQ(link_radius(assembly), 0.0113);
  assembly.link_radius = 0.007;
  EXPECT_EQ(link_radius(assembly), 0.007) << "which its file gives";
}

TEST(LinkSizes, PadsOnHornsOfUnknownScrewsAreAsWideAsTheirServo) {
  const Assembly dog = dog_to_print();
  EXPECT_EQ(link_radius(dog), 0.0112) << "0.4 of 28 mm";
  EXPECT_EQ(end_radius(dog, dog.limbs[0].joints[1].servo), 0.0112);
  EXPECT_DOUBLE_EQ(end_radius(dog, dog.limbs[0].foot), 0.009) << "within a ball of 12 mm";
  Assembly given = dog;
  given.link_radius = 0.0112;
  EXPECT_EQ(end_radius(given, given.limbs[0].foot), 0.0112);
}

TEST(LinkSizes, WallsGrowWithTorqueAndWeight) {
  Assembly dog = hulled_dog();
  EXPECT_EQ(link_wall(dog), 0.003) << "not to be printed";
  dog.print = PrintLimits{};
  const double light = link_wall(dog);
  EXPECT_GE(light, 0.003);
  EXPECT_LT(light, 0.006);
  Assembly strong = dog;
  for (AssemblyJoint& joint : strong.limbs[0].joints) joint.servo.joint->stall_torque = 10.0;
  // 6 x 2 x 10 N m / (25 MPa (22.4 mm)^2) is 9.57 mm.
  EXPECT_EQ(link_wall(strong), 0.01);
  Assembly heavy = dog;
  heavy.trunk.mass = 2.0;
  EXPECT_GT(link_wall(heavy), light);
  heavy.link_wall = 0.002;
  EXPECT_EQ(link_wall(heavy), 0.002) << "which its file gives";
}

}  // namespace
}  // namespace legwright::test
