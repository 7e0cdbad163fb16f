// SPDX-License-Identifier: Apache-2.0
// `validate --engine drake` up to the Python that it runs: which one, with what, and what it says
// where there is none. What Python then does is tested in python/tests/test_drake.py.
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/run/install.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;

class SecondEngine : public testing::Test, protected test::CallsInFolder {
 protected:
  void SetUp() override {
    fs::copy(fs::path(test::source_dir()) / "tests/tools/report/data", folder_.path() / "run",
             fs::copy_options::recursive);
  }

  /// Validates in a stand-in for a Python: it answers the question what it has, and tells what else
  /// it is asked to run.
  test::Outcome validate_with(const std::string& answer, std::vector<std::string> more = {}) const {
    const fs::path python = folder_.path() / "python";
    write_file(python, "#!/bin/sh\nif [ \"$2\" = -c ]; then printf '" + answer +
                           "'; else echo \"$@\"; exit 1; fi\n");
    fs::permissions(python, fs::perms::owner_all);
    const test::Variable named("LEGWRIGHT_PYTHON", python.string());
    std::vector<std::string> words{"validate", "run", "--engine", "drake"};
    words.insert(words.end(), more.begin(), more.end());
    return call(words);
  }

  static void expect_refusal(const test::Outcome& outcome, int code,
                             const std::vector<std::string>& words) {
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.out, "");
    for (const std::string& part : words)
      EXPECT_TRUE(contains(outcome.err, part)) << part << " in: " << outcome.err;
  }
};

TEST_F(SecondEngine, RunsThePackageAndEndsWithItsExitCode) {
  const test::Outcome run = validate_with(program_version() + " has");
  EXPECT_EQ(run.out, "-P -m legwright.drake run --cycles 20\n");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_EQ(validate_with(program_version() + " has", {"--limits", "a b.toml", "--json"}).out,
            "-P -m legwright.drake run --cycles 20 --limits a b.toml --json\n");
}

TEST_F(SecondEngine, SaysHowToGetIt) {
  const std::string cure = "pip install \".[drake]\"";
  expect_refusal(validate_with(""), 3, {"has no package legwright", cure, "LEGWRIGHT_PYTHON"});
  expect_refusal(validate_with(program_version() + " lacks pydrake"), 3,
                 {"has legwright, but not pydrake", cure});
  expect_refusal(validate_with("9.8.7 has"), 3,
                 {"has legwright 9.8.7, and this program is " + program_version(), cure});
}

TEST_F(SecondEngine, RefusesWhatOnlyMujocoMeasures) {
  for (const char* option : {"--quick", "--junit=x.xml"})
    expect_refusal(validate_with(program_version() + " has", {option}), 2,
                   {std::string(option).substr(0, 7), "for MuJoCo's validation"});
}

TEST_F(SecondEngine, NeedsARun) {
  expect_refusal(call({"validate", "nowhere", "--engine", "drake"}), 3, {"nowhere"});
  const test::Outcome unknown = call({"validate", "run", "--engine", "bullet"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(contains(unknown.err, "{mujoco,drake}")) << unknown.err;
}

}  // namespace
}  // namespace legwright
