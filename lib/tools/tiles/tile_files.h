// Raster tiles of a map, read from an MBTiles database (MBTiles 1.3) or from a folder. Files may
// hold anything: sizes, counts and the work of a query are bounded, and nothing is written.
//
// A tile is named by its zoom z, 0 to kMaxZoom, its column x from longitude -180 and its row y from
// the North, each less than 2^z, in Web Mercator (EPSG 3857).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "lib/base/check/result.h"

namespace shoal {

struct TileName {
  static constexpr int kMaxZoom = 24;

  int z = 0;
  int64_t x = 0;
  int64_t y = 0;
};

/// Returns true for a tile that there can be.
[[nodiscard]] bool IsTile(const TileName& tile);

/// What tiles there are: zooms, and where those of the lowest zoom lie.
struct TileExtent {
  int min_zoom = 0;
  int max_zoom = 0;
  int64_t left = 0;    ///< Columns of zoom min_zoom.
  int64_t right = 0;   ///< The last one.
  int64_t top = 0;     ///< Rows of zoom min_zoom, from the North.
  int64_t bottom = 0;  ///< The last one.
};

/// Larger tiles are refused.
inline constexpr size_t kMaxTileBytes = 4'000'000;

/// Returns the extent, or what is wrong with the file: it is cut, no MBTiles, has vector tiles, or
/// its query does not come to an end.
[[nodiscard]] Result<TileExtent> ExtentOfMbtiles(const std::string& path);
/// Returns the tile's bytes, an image; nothing where the file does not have it. @pre IsTile(tile)
[[nodiscard]] Result<std::optional<std::string>> TileOfMbtiles(const std::string& path,
                                                               const TileName& tile);

/// The same of a folder: ZOOM/COLUMN/ROW.png, .jpg, .jpeg or .webp. Its lowest zoom counts with at
/// most 100,000 files.
[[nodiscard]] Result<TileExtent> ExtentOfTileFolder(const std::string& path);
/// Returns the path of a tile below the folder, with the first ending that there is; empty: there
/// is none. @pre IsTile(tile)
[[nodiscard]] std::string TileBelow(const std::string& folder, const TileName& tile);

}  // namespace shoal
