// SPDX-License-Identifier: Apache-2.0
#include "optimizer/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace legwright {

void parallel_for(int count, int threads, const std::function<void(int)>& work) {
  std::vector<std::exception_ptr> failures(std::max(count, 0));
  std::atomic<int> next{0};
  const auto take_turns = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
        if (!failures[i])  // thrown by another runtime than ours, as MuJoCo has one of its own
          failures[i] = std::make_exception_ptr(std::runtime_error("failure of another library"));
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    try {
      for (int t = 1; t < std::min(threads, count); ++t) helpers.emplace_back(take_turns);
    } catch (const std::system_error&) {  // the system has no more threads: fewer do it
    }
    take_turns();
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace legwright
