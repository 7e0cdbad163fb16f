// SPDX-License-Identifier: Apache-2.0
// examples/broken/verdicts: gaits whose validation fails for the reason in the file's name; and
// what a limits file and JUnit make of verdicts.
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstdlib>

#include "tests/support/long_tests.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

const fs::path kVerdicts = test::kExamples / "broken/verdicts";

class BrokenVerdict : public testing::Test, protected test::CallsInFolder {
 protected:
  void plan(const std::string& name) const {
    const test::Outcome optimize =
        call({"optimize", (kVerdicts / name).string(), "--motion-only", "--plan-only",
              "--no-pictures", "--no-certificate", "--force", "-o", "run"});
    ASSERT_LE(optimize.code, 1) << optimize.err;
  }
  Json result(const char* file) const {
    return Json::parse(read_file(folder_.path() / "run/result" / file));
  }
};

std::string first_failing(const Json& verdict) {
  for (const Json& row : verdict["result"]["limits"])
    if (!row["pass"].get<bool>()) return row["name"].get<std::string>();
  return "none";
}

TEST_F(BrokenVerdict, FailsForTheReasonInItsName) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(kVerdicts)) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    const std::string name = entry.path().filename().string(), text = read_file(entry.path());
    const std::string lead = "# expect: ";
    ASSERT_EQ(text.rfind(lead, 0), 0U) << name;
    const std::size_t bar = text.find(" | "), end = text.find('\n');
    ASSERT_LT(bar, end) << name;
    plan(name);
    const test::Outcome validate = call({"validate", "run", "--quick"});
    EXPECT_EQ(validate.code, 1) << name << validate.err;
    const Json verdict = result("verdict.json");
    EXPECT_EQ(first_failing(verdict), text.substr(lead.size(), bar - lead.size())) << name;
    const std::string reason = verdict["result"]["reasons"].at(0).get<std::string>();
    EXPECT_EQ(reason.rfind(text.substr(bar + 3, end - bar - 3), 0), 0U) << name << ": " << reason;
    EXPECT_FALSE(fs::exists(folder_.path() / "run/result/robustness.json"));
  }
  EXPECT_GE(files, 6);
}

TEST_F(BrokenVerdict, IsToldInEveryForm) {
  LEGWRIGHT_LONG_TEST();
  plan("turns_too_little.toml");
  // It turns at two thirds of what is wanted: no pass, but enough to have margins.
  write_file(folder_.path() / "limits.toml",
             "turn_ratio.low = 0.5\nheading_drift_per_cycle.high = 0.2\npath_deviation.high = 1.0\n"
             "survival.low = 0.0\nmargin.mass.low = 0.9\n");
  const std::vector<std::string> words{"validate", "run",         "--limits",  "limits.toml",
                                       "--junit",  "lenient.xml", "--samples", "4"};
  const test::Outcome lenient = call(words);
  EXPECT_EQ(lenient.code, 0) << lenient.out << lenient.err;
  EXPECT_TRUE(test::contains(lenient.out, "disturbed walks survive")) << lenient.out;
  const Json verdict = result("verdict.json"), robustness = result("robustness.json");
  EXPECT_EQ(first_failing(verdict), "none");
  for (const char* name : {"numerics", "survival", "margin.mass.low"})
    EXPECT_TRUE(test::contains(verdict["result"]["limits"].dump(), name)) << name;
  EXPECT_EQ(robustness["monte_carlo"]["samples"], 4);
  EXPECT_EQ(robustness["factors"].size(), 11U);
  const test::Outcome strict = call({"validate", "run", "--quick", "--junit", "out.xml"});
  EXPECT_EQ(strict.code, 1);
  EXPECT_TRUE(test::contains(read_file(folder_.path() / "out.xml"), "<failure type=\"limit\""));
  if (std::system("xmllint --version >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "NOT TESTED, whether JUnit files are valid XML: this machine has no xmllint";
  for (const char* name : {"lenient.xml", "out.xml"}) {
    const std::string lint = "xmllint --noout '" + (folder_.path() / name).string() + "'";
    EXPECT_EQ(std::system(lint.c_str()), 0) << name;
  }
}

TEST_F(BrokenVerdict, DamagedRunIsRefusedBeforeAnythingIsPlayed) {
  // No scene is there: whatever came to play one would say so.
  fs::create_directories(folder_.path() / "run/inputs");
  fs::create_directories(folder_.path() / "run/iterations");
  for (const char* text :
       {R"("name": 3)", R"("motion_only": "yes")", R"("name": null, "tasks": [])"}) {
    write_file(folder_.path() / "run/run.json",
               R"({"schema": "legwright/run", )" + std::string(text) + "}");
    const test::Outcome damaged = call({"validate", "run", "--quick", "--junit", "out.xml"});
    EXPECT_EQ(damaged.code, 2) << text << damaged.err;
    EXPECT_TRUE(test::contains(damaged.err, "the file is damaged")) << damaged.err;
    const std::string junit = read_file(folder_.path() / "out.xml");
    EXPECT_TRUE(test::contains(junit, "<error type=\"legwright\"")) << junit;
    EXPECT_TRUE(test::contains(junit, "the file is damaged")) << junit;
  }
  const std::string run = read_file(folder_.path() / "run/run.json");
  for (const char* name : {"run/run.json", "nowhere/out.xml", "run"}) {
    const test::Outcome refused = call({"validate", "run", "--quick", "--junit", name});
    EXPECT_TRUE(refused.code == 2 || refused.code == 3) << name;
    EXPECT_TRUE(test::contains(refused.err, std::string("--junit ") + name)) << refused.err;
  }
  EXPECT_EQ(read_file(folder_.path() / "run/run.json"), run);
}

TEST_F(BrokenVerdict, OfARunThatCannotBeWrittenIsTold) {
  plan("turns_too_little.toml");
  const auto may = [&](fs::perms permissions) {
    for (const char* folder : {"run/result", "run"})
      fs::permissions(folder_.path() / folder, permissions);
  };
  may(fs::perms::owner_read | fs::perms::owner_exec);
  // Permissions hold for root, too, without this capability.
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0) != 0) ::_exit(77);
    const std::vector<std::string> words{"validate", "run", "--quick", "--json"};
    ::_exit(test::wait_for(test::start(words, folder_.path()), folder_.path()).code);
  }
  const test::Outcome told = test::wait_for(child, folder_.path());
  may(fs::perms::owner_all);
  if (told.code == 77) GTEST_SKIP() << "NOT TESTED: nobody here is kept from writing";
  EXPECT_EQ(told.code, 1) << told.err;
  EXPECT_TRUE(test::contains(told.err, "run cannot be written (Permission denied): the verdict is"))
      << told.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "run/result/verdict.json"));
  const Json verdict = Json::parse(told.out)["verdict"];
  EXPECT_FALSE(verdict.contains("with")) << "no other files stand beside it";
  EXPECT_EQ(call({"validate", "run", "--quick"}).code, 1);
  EXPECT_EQ(result("verdict.json")["result"], verdict["result"]);
}

TEST_F(BrokenVerdict, FaultyLimitsFilesAreRefusedBeforeAnythingIsPlayed) {
  write_file(folder_.path() / "limits.toml", "[tild]\nhigh = 1\n");
  const test::Outcome unknown = call({"validate", "run", "--limits", "limits.toml"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(test::contains(unknown.err, "did you mean 'tilt'?")) << unknown.err;
  write_file(folder_.path() / "limits.toml", "survival.low = 0.9\n");
  const test::Outcome quick = call({"validate", "run", "--quick", "--limits", "limits.toml"});
  EXPECT_EQ(quick.code, 2);
  EXPECT_TRUE(test::contains(quick.err, "--quick leaves out")) << quick.err;
  write_file(folder_.path() / "limits.toml", "numerics.high = 0\n");
  const test::Outcome numerics = call({"validate", "run", "--quick", "--limits", "limits.toml"});
  EXPECT_EQ(numerics.code, 2);
  EXPECT_TRUE(test::contains(numerics.err, "limits on numerics, which --quick leaves out"))
      << numerics.err;
  plan("turns_too_little.toml");
  write_file(folder_.path() / "limits.toml", "margin.floor_friction.low = 5\n");
  const test::Outcome slippery = call({"validate", "run", "--limits", "limits.toml"});
  EXPECT_EQ(slippery.code, 2);
  EXPECT_TRUE(test::contains(
      slippery.err, "limits.toml:1: margin.floor_friction.low: is 5, above what is planned"))
      << slippery.err;
}

}  // namespace
}  // namespace legwright
