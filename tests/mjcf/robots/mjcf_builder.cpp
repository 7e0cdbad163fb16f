// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/mjcf_builder.hpp"

#include <fmt/format.h>

namespace legwright::test {

std::string chain(const std::vector<BodyText>& bodies, int indent) {
  std::string out, line = "\n" + std::string(static_cast<std::size_t>(indent), ' ');
  for (const BodyText& body : bodies) {
    out += line + "<body " + body.attributes + ">";
    line += "  ";
    for (const std::string& element : body.content) out += line + element;
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    line.resize(line.size() - 2);
    out += line + "</body>";
  }
  return out;
}

std::string hinge(const std::string& name, const std::string& axis, const std::string& more) {
  return fmt::format("<joint name=\"{}\" axis=\"{}\"{}{}/>", name, axis, more.empty() ? "" : " ",
                     more);
}

std::string inertial(const std::string& pos, double mass, const std::string& diaginertia) {
  return fmt::format("<inertial pos=\"{}\" mass=\"{}\" diaginertia=\"{}\"/>", pos, mass,
                     diaginertia);
}

std::string cad_inertial(double mass, const std::string& pos, const std::string& diaginertia) {
  return fmt::format("<inertial mass=\"{}\" pos=\"{}\" diaginertia=\"{}\"/>", mass, pos,
                     diaginertia);
}

std::string declarations(std::initializer_list<DeclarationText> parameters, int indent) {
  std::string out;
  for (const auto& [name, data, text] : parameters)
    out += fmt::format(
        "\n{0:{1}}<numeric name=\"legwright/{2}\" data=\"{3}\"/>"
        "\n{0:{1}}<text name=\"legwright/{2}\" data=\"{4}\"/>",
        "", indent, name, data, text);
  return out;
}

std::string for_each_joint(const char* format, std::initializer_list<const char*> legs,
                           std::initializer_list<const char*> joints) {
  std::string out;
  for (const char* const leg : legs)
    for (const char* const joint : joints) out += fmt::format(fmt::runtime(format), leg, joint);
  return out;
}

std::string roll_pitch_knee_leg(const std::string& side, double hip_y, double thigh_y,
                                const std::vector<std::string>& hip,
                                const std::vector<std::string>& thigh) {
  const double sign = side == "L" ? 1.0 : -1.0;
  const auto body = [&](const char* part, double y, double z) {
    return fmt::format(R"(name="{}_{}" pos="0 {} {}")", side, part, sign * y, z);
  };
  const auto with_hinge = [&](const char* joint, const char* axis,
                              const std::vector<std::string>& more) {
    std::vector<std::string> content{hinge(fmt::format("{}_{}", side, joint), axis)};
    for (const std::string& element : more)
      content.push_back(fmt::format(fmt::runtime(element), side));
    return content;
  };
  return chain(
      {{body("hip", hip_y, 0.0), with_hinge("roll", "1 0 0", hip)},
       {body("thigh", thigh_y, 0.0), with_hinge("pitch", "0 1 0", thigh)},
       {body("shank", 0.0, -0.2),
        with_hinge("knee", "0 1 0", {R"(<geom name="{}_foot" size="0.02" pos="0 0 -0.2"/>)"})}});
}

std::string roll_pitch_knee_motors() {
  return for_each_joint("\n<motor joint=\"{0}_{1}\" ctrlrange=\"-9 9\"/>", {"L", "R"},
                        {"roll", "pitch", "knee"});
}

std::string box_vertices(double half_x, double half_y, double z_low, double z_high) {
  std::string text;
  for (const double x : {-half_x, half_x})
    for (const double y : {-half_y, half_y})
      for (const double z : {z_low, z_high})
        text += fmt::format("{}{} {} {}", text.empty() ? "" : "  ", x, y, z);
  return text;
}

}  // namespace legwright::test
