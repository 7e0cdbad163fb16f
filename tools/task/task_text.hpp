// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace legwright
