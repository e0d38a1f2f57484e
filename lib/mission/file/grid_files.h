// Reads the grids that a mission file names, of the sea floor and of the current, and lays them in
// the mission's frame and on its time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
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

/// Returns true for "first", for "absolute" and for a date.
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

/// What `shoal check` reports of a grid beside its values.
struct GridNotes {
  std::vector<std::string> warnings = {};  ///< What is read, and probably meant otherwise.
  bool needs_origin = false;               ///< It lies where origin in [mission] has it.
  /// Of a projected map that grid_origin placed: where on Earth that is.
  std::optional<GeoPoint> own_origin = {};
};

template <class Grid>
struct GridRead {
  Grid grid;
  GridNotes notes = {};
};

/// Returns the sea floor of a grid. Land counts as depth 0. An error names the file, what is wrong
/// with it, and the remedy; that no point of the map lies below the surface is one.
[[nodiscard]] Result<GridRead<DepthGrid>> ReadFloorGrid(const FloorOptions& options,
                                                        const GridPlacement& placement);

/// Returns the current of a grid. Velocities along the axes of a projected or curvilinear grid are
/// turned to East and North at each point. Errors likewise. @pre options.exists()
[[nodiscard]] Result<GridRead<CurrentGrid>> ReadCurrentGrid(const CurrentGridOptions& options,
                                                            const GridPlacement& placement);

}  // namespace shoal
