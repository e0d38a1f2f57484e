// Missions whose sea floor and current are NetCDF files of both kinds.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <utility>
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
  EXPECT_EQ(ErrorOf("floor = {grid = \"sea/other.nc\"}"),
            "m.toml:5:9: sea/other.nc: variable 'elevation' has none of its 12 points below the "
            "surface where its numbers are elevations, negative below it: write grid_is_depth = "
            "true to read them as depths, positive below it");
  EXPECT_NEAR(Sea("floor = {grid = \"sea/other.nc\", grid_is_depth = true}").floor->DepthAt({0, 0}),
              depth_m, 1e-4);
}

/// A map of 50 m everywhere, or of these numbers.
WrittenNetcdf FlatFile(const std::string& name, const std::map<std::string, std::string>& texts,
                       std::vector<double> values = std::vector<double>(9, 50)) {
  return {.dimensions = {{"lat", 3}, {"lon", 3}},
          .variables = {
              Axis("lat", 0, {54.1, 54.2, 54.3}, "degrees_north"),
              Axis("lon", 1, {10.1, 10.2, 10.3}, "degrees_east"),
              {.name = name, .dimensions = {0, 1}, .values = std::move(values), .texts = texts}}};
}

/// Returns what `shoal check` warns of in [environment].
std::vector<std::string> SeaWarnings(const LoadedMission& loaded) {
  std::vector<std::string> warnings;
  for (const std::string& warning : loaded.warnings) {
    if (warning.find("m.toml:5:") != std::string::npos) warnings.push_back(warning);
  }
  return warnings;
}

TEST_P(NetcdfMissions, HaveTheDepthsOfEveryAliasOfTheirStandardName) {
  for (const char* name :
       {"sea_floor_depth_below_sea_level", "sea_floor_depth_below_mean_sea_level",
        "sea_floor_depth_below_geoid", "sea_floor_depth_below_geopotential_datum",
        "sea_floor_depth_below_reference_ellipsoid", "sea_floor_depth"}) {
    const std::string file = std::string("sea/") + name + ".nc";
    Write(file, FlatFile("h", {{"standard_name", name}, {"units", "meters"}}));
    const std::string keys = "floor = {grid = \"" + file + "\"}";
    EXPECT_EQ(Sea(keys).floor->DepthAt({0, 0}), 50) << name;
    EXPECT_EQ(SeaWarnings(Load(keys)).size(),
              std::string(name).ends_with("reference_ellipsoid") ? 1U : 0U)
        << name;
  }
}

TEST_P(NetcdfMissions, HaveTheDepthsThatTheirNameAndTheirSignsShow) {
  for (const char* name : {"depth", "deptho", "bathymetry", "h", "Depth"}) {
    const std::string file = std::string("sea/named_") + name + ".nc";
    Write(file, FlatFile(name, {{"units", "m"}}));
    const std::string keys = "floor = {grid = \"" + file + "\"";
    EXPECT_EQ(Sea(keys + "}").floor->DepthAt({0, 0}), 50) << name;
    ASSERT_EQ(SeaWarnings(Load(keys + "}")).size(), 1U) << name;
    EXPECT_NE(SeaWarnings(Load(keys + "}"))[0].find("write grid_is_depth = true if they are"),
              std::string::npos);
    EXPECT_TRUE(SeaWarnings(Load(keys + ", grid_is_depth = true}")).empty()) << name;
    EXPECT_NE(ErrorOf(keys + ", grid_is_depth = false}").find("write grid_is_depth = true"),
              std::string::npos);
  }
  Write("sea/elevations.nc", FlatFile("depth", {}, std::vector<double>(9, -30)));
  EXPECT_EQ(Sea("floor = {grid = \"sea/elevations.nc\"}").floor->DepthAt({0, 0}), 30)
      << "elevations, whatever they are called";
}

TEST_P(NetcdfMissions, AreRefusedWhereTheAttributesOfTheirFloorMakeItLand) {
  const std::vector<double> negative(9, -50);
  Write("sea/down.nc", FlatFile("z", {{"positive", "down"}}, negative));
  EXPECT_EQ(ErrorOf("floor = {grid = \"sea/down.nc\"}"),
            "m.toml:5:9: sea/down.nc: variable 'z' has none of its 9 points below the surface "
            "where its numbers are depths, positive below it, as by its attribute positive = "
            "'down': write grid_is_depth = false to read them as elevations, negative below it");
  EXPECT_EQ(Sea("floor = {grid = \"sea/down.nc\", grid_is_depth = false}").floor->DepthAt({0, 0}),
            50);
  Write("sea/up.nc", FlatFile("z", {{"standard_name", "altitude"}}));
  EXPECT_NE(ErrorOf("floor = {grid = \"sea/up.nc\"}").find("write grid_is_depth = true"),
            std::string::npos);
  EXPECT_EQ(Sea("floor = {grid = \"sea/up.nc\", grid_is_depth = true}").floor->DepthAt({0, 0}), 50);
  Write("sea/zero.nc", FlatFile("z", {}, std::vector<double>(9, 0)));
  EXPECT_NE(ErrorOf("floor = {grid = \"sea/zero.nc\"}").find("is it the right map?"),
            std::string::npos);
  WrittenNetcdf gaps = FlatFile("z", {}, std::vector<double>(9, -99));
  gaps.variables[2].numbers = {{"_FillValue", -99}};
  Write("sea/gaps.nc", gaps);
  EXPECT_NE(ErrorOf("floor = {grid = \"sea/gaps.nc\", grid_gap_depth_m = 0}")
                .find("has no data at any point"),
            std::string::npos);
}

TEST_P(NetcdfMissions, KeepWhatAFileStatesAndWarnOfAKeyAgainstIt) {
  Write("sea/bay.nc", FlatFile("h", {{"positive", "down"}}));
  const std::string keys = "floor = {grid = \"sea/bay.nc\", grid_is_depth = false}";
  EXPECT_EQ(Sea(keys).floor->DepthAt({0, 0}), 50);
  ASSERT_EQ(SeaWarnings(Load(keys)).size(), 1U);
  EXPECT_NE(SeaWarnings(Load(keys))[0].find("grid_is_depth = false has no effect"),
            std::string::npos);
}

TEST_P(NetcdfMissions, AreWarnedOfTheShareOfLand) {
  Write("sea/bay.nc", FlatFile("elevation", {}, {-5, -5, -5, -5, -5, -5, 0, 3, 4}));
  const std::vector<std::string> warnings = SeaWarnings(Load("floor = {grid = \"sea/bay.nc\"}"));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("33 % of the points of "), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("if they are not, write grid_is_depth = true"), std::string::npos);
}

TEST_P(NetcdfMissions, TakeMarksOfNoDataThatAFileDoesNotName) {
  const auto keys = [&](const std::string& name, const std::string& more = "") {
    return "floor = {grid = \"sea/" + name + "\"" + more + "}";
  };
  Write("sea/hole.nc", FlatFile("elevation", {}, {-50, -50, -50, -50, -9999, -50, -50, -50, -50}));
  EXPECT_NE(ErrorOf(keys("hole.nc")).find("has no data at latitude 54.2, longitude 10.2 (such"),
            std::string::npos)
      << ErrorOf(keys("hole.nc"));
  const std::string filled = keys("hole.nc", ", grid_gap_depth_m = 40");
  EXPECT_NEAR(Sea(filled).floor->DepthAt({0, 0}), 40, 1e-4);
  ASSERT_EQ(SeaWarnings(Load(filled)).size(), 1U);
  EXPECT_NE(SeaWarnings(Load(filled))[0].find("has the number -9999, and none near it"),
            std::string::npos);
  Write("sea/trench.nc",
        FlatFile("elevation", {}, {-9500, -50, -50, -50, -9999, -50, -50, -50, -50}));
  EXPECT_NEAR(Sea(keys("trench.nc")).floor->DepthAt({0, 0}), 9999, 1e-3);
}

TEST_P(NetcdfMissions, ReadNamedDepthsWithLandAsDepthsAndAskWhereTheLandIsTheLargerPart) {
  Write("sea/coast.nc", FlatFile("depth", {}, {50, 50, 50, 50, 50, 50, -5, -5, -5}));
  EXPECT_NEAR(Sea("floor = {grid = \"sea/coast.nc\"}").floor->DepthAt({0, 0}), 50, 1e-4);
  const std::vector<std::string> warnings = SeaWarnings(Load("floor = {grid = \"sea/coast.nc\"}"));
  ASSERT_EQ(warnings.size(), 2U) << "how it is read, and its land";
  Write("sea/hills.nc", FlatFile("depth", {}, {50, 50, 50, -5, -5, -5, -5, -5, -5}));
  EXPECT_NE(ErrorOf("floor = {grid = \"sea/hills.nc\"}")
                .find("67 % of its points are negative: write grid_is_depth = true"),
            std::string::npos)
      << ErrorOf("floor = {grid = \"sea/hills.nc\"}");
  EXPECT_NEAR(
      Sea("floor = {grid = \"sea/hills.nc\", grid_is_depth = false}").floor->DepthAt({0, 0}), 5,
      1e-4);
  Write("sea/zos.nc", FlatFile("zos", {{"standard_name", "sea_surface_height_above_geoid"}},
                               std::vector<double>(9, -0.5)));
  EXPECT_NE(ErrorOf("floor = {grid = \"sea/zos.nc\"}").find("which variable is the sea floor"),
            std::string::npos);
  EXPECT_NE(ErrorOf("floor = {grid = \"sea/zos.nc:zos\"}").find("is not a sea floor"),
            std::string::npos);
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
      const Eigen::Vector2d expected_mps =
          frame.TurnToPlane({East(point.lat_deg, point.lon_deg, place_m.z(), hours),
                             North(point.lat_deg, point.lon_deg, place_m.z(), hours)},
                            point);
      EXPECT_NEAR(water_mps.x(), expected_mps.x(), 1e-6);
      EXPECT_NEAR(water_mps.y(), expected_mps.y(), 1e-6);
    }
  }
}

/// A grid around 75 degrees North, 0 degrees East, with the same components everywhere.
WrittenNetcdf ArcticFile(double east_mps, double north_mps) {
  std::vector<double> lats;
  std::vector<double> lons;
  for (int i = -10; i <= 10; ++i) {
    lats.push_back(75 + 0.5 * i);
    lons.push_back(i);
  }
  WrittenNetcdf file = {
      .dimensions = {{"lat", lats.size()}, {"lon", lons.size()}},
      .variables = {Axis("lat", 0, lats, "degrees_north"), Axis("lon", 1, lons, "degrees_east")}};
  const size_t count = lats.size() * lons.size();
  file.variables.push_back(
      {.name = "uo", .dimensions = {0, 1}, .values = std::vector<double>(count, east_mps)});
  file.variables.push_back(
      {.name = "vo", .dimensions = {0, 1}, .values = std::vector<double>(count, north_mps)});
  return file;
}

TEST_P(NetcdfMissions, DriftToTheNorthOfThePlaceNotToThatOfTheOrigin) {
  const std::string at_origin = "origin = {lat_deg = 75, lon_deg = 0}";
  const LocalFrame frame({.lat_deg = 75, .lon_deg = 0});
  Write("sea/arctic.nc", ArcticFile(0, 1));
  // The same water by the points of a curvilinear grid.
  WrittenNetcdf mesh = ArcticFile(0, 1);
  WrittenNetcdf plain = ArcticFile(0, 1);
  mesh.dimensions = {{"y", 21}, {"x", 21}};
  for (const size_t axis : {0, 1}) {
    mesh.variables[axis].dimensions = {0, 1};
    mesh.variables[axis].values.clear();
    for (size_t i = 0; i < 21 * 21; ++i) {
      mesh.variables[axis].values.push_back(
          plain.variables[axis].values[axis == 0 ? i / 21 : i % 21]);
    }
  }
  mesh.variables[2].texts["standard_name"] = "eastward_sea_water_velocity";
  mesh.variables[3].texts["standard_name"] = "northward_sea_water_velocity";
  Write("sea/mesh.nc", mesh);
  mesh.variables[2].texts["standard_name"] = "sea_water_x_velocity";
  mesh.variables[3].texts["standard_name"] = "sea_water_y_velocity";
  Write("sea/along.nc", mesh);
  for (const char* name : {"sea/arctic.nc", "sea/mesh.nc", "sea/along.nc"}) {
    const LoadedMission loaded =
        Load(std::string("current = {grid = \"") + name + "\"}", at_origin);
    ASSERT_EQ(loaded.errors, std::vector<std::string>{});
    const Result<Ocean> ocean = OceanOf(loaded.mission);
    ASSERT_TRUE(ocean.ok()) << ocean.error();
    for (const Eigen::Vector2d& place_m :
         {Eigen::Vector2d(0, 20'000), Eigen::Vector2d(150'000, 0), Eigen::Vector2d(-90'000, 9e4)}) {
      const GeoPoint point = frame.ToGeo(place_m);
      const Eigen::Vector2d north =
          (*frame.ToLocal({.lat_deg = point.lat_deg + 1e-4, .lon_deg = point.lon_deg}) - place_m)
              .normalized();
      const Eigen::Vector2d flow_mps = ocean->WaterVelocityAt({place_m.x(), place_m.y(), 0}, 0);
      // A plane that touches the Earth bends directions by up to 1e-4 there.
      EXPECT_NEAR(flow_mps.x(), north.x(), 3e-4) << name << place_m.transpose();
      EXPECT_NEAR(flow_mps.y(), north.y(), 3e-4) << name << place_m.transpose();
    }
    EXPECT_NEAR(ocean->WaterVelocityAt({0, 0, 0}, 0).y(), 1, 1e-4);
  }
}

TEST_P(NetcdfMissions, DriftThroughThePoleInOneDirection) {
  std::vector<double> lons;
  for (int i = 0; i < 36; ++i) lons.push_back(10 * i);
  WrittenNetcdf file = {.dimensions = {{"lat", 3}, {"lon", 36}},
                        .variables = {Axis("lat", 0, {88, 89, 90}, "degrees_north"),
                                      Axis("lon", 1, lons, "degrees_east"),
                                      {.name = "uo", .dimensions = {0, 1}},
                                      {.name = "vo", .dimensions = {0, 1}}}};
  for (int row = 0; row < 3; ++row) {
    for (const double lon : lons) {
      // Along the meridian of 0 degrees toward the pole, and on beyond it.
      file.variables[2].values.push_back(std::sin(lon * M_PI / 180));
      file.variables[3].values.push_back(std::cos(lon * M_PI / 180));
    }
  }
  Write("sea/pole.nc", file);
  const LoadedMission loaded =
      Load("current = {grid = \"sea/pole.nc\"}", "origin = {lat_deg = 89.9, lon_deg = 0}");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  const Result<Ocean> ocean = OceanOf(loaded.mission);
  ASSERT_TRUE(ocean.ok()) << ocean.error();
  for (const Eigen::Vector2d& place_m :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 22'000), Eigen::Vector2d(15'000, 11'000)}) {
    const Eigen::Vector2d flow_mps = ocean->WaterVelocityAt({place_m.x(), place_m.y(), 0}, 0);
    EXPECT_NEAR(flow_mps.x(), 0, 5e-3) << place_m.transpose();
    EXPECT_NEAR(flow_mps.y(), 1, 5e-3) << place_m.transpose();
  }
}

/// A current of two depths: 0.5 m/s at the surface, 0.1 m/s at 10 m.
WrittenNetcdf TwoDepths(const std::vector<double>& depths, const std::string& positive) {
  WrittenNetcdf file = {
      .dimensions = {{"depth", 2}, {"lat", 2}, {"lon", 2}},
      .variables = {Axis("depth", 0, depths, "m"), Axis("lat", 1, {54.1, 54.3}, "degrees_north"),
                    Axis("lon", 2, {10.1, 10.3}, "degrees_east")}};
  file.variables[0].texts["positive"] = positive;
  file.variables.push_back(
      {.name = "uo", .dimensions = {0, 1, 2}, .values = {0.5, 0.5, 0.5, 0.5, 0.1, 0.1, 0.1, 0.1}});
  file.variables.push_back(
      {.name = "vo", .dimensions = {0, 1, 2}, .values = std::vector<double>(8, 0)});
  return file;
}

TEST_P(NetcdfMissions, AreRefusedWhereTheirCurrentHasASinglePointAlongAnAxis) {
  WrittenNetcdf file = TwoDepths({0, 10}, "down");
  file.dimensions[1].second = 1;
  file.variables[1].values = {10};
  for (const size_t component : {3, 4}) file.variables[component].values.resize(4);
  Write("sea/row.nc", file);
  EXPECT_NE(ErrorOf("current = {grid = \"sea/row.nc\"}").find("has a single point along one of"),
            std::string::npos);
}

TEST_P(NetcdfMissions, TakePackedMarksOfNoDataForLandAndNameTheComponent) {
  WrittenNetcdf file = TwoDepths({0, 10}, "down");
  for (const size_t component : {3, 4}) {
    file.variables[component].type = WrittenType::kShort;
    file.variables[component].numbers = {{"scale_factor", 0.001}};
    for (double& value : file.variables[component].values) value *= 1000;
  }
  file.variables[4].values[2] = 9999;  // 9.999 m/s.
  file.variables[4].values[3] = 9999;
  Write("sea/packed.nc", file);
  const std::string keys = "current = {grid = \"sea/packed.nc\"}";
  const LocalFrame frame(kOrigin);
  const Eigen::Vector2d north_m = *frame.ToLocal({.lat_deg = 54.3, .lon_deg = 10.2});
  EXPECT_NEAR(Sea(keys).WaterVelocityAt({north_m.x(), north_m.y(), 0}, 0).norm(), 0, 1e-6);
  ASSERT_EQ(SeaWarnings(Load(keys)).size(), 1U);
  EXPECT_NE(SeaWarnings(Load(keys))[0].find("variable 'vo' has the number 9.999, and none near it"),
            std::string::npos)
      << SeaWarnings(Load(keys))[0];
  file.variables[4].texts["standard_name"] = "northward_wind";
  Write("sea/wind.nc", file);
  EXPECT_NE(ErrorOf("current = {grid_east = \"sea/wind.nc:uo\", grid_north = \"sea/wind.nc:vo\"}")
                .find("is not a current: its standard_name is northward_wind"),
            std::string::npos);
}

TEST_P(NetcdfMissions, KeepTheTypeOfBounds) {
  WrittenNetcdf file = TwoDepths({0, 10}, "down");
  for (const size_t component : {3, 4}) {
    file.variables[component].type = WrittenType::kShort;
    file.variables[component].numbers = {
        {"scale_factor", 0.001}, {"valid_min", -2}, {"valid_max", 2}};
    for (double& value : file.variables[component].values) value *= 1000;
  }
  Write("sea/packed.nc", file);
  EXPECT_NEAR(Sea("current = {grid = \"sea/packed.nc\"}").WaterVelocityAt({0, 0, 0}, 0).x(), 0.5,
              1e-6);
}

TEST_P(NetcdfMissions, HaveTheWaterOfTheirDepthWhereTheAxisIsUpsideDown) {
  const std::string keys = "current = {grid = \"sea/tide.nc\"}";
  Write("sea/tide.nc", TwoDepths({0, -10}, "down"));
  EXPECT_NEAR(Sea(keys).WaterVelocityAt({0, 0, 10}, 0).x(), 0.1, 1e-6);
  EXPECT_NEAR(Sea(keys).WaterVelocityAt({0, 0, 0}, 0).x(), 0.5, 1e-6);
  ASSERT_EQ(SeaWarnings(Load(keys)).size(), 1U);
  EXPECT_NE(SeaWarnings(Load(keys))[0].find("above the surface"), std::string::npos);
  Write("sea/up.nc", TwoDepths({0, 10}, "up"));
  EXPECT_NEAR(Sea("current = {grid = \"sea/up.nc\"}").WaterVelocityAt({0, 0, 10}, 0).x(), 0.1,
              1e-6);
}

TEST_P(NetcdfMissions, HaveTheWaterOfTheirDayByTheStandardCalendar) {
  WrittenNetcdf file = {.dimensions = {{"time", 3}, {"lat", 2}, {"lon", 2}},
                        .variables = {Axis("time", 0, {17'758'632, 17'758'680, 17'758'728},
                                           "hours since 1-1-1 00:00:0.0"),
                                      Axis("lat", 1, {54.1, 54.3}, "degrees_north"),
                                      Axis("lon", 2, {10.1, 10.3}, "degrees_east")}};
  file.variables[0].texts["calendar"] = "standard";
  for (const char* name : {"uo", "vo"}) {
    file.variables.push_back(
        {.name = name,
         .dimensions = {0, 1, 2},
         .values = {0.2, 0.2, 0.2, 0.2, 0.4, 0.4, 0.4, 0.4, 0.6, 0.6, 0.6, 0.6}});
  }
  Write("sea/tide.nc", file);
  EXPECT_NEAR(Sea("current = {grid = \"sea/tide.nc\", grid_time = \"2026-11-24T00:00:00Z\"}")
                  .WaterVelocityAt({0, 0, 0}, 0)
                  .x(),
              0.4, 1e-6);
}

/// 0.5 m/s along the x axis of a grid of the Arctic, which points 38 degrees to the left of East.
WrittenNetcdf ArcticFile(const std::string& name, const std::string& axis_name) {
  WrittenNetcdf file = {.dimensions = {{"X", 3}, {"Y", 3}},
                        .variables = {Axis("X", 0, {-1011, -991, -971}, "km"),
                                      Axis("Y", 1, {-1277, -1257, -1237}, "km")}};
  file.variables[0].texts["standard_name"] = "projection_x_coordinate";
  file.variables[1].texts["standard_name"] = "projection_y_coordinate";
  file.variables.push_back({.name = "map",
                            .type = WrittenType::kInt,
                            .texts = {{"grid_mapping_name", name}},
                            .numbers = {{"straight_vertical_longitude_from_pole", 58},
                                        {"latitude_of_projection_origin", 90},
                                        {"standard_parallel", 60},
                                        {"earth_radius", 6'371'000}}});
  for (const auto& [variable, axis, speed_mps] :
       {std::tuple("u", "x", 0.5), std::tuple("v", "y", 0.0)}) {
    file.variables.push_back({.name = variable,
                              .dimensions = {1, 0},
                              .values = std::vector<double>(9, speed_mps),
                              .texts = {{"grid_mapping", "map"}}});
    if (!axis_name.empty()) {
      file.variables.back().texts["standard_name"] = axis + axis_name;
    }
  }
  return file;
}
constexpr char kArcticOrigin[] = "origin = {lat_deg = 74.66357488, lon_deg = 19.74828241}";

TEST_P(NetcdfMissions, DriftAlongTheAxesOfAProjectedGrid) {
  Write("sea/arctic.nc", ArcticFile("polar_stereographic", "_sea_water_velocity"));
  Write("sea/unnamed.nc", ArcticFile("polar_stereographic", ""));
  for (const auto& [keys, num_warnings] :
       {std::pair("grid = \"sea/arctic.nc\", grid_origin = [-991000, -1257000]", 0U),
        std::pair("grid = \"sea/arctic.nc\"", 0U),
        std::pair("grid_east = \"sea/arctic.nc:u\", grid_north = \"sea/arctic.nc:v\"", 0U),
        std::pair("grid = \"sea/unnamed.nc\"", 1U),
        std::pair("grid = \"sea/arctic.nc\", grid_origin = [-995000, -1257000]", 1U)}) {
    const LoadedMission loaded = Load(std::string("current = {") + keys + "}", kArcticOrigin);
    ASSERT_EQ(loaded.errors, std::vector<std::string>{});
    EXPECT_EQ(SeaWarnings(loaded).size(), num_warnings) << keys;
    const Result<Ocean> ocean = OceanOf(loaded.mission);
    ASSERT_TRUE(ocean.ok()) << ocean.error();
    const Eigen::Vector2d drift_m = 100 * ocean->WaterVelocityAt({0, 0, 0}, 0);
    EXPECT_NEAR(drift_m.x(), 39.3, 0.2) << keys;
    EXPECT_NEAR(drift_m.y(), 31, 0.2) << keys;
  }
}

TEST_P(NetcdfMissions, PlaceTheCellsOfAProjectedGridByItsMap) {
  WrittenNetcdf file = ArcticFile("polar_stereographic", "_sea_water_velocity");
  // Faster from column to column, 20 km apart on the map: 19 km on the Earth there.
  file.variables[3].values = {0, 0.5, 1, 0, 0.5, 1, 0, 0.5, 1};
  Write("sea/arctic.nc", file);
  const LoadedMission loaded = Load("current = {grid = \"sea/arctic.nc\"}", kArcticOrigin);
  const Result<Ocean> ocean = OceanOf(loaded.mission);
  ASSERT_TRUE(ocean.ok()) << ocean.error();
  const double angle_rad = std::atan2(31.0, 39.3);
  const Eigen::Vector2d along_m = 9000 * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
  const double scale =
      2 / (1 + std::sin(74.66 * std::acos(-1) / 180));  // Of a map true at the pole.
  const double scale_at_60 = 2 / (1 + std::sin(std::acos(-1) / 3));
  const double expected_mps = 0.5 + 0.5 * 9000 * scale / scale_at_60 / 20'000;
  EXPECT_NEAR(ocean->WaterVelocityAt({along_m.x(), along_m.y(), 0}, 0).norm(), expected_mps, 3e-3);
}

TEST_P(NetcdfMissions, AreRefusedOnAMapThatIsNotKnownOrWithComponentsOfTwoKinds) {
  Write("sea/arctic.nc", ArcticFile("geostationary", "_sea_water_velocity"));
  EXPECT_NE(ErrorOf("current = {grid = \"sea/arctic.nc\"}", kArcticOrigin)
                .find("is on a map whose grid_mapping 'map' is 'geostationary'"),
            std::string::npos);
  WrittenNetcdf file = ArcticFile("polar_stereographic", "_sea_water_velocity");
  file.variables[4].texts["standard_name"] = "northward_sea_water_velocity";
  Write("sea/mixed.nc", file);
  EXPECT_NE(ErrorOf("current = {grid_east = \"sea/mixed.nc:u\", grid_north = \"sea/mixed.nc:v\"}",
                    kArcticOrigin)
                .find("are along different axes by their standard_name"),
            std::string::npos);
  Write("sea/good.nc", ArcticFile("polar_stereographic", "_sea_water_velocity"));
  EXPECT_NE(ErrorOf("current = {grid = \"sea/good.nc\"}", "").find("write in [mission] origin"),
            std::string::npos);
}

/// A curvilinear grid about the origin, whose rows run to the North-East: 0.5 m/s along them, and a
/// floor that is 10 m deeper with each column.
WrittenNetcdf BentFile(const std::string& component) {
  WrittenNetcdf file = {.dimensions = {{"eta", 5}, {"xi", 5}},
                        .variables = {Axis("lat_rho", 0, {}, "degrees_north"),
                                      Axis("lon_rho", 0, {}, "degrees_east"),
                                      {.name = "u"},
                                      {.name = "v"},
                                      {.name = "h"}}};
  const LocalFrame frame(kOrigin);
  for (int eta = -2; eta <= 2; ++eta) {
    for (int xi = -2; xi <= 2; ++xi) {
      const GeoPoint point = frame.ToGeo({1000.0 * (xi - eta), 1000.0 * (xi + eta)});
      file.variables[0].values.push_back(point.lat_deg);
      file.variables[1].values.push_back(point.lon_deg);
      file.variables[2].values.push_back(0.5);
      file.variables[3].values.push_back(0);
      file.variables[4].values.push_back(50 + 10 * xi);
    }
  }
  for (WrittenVariable& variable : file.variables) variable.dimensions = {0, 1};
  file.variables[2].texts["standard_name"] =
      component == "sea_water" ? "sea_water_x_velocity" : "eastward_sea_water_velocity";
  file.variables[3].texts["standard_name"] =
      component == "sea_water" ? "sea_water_y_velocity" : "northward_sea_water_velocity";
  file.variables[4].texts["standard_name"] = "sea_floor_depth_below_geoid";
  return file;
}

TEST_P(NetcdfMissions, HaveTheSeaOfACurvilinearGrid) {
  Write("sea/along.nc", BentFile("sea_water"));
  Write("sea/east.nc", BentFile(""));
  const Ocean along = Sea("current = {grid = \"sea/along.nc\"}\nfloor = {grid = \"sea/along.nc\"}");
  const Eigen::Vector2d flow_mps = along.WaterVelocityAt({200, -300, 0}, 0);
  EXPECT_NEAR(flow_mps.x(), 0.5 * std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(flow_mps.y(), 0.5 * std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(along.floor->DepthAt({0, 0}), 50, 1e-3);
  EXPECT_NEAR(along.floor->DepthAt({700, 700}), 57, 1e-2);
  EXPECT_NEAR(along.floor->DepthAt({-700, 700}), 50, 1e-2);
  const Ocean east = Sea("current = {grid = \"sea/east.nc\"}");
  EXPECT_NEAR(east.WaterVelocityAt({200, -300, 0}, 0).x(), 0.5, 1e-6);
  EXPECT_NE(ErrorOf("current = {grid = \"sea/east.nc\", grid_origin = [1, 2]}")
                .find("remove grid_origin"),
            std::string::npos);
  EXPECT_NE(
      ErrorOf("current = {grid = \"sea/east.nc\"}", "origin = {lat_deg = 55.2, lon_deg = 10.2}")
          .find("outside of the current's grid"),
      std::string::npos);
}

/// How a curvilinear grid is stored whose x points East, and whose y points North.
struct MeshForm {
  std::string x = "x";  ///< Names of its dimensions.
  std::string y = "y";
  bool has_axes = false;
  bool is_x_first = false;
  bool y_falls = false;
};

constexpr int kMeshSide = 5;

/// 5 x 5 points around the origin, 1 km apart, with these components along x and y everywhere.
WrittenNetcdf MeshFile(const MeshForm& form, double along_x, double along_y) {
  const int x_dimension = form.is_x_first ? 0 : 1;
  WrittenNetcdf file = {.dimensions = {{form.is_x_first ? form.x : form.y, kMeshSide},
                                       {form.is_x_first ? form.y : form.x, kMeshSide}},
                        .variables = {Axis("lat_rho", 0, {}, "degrees_north"),
                                      Axis("lon_rho", 0, {}, "degrees_east"),
                                      {.name = "u"},
                                      {.name = "v"}}};
  const LocalFrame frame(kOrigin);
  for (int slow = 0; slow < kMeshSide; ++slow) {
    for (int fast = 0; fast < kMeshSide; ++fast) {
      const int east = form.is_x_first ? slow : fast;
      const int row = form.is_x_first ? fast : slow;
      const int north = form.y_falls ? kMeshSide - 1 - row : row;
      const GeoPoint point = frame.ToGeo({1000.0 * (east - 2), 1000.0 * (north - 2)});
      file.variables[0].values.push_back(point.lat_deg);
      file.variables[1].values.push_back(point.lon_deg);
      file.variables[2].values.push_back(along_x);
      file.variables[3].values.push_back(along_y);
    }
  }
  for (WrittenVariable& variable : file.variables) variable.dimensions = {0, 1};
  file.variables[2].texts["standard_name"] = "sea_water_x_velocity";
  file.variables[3].texts["standard_name"] = "sea_water_y_velocity";
  if (form.has_axes) {
    std::vector<double> rising = {0, 1000, 2000, 3000, 4000};
    std::vector<double> falling(rising.rbegin(), rising.rend());
    file.variables.push_back(Axis(form.x, x_dimension, rising, "m"));
    file.variables.back().texts["standard_name"] = "projection_x_coordinate";
    file.variables.push_back(Axis(form.y, 1 - x_dimension, form.y_falls ? falling : rising, "m"));
    file.variables.back().texts["standard_name"] = "projection_y_coordinate";
  }
  return file;
}

TEST_P(NetcdfMissions, DriftAlongXAndYInWhateverOrderAFileStoresThem) {
  const std::vector<MeshForm> forms = {MeshForm{},
                                       {.has_axes = true},
                                       {.has_axes = true, .y_falls = true},
                                       {.has_axes = true, .is_x_first = true},
                                       {.has_axes = true, .is_x_first = true, .y_falls = true},
                                       {.x = "a", .y = "b", .has_axes = true, .is_x_first = true},
                                       {.is_x_first = true},
                                       {.x = "xi_rho", .y = "eta_rho", .is_x_first = true},
                                       {.x = "ni", .y = "nj", .is_x_first = true}};
  for (size_t count = 0; count < forms.size(); ++count) {
    const std::string name = "sea/mesh" + std::to_string(count) + ".nc";
    Write(name, MeshFile(forms[count], 0.5, 0.25));
    const std::string keys = "current = {grid = \"" + name + "\"}";
    const Eigen::Vector2d flow_mps = Sea(keys).WaterVelocityAt({300, 400, 0}, 0);
    EXPECT_NEAR(flow_mps.x(), 0.5, 1e-5) << count;
    EXPECT_NEAR(flow_mps.y(), 0.25, 1e-5) << count;
    EXPECT_TRUE(SeaWarnings(Load(keys)).empty()) << count;
  }
  const auto warnings_of = [&](const std::string& name, const MeshForm& form) {
    Write(name, MeshFile(form, 0.5, 0.25));
    std::string all;
    for (const std::string& each : SeaWarnings(Load("current = {grid = \"" + name + "\"}"))) {
      all += each;
    }
    return all;
  };
  const std::string unnamed = warnings_of("sea/ab.nc", {.x = "a", .y = "b", .is_x_first = true});
  EXPECT_NE(unnamed.find("on which y lies to the right of x"), std::string::npos) << unnamed;
  EXPECT_NE(unnamed.find("show which is x: the last is taken"), std::string::npos) << unnamed;
  EXPECT_NE(warnings_of("sea/fall.nc", {.y_falls = true}).find("on which y lies to the right of x"),
            std::string::npos);
  EXPECT_NE(warnings_of("sea/turned.nc", {.x = "a", .y = "b", .is_x_first = true, .y_falls = true})
                .find("show which is x: the last is taken"),
            std::string::npos);
  EXPECT_EQ(warnings_of("sea/usual.nc", {.x = "a", .y = "b"}), "");
}

TEST_P(NetcdfMissions, DriftBesideMaskedCoordinatesAndFoldsAsElsewhere) {
  WrittenNetcdf file = MeshFile({}, 0.5, 0.25);
  for (const size_t degrees : {0, 1}) {
    file.variables[degrees].numbers = {{"_FillValue", -999}};
    for (size_t i = 15; i < 20; ++i) file.variables[degrees].values[i] = -999;  // Row 3 of 0 to 4.
  }
  Write("sea/masked.nc", file);
  const auto expect_flow = [&](const std::string& name, const Eigen::Vector2d& place_m) {
    const Ocean ocean = Sea("current = {grid = \"" + name + "\"}");
    const Eigen::Vector2d flow_mps = ocean.WaterVelocityAt({place_m.x(), place_m.y(), 0}, 0);
    EXPECT_NEAR(flow_mps.x(), 0.5, 1e-5) << name << place_m.transpose();
    EXPECT_NEAR(flow_mps.y(), 0.25, 1e-5) << name << place_m.transpose();
  };
  for (const double y_m : {-2000.0, 0.0, 2100.0}) expect_flow("sea/masked.nc", {0, y_m});
  // The last column repeats the third from the end, as at the ends of global grids.
  WrittenNetcdf folded = MeshFile({}, 0.5, 0.25);
  for (const size_t degrees : {0, 1}) {
    std::vector<double>& values = folded.variables[degrees].values;
    for (size_t row = 0; row < 25; row += 5) values[row + 4] = values[row + 2];
  }
  Write("sea/folded.nc", folded);
  for (const double x_m : {-2000.0, 0.0, 1000.0}) expect_flow("sea/folded.nc", {x_m, 0});
}

TEST_P(NetcdfMissions, AreRefusedWhereTheirComponentsLieAtOtherPoints) {
  WrittenNetcdf file = MeshFile({}, 0.5, 0.25);
  file.variables.push_back(file.variables[0]);
  file.variables.back().name = "lat_v";
  for (double& lat : file.variables.back().values) lat += 0.005;
  const std::string keys = "current = {grid = \"sea/staggered.nc\"}";
  Write("sea/staggered.nc", file);
  EXPECT_NE(ErrorOf(keys).find("name those of its points in its attribute coordinates"),
            std::string::npos)
      << ErrorOf(keys);
  file.variables[2].texts["coordinates"] = "lon_rho lat_rho";
  file.variables[3].texts["coordinates"] = "lon_rho lat_v";
  Write("sea/staggered.nc", file);
  EXPECT_NE(ErrorOf(keys).find("are on different points"), std::string::npos) << ErrorOf(keys);
  file.variables[3].texts["coordinates"] = "lon_rho lat_rho";
  Write("sea/together.nc", file);
  EXPECT_NEAR(Sea("current = {grid = \"sea/together.nc\"}").WaterVelocityAt({0, 0, 0}, 0).y(), 0.25,
              1e-5);
}

TEST_P(NetcdfMissions, AreRefusedWhereTheirComponentsNameOtherPointsBesideTheirAxes) {
  WrittenNetcdf file = ArcticFile(0.5, 0.25);
  for (const char* name : {"lat_u", "lat_v"}) {
    file.variables.push_back(file.variables[2]);
    file.variables.back().name = name;
  }
  file.variables[2].texts["coordinates"] = "lat_u";
  file.variables[3].texts["coordinates"] = "lat_v";
  Write("sea/arctic.nc", file);
  EXPECT_NE(ErrorOf("current = {grid = \"sea/arctic.nc\"}", "origin = {lat_deg = 75, lon_deg = 0}")
                .find("are on different points"),
            std::string::npos);
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
