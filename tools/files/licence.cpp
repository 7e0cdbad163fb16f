// SPDX-License-Identifier: Apache-2.0
#include "tools/files/licence.hpp"

#include <system_error>

#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

constexpr const char* kNames[] = {"LICENSE",     "LICENSE.txt", "LICENSE.md", "LICENCE",
                                  "LICENCE.txt", "LICENCE.md",  "COPYING",    "COPYING.txt",
                                  "NOTICE",      "NOTICE.txt",  "NOTICE.md"};
constexpr std::uintmax_t kLargest = 1u << 20;  // [bytes]

}  // namespace

std::vector<std::string> licences_in(const std::filesystem::path& folder) {
  std::vector<std::string> found;
  for (const char* const name : kNames) {
    std::error_code error;
    const std::filesystem::path file = folder / name;
    if (std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error)) &&
        std::filesystem::file_size(file, error) <= kLargest && !error)
      found.emplace_back(name);
  }
  return found;
}

std::vector<std::string> copy_licences(const std::filesystem::path& from,
                                       const std::filesystem::path& to) {
  std::vector<std::string> names = licences_in(from);
  for (const std::string& name : names) write_file(to / name, read_file(from / name));
  return names;
}

}  // namespace legwright
