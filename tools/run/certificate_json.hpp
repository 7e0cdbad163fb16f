// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/objective/violations.hpp"
#include "optimizer/solve/certificate.hpp"
#include "tools/run/certificate_record.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// certificate.json: what is proven of a result, per task and for the design. No times: equal runs
/// give equal bytes.
/// @param proof of `iterate` @param tasks of the problem that are told about
CertificateRecord certificate_record(const CodesignProblem& problem, const DesignIteration& iterate,
                                     const Certificate& proof, const std::vector<int>& tasks);

/// A violation in words: "friction_cone (15): FL at 0.25 s, by 0.3 N".
std::string in_words(const Violation& violation, const Objective& objective);

/// The worst `count` constraints of a task at a motion, in words, worst first; only such as are
/// broken by more than can be called rounding.
std::vector<std::string> worst_constraints(const Objective& objective, const Eigen::VectorXd& s,
                                           const Eigen::VectorXd& m, int count);

}  // namespace legwright
