// SPDX-License-Identifier: Apache-2.0
#include "tests/support/paths.hpp"

namespace legwright::test {

std::string source_dir() { return LEGWRIGHT_SOURCE_DIR; }

std::string binary_dir() { return LEGWRIGHT_BINARY_DIR; }

std::string program() { return binary_dir() + "/bin/legwright"; }

}  // namespace legwright::test
