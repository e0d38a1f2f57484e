#include "lib/mission/file/ocean_of.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/mission/file/load.h"

namespace shoal::ocean_of_test {

Current CurrentOf(const CurrentWords& words, uint64_t seed = 1) {
  Environment environment;
  environment.current = words;
  const Result<Ocean> ocean = OceanOf(environment, seed, {});
  EXPECT_TRUE(ocean.ok()) << ocean.error();
  return ocean->current;
}

CurrentParams ParamsOf(const CurrentWords& words, uint64_t seed = 1) {
  return CurrentOf(words, seed).params();
}

FloorOptions FloorOfStyle(const std::string& style) {
  FloorOptions floor;
  floor.style = style;
  return floor;
}

Result<Ocean> OceanWith(const FloorOptions& floor, const std::string& folder = "") {
  Environment environment;
  environment.floor = floor;
  return OceanOf(environment, 1, {.folder = folder});
}

TEST(OceanOf, HasStillWaterAndAnUnknownFloorByDefault) {
  const Result<Ocean> ocean = OceanOf(Environment(), 1, {});
  ASSERT_TRUE(ocean.ok());
  EXPECT_EQ(Velocity(ocean->current.At(123)), Eigen::Vector2d(0, 0));
  EXPECT_FALSE(ocean->floor.has_value());
}

TEST(OceanOf, TakesNumbersAsTheyAreWithDirectionsClockwiseFromNorth) {
  const Current current = CurrentOf({.speed_mps = "0.5", .direction_deg = "120"});
  for (const double time_s : {0.0, 100.0, 1e6}) {
    const Eigen::Vector2d expected_mps(0.5 * std::cos(DegToRad(30)), -0.25);
    EXPECT_LT((Velocity(current.At(time_s)) - expected_mps).norm(), 1e-12);
  }
}

TEST(OceanOf, TakesASpeedFasterThanAnyZone) {
  EXPECT_NEAR(Velocity(CurrentOf({.speed_mps = "50", .direction_deg = "90"}).At(0)).x(), 50, 1e-9);
}

TEST(OceanOf, DrawsOneNumberFromARange) {
  bool differs = false;
  const double first_mps = ParamsOf({.speed_mps = "0.1..0.4"}, 1).speed_mps.mean;
  for (uint64_t seed = 1; seed < 50; ++seed) {
    const CurrentParams params = ParamsOf(
        {.speed_mps = "0.1..0.4", .direction_deg = "-20..10", .speed_half_period_s = "30..31"},
        seed);
    EXPECT_GE(params.speed_mps.mean, 0.1);
    EXPECT_LE(params.speed_mps.mean, 0.4);
    const double heading_deg = RadToDeg(WrapPi(HeadingFromPsi(params.direction_rad.mean)));
    EXPECT_GE(heading_deg, -20 - 1e-9);
    EXPECT_LE(heading_deg, 10 + 1e-9);
    EXPECT_GE(params.speed_mps.half_period_s, 30);
    EXPECT_LE(params.speed_mps.half_period_s, 31);
    differs = differs || params.speed_mps.mean != first_mps;
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(first_mps, ParamsOf({.speed_mps = "0.1..0.4"}, 1).speed_mps.mean);
}

TEST(OceanOf, DrawsFromZonesByTheirNames) {
  for (uint64_t seed = 1; seed < 50; ++seed) {
    const CurrentParams params = ParamsOf({.speed_mps = "moderate",
                                           .direction_deg = "east",
                                           .speed_deviation_mps = "varied",
                                           .direction_deviation_deg = "steady",
                                           .speed_half_period_s = "choppy",
                                           .direction_half_period_s = "calm"},
                                          seed);
    EXPECT_GE(params.speed_mps.mean, 0.5);
    EXPECT_LE(params.speed_mps.mean, 1);
    EXPECT_LE(std::abs(params.direction_rad.mean), kPi / 8) << "East is psi = 0";
    EXPECT_GE(params.speed_mps.deviation, 0.1);
    EXPECT_LE(params.speed_mps.deviation, 0.5);
    EXPECT_LE(params.direction_rad.deviation, DegToRad(10));
    EXPECT_LE(params.speed_mps.half_period_s, 30);
    EXPECT_EQ(params.direction_rad.half_period_s, 600);
  }
}

TEST(OceanOf, FindsAProblemForEveryInvalidWord) {
  const std::vector<CurrentProblem> problems = FindProblems({.speed_mps = "fastest",
                                                             .direction_deg = "400",
                                                             .speed_deviation_mps = "",
                                                             .direction_deviation_deg = "181",
                                                             .speed_half_period_s = "0",
                                                             .direction_half_period_s = "2..1"});
  ASSERT_EQ(problems.size(), 6U);
  EXPECT_EQ(problems[0].key, "speed_mps");
  EXPECT_EQ(problems[5].key, "direction_half_period_s");
  EXPECT_TRUE(FindProblems({}).empty());
  EXPECT_LT(FindProblems({.speed_mps = std::string(10'000, '9')}).at(0).text.size(), 250U);
}

RC_GTEST_PROP(OceanOf, RefusesOrHasAFiniteCurrentForAnyText, ()) {
  const auto word = [] {
    return *rc::gen::container<std::string>(
        rc::gen::element('1', '0', '.', '-', 'e', 'x', ' ', '\0', 'a', 'n', 'y', '5'));
  };
  Environment environment;
  environment.current = {.speed_mps = word(), .direction_deg = word()};
  const Result<Ocean> ocean = OceanOf(environment, 7, {});
  if (!ocean.ok()) {
    RC_ASSERT(!ocean.error().empty());
    return;
  }
  RC_ASSERT(Velocity(ocean->current.At(100)).norm() <= kMaxCurrent_mps + 1e-9);
}

TEST(OceanOf, RefusesWordsThatOnlyBeginWithANumber) {
  EXPECT_EQ(FindProblems({.speed_mps = std::string("1\0 2", 4)}).size(), 1U);
  EXPECT_EQ(FindProblems({.speed_mps = std::string("0.1..0.4\0", 9)}).size(), 1U);
  EXPECT_EQ(FindProblems({.speed_mps = " 1"}).size(), 1U);
  EXPECT_EQ(FindProblems({.speed_mps = "0x1"}).size(), 1U);
}

TEST(OceanOf, MakesAFlatFloor) {
  FloorOptions floor = FloorOfStyle("flat");
  floor.depth_m = 42;
  const Result<Ocean> ocean = OceanWith(floor);
  ASSERT_TRUE(ocean.ok());
  EXPECT_EQ(ocean->floor->DepthAt({1e5, -1e5}), 42);
}

TEST(OceanOf, MakesAFlatFloorThatSlopesFromTheMiddleOfItsMap) {
  FloorOptions floor = FloorOfStyle("flat");
  floor.depth_m = 60;
  floor.slope_east = -0.125;
  floor.slope_north = 0.05;
  const Result<Ocean> ocean = OceanWith(floor);
  ASSERT_TRUE(ocean.ok() && ocean->floor) << ocean.error();
  EXPECT_NEAR(ocean->floor->DepthAt({0, 0}), 60, 1e-9);
  EXPECT_NEAR(ocean->floor->DepthAt({160, 40}), 60 - 20 + 2, 1e-9);
  EXPECT_NEAR(ocean->floor->DepthAt({-160, 0}), 80, 1e-9);
}

TEST(OceanOf, MakesFloorsOfNoiseThatFallTowardTheSideTheySlope) {
  for (const char* style : {"linear", "sigmoid", "shelf"}) {
    FloorOptions floor = FloorOfStyle(style);
    floor.depth_m = 50;
    floor.range_m = 10;
    floor.size_m = 200;
    floor.scale_m = 100;
    floor.slope_east = 1;
    const Result<Ocean> ocean = OceanWith(floor);
    ASSERT_TRUE(ocean.ok()) << style << ": " << ocean.error();
    EXPECT_GT(ocean->floor->DepthAt({90, 0}), ocean->floor->DepthAt({-90, 0}) + 100) << style;
    EXPECT_EQ(OceanWith(floor)->floor->DepthAt({3, 4}), ocean->floor->DepthAt({3, 4})) << style;
  }
}

/// A folder of its own with a mission file and a grid below it.
class OceanOfFiles : public testing::Test {
 protected:
  OceanOfFiles()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string("ocean_of_test_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_ / "maps");
    Write("maps/bay.asc",
          "ncols 2\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\n-30 -40\n-10 -20\n");
    Write("bay.toml",
          "[mission]\nduration_s = 60\n[environment]\nfloor = {grid = \"maps/bay.asc\", "
          "grid_origin = [105, 205]}\n[[vehicle]]\nname = \"alpha\"\n");
  }
  ~OceanOfFiles() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(OceanOfFiles, ReadsAGridFromTheFolderOfTheMissionFile) {
  const LoadedMission loaded = LoadMission(Path("bay.toml"));
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(loaded.mission.environment.floor.style, "grid");
  const Result<Ocean> ocean = OceanOf(loaded.mission);
  ASSERT_TRUE(ocean.ok()) << ocean.error();
  ASSERT_TRUE(ocean->floor.has_value());
  EXPECT_EQ(ocean->floor->DepthAt({0, 0}), 10);
  EXPECT_EQ(ocean->floor->DepthAt({10, 0}), 20);
  EXPECT_EQ(ocean->floor->DepthAt({0, 10}), 30);
}

TEST_F(OceanOfFiles, ReadsDepthsWhereTheGridHoldsThem) {
  FloorOptions floor = FloorOfStyle("grid");
  floor.grid = "maps/deep.asc";
  floor.grid_is_depth = true;
  Write("maps/deep.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n77\n");
  const Result<Ocean> ocean = OceanWith(floor, folder_.string());
  ASSERT_TRUE(ocean.ok()) << ocean.error();
  EXPECT_EQ(ocean->floor->DepthAt({0, 0}), 77);
}

TEST_F(OceanOfFiles, ExplainsAMissionWithAGridAsOneThatLoadsEqual) {
  const LoadedMission loaded = LoadMission(Path("bay.toml"));
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  const LoadedMission again = LoadMissionText(Explain(loaded.mission), Path("bay.toml"));
  ASSERT_EQ(again.errors, std::vector<std::string>{});
  EXPECT_TRUE(again.mission == loaded.mission) << Explain(again.mission);
}

TEST_F(OceanOfFiles, NamesTheGridAndItsLineWhereItIsBroken) {
  Write("maps/broken.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n-10\n");
  FloorOptions floor = FloorOfStyle("grid");
  floor.grid = "maps/broken.asc";
  const Result<Ocean> ocean = OceanWith(floor, folder_.string());
  ASSERT_FALSE(ocean.ok());
  EXPECT_TRUE(ocean.error().starts_with(Path("maps/broken.asc") + ":")) << ocean.error();
}

TEST_F(OceanOfFiles, MakesTheSeaOnceForEqualMissionsAndAnewForOthers) {
  Mission mission;
  mission.file = Path("bay.toml");
  mission.environment.floor = FloorOfStyle("linear");
  mission.environment.current.speed_mps = "any";
  const double floor_m = OceanOf(mission)->floor->DepthAt({1, 2});
  const double speed_mps = OceanOf(mission)->current.params().speed_mps.mean;
  EXPECT_EQ(OceanOf(mission)->floor->DepthAt({1, 2}), floor_m);
  mission.seed = 2;
  EXPECT_NE(OceanOf(mission)->floor->DepthAt({1, 2}), floor_m);
  EXPECT_NE(OceanOf(mission)->current.params().speed_mps.mean, speed_mps);
  mission.seed = 1;
  EXPECT_EQ(OceanOf(mission)->floor->DepthAt({1, 2}), floor_m);
}

}  // namespace shoal::ocean_of_test
