// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/tools/verbs/program.hpp"

/// Tasks of the examples as people run them: optimize, then validate --quick.
namespace legwright::test {

struct JudgedExample {
  int optimize = -1, validate = -1;  // exit codes
  std::string told;                  // by both on stderr, if they ran here
};

/// The folder that examples/table has just filled for tests and pages, and tests/robots/walk its
/// robots/ (tools/test does so, with --verdicts); empty: each test makes its own runs.
inline std::filesystem::path made_examples() {
  const char* const folder = std::getenv("LEGWRIGHT_MADE_EXAMPLES");
  return folder == nullptr ? "" : folder;
}

/// Makes the run `into` of a task, by the options that examples/table --verdicts gives and the
/// verdict needs; or copies the run that is made already.
/// @param task ROBOT/TASK.toml below examples/
inline JudgedExample judge_example(const std::string& task, const std::filesystem::path& into) {
  namespace fs = std::filesystem;
  JudgedExample out;
  if (const fs::path made = made_examples(); !made.empty()) {
    const fs::path file(task);
    const std::string name = file.parent_path().string() + "-" + file.stem().string();
    std::ifstream(made / (name + ".codes")) >> out.optimize >> out.validate;
    EXPECT_GE(out.validate, 0) << made << " has no run of " << task << ": run examples/table";
    fs::copy(made / name, into, fs::copy_options::recursive);
    return out;
  }
  const Outcome optimize = call({"optimize", (kExamples / task).string(), "--no-pictures",
                                 "--no-certificate", "--no-reasons", "-o", into.string()});
  const Outcome validate = call({"validate", into.string(), "--quick"});
  return {optimize.code, validate.code, optimize.err + validate.out + validate.err};
}

}  // namespace legwright::test
