// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// What to write in a URDF, where a message says what to write in MJCF: feet are <collision>
/// shapes, bodies are links. Other words stay.
std::string in_words_of_urdf(std::string message);

}  // namespace legwright
