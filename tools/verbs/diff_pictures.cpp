// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/diff_pictures.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/exit_code.hpp"
#include "tools/files/json_file.hpp"
#include "tools/image/id_image.hpp"
#include "tools/image/png.hpp"
#include "tools/image/side_by_side.hpp"
#include "tools/run/picture_diff_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

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

std::string size_text(const PictureSize& size) {
  return fmt::format("{} x {} pixels", size.width, size.height);
}

/// Throws InputError where the picture that shows the difference would take the place of one that
/// is compared, or of something else than a picture. It goes away where there is nothing to show.
void check_place(const PictureDiff& asked) {
  const fs::path shown = asked.shown;
  if (asked.shown.empty() || !fs::exists(shown)) return;
  for (const std::string& compared : {asked.before, asked.after})
    if (fs::exists(compared) && fs::equivalent(shown, compared))
      throw InputError(asked.shown, 0, "",
                       "-o would replace a picture that is compared; name another file");
  constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
  if (!fs::is_regular_file(shown)) return;  // writing it tells why not
  if (const std::string head = read_head(shown, kPng.size()); !head.empty() && head != kPng)
    throw InputError(asked.shown, 0, "",
                     "-o would replace something else than a PNG; name another file");
}

/// Writes what differs where that is too much; else no picture of an earlier one stays.
/// @return whether there is a picture now
bool show(const PictureDiff& asked, bool passes, const Image& before, const Image& after) {
  if (asked.shown.empty()) return false;
  if (!passes)
    write_png(asked.shown, side_by_side(before, after));
  else if (fs::is_regular_file(asked.shown))
    fs::remove(asked.shown);
  return !passes;
}

void tell(const PictureDiffRecord& found) {
  const std::string shown = found.shown ? terminal_text(*found.shown) : "";
  if (!found.same_size)
    fmt::print("{} and {}: other sizes{}\n", size_text(found.before_size),
               size_text(found.after_size), shown.empty() ? "" : "; before | after: " + shown);
  else
    fmt::print("{} of {} pixels differ, {} may{}\n", found.different, found.pixels, found.allowed,
               shown.empty() ? "" : "; before | after | difference: " + shown);
}

}  // namespace

int diff_pictures(const PictureDiff& asked) {
  check_place(asked);
  const Image before = picture(asked.before), after = picture(asked.after);
  PictureDiffRecord found{.before = asked.before,
                          .after = asked.after,
                          .before_size = {before.width, before.height},
                          .after_size = {after.width, after.height},
                          .same_size = before.width == after.width && before.height == after.height,
                          .pixels = after.width * after.height,
                          .allowed = asked.allowed,
                          .shown = {}};
  found.different = found.same_size ? different_pixels(before, after) : found.pixels;
  found.pass = found.same_size && found.different <= found.allowed;
  if (show(asked, found.pass, before, after)) found.shown = asked.shown;
  if (asked.json)
    fmt::print("{}", to_text(json_of(found)));
  else
    tell(found);
  return found.pass ? kOk : kInfeasible;
}

}  // namespace legwright
