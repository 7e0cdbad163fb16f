// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// Two pictures of gaits, as golden pictures of a pipeline are compared.
struct PictureDiff {
  std::string before, after;  // PNG files
  int allowed = 0;            // pixels that may differ
  std::string shown;          // where side_by_side() of them goes if too many do; empty: nowhere
  bool json = false;
};

/// Prints how many pixels differ. An old picture in the place of `shown` goes away where at most
/// `allowed` do. @return 0 there, 1 else. Throws InputError for a file that is no PNG, and where
/// `shown` is a picture that is compared or something else than a PNG.
int diff_pictures(const PictureDiff& asked);

}  // namespace legwright
