// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// Two pictures of gaits, as golden pictures of a pipeline are compared.
struct PictureDiff {
  std::string before, after;  // PNG files
  int allowed = 0;            // pixels that may differ
  std::string shown;          // where before | after | difference go if too many do; empty: nowhere
  bool json = false;
};

/// Prints how many pixels differ. @return 0 where at most `allowed` do, 1 else. Throws InputError
/// for a file that is no PNG.
int diff_pictures(const PictureDiff& asked);

}  // namespace legwright
