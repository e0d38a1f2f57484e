#include "lib/tools/tiles/tile_files.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace shoal::tile_files_test {

namespace fs = std::filesystem;

class Tiles : public testing::Test {
 protected:
  Tiles() { fs::create_directories(folder_); }
  ~Tiles() override { fs::remove_all(folder_); }

  /// Returns the path of a database that these statements have made.
  std::string DatabaseOf(const std::string& sql) const {
    const std::string path = (folder_ / "made.mbtiles").string();
    fs::remove(path);
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
    return path;
  }

  const fs::path folder_ = testing::TempDir() + "tiles-" + std::to_string(getpid());
};

constexpr const char* kTable =
    "CREATE TABLE metadata (name TEXT, value TEXT);"
    "CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, "
    "tile_data BLOB);";

TEST_F(Tiles, OfADatabaseAreCountedFromTheNorth) {
  const std::string path = DatabaseOf(std::string(kTable) +
                                      "INSERT INTO tiles VALUES (2, 1, 0, x'4142'), "
                                      "(2, 2, 1, x'43'), (3, 3, 3, x'44')");
  const Result<TileExtent> extent = ExtentOfMbtiles(path);
  ASSERT_TRUE(extent.ok()) << extent.error();
  EXPECT_EQ(extent->min_zoom, 2);
  EXPECT_EQ(extent->max_zoom, 3);
  EXPECT_EQ(extent->left, 1);
  EXPECT_EQ(extent->right, 2);
  EXPECT_EQ(extent->top, 2);
  EXPECT_EQ(extent->bottom, 3);
  EXPECT_EQ(**TileOfMbtiles(path, {.z = 2, .x = 1, .y = 3}), "AB");
  EXPECT_FALSE(TileOfMbtiles(path, {.z = 2, .x = 1, .y = 0})->has_value());
}

TEST_F(Tiles, OfAViewAreRead) {
  const std::string path = DatabaseOf(
      "CREATE TABLE map (z, x, y, id); CREATE TABLE images (id, data);"
      "INSERT INTO map VALUES (1, 0, 0, 'a'); INSERT INTO images VALUES ('a', x'45');"
      "CREATE VIEW tiles AS SELECT map.z AS zoom_level, map.x AS tile_column, "
      "map.y AS tile_row, images.data AS tile_data FROM map JOIN images USING (id)");
  EXPECT_EQ(ExtentOfMbtiles(path)->max_zoom, 1);
  EXPECT_EQ(**TileOfMbtiles(path, {.z = 1, .x = 0, .y = 1}), "E");
}

TEST_F(Tiles, OfHostileDatabasesAreRefusedWithTheReason) {
  const std::string endless = DatabaseOf(
      "CREATE VIEW tiles AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
      "SELECT i + 5 AS zoom_level, 0 AS tile_column, 0 AS tile_row, x'00' AS tile_data FROM n");
  EXPECT_NE(ExtentOfMbtiles(endless).error().find("does not come to an end"), std::string::npos);
  EXPECT_NE(TileOfMbtiles(endless, {.z = 1, .y = 1}).error().find("made.mbtiles"),
            std::string::npos);
  const std::string huge =
      DatabaseOf(std::string(kTable) + "INSERT INTO tiles VALUES (0, 0, 0, zeroblob(5000000))");
  EXPECT_NE(TileOfMbtiles(huge, {}).error().find("larger than 4 MB"), std::string::npos);
  for (const char* values : {"(99, 0, 0, x'00')", "(-1, 0, 0, x'00')"}) {
    EXPECT_FALSE(
        ExtentOfMbtiles(DatabaseOf(std::string(kTable) + "INSERT INTO tiles VALUES " + values))
            .ok());
  }
  EXPECT_FALSE(ExtentOfMbtiles(DatabaseOf(kTable)).ok()) << "it has no tile";
  const std::string vectors = DatabaseOf(std::string(kTable) +
                                         "INSERT INTO metadata VALUES ('format', 'pbf');"
                                         "INSERT INTO tiles VALUES (0, 0, 0, x'00')");
  EXPECT_NE(ExtentOfMbtiles(vectors).error().find("vector tiles"), std::string::npos);
  EXPECT_FALSE(ExtentOfMbtiles(DatabaseOf("CREATE TABLE other (x)")).ok());
  EXPECT_FALSE(ExtentOfMbtiles((folder_ / "missing.mbtiles").string()).ok());
}

TEST_F(Tiles, OfACutDatabaseAreRefusedAndNeverCrash) {
  std::string rows;
  for (int i = 0; i < 60; ++i) {
    rows += "INSERT INTO tiles VALUES (7, " + std::to_string(i) + ", 0, zeroblob(3000));";
  }
  const std::string path = DatabaseOf(std::string(kTable) + rows);
  const auto size = fs::file_size(path);
  int num_refused = 0;
  for (uintmax_t part = 0; part < size; part += 2'500) {
    const std::string cut = (folder_ / "cut.mbtiles").string();
    fs::copy_file(path, cut, fs::copy_options::overwrite_existing);
    fs::resize_file(cut, part);
    const auto tile = TileOfMbtiles(cut, {.z = 7, .x = 59, .y = 127});
    num_refused += tile.ok() ? 0 : 1;
    if (!tile.ok()) continue;
    EXPECT_EQ(tile->value_or(std::string(3'000, ' ')).size(), 3'000u);
  }
  EXPECT_GT(num_refused, 10);
}

TEST_F(Tiles, OfAFolderAreFoundByTheirNumbers) {
  fs::create_directories(folder_ / "map/4/5");
  fs::create_directories(folder_ / "map/6/20");
  std::ofstream(folder_ / "map/4/5/6.png") << "A";
  std::ofstream(folder_ / "map/4/5/7.jpg") << "B";
  std::ofstream(folder_ / "map/4/5/99.png") << "of no tile";
  std::ofstream(folder_ / "map/readme.txt") << "C";
  const std::string folder = (folder_ / "map").string();
  const Result<TileExtent> extent = ExtentOfTileFolder(folder);
  ASSERT_TRUE(extent.ok()) << extent.error();
  EXPECT_EQ(extent->min_zoom, 4);
  EXPECT_EQ(extent->max_zoom, 6);
  EXPECT_EQ(extent->left, 5);
  EXPECT_EQ(extent->right, 5);
  EXPECT_EQ(extent->top, 6);
  EXPECT_EQ(extent->bottom, 7);
  EXPECT_EQ(TileBelow(folder, {.z = 4, .x = 5, .y = 7}), "4/5/7.jpg");
  EXPECT_EQ(TileBelow(folder, {.z = 4, .x = 5, .y = 8}), "");
  EXPECT_FALSE(ExtentOfTileFolder((folder_ / "nowhere").string()).ok());
  EXPECT_FALSE(ExtentOfTileFolder(folder_.string()).ok());
}

TEST(TileName, HasAsManyColumnsAndRowsAsItsZoomAllows) {
  EXPECT_TRUE(IsTile({.z = 0, .x = 0, .y = 0}));
  EXPECT_TRUE(IsTile({.z = 24, .x = (1 << 24) - 1, .y = 0}));
  for (const TileName tile : {TileName{.z = 0, .x = 1}, TileName{.z = 25}, TileName{.z = -1},
                              TileName{.z = 3, .x = 0, .y = 8}, TileName{.z = 3, .x = -1}}) {
    EXPECT_FALSE(IsTile(tile));
  }
}

}  // namespace shoal::tile_files_test
