// The CRC-32 of MCAP, zip and Ethernet: polynomial 0xedb88320, reflected, inverted.
#pragma once

#include <cstdint>
#include <string_view>

namespace shoal {

/// Returns the CRC of the bytes before, of which it is `crc`, and of `bytes`. It is 0 of none.
[[nodiscard]] uint32_t ExtendCrc32(uint32_t crc, std::string_view bytes);

}  // namespace shoal
