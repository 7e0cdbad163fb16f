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
  EXPECT_NE(dynamic.find("[libmujoco.so." LEGWRIGHT_MUJOCO_VERSION "]"),
            std::string::npos);  // named with its version
  EXPECT_EQ(dynamic.find("RPATH"), std::string::npos);
  EXPECT_EQ(dynamic.find("RUNPATH"), std::string::npos);
  EXPECT_EQ(dynamic.find("libfmt"), std::string::npos);
}

/// What a host without MuJoCo of its own prints when it loads the plugin.
std::string output_of_other_host(const std::string& arguments) {
  return output_of("ASAN_OPTIONS=detect_leaks=0 '" LEGWRIGHT_OTHER_HOST "' '" + kFile + "' " +
                   arguments + " 2>&1");
}

TEST(Library, NamesTheVersionOfMujocoThatIsMissing) {
  const std::string output = output_of_other_host("");
  EXPECT_NE(output.find("not loaded: libmujoco.so." LEGWRIGHT_MUJOCO_VERSION
                        ": cannot open shared object file"),
            std::string::npos)
      << output;
}

TEST(Library, RefusesAnotherVersionUnderTheRightName) {
  const std::string engine = "'" LEGWRIGHT_OTHER_MUJOCO "' ";
  const std::string other = output_of_other_host(engine + "9008007");
  EXPECT_NE(other.find("legwright.gait: init -1: legwright.gait \"gait\": built for "
                       "MuJoCo " LEGWRIGHT_MUJOCO_VERSION
                       ", but this is 9.8.7; load the plugin for it, or "
                       "rebuild Legwright with it"),
            std::string::npos)
      << other;
  EXPECT_NE(other.find("legwright.sensor: init -1: legwright.sensor \"gait\": built for MuJoCo"),
            std::string::npos)
      << other;
  // Negative control: of the right version, it is the model that is at fault.
  const std::string right = output_of_other_host(engine + LEGWRIGHT_MUJOCO_HEADER);
  EXPECT_NE(right.find("no actuator refers to this instance"), std::string::npos) << right;
  EXPECT_EQ(right.find("built for"), std::string::npos) << right;
}

}  // namespace
}  // namespace legwright
