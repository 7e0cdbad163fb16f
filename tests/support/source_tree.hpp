// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tests/support/paths.hpp"

namespace legwright::test {

// Folders of the source tree that tests read.
inline const std::filesystem::path kSource = test::source_dir();
inline const std::filesystem::path kExamples = kSource / "examples";
inline const std::filesystem::path kPuppy = kExamples / "puppy";

}  // namespace legwright::test
