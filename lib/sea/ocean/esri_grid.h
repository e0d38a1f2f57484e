// Reads depths, or velocities, from the text of an ESRI ASCII grid, a form in which bathymetry is
// commonly sold and given away ("Esri ASCII raster format", ArcGIS documentation).
//
//   ncols 4
//   nrows 3
//   xllcorner 500          (or xllcenter: the middle of the cell in the South-West)
//   yllcorner 6000         (or yllcenter)
//   cellsize 25            (or dx and dy)
//   NODATA_value -9999     (optional)
//   -20 -21 -22 -25        (the northernmost row, from West to East)
//   ...
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/sea/ocean/depth_grid.h"
#include "lib/sea/ocean/floor_signs.h"
#include "lib/sea/ocean/grid_map.h"

namespace shoal {

/// What the numbers of a grid are.
enum class GridValues {
  kElevation,  ///< Negative below the surface, as maps of land and sea have it.
  kDepth,      ///< Positive below the surface.
  kVelocity,   ///< Metres per second, of one component of a current.
};

struct EsriGridOptions {
  std::string name = "grid";  ///< Of the file, for messages.
  GridValues values = GridValues::kElevation;
  /// Where the mission's origin lies in the grid's own coordinates, which must be metres.
  Eigen::Vector2d mission_origin_m = Eigen::Vector2d::Zero();
  /// Depth of cells without data; none: they are an error. Of velocities they never are.
  std::optional<double> nodata_depth_m = {};
};

/// 64 MB of depths.
inline constexpr int kMaxGridPoints = 16'000'000;

/// Returns the grid in the mission's frame. Its points are the middles of the cells. Land counts as
/// depth 0. Keys in any case; lines may end anywhere between the numbers, as the format allows.
/// Without data are the numbers within a millionth of NODATA_value, which programs write with other
/// digits than their numbers (-9999 where it is nan, or missing), those beyond 1e30, "nan", and of
/// depths and elevations the GapMarks. An error names the line and what to do: "bay.asc:9: ...".
/// Takes no more memory than the text has numbers, whatever its header claims.
/// @pre finite options
[[nodiscard]] Result<DepthGrid> ParseEsriGrid(std::string_view text,
                                              const EsriGridOptions& options);

/// What a text holds, in rows from South to North.
struct EsriField {
  GridFrame frame;
  std::vector<float> values;  ///< Depths, >= 0, or velocities: NaN where a cell has no data.
  FloorSigns signs = {};      ///< Of depths and elevations: the numbers of cells with data.
  std::vector<float> gap_marks = {};  ///< Numbers that were taken for no data (GapMarks).
};

/// The same, for values of any kind.
[[nodiscard]] Result<EsriField> ParseEsriField(std::string_view text,
                                               const EsriGridOptions& options);

}  // namespace shoal
