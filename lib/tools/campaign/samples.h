// What a repetition of a campaign draws: its mission's seed, and the sampled keys. Both depend on
// the campaign's seed and the number of the repetition alone, so that all cases meet the same sea
// and the same losses (common random numbers), and more repetitions change none that are there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/tools/campaign/campaign.h"

namespace shoal {

/// Returns the mission's seed, below 2^48. @pre repetition >= 1
[[nodiscard]] uint64_t SeedOf(const Campaign& campaign, int64_t repetition);

/// Returns the values of the sampled keys, as TOML writes them, in the campaign's order.
///
/// With a Latin hypercube (McKay, Beckman, Conover 1979), each block of campaign.latin_hypercube
/// repetitions has one draw in each of as many equally probable strata of each key; the order of
/// the strata is shuffled by block and key.
[[nodiscard]] std::vector<std::string> SamplesOf(const Campaign& campaign, int64_t repetition);

}  // namespace shoal
