// SPDX-License-Identifier: Apache-2.0
// The plugins of all releases that were built, each in a host of each release: it plays in its own
// and is refused in every other.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <string>

#include "plugin/number_text.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/simulate/plugin_files.hpp"

namespace legwright {
namespace {

struct Release {
  const char *version, *host, *plugin;
};
void PrintTo(const Release& release, std::ostream* out) { *out << release.version; }
constexpr Release kReleases[] = {LEGWRIGHT_RELEASES};

struct Ended {
  int code;
  std::string output;
};

Ended run(const std::string& command) {
  Ended ended{-1, ""};
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return ended;
  std::array<char, 4096> buffer;
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe))
    ended.output.append(buffer.data(), size);
  ended.code = pclose(pipe);
  return ended;
}

/// The complete model that the plugin's page shows.
std::string swinging_arm() {
  const std::string page = read_file(test::source_dir() + "/plugin/README.md");
  const std::size_t begin = page.find("<mujoco model=\"swinging_arm\">");
  return page.substr(begin, page.find("```", begin) - begin);
}

Ended load_in(const Release& host, const Release& plugin) {
  const test::TemporaryFolder folder;
  const std::string model = (folder.path() / "arm.xml").string();
  write_file(model, swinging_arm());
  return run(std::string("ASAN_OPTIONS=detect_leaks=0 '") + host.host + "' '" + plugin.plugin +
             "' '" + model + "'");
}

/// The angle that version_host prints.
double elbow(const std::string& output) {
  const std::string before = "elbow ", after = " after 0.250 s";
  const std::size_t begin = output.find(before) + before.size(), end = output.find(after);
  if (end == std::string::npos) return 0.0;
  return read_number(output.substr(begin, end - begin)).value_or(0.0);
}

class Releases : public testing::TestWithParam<Release> {};

TEST_P(Releases, PluginPlaysInItsOwn) {
  const Ended ended = load_in(GetParam(), GetParam());
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_EQ(ended.output.find(std::string("MuJoCo ") + GetParam().version + "\n"), 0U)
      << ended.output;
  EXPECT_EQ(ended.output.find("warning"), std::string::npos) << ended.output;
  // The spline at its second knot, (0 + 4 · 0.5 + 0) / 6, as near as the servo comes.
  EXPECT_NEAR(elbow(ended.output), 1.0 / 3.0, 0.03) << ended.output;
}

TEST_P(Releases, PluginIsRefusedByEveryOther) {
  if (std::size(kReleases) == 1)
    GTEST_SKIP() << "NOT TESTED: configured without LEGWRIGHT_PLUGIN_VERSIONS";
  for (const Release& host : kReleases) {
    if (std::string(host.version) == GetParam().version) continue;
    const Ended ended = load_in(host, GetParam());
    EXPECT_NE(ended.code, 0) << ended.output;
    EXPECT_NE(ended.output.find(std::string("libmujoco.so.") + GetParam().version +
                                ": cannot open shared object file"),
              std::string::npos)
        << ended.output;
    EXPECT_EQ(ended.output.find("elbow"), std::string::npos) << ended.output;
  }
}

TEST_P(Releases, PluginIsFoundByTheReleaseThatItServes) {
  const auto plugin = find_plugin(GetParam().version);
  ASSERT_TRUE(plugin.has_value());
  EXPECT_TRUE(std::filesystem::equivalent(*plugin, GetParam().plugin)) << *plugin;
  EXPECT_EQ(served_mujoco(*plugin), GetParam().version);
}

INSTANTIATE_TEST_SUITE_P(Built, Releases, testing::ValuesIn(kReleases), [](const auto& release) {
  std::string name = release.param.version;
  for (char& c : name) c = c == '.' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace legwright
