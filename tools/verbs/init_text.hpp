// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/propose/proposals.hpp"

namespace legwright {

/// What `init` found as a tree: trunk, legs front to hind with their servos and feet, mirror images
/// side by side, what rides along. For people, not yet cleaned for a terminal.
std::string robot_tree(const ProposedParameters& found);

/// The robot in a line, and what of it is held or keeps it from standing.
std::string robot_summary(const ProposedParameters& found);

/// What the file brings that scenes have otherwise, surroundings and solver options, a line each.
std::string file_notes(const RobotModel& robot);

/// "26 design parameters (10 lengths, 16 angles) in its <custom> section"; what the file had
/// already besides.
std::string proposal_summary(const ProposedParameters& found);

/// That nothing was to be added to the file.
std::string declared_summary(const ProposedParameters& found);

/// The proposals as a table, what the file declares already, and what was left out, reason by
/// reason.
std::string proposal_table(const ProposedParameters& found);

}  // namespace legwright
