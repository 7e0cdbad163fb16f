// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace legwright {

ChildProcess::ChildProcess(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int error =
      ::posix_spawn(&child_, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  messages_ = ends[0];
  if (error == 0) return;
  ::close(messages_);
  throw std::system_error(error, std::generic_category(), "cannot run " + words.front());
}

ChildProcess::~ChildProcess() {
  stop();
  (void)follow([](const std::string&) {});
  ::close(messages_);
}

int ChildProcess::follow(const std::function<void(const std::string&)>& tell) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t got; (got = ::read(messages_, buffer.data(), buffer.size())) > 0 ||
                    (got < 0 && errno == EINTR);) {
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
    for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
      tell(text.substr(0, end));
  }
  if (!text.empty()) tell(text);
  const std::lock_guard lock(mutex_);
  if (child_ < 0) return 0;
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

void ChildProcess::stop() {
  const std::lock_guard lock(mutex_);
  if (child_ > 0) ::kill(child_, SIGKILL);
}

}  // namespace legwright
