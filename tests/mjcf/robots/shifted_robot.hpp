// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright::test {

/// The same robot with the origin of each body that has hinges elsewhere, some centimetres off: all
/// that stands in the body keeps its place.
std::string shifted_robot(const std::string& text);

}  // namespace legwright::test
