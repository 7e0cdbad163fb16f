// SPDX-License-Identifier: Apache-2.0
// Joints of an assembly that a linear actuator turns: what their tables say, and what is refused.
#include "tools/modules/linear_pivots.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/modules/installed_modules.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/modules/assembly_file.hpp"
#include "tools/modules/assembly_text.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

/// A dog with these words on its hip and on its knee, whose link above is 0.1 m long.
std::string pivoted_dog(const std::string& hip, const std::string& knee,
                        const std::string& whole = "") {
  return "servo = \"XL430-W250\"\n[trunk]\nsize = [0.2, 0.09, 0.04]\nmass = 0.3\n" + whole +
         "[[limb]]\nnames = [\"F\", \"H\"]\nhip = [0.09, 0.07, 0.0]\nstep = [-0.18, 0, 0]\n"
         "copies = 2\nmirror = \"y\"\nfoot = \"ball_foot_12\"\nfoot_offset = [0.05, 0, -0.09]\n"
         "[[limb.joint]]\nname = \"hip\"\naxis = [0, 1, 0]\n" +
         hip + "[[limb.joint]]\nname = \"knee\"\naxis = [0, 1, 0]\noffset = [-0.06, 0, -0.08]\n" +
         knee;
}

Assembly read_pivots(const std::string& text) {
  return parse_assembly(text, "dog.toml", test::installed_modules());
}

void expect_pivots_refused(const std::string& text, const std::string& part) {
  std::string told;
  try {
    (void)read_pivots(text);
  } catch (const InputError& error) {
    told = error.what();
  }
  EXPECT_NE(told.find(part), std::string::npos) << part << " in\n" << told;
}

const std::string kPivotedActuator = "servo = \"L16-50-35\"\n";

TEST(LinearPivots, AreReadAndWritten) {
  const Assembly plain = read_pivots(pivoted_dog("", kPivotedActuator));
  ASSERT_TRUE(plain.limbs[0].joints[1].is_linear());
  EXPECT_FALSE(plain.limbs[0].joints[1].lever || plain.limbs[0].joints[1].mount);
  const Assembly given = read_pivots(pivoted_dog(
      "", kPivotedActuator + "lever = [0.015, 0.0, 0.002]\nmount = [0.07, 0.0, 0.13]\n"));
  const Assembly again = read_pivots(assembly_text(given));
  for (const Assembly* each : {&given, &again}) {
    EXPECT_EQ(each->limbs[0].joints[1].servo.name, "L16-50-35");
    EXPECT_EQ(each->limbs[0].joints[1].lever, Vector3d(0.015, 0.0, 0.002));
    EXPECT_EQ(each->limbs[0].joints[1].mount, Vector3d(0.07, 0.0, 0.13));
    EXPECT_EQ(each->limbs[0].joints[0].servo.name, "XL430-W250");
  }
}

TEST(LinearPivots, AreRefusedWhereTheActuatorCannotTurnTheJoint) {
  expect_pivots_refused(pivoted_dog(kPivotedActuator, ""),
                        "names L16-50-35, a linear actuator, for the first joint");
  expect_pivots_refused(pivoted_dog("", "lever = [0.01, 0, 0]\n"),
                        "limb.joint.lever: is of linear actuators");
  expect_pivots_refused(pivoted_dog("", "mount = [0.01, 0, 0.1]\n"),
                        "limb.joint.mount: is of linear actuators");
  expect_pivots_refused(pivoted_dog("", kPivotedActuator + "mount = [0.0, 0.0, 0.3]\n"),
                        "dog.toml:21: limb.joint.mount: puts the pivots of L16-50-35");
  expect_pivots_refused(pivoted_dog("", kPivotedActuator + "lever = [0.0, 0.01, 0.0]\n"),
                        "limb.joint.lever: gives");
  expect_pivots_refused(pivoted_dog("", kPivotedActuator, "[print]\n"), "beside [print]");
  expect_pivots_refused(pivoted_dog("", kPivotedActuator, "[[part]]\nmodule = \"L16-50-35\"\n"),
                        "a linear actuator, which stands in a limb's joint");
  expect_pivots_refused(pivoted_dog("", "servo = \"L16-50-36\"\n"), "did you mean \"L16-50-35\"?");
  expect_pivots_refused(pivoted_dog("", "servo = \"ball_foot_12\"\n"),
                        "which is a foot; expected a servo");
}

}  // namespace
}  // namespace legwright
