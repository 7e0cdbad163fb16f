// SPDX-License-Identifier: Apache-2.0
// OSMesa, EGL, neither: one process each, because MuJoCo takes its functions once.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct Probe {
  int code = -1;
  std::string platform, message, png;
};

/// @param libraries a folder that the loader searches first, or none.
Probe probe(const std::string& platform, const fs::path& libraries = {}) {
  const test::TemporaryFolder folder;
  const fs::path out = folder.path() / "out", err = folder.path() / "err",
                 png = folder.path() / "a.png";
  std::string command = "LEGWRIGHT_GL='" + platform + "' ";
  if (!libraries.empty()) command += "LD_LIBRARY_PATH='" + libraries.string() + "' ";
  command += std::string("'") + LEGWRIGHT_GL_PROBE + "' '" + png.string() + "' >'" + out.string() +
             "' 2>'" + err.string() + "'";
  const int status = std::system(command.c_str());
  Probe result;
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.platform = read_file(out);
  result.message = read_file(err);
  if (fs::exists(png)) result.png = read_file(png);
  return result;
}

/// A folder in which these libraries are there but broken, as the loader sees it.
void break_libraries(const fs::path& folder, std::initializer_list<const char*> names) {
  for (const char* name : names) write_file(folder / name, "");
}

bool says(const Probe& probe, const char* part) {
  return probe.message.find(part) != std::string::npos;
}

#define LEGWRIGHT_NEEDS(probe, name)                                                         \
  if ((probe).code == 3) {                                                                   \
    GTEST_SKIP() << "NOT TESTED, this machine has no " << (name) << ": " << (probe).message; \
  }

TEST(GlPlatform, OsMesaAndEglDrawTheSameBytes) {
  const Probe osmesa = probe("osmesa"), egl = probe("egl");
  LEGWRIGHT_NEEDS(osmesa, "OSMesa");
  LEGWRIGHT_NEEDS(egl, "EGL");
  ASSERT_EQ(osmesa.code, 0) << osmesa.message;
  ASSERT_EQ(egl.code, 0) << egl.message;
  EXPECT_EQ(osmesa.platform, "osmesa\n");
  EXPECT_EQ(egl.platform, "egl\n");
  EXPECT_GT(osmesa.png.size(), 1000U);
  EXPECT_EQ(osmesa.png, egl.png);
}

TEST(GlPlatform, OsMesaIsTakenFirstAndEglWhereItIsBroken) {
  const Probe first = probe("");
  LEGWRIGHT_NEEDS(first, "OpenGL");
  LEGWRIGHT_NEEDS(probe("osmesa"), "OSMesa");
  LEGWRIGHT_NEEDS(probe("egl"), "EGL");
  EXPECT_EQ(first.platform, "osmesa\n") << first.message;
  const test::TemporaryFolder libraries;
  break_libraries(libraries.path(), {"libOSMesa.so.8"});
  const Probe second = probe("", libraries.path());
  EXPECT_EQ(second.code, 0) << second.message;
  EXPECT_EQ(second.platform, "egl\n");
  EXPECT_EQ(second.png, first.png);
}

TEST(GlPlatform, WithoutAnyTheReasonNamesBothAndAWayOut) {
  const test::TemporaryFolder libraries;
  break_libraries(libraries.path(), {"libOSMesa.so.8", "libEGL.so.1"});
  const Probe none = probe("", libraries.path());
  EXPECT_EQ(none.code, 3);
  for (const char* part : {"no off-screen OpenGL", "libOSMesa.so.8", "libEGL.so.1", "libosmesa6"})
    EXPECT_TRUE(says(none, part)) << part << " in: " << none.message;
  EXPECT_TRUE(none.png.empty());
}

TEST(GlPlatform, TheEnvironmentRulesOutOrIsRefused) {
  const Probe none = probe("none"), odd = probe("vulkan");
  EXPECT_EQ(none.code, 3);
  EXPECT_TRUE(says(none, "LEGWRIGHT_GL=none")) << none.message;
  EXPECT_EQ(odd.code, 3);
  EXPECT_TRUE(says(odd, "'vulkan', expected osmesa, egl or none")) << odd.message;
}

}  // namespace
}  // namespace legwright
