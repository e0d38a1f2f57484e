// Recovers an order of answers by the one before it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace shoal {

/// Returns `ids` with each that `reference` has no match for replaced by the nearest unmatched id
/// of `reference`: fewest differing bits, then nearest place. An id matches at its own place, else
/// at any other; each place of `reference` matches once. Nothing if the lengths differ, if both are
/// empty, or if more than half of the ids were replaced.
[[nodiscard]] std::optional<std::vector<int64_t>> RepairSchedule(
    const std::vector<int64_t>& ids, const std::vector<int64_t>& reference);

}  // namespace shoal
