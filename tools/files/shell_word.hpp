// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// Text as a shell takes it for one word: quoted only where that is needed.
std::string shell_word(const std::string& text);

}  // namespace legwright
