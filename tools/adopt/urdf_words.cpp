// SPDX-License-Identifier: Apache-2.0
#include "tools/adopt/urdf_words.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace legwright {
namespace {

/// The MJCF's words and the URDF's.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kWords{{
    {R"(add <geom type="sphere"> that collides (contype="1") at its end, or a <site> where a ball)"
     " shall be",
     "add <collision><origin xyz=\"…\"/><geometry><sphere radius=\"…\"/></geometry></collision> at "
     "its end to this link, or to one that is fixed to it; <visual> shapes touch nothing"},
    {"check ranges and axes, or write a keyframe named home",
     "check <limit>, <axis> and where <origin> puts the legs' ends"},
    {"remove what couples them, or give each hinge an actuator of its own",
     "remove <mimic> from one of them"},
    {"bodies '", "links '"},
    {"body '", "link '"},
    {"geom '", "shape '"},
}};

}  // namespace

std::string in_words_of_urdf(std::string message) {
  for (const auto& [mjcf, urdf] : kWords)
    for (std::size_t at = 0; (at = message.find(mjcf, at)) != std::string::npos; at += urdf.size())
      message.replace(at, mjcf.size(), urdf);
  return message;
}

}  // namespace legwright
