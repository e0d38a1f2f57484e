// The backgrounds of a mission as a viewer serves them.
#pragma once

#include <cstddef>
#include <string>

#include "lib/base/check/result.h"
#include "lib/mission/file/background_files.h"
#include "lib/tools/tiles/tile_files.h"
#include "lib/tools/view/json_writer.h"

namespace shoal {

/// Returns the bytes of a tile; empty: the background does not have it. An error where the
/// background holds no tiles, or cannot be read. @pre IsTile(tile)
[[nodiscard]] Result<std::string> TileOf(const BackgroundFolder& backgrounds, size_t number,
                                         const TileName& tile);

/// Writes `backgrounds` of /api/setup, as the value of a key: docs/extending/viewer_protocol.md.
void WriteBackgrounds(const BackgroundFolder& backgrounds, JsonWriter* json);

}  // namespace shoal
