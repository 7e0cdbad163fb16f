// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>

#include "python/core/conversation.hpp"

namespace legwright {

/// What a call shares with the thread that does its work.
struct FollowedCall {
  Conversation conversation;
  KeptError kept;
  std::atomic<int> signal{0};  // not 0: the work is to stop
};

/// Does work that needs no lock on a thread of its own. The calling thread gives up the lock, takes
/// it for what the work asks through the conversation, and looks for signals twenty times a second;
/// what these raise sets `signal`, and is raised once the work has come to its end. So does the end
/// of the interpreter. Needs the lock. Throws what the work throws.
void follow(FollowedCall& call, const std::function<void()>& work);

}  // namespace legwright
