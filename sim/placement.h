// Which part of a mission steps which vehicle, where several processes share one mission.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// The recorder, the director and the embedding program are always of part 0.
struct Placement {
  size_t num_parts = 1;
  size_t broker_part = 0;  ///< Has the broker, but for the blocks of other parts.
  /// Which part routes the reports of a block (lib/run/broker/report_blocks.h); empty: the
  /// broker's.
  std::vector<size_t> part_of_block = {};
  std::vector<size_t> part_of_vehicle = {};  ///< By its place in the mission.

  bool operator==(const Placement&) const = default;
};

/// Returns all of a mission as one part.
[[nodiscard]] Placement OnePart(const Mission& mission);

/// Shares the vehicles out by what they cost: in the mission's order, so that neighbours stay
/// together, with fewer to part 0, which has the director too. The broker is shared out with the
/// vehicles, block by block; where it has one block only, it is of part 0 or part 1, whichever
/// leaves less to the busiest part. `by_hand` names vehicles that go to a part of the user's
/// choice, as --place takes them: "0=alpha,bravo", "1=group:hiders", and "1=shore_broker", which
/// then has all blocks; the others are shared out around them. The result of a mission does not
/// depend on its placement. The error names the words that are wrong.
/// @pre num_parts > 0
[[nodiscard]] Result<Placement> MakePlacement(const Mission& mission, size_t num_parts,
                                              std::span<const std::string> by_hand = {});

}  // namespace shoal
