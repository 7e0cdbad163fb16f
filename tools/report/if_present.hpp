// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace legwright {

/// Runs `read` on the file if it is there; what it throws becomes a note.
template <class Read>
void if_present(const std::filesystem::path& file, std::vector<std::string>& notes,
                const Read& read) {
  if (!std::filesystem::exists(file)) return;
  try {
    read(file);
  } catch (const std::exception& error) {
    notes.push_back(error.what());
  }
}

}  // namespace legwright
