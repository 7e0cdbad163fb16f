// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace legwright {

/// From here on this process gets a signal when its parent dies (the thread that started it, as
/// Linux has it), at once where `parent` is its parent no more.
void end_with_parent(int signal, pid_t parent);

/// The same with SIGKILL where the caller asks for it: LEGWRIGHT_ENDS_WITH is its process id.
void end_with_caller();

}  // namespace legwright
