// SPDX-License-Identifier: Apache-2.0
// Linked into each test program of a build with sanitizers: MuJoCo's arenas, some 14 MB for each
// mjData, are used again. AddressSanitizer maps each anew, keeps it in quarantine and unmaps it
// with its shadow: page faults, a third of the processor time of what reads many robots. A free
// one is poisoned whole until it serves again. An mjData that leaks is told by its head.
#include <mujoco/mujoco.h>
#include <sanitizer/asan_interface.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <vector>

#pragma weak mju_user_malloc  // a program without MuJoCo has none
#pragma weak mju_user_free

namespace legwright::test {
namespace {

constexpr std::size_t kLarge = 1 << 20;  // bytes; what is smaller goes to the allocator as always
constexpr std::size_t kAlignment = 64;   // bytes, as MuJoCo's own

struct Block {
  void* memory = nullptr;
  std::size_t size = 0;
  bool is_taken = false;
};

class ReusedBlocks {
 public:
  void* take(std::size_t size) {
    if (size < kLarge) return aligned(size);
    const std::lock_guard lock(turns_);
    for (Block& each : blocks_) {
      if (each.is_taken || each.size != size) continue;
      each.is_taken = true;
      ASAN_UNPOISON_MEMORY_REGION(each.memory, size);
      return each.memory;
    }
    void* const memory = aligned(size);
    if (memory != nullptr) blocks_.push_back({memory, size, true});
    return memory;
  }

  void give_back(void* memory) {
    {
      const std::lock_guard lock(turns_);
      const auto at = std::find_if(blocks_.begin(), blocks_.end(),
                                   [&](const Block& each) { return each.memory == memory; });
      if (at != blocks_.end()) {
        at->is_taken = false;
        ASAN_POISON_MEMORY_REGION(memory, at->size);
        return;
      }
    }
    std::free(memory);
  }

 private:
  static void* aligned(std::size_t size) {
    return std::aligned_alloc(kAlignment, (size + kAlignment - 1) / kAlignment * kAlignment);
  }

  std::mutex turns_;
  std::vector<Block> blocks_;
};

ReusedBlocks& blocks() {
  static auto* const all = new ReusedBlocks;  // never destroyed: MuJoCo frees until the end
  return *all;
}

[[maybe_unused]] const bool g_is_set = [] {
  if (&mju_user_malloc == nullptr) return false;
  mju_user_malloc = [](std::size_t size) { return blocks().take(size); };
  mju_user_free = [](void* memory) { blocks().give_back(memory); };
  return true;
}();

}  // namespace
}  // namespace legwright::test
