// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/text/xml.hpp"

namespace legwright {

/// Numbers by which a small file asks MuJoCo for much memory or time: tables of <size>, iterations
/// of <option>, finely cut drawings of <visual>. Throws InputError at the element.
void check_sizes(const XmlFile& xml, const XmlElement& element);

/// Width and height of a picture [pixels].
struct PictureSize {
  double width = 0.0, height = 0.0;
  bool is_face = false;  // one of the six of a cube
};

/// What a robot's textures and height fields take in memory once they are unpacked.
class PictureMemory {
 public:
  /// Adds a texture or height field by what its element says, and nothing for other elements.
  /// Throws InputError at it where a side is longer than 16384, or all together take more than
  /// 512 MB.
  void add(const XmlFile& xml, const XmlElement& element);
  /// Adds one that is read from a picture.
  void add(const XmlFile& xml, const XmlElement& element, PictureSize picture);

 private:
  double bytes_ = 0.0;
};

}  // namespace legwright
