// SPDX-License-Identifier: Apache-2.0
// What the shared library asks of a host: read from the file with binutils.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace legwright {
namespace {

std::string output_of(const std::string& command) {
  std::string output;
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 4096> buffer;
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.append(buffer.data(), size);
  }
  pclose(pipe);
  return output;
}

const std::string kFile = LEGWRIGHT_PLUGIN_FILE;

TEST(Library, ExportsNothing) { EXPECT_EQ(output_of("nm -D --defined-only '" + kFile + "'"), ""); }

TEST(Library, CannotEndTheHost) {
  const std::string symbols = output_of("nm -D --undefined-only '" + kFile + "'");
  ASSERT_NE(symbols.find(" mju_warning\n"), std::string::npos) << symbols;  // nm works
  for (const char* const symbol :
       {"mju_error", "mju_setLogHandler", "exit@", "_exit@", "abort@", "signal@"}) {
    EXPECT_EQ(symbols.find(std::string(" ") + symbol), std::string::npos) << symbol;
  }
}

TEST(Library, LeavesTheChoiceOfMujocoToTheHost) {
  const std::string dynamic = output_of("readelf -d '" + kFile + "'");
  EXPECT_NE(dynamic.find("libmujoco.so.3"), std::string::npos);  // named with its version
  EXPECT_EQ(dynamic.find("RPATH"), std::string::npos);
  EXPECT_EQ(dynamic.find("RUNPATH"), std::string::npos);
  EXPECT_EQ(dynamic.find("libfmt"), std::string::npos);
}

}  // namespace
}  // namespace legwright
