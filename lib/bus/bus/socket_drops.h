// What the kernel threw away because a process did not read fast enough.
#pragma once

#include <cstdint>
#include <span>

namespace shoal {

/// Returns how many datagrams for these UDP ports found this process's receive buffers full, as
/// /proc/net/udp shows; 0 where it cannot be read.
[[nodiscard]] int64_t DroppedDatagrams(std::span<const int> ports);

}  // namespace shoal
