// SPDX-License-Identifier: Apache-2.0
#include "tools/run/picture_diff_record.hpp"

namespace legwright {

void fields(Fields& f, PictureSize& size) {
  f("width", size.width, "pixels");
  f("height", size.height, "pixels");
}

void fields(Fields& f, PictureDiffRecord& diff) {
  f("before", diff.before, "file");
  f("after", diff.after, "file");
  f("before_size", diff.before_size);
  f("after_size", diff.after_size);
  f("same_size", diff.same_size);
  f("pixels", diff.pixels, "of the picture after");
  f("different", diff.different, "pixels; all of them where the sizes differ");
  f("allowed", diff.allowed, "how many pixels may differ");
  f("pass", diff.pass, "whether the sizes are the same and no more pixels differ: exit code 0");
  f("shown", diff.shown, "the picture that -o had written; absent where none was");
}

}  // namespace legwright
