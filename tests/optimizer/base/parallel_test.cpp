// SPDX-License-Identifier: Apache-2.0
#include "optimizer/base/parallel.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <unwind.h>

#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace legwright {
namespace {

TEST(ParallelFor, CallsEachIndexOnceAtAnyThreadCount) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<int> calls(23, 0);
    parallel_for(23, threads, [&](int i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(23, 1)) << threads;
  }
  parallel_for(0, 2, [](int) { FAIL() << "there is nothing to do"; });
}

TEST(ParallelFor, ThrowsTheFirstFailureAfterAllHaveEnded) {
  std::vector<int> calls(8, 0);
  try {
    parallel_for(8, 3, [&](int i) {
      ++calls[i];
      if (i == 2 || i == 5) throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "2");
  }
  EXPECT_EQ(calls, std::vector<int>(8, 1));
}

TEST(ParallelFor, TellsAFailureThatIsNoExceptionOfOurs) {
  _Unwind_Exception foreign{};
  foreign.exception_class = 0x4c5747545445535cU;  // of no runtime that we know
  EXPECT_THROW(parallel_for(4, 2,
                            [&](int i) {
                              if (i == 3) _Unwind_RaiseException(&foreign);
                            }),
               std::runtime_error);
}

/// While it lives, this process may start no threads.
class WithoutThreads {
 public:
  WithoutThreads() {
    ::pthread_attr_t attributes;
    ::pthread_getattr_default_np(&attributes);
    ::pthread_attr_getstacksize(&attributes, &size_);
    ::pthread_attr_setstacksize(&attributes, std::size_t{1} << 46);  // no address space has it
    ::pthread_setattr_default_np(&attributes);
    ::pthread_attr_destroy(&attributes);
  }
  ~WithoutThreads() {
    ::pthread_attr_t attributes;
    ::pthread_getattr_default_np(&attributes);
    ::pthread_attr_setstacksize(&attributes, size_);
    ::pthread_setattr_default_np(&attributes);
    ::pthread_attr_destroy(&attributes);
  }
  WithoutThreads(const WithoutThreads&) = delete;
  WithoutThreads& operator=(const WithoutThreads&) = delete;

 private:
  std::size_t size_ = 0;
};

TEST(ParallelFor, DoesWithoutThreadsThatTheSystemHasNot) {
  const WithoutThreads none;
  EXPECT_THROW(std::thread([] {}).join(), std::system_error) << "else nothing is tested";
  std::vector<int> calls(9, 0);
  parallel_for(9, 4, [&](int i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(9, 1));
}

}  // namespace
}  // namespace legwright
