// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace legwright::test {

/// The same robot with the origin of each body that has hinges elsewhere, some centimetres off: all
/// that stands in the body keeps its place.
std::string shifted_robot(const std::string& text);

/// The same robot with the frame of its trunk elsewhere: all that stands in the trunk keeps its
/// place there.
std::string with_trunk_frame_at(const std::string& text, const Eigen::Vector3d& place);

}  // namespace legwright::test
