// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace legwright {

/// Exchanges the names of two folders, so that there is no moment without either.
/// @return false where the file system cannot, or not these two: a lower layer's, a mounted one.
/// Throws std::system_error.
bool exchange_at_once(const std::filesystem::path& fresh, const std::filesystem::path& old);

/// Puts a folder in the place of another: at once where the file system can exchange names.
/// @return where the other one is now. Throws std::system_error.
std::filesystem::path exchange_folders(const std::filesystem::path& fresh,
                                       const std::filesystem::path& old);

/// The same; the other one goes away when the new one stands there. Throws std::system_error.
void replace_folder(const std::filesystem::path& fresh, const std::filesystem::path& old);

}  // namespace legwright
