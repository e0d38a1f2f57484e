// The files that viewers draw under a mission: [mission] backgrounds. They lie in the mission's
// folder, since a viewer shows them to all that reach its page.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// What a background is, by its name.
enum class BackgroundKind {
  kFile,    ///< Read as a whole: GeoJSON, or an image.
  kTiles,   ///< An MBTiles database, "charts/bay.mbtiles".
  kFolder,  ///< A folder of tiles, "charts/tiles/": ZOOM/COLUMN/ROW.png below it.
};

/// Where a viewer finds them.
struct BackgroundFolder {
  static constexpr size_t kMaxBytes = 64'000'000;  ///< Of a file.

  std::string folder = {};
  std::vector<std::string> files = {};  ///< As the mission names them.

  /// Returns the bytes of a file or, with `world`, of the world file beside it. An error where
  /// there is none, where it is too large, and where a link leads out of the folder. Errors name
  /// the file and what to do.
  [[nodiscard]] Result<std::string> Read(size_t number, bool world) const;
  /// Returns where a background, or `below` it in a folder of tiles, lies: a path without links.
  /// Errors as those of Read().
  [[nodiscard]] Result<std::string> Find(size_t number, const std::string& below = "") const;
  /// Returns true where a world file lies beside it.
  [[nodiscard]] bool HasWorld(size_t number) const;
};

[[nodiscard]] BackgroundFolder BackgroundsOf(const Mission& mission);

[[nodiscard]] BackgroundKind KindOfBackground(std::string_view file);

/// Returns what is wrong with a name; empty: nothing.
[[nodiscard]] std::string BackgroundProblem(std::string_view file);

/// Returns "chart.pgw" of "chart.png": where an image lies; empty for what needs none.
[[nodiscard]] std::string WorldFileOf(std::string_view file);

/// Returns those of the mission's files that are there, each before its world file: what a
/// recording holds copies of. Without folders of tiles, and without files beyond kMaxBytes.
[[nodiscard]] std::vector<std::string> BackgroundFilesThere(const Mission& mission);

/// Returns what a viewer will not find: a text for each file that is missing, too large, or out of
/// the mission's folder, with what to do.
[[nodiscard]] std::vector<std::string> MissingBackgrounds(const Mission& mission);

}  // namespace shoal
