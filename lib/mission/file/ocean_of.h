// The sea that a mission takes place in: its current and its floor, made from the mission file.
//
//   Result<Ocean> ocean = OceanOf(mission);
//   Eigen::Vector2d water_mps = ocean->WaterVelocityAt({x, y, z}, time_s);
//   if (ocean->floor) double z_m = ocean->floor->DepthAt({x, y});
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/file/grid_files.h"
#include "lib/mission/model/mission.h"
#include "lib/sea/ocean/current.h"
#include "lib/sea/ocean/current_grid.h"
#include "lib/sea/ocean/plume.h"
#include "lib/sea/ocean/sea_floor.h"

namespace shoal {

struct Ocean {
  Current current;
  std::shared_ptr<const CurrentGrid> current_grid;  ///< Null: `current` is the same everywhere.
  std::optional<SeaFloor> floor;                    ///< Absent: the depth is not known.
  std::optional<Plume> plume;
  GridNotes current_notes = {};
  GridNotes floor_notes = {};

  /// Returns the water's velocity over ground, x East, y North. @pre time_s is finite
  [[nodiscard]] Eigen::Vector2d WaterVelocityAt(const Eigen::Vector3d& position_m,
                                                double time_s) const {
    return current_grid ? current_grid->VelocityAt(position_m, time_s) : current.VelocityAt(time_s);
  }
};

/// Returns the sea, drawn from the mission's seed, or why there can be none.
[[nodiscard]] Result<Ocean> OceanOf(const Environment& environment, uint64_t seed,
                                    const GridPlacement& placement);

/// The same for a mission that was loaded from a file.
[[nodiscard]] Result<Ocean> OceanOf(const Mission& mission);

/// What is wrong with one key of [environment.current].
struct CurrentProblem {
  std::string key;
  std::string text;
};
[[nodiscard]] std::vector<CurrentProblem> FindProblems(const CurrentWords& words);

}  // namespace shoal
