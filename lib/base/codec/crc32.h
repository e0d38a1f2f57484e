// The checksum of Ethernet, zip and PNG: CRC-32 of ISO/IEC 8802-3 (IEEE 802.3), polynomial
// 0x04C11DB7, bits reflected, preset and inverted. Finds every error of up to three bits in a frame
// of up to 11 KB, and all but one in 4 billion of the others.
#pragma once

#include <cstdint>
#include <span>

namespace shoal {

/// Crc32 of the text "123456789" is 0xCBF43926; of nothing, 0.
[[nodiscard]] uint32_t Crc32(std::span<const uint8_t> bytes);

}  // namespace shoal
