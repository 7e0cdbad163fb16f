// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page_pictures.hpp"

#include <fmt/format.h>

#include <span>

#include "tools/files/atomic_file.hpp"

namespace legwright {

namespace fs = std::filesystem;

bool PictureBudget::take(const fs::path& file, std::uintmax_t most) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return false;
  if (size > left_ || size > most) {
    refused_ = true;
    return false;
  }
  left_ -= size;
  return true;
}

namespace {

std::string picture_uri(const char* type, const fs::path& file) {
  const std::string bytes = read_file(file);
  return data_uri(type,
                  std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

}  // namespace

void add_moving(Html& page, const fs::path& webp, const fs::path& still, const std::string& title,
                const std::string& explanation) {
  page.open("figure", {{"class", "moving"}});
  page.open("figcaption").element("b", title).text(" " + explanation).close();
  page.open("picture");
  if (fs::exists(still))
    page.lone("source", {{"media", "print, (prefers-reduced-motion: reduce)"},
                         {"srcset", picture_uri("image/png", still)}});
  page.lone("img", {{"src", picture_uri("image/webp", webp)}, {"alt", title}});
  page.close().close();
}

void add_strip(Html& page, const fs::path& file, const std::string& title,
               const std::string& explanation, double share) {
  page.open("figure", {{"class", "strip"}});
  page.open("figcaption").element("b", title).text(" " + explanation).close();
  page.open("div", {{"class", "scroll"}, {"tabindex", "0"}});
  const std::string source = picture_uri("image/png", file);
  if (share < 1.0) {
    const std::string style =
        fmt::format("width: {:.2f}%; min-width: {:.2f}rem", 100.0 * share, 56.0 * share);
    page.lone("img", {{"src", source}, {"alt", title}, {"style", style}});
  } else {
    page.lone("img", {{"src", source}, {"alt", title}});
  }
  page.close().close();
}

}  // namespace legwright
