// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "optimizer/solve/status.hpp"
#include "tools/files/json_file.hpp"
#include "tools/session/alternatives.hpp"
#include "tools/session/state.hpp"

namespace legwright {

/// What a solve found. It stands in the journal beside the command that asked for it, so that a
/// replay takes it over and need not solve.
struct Found {
  Eigen::VectorXd s;                     // the body
  std::vector<Eigen::VectorXd> motions;  // of each task
  std::vector<double> values;       // Fᵢ + Jᵢ of each task: another program's may be others
  std::vector<SolveStatus> status;  // of each motion
};

/// What a state stands at; nothing where F is not finite there.
std::optional<Found> found_in(const SessionState& state);
/// Whether these are a body within the state's bounds and motions of its tasks, of the right sizes.
bool fits(const Found& found, const SessionState& state);
/// Whether F and J of the point are what they were when this was found, but for rounding.
bool same_values(const Found& found, const DesignPoint& point);

/// Numbers are base64 of their bytes: the same bits come back.
Json json_of(const Found& found);
Json json_of(const Alternatives& all);
/// Read strictly. Throw std::invalid_argument, or an error of Json's, that says what is wrong.
Found found_of(const Json& json);
Alternatives alternatives_of(const Json& json);  // without their problem
/// Whether designs are of such a state's problem, each with a motion for each of its tasks.
bool fits(const Alternatives& all, const SessionState& state);

}  // namespace legwright
