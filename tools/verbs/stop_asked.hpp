// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace legwright {

/// Whether somebody asked a run to stop; any thread may call it.
using StopAsked = std::function<bool()>;

}  // namespace legwright
