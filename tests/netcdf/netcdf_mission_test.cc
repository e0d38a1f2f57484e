// Missions whose sea floor and current are NetCDF files of both kinds.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lib/base/geodesy/local_frame.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/file/data_files.h"
#include "lib/mission/file/load.h"
#include "lib/mission/file/ocean_of.h"
#include "tests/netcdf/write_netcdf.h"

namespace shoal::netcdf_mission_test {

constexpr GeoPoint kOrigin = {.lat_deg = 54.2, .lon_deg = 10.2};
constexpr double kHour_s = 3600;

/// Fields that are linear in all coordinates: interpolation reproduces them.
double FloorElevation(double lat_deg, double lon_deg) {
  return -40 - 100 * (lat_deg - 54) + 60 * (lon_deg - 10);
}
double East(double lat_deg, double lon_deg, double depth_m, double hours) {
  return 0.3 + 0.5 * (lat_deg - 54) - 0.25 * (lon_deg - 10) - 0.01 * depth_m + 0.04 * hours;
}
double North(double lat_deg, double lon_deg, double depth_m, double hours) {
  return -0.2 - 0.75 * (lat_deg - 54) + 0.125 * (lon_deg - 10) + 0.02 * depth_m - 0.02 * hours;
}

const std::vector<double> kLats = {54.5, 54.3, 54.25, 54};  // Descending, at uneven steps.
const std::vector<double> kLons = {10, 10.1, 10.4};
const std::vector<double> kDepths = {0.5, 10, 40};
const std::vector<double> kHours = {6, 7, 9};

WrittenVariable Axis(const std::string& name, int dimension, const std::vector<double>& points,
                     const std::string& units) {
  return {.name = name,
          .type = WrittenType::kDouble,
          .dimensions = {dimension},
          .values = points,
          .texts = {{"units", units}}};
}

/// 0: longitudes as they are; 360: the same ones counted on.
WrittenNetcdf FloorFile(double turn_deg) {
  std::vector<double> lons;
  for (const double lon : kLons) lons.push_back(lon + turn_deg);
  WrittenNetcdf file = {.dimensions = {{"lat", kLats.size()}, {"lon", kLons.size()}},
                        .variables = {Axis("lat", 0, kLats, "degrees_north"),
                                      Axis("lon", 1, lons, "degrees_east"),
                                      {.name = "elevation", .dimensions = {0, 1}}}};
  for (const double lat : kLats) {
    for (const double lon : kLons) {
      file.variables[2].values.push_back(FloorElevation(lat, lon));
    }
  }
  return file;
}

/// A component, packed as shorts where `step` > 0.
WrittenVariable Component(const std::string& name, double (*field)(double, double, double, double),
                          double step) {
  WrittenVariable variable = {.name = name, .dimensions = {0, 1, 2, 3}};
  variable.texts = {{"units", "m s-1"}};
  if (step > 0) {
    variable.type = WrittenType::kShort;
    variable.numbers = {{"scale_factor", step}, {"add_offset", 0.125}, {"_FillValue", -32768}};
  }
  for (const double hours : kHours) {
    for (const double depth : kDepths) {
      for (const double lat : kLats) {
        for (const double lon : kLons) {
          const double value = field(lat, lon, depth, hours - kHours.front());
          variable.values.push_back(step > 0 ? std::round((value - 0.125) / step) : value);
        }
      }
    }
  }
  return variable;
}

WrittenNetcdf CurrentFile(double step) {
  return {.dimensions = {{"time", kHours.size()},
                         {"depth", kDepths.size()},
                         {"lat", kLats.size()},
                         {"lon", kLons.size()}},
          .variables = {Axis("time", 0, kHours, "hours since 2026-11-24 00:00:00"),
                        Axis("depth", 1, kDepths, "m"), Axis("lat", 2, kLats, "degrees_north"),
                        Axis("lon", 3, kLons, "degrees_east"), Component("uo", East, step),
                        Component("vo", North, step)}};
}

/// A folder of its own with a mission file.
class NetcdfMissions : public testing::TestWithParam<NetcdfForm> {
 protected:
  NetcdfMissions()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("netcdf_mission_test_" + std::to_string(getpid()) + "_" + FolderName())) {
    std::filesystem::create_directories(folder_ / "sea");
  }
  ~NetcdfMissions() override { std::filesystem::remove_all(folder_); }

  /// Of this test and form alone: a sea that was read is kept, by its path.
  static std::string FolderName() {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ranges::replace(name, '/', '_');
    return name;
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  void Write(const std::string& name, const WrittenNetcdf& content) const {
    WriteNetcdf(Path(name), GetParam(), content);
  }
  /// Loads a mission whose [environment] is this.
  LoadedMission Load(const std::string& environment,
                     const std::string& in_mission = "origin = {lat_deg = 54.2, lon_deg = 10.2}") {
    std::ofstream(Path("m.toml")) << "[mission]\nduration_s = 60\n"
                                  << in_mission << "\n[environment]\n"
                                  << environment << "\n[[vehicle]]\nname = \"alpha\"\n"
                                  << "helm_options = {deploy_at_start = true}\n";
    return LoadMission(Path("m.toml"));
  }
  Ocean Sea(const std::string& environment) {
    const LoadedMission loaded = Load(environment);
    EXPECT_EQ(loaded.errors, std::vector<std::string>{});
    Result<Ocean> ocean = OceanOf(loaded.mission);
    EXPECT_TRUE(ocean.ok()) << ocean.error();
    return ocean.ok() ? *ocean : Ocean{};
  }
  std::string ErrorOf(const std::string& environment,
                      const std::string& in_mission = "origin = {lat_deg = 54.2, lon_deg = 10.2}") {
    const LoadedMission loaded = Load(environment, in_mission);
    if (loaded.errors.empty()) return "no error";
    // Without the folder, which is another one in each run.
    std::string text = loaded.errors.front();
    for (size_t at = text.find(folder_.string()); at != std::string::npos;
         at = text.find(folder_.string())) {
      text.erase(at, folder_.string().size() + 1);
    }
    return text;
  }

  const std::filesystem::path folder_;
};

TEST_P(NetcdfMissions, HaveTheSeaFloorOfTheirLatitudesAndLongitudes) {
  for (const double turn_deg : {0.0, 360.0}) {
    Write("sea/bay.nc", FloorFile(turn_deg));
    const Ocean ocean =
        Sea("floor = {grid = \"sea/bay.nc\", grid_gap_depth_m = " + std::to_string(turn_deg) + "}");
    ASSERT_TRUE(ocean.floor.has_value());
    const LocalFrame frame(kOrigin);
    for (const Eigen::Vector2d& place_m :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(1234, -4321), Eigen::Vector2d(-9000, 15'000)}) {
      const GeoPoint point = frame.ToGeo(place_m);
      EXPECT_NEAR(ocean.floor->DepthAt(place_m), -FloorElevation(point.lat_deg, point.lon_deg),
                  1e-4);
    }
  }
}

TEST_P(NetcdfMissions, HaveTheFloorThatTheFileStatesToBeDepths) {
  WrittenNetcdf file = FloorFile(0);
  for (double& value : file.variables[2].values) value = -value;
  const std::string keys = "floor = {grid = \"sea/bay.nc\"}";
  file.variables[2].texts = {{"positive", "down"}};
  Write("sea/bay.nc", file);
  const double depth_m = -FloorElevation(54.2, 10.2);
  EXPECT_NEAR(Sea(keys).floor->DepthAt({0, 0}), depth_m, 1e-4);
  file.variables[2].texts.clear();
  Write("sea/other.nc", file);
  EXPECT_EQ(Sea("floor = {grid = \"sea/other.nc\"}").floor->DepthAt({0, 0}), 0) << "land";
  EXPECT_NEAR(Sea("floor = {grid = \"sea/other.nc\", grid_is_depth = true}").floor->DepthAt({0, 0}),
              depth_m, 1e-4);
}

TEST_P(NetcdfMissions, LayMapsInMetresByTheirOrigin) {
  WrittenNetcdf file = {
      .dimensions = {{"y", 2}, {"x", 2}},
      .variables = {Axis("y", 0, {6'000'000, 6'001'000}, "m"),
                    Axis("x", 1, {500, 501}, "km"),
                    {.name = "Band1", .dimensions = {0, 1}, .values = {-10, -20, -30, -40}}}};
  Write("sea/utm.nc", file);
  const Ocean ocean = Sea("floor = {grid = \"sea/utm.nc:Band1\", grid_origin = [500250, 6000500]}");
  EXPECT_NEAR(ocean.floor->DepthAt({0, 0}), 22.5, 1e-4);
  EXPECT_NEAR(ocean.floor->DepthAt({250, -500}), 15, 1e-4);
}

TEST_P(NetcdfMissions, HaveTheCurrentOfAnyPlaceDepthAndTime) {
  Write("sea/tide.nc", CurrentFile(0));
  const Ocean ocean = Sea("current = {grid = \"sea/tide.nc\"}");
  const LocalFrame frame(kOrigin);
  for (const Eigen::Vector3d& place_m : {Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(3000, -8000, 25),
                                         Eigen::Vector3d(-10'000, 12'000, 0.5)}) {
    for (const double time_s : {0.0, 1000.0, 9000.0}) {
      const GeoPoint point = frame.ToGeo(place_m.head<2>());
      const Eigen::Vector2d water_mps = ocean.WaterVelocityAt(place_m, time_s);
      const double hours = time_s / kHour_s;
      EXPECT_NEAR(water_mps.x(), East(point.lat_deg, point.lon_deg, place_m.z(), hours), 1e-6);
      EXPECT_NEAR(water_mps.y(), North(point.lat_deg, point.lon_deg, place_m.z(), hours), 1e-6);
    }
  }
}

TEST_P(NetcdfMissions, UnpackShorts) {
  constexpr double kStep = 1e-4;
  Write("sea/tide.nc", CurrentFile(kStep));
  const Ocean ocean = Sea("current = {grid = \"sea/tide.nc\"}");
  EXPECT_NEAR(ocean.WaterVelocityAt({0, 0, 0.5}, 0).x(), East(54.2, 10.2, 0.5, 0),
              kStep / 2 + 1e-6);
}

TEST_P(NetcdfMissions, StartAtTheTimeOfTheGridThatTheyName) {
  Write("sea/tide.nc", CurrentFile(0));
  const auto east_at_start = [&](const std::string& time, const std::string& in_mission) {
    const LoadedMission loaded =
        Load("current = {grid = \"sea/tide.nc\", grid_time = \"" + time + "\"}",
             "origin = {lat_deg = 54.2, lon_deg = 10.2}\n" + in_mission);
    EXPECT_EQ(loaded.errors, std::vector<std::string>{});
    const Result<Ocean> ocean = OceanOf(loaded.mission);
    return ocean.ok() ? ocean->WaterVelocityAt({0, 0, 0.5}, 0).x() : NAN;
  };
  EXPECT_NEAR(east_at_start("first", ""), East(54.2, 10.2, 0.5, 0), 1e-6);
  EXPECT_NEAR(east_at_start("2026-11-24T07:30:00Z", ""), East(54.2, 10.2, 0.5, 1.5), 1e-6);
  // `date -u -d "2026-11-24 08:00" +%s`
  EXPECT_NEAR(east_at_start("absolute", "start_utime = 1795507200000000"), East(54.2, 10.2, 0.5, 2),
              1e-6);
}

TEST_P(NetcdfMissions, TakeComponentsFromTwoFilesToo) {
  WrittenNetcdf file = CurrentFile(0);
  Write("sea/tide.nc", file);
  Write("sea/again.nc", file);
  const std::string keys =
      "current = {grid_east = \"sea/tide.nc:uo\", grid_north = \"sea/again.nc:vo\"}";
  const Eigen::Vector2d water_mps = Sea(keys).WaterVelocityAt({0, 0, 0.5}, 0);
  EXPECT_NEAR(water_mps.x(), East(54.2, 10.2, 0.5, 0), 1e-6);
  EXPECT_NEAR(water_mps.y(), North(54.2, 10.2, 0.5, 0), 1e-6);
  EXPECT_EQ(DataFilesOf(Load(keys).mission),
            (std::vector<std::string>{"sea/tide.nc", "sea/again.nc"}));
}

TEST_P(NetcdfMissions, ListTheFilesThatTheyConsistOf) {
  Write("sea/tide.nc", CurrentFile(0));
  Write("sea/bay.nc", FloorFile(0));
  const std::string keys =
      "current = {grid = \"sea/tide.nc\"}\nfloor = {grid = \"sea/bay.nc:elevation\"}";
  EXPECT_EQ(Load(keys).errors, std::vector<std::string>{});
  const FilesRead files;  // The sea is kept from before.
  const LoadedMission loaded = Load(keys);
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_TRUE(files.paths().contains(Path("sea/tide.nc")));
  EXPECT_TRUE(files.paths().contains(Path("sea/bay.nc")));
  EXPECT_EQ(DataFilesOf(loaded.mission), (std::vector<std::string>{"sea/bay.nc", "sea/tide.nc"}));
}

TEST_P(NetcdfMissions, AreRefusedWhereTheirGridDoesNotFit) {
  Write("sea/tide.nc", CurrentFile(0));
  Write("sea/bay.nc", FloorFile(0));
  const std::string tide = "current = {grid = \"sea/tide.nc\"}";
  EXPECT_EQ(
      ErrorOf(tide, ""),
      "m.toml:5:11: its grid has latitudes and longitudes, and the mission does not state where "
      "it takes place: write in [mission] origin = {lat_deg = ..., lon_deg = ...}");
  EXPECT_EQ(
      ErrorOf(tide, "origin = {lat_deg = 10, lon_deg = 10.2}"),
      "m.toml:6:1: alpha starts at (0, 0), outside of the current's grid sea/tide.nc: start it "
      "inside, move the grid (origin in [mission]), or name a larger one");
  EXPECT_EQ(
      ErrorOf("floor = {grid = \"sea/bay.nc\", grid_origin = [5, 5]}"),
      "m.toml:5:9: sea/bay.nc: variable 'elevation' has latitudes and longitudes, among which "
      "the mission's own origin counts: remove grid_origin");
  EXPECT_EQ(
      ErrorOf("floor = {grid = \"sea/bay.nc:deep\"}"),
      "m.toml:5:9: sea/bay.nc: there is no variable 'deep' in it; name one of these: elevation");
  EXPECT_EQ(
      ErrorOf("floor = {grid = \"sea/none.nc\"}"),
      "m.toml:5:9: sea/none.nc: cannot be read: No such file or directory; a grid's path counts "
      "from the mission file's folder");
}

TEST_P(NetcdfMissions, AreRefusedForValuesThatAreNone) {
  WrittenNetcdf bay = FloorFile(0);
  bay.variables[2].numbers = {{"_FillValue", -9999}};
  bay.variables[2].values[1] = -9999;
  Write("sea/bay.nc", bay);
  EXPECT_EQ(ErrorOf("floor = {grid = \"sea/bay.nc\"}"),
            "m.toml:5:9: sea/bay.nc: variable 'elevation' has no data at latitude 54.5, longitude "
            "10.1; give points without data a depth: grid_gap_depth_m");
  EXPECT_NEAR(Sea("floor = {grid = \"sea/bay.nc\", grid_gap_depth_m = 3}")
                  .floor->DepthAt(*LocalFrame(kOrigin).ToLocal({.lat_deg = 54.5, .lon_deg = 10.1})),
              3, 1e-4);
  WrittenNetcdf tide = CurrentFile(0);
  tide.variables[4].values[2] = 999;
  Write("sea/tide.nc", tide);
  EXPECT_EQ(ErrorOf("current = {grid = \"sea/tide.nc\"}"),
            "m.toml:5:11: sea/tide.nc: variable 'uo' is 999 m/s at latitude 54.5, longitude 10.4, "
            "faster than 50 m/s; is it the mark for no data? Then give the variable a _FillValue");
}

TEST_P(NetcdfMissions, AreWarnedOfTimesAndPlacesWithoutData) {
  WrittenNetcdf tide = CurrentFile(0);
  for (const size_t component : {4, 5}) {
    tide.variables[component].numbers = {{"_FillValue", -9999}};
    for (double& value : tide.variables[component].values) value = -9999;
  }
  Write("sea/tide.nc", tide);
  const LoadedMission loaded =
      Load("current = {grid = \"sea/tide.nc\", grid_time = \"2026-11-24T08:59:30Z\"}");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  ASSERT_EQ(loaded.warnings.size(), 3U) << "the third: alpha has no task";
  const std::string all = loaded.warnings[0] + loaded.warnings[1] + loaded.warnings[2];
  EXPECT_NE(
      all.find("the grid has the current from -10770 to 30 s of the mission, which lasts 60 s"),
      std::string::npos)
      << all;
  EXPECT_NE(all.find("alpha starts at (0, 0), where the current's grid sea/tide.nc has no data at "
                     "any time: the water stands still there"),
            std::string::npos)
      << all;
  EXPECT_EQ(OceanOf(loaded.mission)->WaterVelocityAt({0, 0, 0}, 5), Eigen::Vector2d(0, 0));
}

INSTANTIATE_TEST_SUITE_P(OfBothForms, NetcdfMissions,
                         testing::Values(NetcdfForm::kClassic, NetcdfForm::kHdf5),
                         [](const auto& each) {
                           return each.param == NetcdfForm::kClassic ? "Classic" : "Hdf5";
                         });

}  // namespace shoal::netcdf_mission_test
