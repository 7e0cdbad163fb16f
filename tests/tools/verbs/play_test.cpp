// SPDX-License-Identifier: Apache-2.0
// Which plugin `play` gives to a Python, and what it says where there is none for its MuJoCo.
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;

class PlayInPython : public testing::Test, protected test::CallsInFolder {
 protected:
  void SetUp() override {
    ::unsetenv("DISPLAY");  // nothing is opened: `play` prints the command and ends
    ::unsetenv("WAYLAND_DISPLAY");
    fs::copy(fs::path(test::source_dir()) / "tests/tools/report/data", folder_.path() / "run",
             fs::copy_options::recursive);
    write_file(folder_.path() / "run/result/scene.xml", "<mujoco/>");
  }

  /// Plays the run in a stand-in for a Python with this release of MuJoCo.
  test::Outcome play_with(const std::string& mujoco) const {
    const fs::path python = folder_.path() / "python";
    write_file(python, "#!/bin/sh\necho " + mujoco + "\n");
    fs::permissions(python, fs::perms::owner_all);
    const test::Variable named("LEGWRIGHT_PYTHON", python.string());
    return call({"play", "run", "--viewer", "python"});
  }

  /// The name of a file that says of itself that it serves this release.
  std::string plugin_for(const std::string& mujoco) const {
    const fs::path file = folder_.path() / "gait.so";
    write_file(file, "ELF legwright.gait for MuJoCo " + mujoco + std::string(1, '\0') + "rest");
    return file.string();
  }
};

TEST_F(PlayInPython, TakesThePluginOfThisBuildForItsOwnMujoco) {
  const test::Outcome play = play_with(LEGWRIGHT_MUJOCO_VERSION);
  EXPECT_TRUE(contains(play.out, "bin/mujoco_plugin/liblegwright.so")) << play.out << play.err;
  EXPECT_TRUE(contains(play.err, "no display")) << play.err;
}

TEST_F(PlayInPython, SaysHowToGetThePluginForAnotherMujoco) {
  const test::Outcome play = play_with("9.8.7");
  EXPECT_EQ(play.code, 3);
  EXPECT_EQ(play.out, "");
  for (const char* words :
       {"has mujoco 9.8.7", "-DLEGWRIGHT_PLUGIN_VERSIONS=9.8.7", "legwright_gait_plugins",
        "mujoco_plugin/liblegwright.so, which serves MuJoCo " LEGWRIGHT_MUJOCO_VERSION,
        "legwright_plugins/9.8.7/liblegwright.so, not there", "pip install 'mujoco",
        "==" LEGWRIGHT_MUJOCO_VERSION "'"})
    EXPECT_TRUE(contains(play.err, words)) << words << " in: " << play.err;
}

TEST_F(PlayInPython, TakesTheNamedPluginThatServesItsMujoco) {
  const test::Variable named("LEGWRIGHT_PLUGIN", plugin_for("9.8.7"));
  const test::Outcome play = play_with("9.8.7");
  EXPECT_TRUE(contains(play.out, "gait.so")) << play.out << play.err;
  EXPECT_TRUE(contains(play.err, "no display")) << play.err;
}

TEST_F(PlayInPython, RefusesANamedPluginForAnotherMujoco) {
  const test::Variable named("LEGWRIGHT_PLUGIN", plugin_for("9.8.7"));
  for (const char* mujoco : {LEGWRIGHT_MUJOCO_VERSION, "9.8.70", "9.8"}) {
    const test::Outcome play = play_with(mujoco);
    EXPECT_EQ(play.code, 3) << mujoco;
    for (const char* words : {"gait.so, which serves MuJoCo 9.8.7", "unset LEGWRIGHT_PLUGIN"})
      EXPECT_TRUE(contains(play.err, words)) << words << " in: " << play.err;
  }
}

TEST_F(PlayInPython, DoctorNamesThePluginForTheMujocoOfThePython) {
  const fs::path python = folder_.path() / "python";
  write_file(python, "#!/bin/sh\necho 9.8.7\n");
  fs::permissions(python, fs::perms::owner_all);
  const test::Variable named("LEGWRIGHT_PYTHON", python.string());
  const test::Outcome doctor = call({"doctor"});
  EXPECT_TRUE(contains(doctor.out, "has mujoco 9.8.7, for which there is no plugin")) << doctor.out;
  EXPECT_TRUE(contains(doctor.out, "loadable, for MuJoCo " LEGWRIGHT_MUJOCO_VERSION)) << doctor.out;
}

}  // namespace
}  // namespace legwright
