// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <functional>

#include "python/core/conversation.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// Makes an objective of Python's the problem's J. It is an instance of _objective.AskedObjective,
/// which judges what the user's function returns. It is asked through the conversation; what it
/// raises ends the run by an exception, KeyboardInterrupt as any Ctrl-C. Without the lock.
/// @param interrupt called on the calling thread at Ctrl-C, with the exception to keep
void set_own_objective(CodesignProblem& problem, const nanobind::object& objective,
                       Conversation& conversation,
                       const std::function<void(nanobind::python_error&&)>& interrupt);

}  // namespace legwright
