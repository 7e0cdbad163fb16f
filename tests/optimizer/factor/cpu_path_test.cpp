// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/cpu_path.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace legwright {
namespace {

constexpr const char* kVariable = "LEGWRIGHT_CPU_PATH";

/// Puts the variable back as it was.
class CpuPathTest : public testing::Test {
 protected:
  CpuPathTest() {
    if (const char* found = std::getenv(kVariable)) before_ = found;
  }
  ~CpuPathTest() override {
    if (before_.empty())
      unsetenv(kVariable);
    else
      setenv(kVariable, before_.c_str(), 1);
  }

 private:
  std::string before_;
};

TEST_F(CpuPathTest, TheFastestIsTakenUnlessOneIsNamed) {
  ASSERT_EQ(unsetenv(kVariable), 0);
  EXPECT_EQ(cpu_path(), available_cpu_paths().back());
  for (const CpuPath path : available_cpu_paths()) {
    ASSERT_EQ(setenv(kVariable, std::string(to_string(path)).c_str(), 1), 0);
    EXPECT_EQ(cpu_path(), path);
    EXPECT_EQ(cpu_path_by_name(to_string(path)), path);
  }
}

TEST_F(CpuPathTest, AnUnknownNameIsRefusedWithThoseThereAre) {
  ASSERT_EQ(setenv(kVariable, "avx1024", 1), 0);
  EXPECT_FALSE(cpu_path_by_name("avx1024"));
  try {
    cpu_path();
    FAIL() << "must throw";
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("LEGWRIGHT_CPU_PATH is 'avx1024'"), std::string::npos) << message;
    EXPECT_NE(message.find("baseline"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace legwright
