// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/parent_death.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <cstring>

namespace legwright {
namespace {

constexpr const char* kCaller = "LEGWRIGHT_ENDS_WITH";

}  // namespace

void end_with_parent(int signal, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, signal);
  if (::getppid() != parent) ::raise(signal);
}

void end_with_caller() {
  const char* caller = std::getenv(kCaller);
  if (caller == nullptr) return;
  pid_t parent = 0;
  std::from_chars(caller, caller + std::strlen(caller), parent);
  ::unsetenv(kCaller);  // what this process starts has another parent
  if (parent > 0) end_with_parent(SIGKILL, parent);
}

}  // namespace legwright
