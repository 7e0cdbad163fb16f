// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tools/run/record.hpp"

namespace legwright {

/// Of a picture [pixels].
struct PictureSize {
  int width = 0, height = 0;
};
void fields(Fields& f, PictureSize& size);

/// What `legwright diff A.png B.png --json` prints.
struct PictureDiffRecord {
  static constexpr RecordKind kKind{"legwright/picture_diff", 1, "diff"};
  std::string before, after;  // the files
  PictureSize before_size, after_size;
  bool same_size = false;
  int pixels = 0, different = 0, allowed = 0;
  bool pass = false;
  std::optional<std::string> shown;  // the picture that was written
};
void fields(Fields& f, PictureDiffRecord& diff);

}  // namespace legwright
