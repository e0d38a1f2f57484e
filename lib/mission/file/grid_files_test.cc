#include "lib/mission/file/grid_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lib/mission/file/data_files.h"
#include "lib/mission/file/load.h"
#include "lib/mission/file/ocean_of.h"

namespace shoal::grid_files_test {

TEST(GridName, MayNameAVariableOfANetcdfFile) {
  EXPECT_EQ(SplitGridName("maps/bay.nc:elevation").file, "maps/bay.nc");
  EXPECT_EQ(SplitGridName("maps/bay.nc:elevation").variable, "elevation");
  EXPECT_TRUE(SplitGridName("BAY.NC").is_netcdf);
  EXPECT_EQ(SplitGridName("a:b.nc").file, "a:b.nc");
  EXPECT_FALSE(SplitGridName("bay.asc").is_netcdf);
  EXPECT_EQ(SplitGridName("odd:name.asc").file, "odd:name.asc");
}

TEST(GridTime, IsAWordOrADate) {
  for (const char* time : {"first", "absolute", "2026-11-24T06:00:00Z", "2026-11-24 06:00:00"}) {
    EXPECT_TRUE(IsGridTime(time)) << time;
  }
  for (const char* other : {"", "last", "2026-13-24T06:00:00Z"}) EXPECT_FALSE(IsGridTime(other));
}

/// A folder of its own with two grids of a current and a mission file.
class GridFiles : public testing::Test {
 protected:
  GridFiles()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string("grid_files_test_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_);
    Write("u.asc", Grid("0.1 0.2\n0.3 0.5\n"));
    Write("v.asc", Grid("-1 -1\n-9999 0\n"));
  }
  ~GridFiles() override { std::filesystem::remove_all(folder_); }

  static std::string Grid(const std::string& rows) {
    return "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 100\n" + rows;
  }
  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  LoadedMission Load(const std::string& current, const std::string& start = "x_m = 0") const {
    return LoadMissionText("[mission]\nduration_s = 60\n[environment]\ncurrent = " + current +
                               "\n[[vehicle]]\nname = \"alpha\"\nstart = {" + start +
                               "}\nhelm_options = {deploy_at_start = true}\n",
                           (folder_ / "m.toml").string());
  }
  std::string FirstError(const std::string& current, const std::string& start = "x_m = 0") const {
    const LoadedMission loaded = Load(current, start);
    if (loaded.errors.empty()) return "no error";
    return loaded.errors.front().substr(folder_.string().size() + 1);
  }

  const std::filesystem::path folder_;
};

TEST_F(GridFiles, MakeASteadyCurrentOfTwoEsriGrids) {
  const LoadedMission loaded =
      Load("{grid_east = \"u.asc\", grid_north = \"v.asc\", grid_origin = [100, 0]}");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(loaded.warnings.size(), 1U) << "that alpha has no task, and no other";
  const Result<Ocean> ocean = OceanOf(loaded.mission);
  ASSERT_TRUE(ocean.ok()) << ocean.error();
  EXPECT_FLOAT_EQ(static_cast<float>(ocean->WaterVelocityAt({0, 0, 9}, 1e6).x()), 0.5F);
  EXPECT_EQ(ocean->WaterVelocityAt({-100, 0, 0}, 0), Eigen::Vector2d(0, 0)) << "no data: land";
  EXPECT_NEAR(ocean->WaterVelocityAt({-50, 100, 0}, 0).x(), 0.15, 1e-6);
  EXPECT_NEAR(ocean->WaterVelocityAt({-50, 100, 0}, 0).y(), -1, 1e-6);
  EXPECT_EQ(DataFilesOf(loaded.mission), (std::vector<std::string>{"u.asc", "v.asc"}));
}

TEST_F(GridFiles, ExplainAsAMissionThatLoadsEqual) {
  const LoadedMission loaded =
      Load("{grid_east = \"u.asc\", grid_north = \"v.asc\", grid_time = \"absolute\"}");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  const LoadedMission again =
      LoadMissionText(Explain(loaded.mission), (folder_ / "m.toml").string());
  ASSERT_EQ(again.errors, std::vector<std::string>{});
  EXPECT_TRUE(again.mission == loaded.mission) << Explain(again.mission);
}

TEST_F(GridFiles, AreRefusedWhereTheKeysDoNotFitTogether) {
  EXPECT_EQ(
      FirstError("{grid_east = \"u.asc\"}"),
      "m.toml:4:24: a current needs both components: write grid_east and grid_north, or grid = "
      "\"tide.nc\", a NetCDF file with both");
  EXPECT_EQ(
      FirstError("{grid = \"u.asc\"}"),
      "m.toml:4:19: grid is a NetCDF file with both components, tide.nc; of ESRI ASCII files, "
      "and to name variables (tide.nc:u), write grid_east and grid_north");
  EXPECT_EQ(
      FirstError("{grid_east = \"u.nc\", grid_north = \"v.asc\"}"),
      "m.toml:4:24: grid_east and grid_north are two ESRI ASCII files (.asc), or a NetCDF file "
      "each with its variable, like \"tide.nc:u\" and \"tide.nc:v\"");
  EXPECT_EQ(FirstError("{grid_east = \"u.asc\", grid_north = \"v.asc\", grid_time = \"noon\"}"),
            "m.toml:4:24: grid_time is \"first\", \"absolute\", or a date like "
            "\"2026-11-24T06:00:00Z\"");
  EXPECT_EQ(
      FirstError("{grid_east = \"u.asc\", grid_north = \"v.asc\", speed_mps = 1}"),
      "m.toml:4:67: speed_mps has no effect beside a grid, which is the whole current: remove "
      "one of them");
}

TEST_F(GridFiles, AreRefusedWhereAVehicleStartsOutside) {
  const std::string current = "{grid_east = \"u.asc\", grid_north = \"v.asc\"}";
  EXPECT_EQ(FirstError(current, "x_m = 149, y_m = -49"), "no error");
  EXPECT_EQ(FirstError(current, "x_m = 151"),
            "m.toml:7:9: alpha starts at (151, 0), outside of the current's grid u.asc: start it "
            "inside, move the grid (grid_origin), or name a larger one");
}

TEST_F(GridFiles, AreRefusedWhereTheyAreDamagedOrOfOtherPoints) {
  Write("v.asc", "ncols 1\nnrows 1\nxllcenter 0\nyllcenter 0\ncellsize 100\n0\n");
  const std::string current = "{grid_east = \"u.asc\", grid_north = \"v.asc\"}";
  EXPECT_EQ(
      FirstError(current),
      "m.toml:4:11: u.asc and v.asc are on different points; both components must be known at "
      "the same places, depths and times: interpolate one to the other's, for example with cdo "
      "remapbil");
  Write("v.asc", Grid("0 0\n0 zero\n"));
  EXPECT_NE(FirstError(current).find("v.asc:7: 'zero' is not a number"), std::string::npos)
      << FirstError(current);
}

/// A floor of ESRI ASCII, as shoal check sees it.
class FloorFiles : public GridFiles {
 protected:
  /// Returns what is reported of the floor: an error, or else the warning, or nothing.
  std::string Report(const std::string& rows, const std::string& keys = "") {
    // Of another name each time: a sea that was read is kept, by its path.
    const std::string name = "floor" + std::to_string(++count_) + ".asc";
    Write(name, Grid(rows));
    loaded_ = LoadMissionText("[mission]\nduration_s = 60\n[environment]\nfloor = {grid = \"" +
                                  name + "\"" + keys + "}\n[[vehicle]]\nname = \"alpha\"\n",
                              (folder_ / "m.toml").string());
    for (const auto* texts : {&loaded_.errors, &loaded_.warnings}) {
      for (const std::string& text : *texts) {
        if (text.find("m.toml:4:") != std::string::npos) return text;
      }
    }
    return "";
  }
  double Depth() const {
    const Result<Ocean> ocean = OceanOf(loaded_.mission);
    return ocean.ok() && ocean->floor ? ocean->floor->DepthAt({0, 0}) : -1;
  }

  int count_ = 0;
  LoadedMission loaded_;
};

TEST_F(FloorFiles, AreRefusedWhereNoPointLiesBelowTheSurface) {
  const std::string depths = "50 50\n50 50\n";
  EXPECT_NE(Report(depths).find(
                "the map has none of its 4 points below the surface where its numbers are "
                "elevations, negative below it: write grid_is_depth = true to read them as depths"),
            std::string::npos);
  EXPECT_EQ(Report(depths, ", grid_is_depth = true"), "");
  EXPECT_EQ(Depth(), 50);
  const std::string elevations = "-50 -50\n-50 -50\n";
  EXPECT_NE(Report(elevations, ", grid_is_depth = true").find("write grid_is_depth = false"),
            std::string::npos);
  EXPECT_EQ(Report(elevations), "");
  EXPECT_EQ(Depth(), 50);
  EXPECT_NE(Report("0 0\n0 0\n").find("is it the right map?"), std::string::npos);
  EXPECT_NE(Report("-9999 nan\nnan nan\n", ", grid_gap_depth_m = 5").find("has no data"),
            std::string::npos);
}

TEST_F(FloorFiles, AreRefusedInDegreesWhereTheMissionLiesAmongThese) {
  const auto error = [&](double west, double south, double cell, double lat_deg, double lon_deg) {
    const int rows = cell > 30 ? 5 : 10;
    std::string text = "ncols 10\nnrows " + std::to_string(rows) + "\nxllcorner " +
                       std::to_string(west) + "\nyllcorner " + std::to_string(south) +
                       "\ncellsize " + std::to_string(cell) + "\n";
    for (int i = 0; i < 10 * rows; ++i) text += "-20 ";
    Write("bay.asc", text);
    const auto floor = ReadFloorGrid(
        {.style = "grid", .grid = "bay.asc"},
        {.folder = folder_.string(), .origin_lat_deg = lat_deg, .origin_lon_deg = lon_deg});
    return floor.ok() ? "" : floor.error();
  };
  EXPECT_NE(error(0, 55, 1, 60, 5).find("which are longitudes and latitudes"), std::string::npos);
  EXPECT_NE(error(350, 55, 1, 60, -5).find("project it"), std::string::npos);
  EXPECT_NE(error(-180, -90, 36, 0, 0).find("project it"), std::string::npos) << "the whole Earth";
  EXPECT_EQ(error(-5, -5, 1, 1, 2), "") << "a tank around the mission's own origin";
  EXPECT_EQ(error(0, 55, 1, 30, 5), "") << "the mission is elsewhere";
  EXPECT_EQ(error(-500, -500, 100, 60, 5), "") << "metres";
}

TEST_F(FloorFiles, AreWarnedOfTheirLandWithItsShare) {
  const std::string report = Report("-5 -5\n-5 2\n");
  EXPECT_NE(report.find("25 % of the points of "), std::string::npos) << report;
  EXPECT_NE(report.find("if they are not, write grid_is_depth = true"), std::string::npos);
  EXPECT_EQ(loaded_.errors, std::vector<std::string>{});
}

TEST_F(FloorFiles, OfHardlyAnyWaterAreReadOnlyWhereTheMissionStatesWhatTheyHold) {
  const auto write = [&](int num_wet) {
    std::string text = "ncols 20\nnrows 20\nxllcenter 0\nyllcenter 0\ncellsize 100\n";
    for (int i = 0; i < 400; ++i) text += i < 400 - num_wet ? "30\n" : "-7\n";
    Write("hills.asc", text);
  };
  const auto error = [&](const std::string& keys) {
    const auto floor =
        ReadFloorGrid({.style = "grid",
                       .grid = "hills.asc",
                       .grid_is_depth = keys.empty() ? std::nullopt : std::optional(false)},
                      {.folder = folder_.string()});
    return floor.ok() ? "" : floor.error();
  };
  write(3);
  EXPECT_NE(error("").find("has no more than 3 of its 400 points below the surface"),
            std::string::npos)
      << error("");
  EXPECT_EQ(error("stated"), "");
  write(4);
  EXPECT_EQ(error(""), "");
}

TEST_F(FloorFiles, ExplainWhatTheirNumbersAreAsTheMissionStatesIt) {
  for (const char* keys : {"", ", grid_is_depth = false", ", grid_is_depth = true"}) {
    EXPECT_NE(Report("-5 5\n-5 5\n", keys), "") << "half of it is land";
    const LoadedMission again =
        LoadMissionText(Explain(loaded_.mission), (folder_ / "m.toml").string());
    EXPECT_TRUE(again.mission == loaded_.mission) << keys;
  }
}

}  // namespace shoal::grid_files_test
