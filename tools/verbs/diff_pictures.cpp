// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/diff_pictures.hpp"

#include <fmt/format.h>

#include "mjcf/text/input_error.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/exit_code.hpp"
#include "tools/files/json_file.hpp"
#include "tools/image/id_image.hpp"
#include "tools/image/png.hpp"
#include "tools/image/side_by_side.hpp"

namespace legwright {
namespace {

Image picture(const std::string& file) {
  try {
    return read_png(file);
  } catch (const std::system_error&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw InputError(file, 0, "",
                     fmt::format("is no PNG ({}); give two pictures, as `legwright render` draws "
                                 "them, or two models",
                                 error.what()));
  }
}

std::string size_text(const Image& image) {
  return fmt::format("{} x {} pixels", image.width, image.height);
}

}  // namespace

int diff_pictures(const PictureDiff& asked) {
  const Image before = picture(asked.before), after = picture(asked.after);
  const bool same_size = before.width == after.width && before.height == after.height;
  const int all = after.width * after.height;
  const int differ = same_size ? different_pixels(before, after) : all;
  const bool passes = same_size && differ <= asked.allowed;
  if (!passes && same_size && !asked.shown.empty())
    write_png(asked.shown, side_by_side(before, after));
  if (asked.json)
    fmt::print("{}", to_text({{"schema", "legwright/picture_diff"},
                              {"version", 1},
                              {"before", asked.before},
                              {"after", asked.after},
                              {"same_size", same_size},
                              {"pixels", all},
                              {"different", differ},
                              {"allowed", asked.allowed}}));
  else if (!same_size)
    fmt::print("{} and {}: other sizes\n", size_text(before), size_text(after));
  else
    fmt::print("{} of {} pixels differ, {} may{}\n", differ, all, asked.allowed,
               passes || asked.shown.empty()
                   ? ""
                   : "; before | after | difference: " + terminal_text(asked.shown));
  return passes ? kOk : kInfeasible;
}

}  // namespace legwright
