// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/speed_limits.hpp"

#include <fmt/format.h>

#include "mjcf/read/motor_lines.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

constexpr double kStallOfEffort = 2.0;

}  // namespace

std::map<std::string, double> speed_limits(const XmlFile& urdf) {
  std::map<std::string, double> out;
  for (const XmlElement* joint = urdf.root().FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const XmlElement* const limit = joint->FirstChildElement("limit");
    if (limit == nullptr) continue;
    const double speed = parse_number(attribute(*limit, "velocity")).value_or(0.0);
    if (speed > 0.0 && speed < kNoSpeedLimit) out[std::string(attribute(*joint, "name"))] = speed;
  }
  return out;
}

std::string motor_line_data(double effort, double speed) {
  return format_number(kStallOfEffort * effort) + " " + format_number(speed);
}

std::string speed_limits_note(int joints, double slowest, double fastest) {
  const std::string speeds = slowest == fastest ? fmt::format("{:.3g}", slowest)
                                                : fmt::format("{:.3g} to {:.3g}", slowest, fastest);
  return fmt::format(
      "{} motor{} <limit velocity>, {} rad/s: torque is that of <limit effort> up to half of it "
      "and falls to nothing there; a line {}JOINT in <custom> says so, with a motor's own torque "
      "at rest and speed without load write those",
      joints, joints == 1 ? " keeps its" : "s keep their", speeds, kMotorPrefix);
}

}  // namespace legwright
