#include "lib/tools/view/background_tiles.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace shoal {

namespace {

/// Returns the bytes of a regular file of at most kMaxTileBytes.
Result<std::string> ReadTile(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > kMaxTileBytes) {
    return Error{fmt::format("the tile {} is larger than {} MB: make it smaller", path,
                             kMaxTileBytes / 1'000'000)};
  }
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

Result<TileExtent> ExtentOf(const BackgroundFolder& backgrounds, size_t number,
                            BackgroundKind kind) {
  const Result<std::string> path = backgrounds.Find(number);
  if (!path.ok()) return Error{path.error()};
  return kind == BackgroundKind::kTiles ? ExtentOfMbtiles(*path) : ExtentOfTileFolder(*path);
}

}  // namespace

Result<std::string> TileOf(const BackgroundFolder& backgrounds, size_t number,
                           const TileName& tile) {
  const Result<std::string> path = backgrounds.Find(number);
  if (!path.ok()) return path;
  switch (KindOfBackground(backgrounds.files[number])) {
    case BackgroundKind::kTiles: {
      Result<std::optional<std::string>> bytes = TileOfMbtiles(*path, tile);
      if (!bytes.ok()) return Error{bytes.error()};
      return std::move(*bytes).value_or("");
    }
    case BackgroundKind::kFolder: {
      const std::string below = TileBelow(*path, tile);
      if (below.empty()) return std::string();
      const Result<std::string> file = backgrounds.Find(number, below);
      return file.ok() ? ReadTile(*file) : file;
    }
    case BackgroundKind::kFile:
      break;
  }
  return Error{fmt::format("the background {} has no tiles", backgrounds.files[number])};
}

void WriteBackgrounds(const BackgroundFolder& backgrounds, JsonWriter* json) {
  json->BeginArray();
  for (size_t i = 0; i < backgrounds.files.size(); ++i) {
    json->BeginObject()
        .Text("file", backgrounds.files[i])
        .Boolean("has_world", backgrounds.HasWorld(i));
    const BackgroundKind kind = KindOfBackground(backgrounds.files[i]);
    if (kind == BackgroundKind::kFile) {
      json->Key("tiles").Raw("null").EndObject();
      continue;
    }
    const Result<TileExtent> extent = ExtentOf(backgrounds, i, kind);
    if (!extent.ok()) {
      json->Text("problem", extent.error()).Key("tiles").Raw("null").EndObject();
      continue;
    }
    json->Key("tiles")
        .BeginObject()
        .Integer("min_zoom", extent->min_zoom)
        .Integer("max_zoom", extent->max_zoom)
        .Integer("left", extent->left)
        .Integer("right", extent->right)
        .Integer("top", extent->top)
        .Integer("bottom", extent->bottom)
        .EndObject()
        .EndObject();
  }
  json->EndArray();
}

}  // namespace shoal
