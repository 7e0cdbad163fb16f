// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/angle_words.hpp"

#include <fmt/format.h>

#include <numbers>

#include "mjcf/text/elements.hpp"

namespace legwright {
namespace {

double in_unit(double angle, bool in_degrees) {
  return in_degrees ? angle * 180.0 / std::numbers::pi : angle;
}
const char* unit(bool in_degrees) { return in_degrees ? "degrees" : "rad"; }

}  // namespace

bool angles_in_degrees(const XmlFile& xml) {
  return compiler_setting(xml, "angle", "degree") != "radian";
}

std::string angle_text(double angle, bool in_degrees) {
  return fmt::format("{:.4g} {}", in_unit(angle, in_degrees), unit(in_degrees));
}

std::string rough_angle_text(double angle, bool in_degrees) {
  return fmt::format("{:.2g} {}", in_unit(angle, in_degrees), unit(in_degrees));
}

std::string angle_range_text(double lower, double upper, bool in_degrees) {
  return fmt::format("{:.3g} to {:.3g} {}", in_unit(lower, in_degrees), in_unit(upper, in_degrees),
                     unit(in_degrees));
}

}  // namespace legwright
