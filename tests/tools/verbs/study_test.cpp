// SPDX-License-Identifier: Apache-2.0
// `study` is the module legwright.study: how its Python is found, called, stopped and judged by its
// exit code. The module itself is tested in python/tests.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/tools/verbs/program.hpp"
#include "tools/run/install.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;

class StudyTest : public testing::Test, protected test::CallsInFolder {
 protected:
  /// A Python program for LEGWRIGHT_PYTHON whose module runs `script`.
  /// @param has what it answers of the library
  std::string interpreter(const std::string& script, const std::string& has = "has") const {
    const fs::path file = folder_.path() / "python";
    write_file(file, "#!/bin/sh\nif [ \"$2\" = -c ]; then printf '" + program_version() + " " +
                         has + "'; exit; fi\n" + script + "\n");
    fs::permissions(file, fs::perms::owner_all);
    return file.string();
  }
};

TEST_F(StudyTest, CallsTheModuleWithTheOptionsAndReturnsItsExitCode) {
  const test::Variable python("LEGWRIGHT_PYTHON",
                              interpreter("printf '%s|' \"$@\"; echo told >&2; exit 75"));
  const test::Outcome study = call(
      {"study", "-strange.toml", "-o", "out", "--workers", "3", "--force", "--quiet", "--json"});
  EXPECT_EQ(study.code, 2);  // what begins with a dash is an option
  const test::Outcome good =
      call({"study", "my study.toml", "-o", "out", "--workers", "3", "--force", "--json"});
  EXPECT_EQ(good.code, 75);
  EXPECT_EQ(good.out,
            "-P|-m|legwright.study|--output|out|--workers|3|--force|--json|--|my study.toml|");
  EXPECT_EQ(good.err, "told\n");
  const test::Outcome cluster = call({"study", "s.toml", "--scheduler", "tcp://a:1", "--quiet"});
  EXPECT_EQ(cluster.out, "-P|-m|legwright.study|--scheduler|tcp://a:1|--quiet|--|s.toml|");
}

TEST_F(StudyTest, RefusesOptionsThatContradictEachOther) {
  EXPECT_EQ(call({"study"}).code, 2);
  EXPECT_EQ(call({"study", "s.toml", "--workers", "0"}).code, 2);
  EXPECT_EQ(call({"study", "s.toml", "--workers", "1", "--scheduler", "tcp://a:1"}).code, 2);
}

TEST_F(StudyTest, SaysHowToGetAPythonThatHasTheModule) {
  {
    const test::Variable none("LEGWRIGHT_PYTHON", (folder_.path() / "gone").string());
    const test::Outcome study = call({"study", "s.toml"});
    EXPECT_EQ(study.code, 3);
    for (const char* part : {"gone does not run", "pip install \".[study]\"", "LEGWRIGHT_PYTHON"})
      EXPECT_TRUE(contains(study.err, part)) << part << " in: " << study.err;
  }
  const test::Variable bare("LEGWRIGHT_PYTHON", interpreter("exit 9", "lacks distributed"));
  const test::Outcome study = call({"study", "s.toml"});
  EXPECT_EQ(study.code, 3);
  EXPECT_TRUE(contains(study.err, "has legwright, but not distributed")) << study.err;
  EXPECT_TRUE(contains(study.err, "pip install \".[study]\"")) << study.err;
}

TEST_F(StudyTest, SignalsGoOnToTheModuleWhoseExitCodeCounts) {
  const test::Variable python(
      "LEGWRIGHT_PYTHON",
      interpreter("trap 'exit 75' TERM; trap 'exit 130' INT; touch ready; while :; do sleep "
                  "0.02; done"));
  for (const auto& [signal, code] : {std::pair(SIGTERM, 75), std::pair(SIGINT, 130)}) {
    fs::remove(folder_.path() / "ready");
    const pid_t child = test::start({"study", "s.toml"}, folder_.path());
    while (!fs::exists(folder_.path() / "ready"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ::kill(child, signal);
    EXPECT_EQ(test::wait_for(child, folder_.path()).code, code);
  }
}

TEST_F(StudyTest, TheModuleIsAskedToStopWhereTheProgramIsKilled) {
  const test::Variable python("LEGWRIGHT_PYTHON",
                              interpreter("trap 'touch asked; exit 75' TERM; touch ready; while :; "
                                          "do sleep 0.02; done"));
  const pid_t child = test::start({"study", "s.toml"}, folder_.path());
  const auto wait_for_file = [&](const char* name) {
    for (int k = 0; k < 2000 && !fs::exists(folder_.path() / name); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return fs::exists(folder_.path() / name);
  };
  ASSERT_TRUE(wait_for_file("ready"));
  ::kill(child, SIGKILL);
  EXPECT_EQ(test::wait_for(child, folder_.path()).code, -SIGKILL);
  EXPECT_TRUE(wait_for_file("asked"));
}

TEST_F(StudyTest, DoctorTellsWhatPythonHasOfStudiesDrakeAndParts) {
  const auto item_of = [this](const std::string& has, const std::string& extra) {
    const test::Variable python("LEGWRIGHT_PYTHON", interpreter("exit 9", has));
    const test::Outcome doctor = call({"doctor", "--json"});
    EXPECT_EQ(doctor.code, 0) << doctor.out;  // none of them is required
    const Json told = Json::parse(doctor.out);
    for (const Json& item : told["items"])
      if (item["name"] == extra) return item;
    return Json();
  };
  for (const auto& [extra, library] : {std::pair("study", "pyarrow"), std::pair("drake", "pydrake"),
                                       std::pair("parts", "trimesh")}) {
    const Json here = item_of("has", extra), gone = item_of(std::string("lacks ") + library, extra);
    EXPECT_EQ(here["found"], true);
    EXPECT_TRUE(contains(here["detail"].get<std::string>(), library)) << here;
    EXPECT_EQ(gone["found"], false);
    EXPECT_TRUE(contains(gone["detail"].get<std::string>(), std::string("but not ") + library));
    EXPECT_TRUE(
        contains(gone["fix"].get<std::string>(), "\"legwright[" + std::string(extra) + "]\""));
  }
}

TEST_F(StudyTest, PartsIsAModuleLikeIt) {
  const test::Variable python("LEGWRIGHT_PYTHON", interpreter("printf '%s|' \"$@\"; exit 1"));
  const test::Outcome parts = call({"parts", "runs/a b", "-o", "out", "--json", "--fit", "0.2",
                                    "--bed", "200x200x180", "--quiet"});
  EXPECT_EQ(parts.code, 1);
  EXPECT_EQ(parts.out,
            "-P|-m|legwright.parts|--output|out|--fit|0.2|--bed|200x200x180|--quiet|"
            "--json|--|runs/a b|");
  EXPECT_EQ(call({"parts"}).code, 2);
}

TEST_F(StudyTest, AModuleThatIsKilledIsToldWithTheWayOn) {
  const test::Variable python("LEGWRIGHT_PYTHON", interpreter("kill -9 $$"));
  const test::Outcome study = call({"study", "s.toml"});
  EXPECT_EQ(study.code, 3);
  EXPECT_TRUE(contains(study.err, "was ended by signal 9 (Killed)")) << study.err;
  EXPECT_TRUE(contains(study.err, "the same command goes on")) << study.err;
}

}  // namespace
}  // namespace legwright
