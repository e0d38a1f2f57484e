// Bounds that several parts of the view share.
#pragma once

#include <cstddef>
#include <cstdint>

namespace shoal {

/// Messages of one step may overtake those of the next by less than this.
inline constexpr int64_t kOvertaking_us = 1'000'000;
/// Longer names of vehicles are cut: they are not a mission's.
inline constexpr size_t kMaxNameBytes = 64;

}  // namespace shoal
