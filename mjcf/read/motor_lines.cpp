// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/motor_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

constexpr double kTorqueDigits = 1e-6;  // of torques: files have six digits

MotorLine line_of(const XmlFile& xml, const XmlElement& numeric) {
  const std::string_view data = attribute(numeric, "data");
  std::vector<double> numbers;
  for (const std::string_view word : split_words(data))
    numbers.push_back(parse_number(word).value_or(-1.0));
  const bool positive =
      std::all_of(numbers.begin(), numbers.end(), [](double x) { return x > 0.0; });
  if (numbers.size() != 2 || !positive)
    throw xml.error(numeric, fmt::format("attribute data: '{}' is no motor; expected two positive "
                                         "numbers, the torque at rest [N m] and the speed without "
                                         "load [rad/s], as \"1.5 6\"; of a linear actuator force "
                                         "[N] and speed [m/s]",
                                         data));
  return {numbers[0], numbers[1]};
}

void read_motor_line(const XmlFile& xml, const XmlElement& numeric, std::string_view joint,
                     const Morphology& morphology, std::vector<Servo>& servos) {
  const bool is_of_leg = std::any_of(morphology.links.begin() + 1, morphology.links.end(),
                                     [&](const Link& link) { return link.joint.name == joint; });
  if (!is_of_leg)
    throw xml.error(numeric, fmt::format("is the motor of joint '{}', which no servo of a limb "
                                         "moves; correct the name, or remove it",
                                         joint));
  const MotorLine line = line_of(xml, numeric);
  const auto servo = std::find_if(servos.begin(), servos.end(),
                                  [&](const Servo& each) { return each.joint == joint; });
  if (servo == servos.end()) return;  // refused
  if (std::isfinite(servo->torque_limit) &&
      line.stall_torque < (1.0 - kTorqueDigits) * servo->torque_limit)
    throw xml.error(numeric, fmt::format("has {0} {3} at rest, less than the {4} limit of "
                                         "actuator '{1}', {2} {3}; lower its forcerange",
                                         line.stall_torque, servo->actuator, servo->torque_limit,
                                         servo->tendon.empty() ? "N m" : "N",
                                         servo->tendon.empty() ? "torque" : "force"));
  servo->line = line;
}

}  // namespace

void read_motor_lines(const XmlFile& xml, const Structure& structure, const Morphology& morphology,
                      std::vector<Servo>& servos, Refusals& reasons) {
  for (const XmlElement* const numeric : custom_elements(xml, "numeric", kMotorPrefix)) {
    const std::string_view joint = attribute(*numeric, "name").substr(kMotorPrefix.size());
    const auto is_held = [&](const FrozenJoint& frozen) { return frozen.name == joint; };
    if (std::any_of(structure.frozen.begin(), structure.frozen.end(), is_held)) continue;
    reasons.collect([&] { read_motor_line(xml, *numeric, joint, morphology, servos); });
  }
}

}  // namespace legwright
