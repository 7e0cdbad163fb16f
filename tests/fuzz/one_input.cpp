// SPDX-License-Identifier: Apache-2.0
// What libFuzzer calls.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  legwright::test::LEGWRIGHT_FUZZ_TARGET({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
