// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace legwright {

/// Calls work(0) … work(count − 1), at most `threads` at a time, and returns when all are done.
/// Each index must touch its own data only: then results do not depend on the number of threads.
/// What an index throws is thrown here, the lowest index first, after all have ended.
void parallel_for(int count, int threads, const std::function<void(int)>& work);

}  // namespace legwright
