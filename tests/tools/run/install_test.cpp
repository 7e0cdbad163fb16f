// SPDX-License-Identifier: Apache-2.0
#include "tools/run/install.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

namespace fs = std::filesystem;

TEST(Install, KnowsItselfAndItsVersions) {
  EXPECT_TRUE(fs::exists(program_file()));
  EXPECT_FALSE(command_line().empty());
  EXPECT_EQ(versions()["legwright"], program_version());
  EXPECT_NE(versions()["eigen"], "");
  EXPECT_GT(peak_memory_mib(), 1.0);
}

}  // namespace
}  // namespace legwright
