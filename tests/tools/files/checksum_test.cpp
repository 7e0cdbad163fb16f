// SPDX-License-Identifier: Apache-2.0
#include "tools/files/checksum.hpp"

#include <gtest/gtest.h>

#include <set>

namespace legwright {
namespace {

TEST(Crc32, AgreesWithThePublishedCheckValue) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(crc32_hex(""), "00000000");
  EXPECT_EQ(crc32_hex("123456789"), "cbf43926");
}

TEST(Crc32, NoticesEveryFlippedBit) {
  const std::string text = "{\"event\":\"iteration\"}";
  for (std::size_t i = 0; i < text.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = text;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      EXPECT_NE(crc32(damaged), crc32(text));
    }
}

TEST(Sha256, AgreesWithFips180Examples) {
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DiffersForEveryLengthAroundABlock) {
  std::set<std::string> seen;
  for (std::size_t length = 0; length < 200; ++length)
    seen.insert(sha256_hex(std::string(length, 'x')));
  EXPECT_EQ(seen.size(), 200u);
}

}  // namespace
}  // namespace legwright
