// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/proposals.hpp"

namespace legwright {

/// What `init` found as a tree: trunk, legs front to hind with their servos and feet, mirror images side by side, what
/// rides along. For people, not yet cleaned for a terminal.
std::string robot_tree(const StudiedRobot& found);

/// The proposals as a table, what the file declares already, and what was left out, reason by reason.
std::string proposal_table(const StudiedRobot& found);

}  // namespace legwright
