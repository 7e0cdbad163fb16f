// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace legwright {

/// CRC-32 of IEEE 802.3 (as zlib and PNG have it).
std::uint32_t crc32(std::string_view bytes);
/// The same as eight lower-case hexadecimal digits.
std::string crc32_hex(std::string_view bytes);

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);
/// The same as its 32 bytes.
std::string sha256_bytes(std::string_view bytes);

}  // namespace legwright
