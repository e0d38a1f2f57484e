// Reads the grids that a mission file names, of the sea floor and of the current, and lays them in
// the mission's frame and on its time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/geodesy/local_frame.h"
#include "lib/mission/model/environment.h"
#include "lib/sea/ocean/current_grid.h"
#include "lib/sea/ocean/depth_grid.h"

namespace shoal {

struct Mission;

/// A grid as a mission file names it: "bay.asc", "bay.nc", "bay.nc:elevation".
struct GridName {
  std::string file;
  std::string variable = {};  ///< Empty: none is named.
  bool is_netcdf = false;     ///< The file's name ends in .nc, in any case; else it is ESRI ASCII.
};
[[nodiscard]] GridName SplitGridName(const std::string& text);

/// Returns whether it is "first", "absolute" or a date.
[[nodiscard]] bool IsGridTime(std::string_view text);

/// What of a mission decides how a grid lies.
struct GridPlacement {
  std::string folder;  ///< The mission file's, from which paths count.
  double origin_lat_deg = 0;
  double origin_lon_deg = 0;
  int64_t start_utime = 0;  ///< Microseconds since 1970, of step 0.

  bool operator==(const GridPlacement&) const = default;
};
[[nodiscard]] GridPlacement PlacementOf(const Mission& mission);

/// Returns the paths of the grids that the mission file names, as it has them: floor, then current.
[[nodiscard]] std::vector<std::string> GridFilesOf(const Environment& environment);

/// Lists them as files that were read (NoteFileRead), for a sea that is kept from another time.
void NoteGridFilesRead(const Environment& environment, const GridPlacement& placement);

/// Returns the sea floor of a grid. Land counts as depth 0. An error names the file, what is wrong
/// with it, and the remedy.
[[nodiscard]] Result<DepthGrid> ReadFloorGrid(const FloorOptions& options,
                                              const GridPlacement& placement);

/// Returns the current of a grid. Errors likewise. @pre options.exists()
[[nodiscard]] Result<CurrentGrid> ReadCurrentGrid(const CurrentGridOptions& options,
                                                  const GridPlacement& placement);

}  // namespace shoal
