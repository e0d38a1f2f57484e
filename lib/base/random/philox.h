// Philox4x32-10, a keyed permutation of 128-bit counters (Salmon, Moraes, Dror, Shaw: "Parallel
// random numbers: as easy as 1, 2, 3", SC 2011). Everything random in shoal comes from it.
#pragma once

#include <array>
#include <cstdint>

namespace shoal {

using PhiloxCounter = std::array<uint32_t, 4>;
using PhiloxKey = std::array<uint32_t, 2>;

/// Returns 128 random bits: the same for the same counter and key, on every machine.
[[nodiscard]] PhiloxCounter Philox4x32(const PhiloxCounter& counter, const PhiloxKey& key);

}  // namespace shoal
