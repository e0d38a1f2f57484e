#include "lib/tools/tiles/tile_files.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// Operations of SQLite's machine after which a query is ended: a file can define `tiles` as a
/// query that never ends.
constexpr int kMaxOperations = 50'000'000;
constexpr int kMaxFilesCounted = 100'000;
constexpr std::array<std::string_view, 4> kEndings = {".png", ".jpg", ".jpeg", ".webp"};

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct FinalizeStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, FinalizeStatement>;

/// A database of others: opened for reading, its schema not trusted.
class ForeignDatabase {
 public:
  explicit ForeignDatabase(const std::string& path) : path_(path) {
    sqlite3* database = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &database,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, nullptr);
    database_.reset(database);
    if (code != SQLITE_OK) return;
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_limit(database, SQLITE_LIMIT_LENGTH, static_cast<int>(kMaxTileBytes));
    sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_progress_handler(
        database, kMaxOperations, [](void*) { return 1; }, nullptr);
  }

  Result<Statement> Prepare(std::string_view sql) {
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()),
                                        &statement, nullptr);
    if (code != SQLITE_OK) return Problem(code);
    return Statement(statement);
  }

  Error Problem(int code) const {
    const std::string_view what = code == SQLITE_INTERRUPT ? "its query does not come to an end"
                                  : code == SQLITE_TOOBIG  ? "a tile is larger than 4 MB"
                                  : code == SQLITE_ERROR   ? sqlite3_errmsg(database_.get())
                                                           : sqlite3_errstr(code);
    return Error{fmt::format("{} is no MBTiles file that can be read: {}; copy or make it again",
                             fs::path(path_).filename().string(), what)};
  }

 private:
  std::string path_;
  std::unique_ptr<sqlite3, CloseDatabase> database_;
};

/// Reads the whole of `text` as a number of a folder or file; nothing where it is none.
std::optional<int64_t> NumberIn(std::string_view text) {
  int64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return is_whole && number >= 0 && !text.empty() ? std::optional(number) : std::nullopt;
}

}  // namespace

bool IsTile(const TileName& tile) {
  if (tile.z < 0 || tile.z > TileName::kMaxZoom) return false;
  const int64_t count = int64_t{1} << tile.z;
  return tile.x >= 0 && tile.y >= 0 && tile.x < count && tile.y < count;
}

Result<TileExtent> ExtentOfMbtiles(const std::string& path) {
  ForeignDatabase database(path);
  Result<Statement> format = database.Prepare(
      "SELECT value FROM metadata WHERE name = 'format' AND value IN ('pbf', 'mvt')");
  if (format.ok() && sqlite3_step(format->get()) == SQLITE_ROW) {
    return Error{fmt::format("{} holds vector tiles: raster tiles (PNG, JPEG, WebP) are read",
                             fs::path(path).filename().string())};
  }
  Result<Statement> zooms = database.Prepare("SELECT min(zoom_level), max(zoom_level) FROM tiles");
  if (!zooms.ok()) return Error{zooms.error()};
  if (const int code = sqlite3_step(zooms->get()); code != SQLITE_ROW) {
    return database.Problem(code);
  }
  TileExtent extent = {.min_zoom = sqlite3_column_int(zooms->get(), 0),
                       .max_zoom = sqlite3_column_int(zooms->get(), 1)};
  const bool is_empty = sqlite3_column_type(zooms->get(), 0) == SQLITE_NULL;
  if (is_empty || extent.min_zoom < 0 || extent.max_zoom > TileName::kMaxZoom) {
    return Error{fmt::format("{} has no tiles of zoom 0 to {}", fs::path(path).filename().string(),
                             TileName::kMaxZoom)};
  }
  Result<Statement> box = database.Prepare(
      "SELECT min(tile_column), max(tile_column), min(tile_row), max(tile_row) FROM tiles "
      "WHERE zoom_level = ?");
  if (!box.ok()) return Error{box.error()};
  sqlite3_bind_int(box->get(), 1, extent.min_zoom);
  if (const int code = sqlite3_step(box->get()); code != SQLITE_ROW) return database.Problem(code);
  const int64_t last = (int64_t{1} << extent.min_zoom) - 1;
  const auto in_range = [&](int column) {
    return std::clamp<int64_t>(sqlite3_column_int64(box->get(), column), 0, last);
  };
  extent.left = in_range(0);
  extent.right = in_range(1);
  extent.top = last - in_range(3);  // MBTiles count rows from the South.
  extent.bottom = last - in_range(2);
  return extent;
}

Result<std::optional<std::string>> TileOfMbtiles(const std::string& path, const TileName& tile) {
  SHOAL_CHECK(IsTile(tile), "zoom, column and row are those of a tile");
  ForeignDatabase database(path);
  Result<Statement> found = database.Prepare(
      "SELECT tile_data FROM tiles WHERE zoom_level = ? AND tile_column = ? AND tile_row = ?");
  if (!found.ok()) return Error{found.error()};
  sqlite3_bind_int(found->get(), 1, tile.z);
  sqlite3_bind_int64(found->get(), 2, tile.x);
  sqlite3_bind_int64(found->get(), 3, (int64_t{1} << tile.z) - 1 - tile.y);
  const int code = sqlite3_step(found->get());
  if (code == SQLITE_DONE) return std::optional<std::string>();
  if (code != SQLITE_ROW) return database.Problem(code);
  const void* bytes = sqlite3_column_blob(found->get(), 0);
  const auto size = static_cast<size_t>(sqlite3_column_bytes(found->get(), 0));
  if (size > kMaxTileBytes) return database.Problem(SQLITE_TOOBIG);
  if (bytes == nullptr) return std::optional<std::string>();
  return std::optional(std::string(static_cast<const char*>(bytes), size));
}

Result<TileExtent> ExtentOfTileFolder(const std::string& path) {
  std::optional<TileExtent> extent;
  std::error_code error;
  for (fs::directory_iterator each(path, error), end; !error && each != end;
       each.increment(error)) {
    const auto zoom = NumberIn(each->path().filename().string());
    if (!zoom || *zoom > TileName::kMaxZoom || !each->is_directory(error)) continue;
    const int z = static_cast<int>(*zoom);
    if (!extent) extent = {.min_zoom = z, .max_zoom = z};
    extent->min_zoom = std::min(extent->min_zoom, z);
    extent->max_zoom = std::max(extent->max_zoom, z);
  }
  if (!extent) {
    return Error{fmt::format("{} holds no folders of tiles, as {}/12/1234/1500.png",
                             fs::path(path).parent_path().filename().string(), path)};
  }
  const int64_t last = (int64_t{1} << extent->min_zoom) - 1;
  extent->left = extent->top = last;
  int num_files = 0;
  const fs::path lowest = fs::path(path) / std::to_string(extent->min_zoom);
  for (fs::recursive_directory_iterator each(lowest, error), end;
       !error && each != end && num_files < kMaxFilesCounted; each.increment(error)) {
    const auto x = NumberIn(each->path().parent_path().filename().string());
    const auto y = NumberIn(each->path().stem().string());
    if (each.depth() != 1 || !x || !y || *x > last || *y > last) continue;
    ++num_files;
    extent->left = std::min(extent->left, *x);
    extent->right = std::max(extent->right, *x);
    extent->top = std::min(extent->top, *y);
    extent->bottom = std::max(extent->bottom, *y);
  }
  if (num_files == 0) {
    return Error{
        fmt::format("{} holds no tiles, as {}/1234/1500.png", lowest.string(), lowest.string())};
  }
  return *extent;
}

std::string TileBelow(const std::string& folder, const TileName& tile) {
  SHOAL_CHECK(IsTile(tile), "zoom, column and row are those of a tile");
  for (const std::string_view ending : kEndings) {
    const std::string below = fmt::format("{}/{}/{}{}", tile.z, tile.x, tile.y, ending);
    std::error_code error;
    if (fs::is_regular_file(fs::path(folder) / below, error)) return below;
  }
  return "";
}

}  // namespace shoal
