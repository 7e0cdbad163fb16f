// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright::test {

/// Folders of this checkout and of this build. Functions, not macros: one object file has them, so
/// that all others are the same in every checkout, and a compiler cache serves them there.
std::string source_dir();
std::string binary_dir();

/// The program that was built.
std::string program();

}  // namespace legwright::test
