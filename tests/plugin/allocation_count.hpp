// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// How often operator new has been called in this process, plugins included.
long allocation_count();

}  // namespace legwright
