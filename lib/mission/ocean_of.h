// The sea that a mission takes place in: its current and its floor, made from the mission file.
//
//   Result<Ocean> ocean = OceanOf(mission.environment, mission.seed, folder_of_the_file);
//   Eigen::Vector2d water_mps = Velocity(ocean->current.At(time_s));
//   if (ocean->floor) double z_m = ocean->floor->DepthAt({x, y});
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/check/result.h"
#include "lib/mission/mission.h"
#include "lib/ocean/current.h"
#include "lib/ocean/plume.h"
#include "lib/ocean/sea_floor.h"

namespace shoal {

struct Ocean {
  Current current;
  std::optional<SeaFloor> floor;  ///< Absent: the depth is not known.
  std::optional<Plume> plume;
};

/// Returns the sea, drawn from the mission's seed, or why there can be none. A grid's path counts
/// from `folder`.
[[nodiscard]] Result<Ocean> OceanOf(const Environment& environment, uint64_t seed,
                                    const std::string& folder);

/// The same for a mission that was loaded from a file.
[[nodiscard]] Result<Ocean> OceanOf(const Mission& mission);

/// What is wrong with one key of [environment.current].
struct CurrentProblem {
  std::string key;
  std::string text;
};
[[nodiscard]] std::vector<CurrentProblem> FindProblems(const CurrentWords& words);

}  // namespace shoal
