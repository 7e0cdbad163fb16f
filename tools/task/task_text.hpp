// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

/// Task files that are changed in one place and stay byte for byte elsewhere.
namespace legwright {

/// The text of a task file with `robot = "robot.xml"`, everything else byte for byte: what can be
/// run again beside a copy of the robot under that name.
std::string text_beside_robot(const std::string& text);

/// The text with these weights of its [[task]] tables, in their order. The text must be one that
/// parse_task_set() takes.
std::string with_weights(const std::string& text, const std::vector<double>& weights);

/// Where the tables of a task stand: within its [[task]] table, or in the file itself. Throws
/// InputError where the text is no TOML. @param task its number from 0
std::vector<std::string> path_of_task(const std::string& text, int task);

/// The text with another value of a key, which is put where its table is, or in a table of its own
/// where there is none yet; without one the key is taken out, also a whole table. Where the text is
/// too intricate for that it is written anew, without its comments. What comes out says nothing
/// else: that is looked at.
/// @param path names from the root on; those of [[task]] tables are their numbers from 0
/// @param value as TOML. Throws InputError where text or value are no TOML.
std::string with_key(const std::string& text, const std::vector<std::string>& path,
                     const std::optional<std::string>& value);

}  // namespace legwright
