// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/plugin_files.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

const fs::path kPrograms = fs::path(test::binary_dir()) / "bin";

TEST(PluginFiles, NameTheMujocoThatTheyServe) {
  EXPECT_EQ(served_mujoco(kPrograms / "mujoco_plugin/liblegwright.so"), mj_versionString());
  const test::TemporaryFolder folder;
  const auto served = [&](const std::string& bytes) {
    write_file(folder.path() / "file", bytes);
    return served_mujoco(folder.path() / "file");
  };
  EXPECT_EQ(served(std::string("\0legwright.gait for MuJoCo 12.3.4\0", 35)), "12.3.4");
  EXPECT_EQ(served("legwright.gait for MuJoCo 12.3.4"), "12.3.4");
  EXPECT_EQ(served("legwright.gait for MuJoCo "), std::nullopt);
  EXPECT_EQ(served("legwright.gait for MuJo"), std::nullopt);
  EXPECT_EQ(served(""), std::nullopt);
  EXPECT_EQ(served_mujoco(folder.path()), std::nullopt);
  EXPECT_EQ(served_mujoco(folder.path() / "nothing"), std::nullopt);
}

TEST(PluginFiles, ThatOfTheProgramsOwnMujocoIsFound) {
  EXPECT_EQ(find_plugin(mj_versionString()), kPrograms / "mujoco_plugin/liblegwright.so");
  EXPECT_EQ(find_plugin("9.8.7"), std::nullopt);
}

TEST(PluginFiles, AMissingOneIsReportedWithTheWayToGetIt) {
  try {
    require_plugin("9.8.7");
    FAIL() << "there is a plugin for MuJoCo 9.8.7";
  } catch (const PluginError& error) {
    const std::string message = error.what();
    for (const std::string& words :
         {std::string("for MuJoCo 9.8.7 was not found"),
          std::string("-DLEGWRIGHT_PLUGIN_VERSIONS=9.8.7"),
          (kPrograms / "legwright_plugins/9.8.7/liblegwright.so, not there").string(),
          std::string("which serves MuJoCo ") + mj_versionString()})
      EXPECT_NE(message.find(words), std::string::npos) << words << " in: " << message;
  }
}

}  // namespace
}  // namespace legwright
