// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/run/judged_sums.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {

/// A verdict under the name of its task.
struct JunitSuite {
  std::string name;
  Verdict verdict;
  JudgedSums of = {};  // what was judged
};

/// The verdicts as JUnit XML: a suite per task, a case per limit, what was
/// judged as properties "of FILE". Valid XML whatever the names are.
std::string junit_xml(const std::vector<JunitSuite>& suites);
/// A suite of one case that ended in an error before there was a verdict.
std::string junit_error_xml(const std::string& suite, const std::string& message);

}  // namespace legwright
