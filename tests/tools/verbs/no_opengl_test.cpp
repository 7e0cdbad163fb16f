// SPDX-License-Identifier: Apache-2.0
// A machine without OpenGL: `optimize` does all but the pictures, `render` says why and exits 3.
#include <gtest/gtest.h>

#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class NoOpenGl : public testing::Test, protected test::CallsInFolder {
 protected:
  test::Outcome optimize(const std::string& run, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"optimize",
                                   (test::kExamples / "puppy/sideways.toml"),
                                   "--motion-only",
                                   "--plan-only",
                                   "--max-iterations",
                                   "1",
                                   "-o",
                                   run};
    words.insert(words.end(), more.begin(), more.end());
    return call(words);
  }
  std::string motion(const std::string& run) const {
    return read_file(folder_.path() / run / "result" / "motion.csv");
  }
};

TEST_F(NoOpenGl, OptimizeGoesOnAndRenderExitsThree) {
  const test::Outcome usual = optimize("usual", {"--no-pictures"});
  ASSERT_LE(usual.code, 1) << usual.err;
  const test::TemporaryFolder libraries;
  for (const char* name : {"libOSMesa.so.8", "libEGL.so.1"})
    write_file(libraries.path() / name, "");  // there, but broken
  const test::Variable path("LD_LIBRARY_PATH", libraries.path().string());
  const test::Outcome without = optimize("without");
  EXPECT_EQ(without.code, usual.code) << without.err;
  for (const char* part : {"warning: no pictures: no off-screen OpenGL", "libOSMesa.so.8",
                           "libEGL.so.1", "install the package libosmesa6"})
    EXPECT_TRUE(test::contains(without.err, part)) << part << " in: " << without.err;
  EXPECT_EQ(motion("without"), motion("usual"));
  EXPECT_FALSE(fs::exists(folder_.path() / "without/iterations/0000/frame.png"));
  const test::Outcome render = call({"render", "without"});
  EXPECT_EQ(render.code, 3);
  EXPECT_TRUE(test::contains(render.err, "no off-screen OpenGL")) << render.err;
}

TEST_F(NoOpenGl, TheEnvironmentCanRuleItOut) {
  ASSERT_LE(optimize("run", {"--no-pictures"}).code, 1);
  const test::Variable none("LEGWRIGHT_GL", "none");
  const test::Outcome render = call({"render", "run", "--still"});
  EXPECT_EQ(render.code, 3);
  EXPECT_TRUE(test::contains(render.err, "LEGWRIGHT_GL=none")) << render.err;
  EXPECT_EQ(call({"render", "run", "--phase", "1.5"}).code, 2);  // no phase
}

}  // namespace
}  // namespace legwright
