// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/module_words.hpp"

#include <gtest/gtest.h>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/read/declared_modules.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright {
namespace {

Attachment attachment(const char* name, bool on_horn, const Eigen::Vector3d& position,
                      const Eigen::Vector3d& normal) {
  Attachment out;
  out.name = name;
  out.on_horn = on_horn;
  out.position = position;
  out.normal = normal;
  return out;
}

TEST(ModuleWords, SayWhereTheAttachmentsOfAModuleAreWhereItStands) {
  Module servo = test::servo_module();
  servo.attachments = {attachment("horn", true, {0.0, 0.009, 0.017}, {0, 0, 1}),
                       attachment("back", false, {0.001, 0.0, -0.017}, {0, 0, -1})};
  ModulePlace place;
  place.pose.translation() = Eigen::Vector3d(0.0, -0.009, -0.017);
  EXPECT_EQ(module_declaration(servo, place, "body", "A_servo", "A_hip"),
            "<text name=\"legwright_module/A_servo\" data=\"S servo 0.06 kg | body A_servo | joint "
            "A_hip | horn horn: 0 0 0 0 0 1 | body back: 0.001 -0.009 -0.034 0 0 -1\"/>");
  place.pose.linear() = Eigen::AngleAxisd(0.5 * std::acos(-1.0), Eigen::Vector3d::UnitX())
                            .toRotationMatrix();  // z to -y
  place.pose.translation().setZero();
  place.mirrored = true;
  EXPECT_EQ(
      module_declaration(servo, place, "geom", "A"),
      "<text name=\"legwright_module/A\" data=\"S servo 0.06 kg | geom A | horn horn: 0 0.017 "
      "0.009 0 1 0 | body back: 0.001 -0.017 0 0 -1 0\"/>");
}

TEST(ModuleWords, HaveTheHolesOfScrewsBehindTheNormal) {
  Module servo = test::servo_module();
  servo.attachments = {attachment("horn", true, {0.0, 0.009, 0.017}, {0, 0, 1})};
  servo.attachments[0].screws = "M2";
  servo.attachments[0].holes = {{0.008, 0.009, 0.017}, {0.0, 0.017, 0.017}};
  ModulePlace place;
  place.mirrored = true;
  EXPECT_EQ(module_declaration(servo, place, "body", "A"),
            "<text name=\"legwright_module/A\" data=\"S servo 0.06 kg | body A | horn horn M2: 0 "
            "-0.009 0.017 0 0 1 0.008 -0.009 0.017 0 -0.017 0.017\"/>");
}

TEST(ModuleWords, TellPriceAndCablesThatAreKnown) {
  Module servo = test::servo_module();
  servo.attachments.clear();
  servo.price = 23.9;
  servo.cable = {"left", "back"};
  EXPECT_EQ(module_declaration(servo, {}, "body", "A", "A_hip"),
            "<text name=\"legwright_module/A\" data=\"S servo 0.06 kg | body A | joint A_hip | "
            "price 23.9 | cable left back\"/>");
}

/// Trunk, what rides on it, servos and feet, each once, at any design.
TEST(ModuleWords, StandInTheFileOfARobotAndStayWhereADesignIsWritten) {
  const BuiltRobot built = build_robot(test::boxy_dog(), "dog.xml");
  const auto count = [](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(kModulePrefix, at)) != std::string::npos; ++at)
      ++found;
    return found;
  };
  EXPECT_EQ(count(built.xml), 1u + 1u + 8u + 4u);
  Eigen::VectorXd s = built.found.model.space.initial();
  s[0] *= 1.1;
  const std::string longer = rewrite_robot(built.found.model, s);
  EXPECT_NE(longer, built.xml);
  EXPECT_EQ(count(longer), count(built.xml));
}

}  // namespace
}  // namespace legwright
