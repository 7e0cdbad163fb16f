// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// The text of play_gait.py, which `export` writes as play.py.
extern const char* const kPlayScript;

}  // namespace legwright
