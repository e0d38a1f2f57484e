// What the counts of a network add up to.
#pragma once

#include <cstdint>
#include <numeric>

#include "lib/sea/acoustics/acoustic_statistics.h"

namespace shoal {

/// Returns how many receptions have a fate: all that were offered, but for those in transit.
[[nodiscard]] inline int64_t NumDecided(const AcousticStatistics& statistics) {
  return std::accumulate(statistics.num_fates.begin(), statistics.num_fates.end(), int64_t{0});
}

}  // namespace shoal
