// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace legwright {

/// Puts a folder in the place of another, which goes away only when the new one stands there: at
/// once where the file system can exchange names. Throws std::system_error.
void replace_folder(const std::filesystem::path& fresh, const std::filesystem::path& old);

}  // namespace legwright
