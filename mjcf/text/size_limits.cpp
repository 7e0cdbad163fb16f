// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/size_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

struct SizeLimit {
  const char *tag, *attribute;
  double largest;
};

/// Far above what robots have, far below what hurts.
constexpr SizeLimit kLimits[] = {
    {"size", "nuserdata", 1e6},
    {"size", "nuser_body", 100},
    {"size", "nuser_jnt", 100},
    {"size", "nuser_geom", 100},
    {"size", "nuser_site", 100},
    {"size", "nuser_cam", 100},
    {"size", "nuser_tendon", 100},
    {"size", "nuser_actuator", 100},
    {"size", "nuser_sensor", 100},
    {"size", "nkey", 1e4},
    {"size", "njmax", 1e6},
    {"size", "nconmax", 1e6},
    {"option", "iterations", 1e4},
    {"option", "ls_iterations", 1e4},
    {"option", "noslip_iterations", 1e4},
    {"option", "ccd_iterations", 1e4},
    {"option", "sdf_iterations", 1e4},
    {"option", "sdf_initpoints", 1e4},
    {"quality", "numslices", 1e3},
    {"quality", "numstacks", 1e3},
    {"quality", "numquads", 1e3},
    {"quality", "shadowsize", 16384},
    {"quality", "offsamples", 64},
    {"global", "offwidth", 16384},
    {"global", "offheight", 16384},
};

constexpr double kMemory = 1e9;  // [bytes] of the engine's stack

/// "10M" as bytes; NaN for what is no such text. "-1" lets MuJoCo decide.
double bytes_of(std::string_view text) {
  double unit = 1.0;
  constexpr std::string_view kUnits = "KMGTPE";
  if (!text.empty())
    if (const std::size_t k = kUnits.find(text.back()); k != std::string_view::npos) {
      unit = std::pow(1024.0, static_cast<double>(k) + 1.0);
      text.remove_suffix(1);
    }
  const auto number = parse_number(text);
  return number ? unit * *number : std::nan("");
}

constexpr double kLongestSide = 16384;               // [pixels]
constexpr double kMostPictures = 512 * 1024 * 1024;  // [bytes]; MuJoCo holds them several times

double number_in(const XmlElement& element, const char* name, double otherwise) {
  const auto value = parse_numbers(attribute(element, name));
  return value && !value->empty() ? value->front() : otherwise;
}

/// Never below zero: what MuJoCo refuses later must not make room for others.
double side_in(const XmlElement& element, const char* name) {
  return std::max(number_in(element, name, 0.0), 0.0);
}

/// Bytes of a texture of one picture, or of one that MuJoCo makes.
double texture_bytes(const XmlElement& element, PictureSize picture) {
  const double channels = std::max(number_in(element, "nchannel", 3.0), 1.0);
  const std::string_view type = attribute(element, "type");
  if (type == "2d" || picture.is_face) return channels * picture.width * picture.height;
  // A picture in a file may hold the faces in a grid; what MuJoCo makes itself has all sides full
  // size.
  const std::string_view made = attribute(element, "builtin");
  const auto grid =
      made.empty() || made == "none" ? parse_numbers(attribute(element, "gridsize")) : std::nullopt;
  const double side = picture.width / (grid && grid->size() == 2 ? std::max((*grid)[1], 1.0) : 1.0);
  return 6 * channels * side * side;  // a cube's faces
}

}  // namespace

void PictureMemory::add(const XmlFile& xml, const XmlElement& element) {
  const bool is_texture = is_tag(element, "texture");
  if (!is_texture && !is_tag(element, "hfield")) return;
  for (const char* const side : {"width", "height", "nrow", "ncol"})
    if (number_in(element, side, 0.0) > kLongestSide)
      throw xml.error(element, fmt::format("attribute {}: larger than {}; make it smaller", side,
                                           kLongestSide));
  add(xml, element,
      is_texture ? PictureSize{side_in(element, "width"), side_in(element, "height")}
                 : PictureSize{side_in(element, "ncol"), side_in(element, "nrow")});
}

void PictureMemory::add(const XmlFile& xml, const XmlElement& element, PictureSize picture) {
  constexpr double kHeightBytes = 4.0;
  bytes_ += is_tag(element, "texture") ? texture_bytes(element, picture)
                                       : kHeightBytes * picture.width * picture.height;
  if (bytes_ > kMostPictures)
    throw xml.error(element, fmt::format("the textures and height fields of the robot together "
                                         "take more than {} MB unpacked; make them smaller",
                                         kMostPictures / (1024 * 1024)));
}

void check_sizes(const XmlFile& xml, const XmlElement& element) {
  for (const SizeLimit& limit : kLimits) {
    if (!is_tag(element, limit.tag) || !has_attribute(element, limit.attribute)) continue;
    const auto value = parse_numbers(attribute(element, limit.attribute));
    if (value && !value->empty() && std::abs(value->front()) > limit.largest)
      throw xml.error(element, fmt::format("attribute {}: {} is beyond any robot (at most {})",
                                           limit.attribute, value->front(), limit.largest));
  }
  if (is_tag(element, "size") && has_attribute(element, "memory") &&
      !(bytes_of(attribute(element, "memory")) <= kMemory))
    throw xml.error(element, fmt::format("attribute memory: '{}' is beyond any robot (at most {} "
                                         "bytes); remove it, MuJoCo takes what it needs",
                                         attribute(element, "memory"), kMemory));
}

}  // namespace legwright
