// Sound speed profiles from NetCDF files with temperature and salinity, or the speed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "lib/mission/file/water_files.h"
#include "lib/sea/ocean/sound_speed.h"
#include "tests/netcdf/write_netcdf.h"

namespace shoal::netcdf_profile_test {

namespace fs = std::filesystem;

class NetcdfProfile : public testing::Test {
 protected:
  void SetUp() override {
    path_ =
        (fs::temp_directory_path() / ("profile_" + std::to_string(::getpid()) + ".nc")).string();
  }
  void TearDown() override { fs::remove(path_); }

  Result<SoundProfile> Read(const WrittenNetcdf& content, NetcdfForm form = NetcdfForm::kHdf5) {
    WriteNetcdf(path_, form, content);
    return ReadProfileFile(path_);
  }

  std::string path_;
};

/// Three depths, as models write them.
WrittenNetcdf Water() {
  return {.dimensions = {{"time", 1}, {"depth", 3}},
          .variables = {{.name = "depth",
                         .type = WrittenType::kDouble,
                         .dimensions = {1},
                         .values = {0, 50, 1000},
                         .texts = {{"units", "m"}, {"positive", "down"}}},
                        {.name = "thetao",
                         .dimensions = {0, 1},
                         .values = {20, 15, 25},
                         .texts = {{"standard_name", "sea_water_potential_temperature"},
                                   {"units", "degrees_C"}}},
                        {.name = "so",
                         .dimensions = {0, 1},
                         .values = {35, 35, 35},
                         .texts = {{"standard_name", "sea_water_salinity"}}}}};
}

TEST_F(NetcdfProfile, IsMackenziesOfTemperatureAndSalinity) {
  for (const NetcdfForm form : {NetcdfForm::kClassic, NetcdfForm::kHdf5}) {
    const Result<SoundProfile> profile = Read(Water(), form);
    ASSERT_TRUE(profile.ok()) << profile.error();
    ASSERT_EQ(profile->points().size(), 3U);
    EXPECT_NEAR(profile->SpeedAt(1000), 1550.744, 5e-4);
    EXPECT_NEAR(profile->SpeedAt(50),
                *SoundSpeed({.temperature_degc = 15, .salinity_ppt = 35, .depth_m = 50}), 1e-9);
  }
}

TEST_F(NetcdfProfile, UnpacksTakesKelvinAndLeavesGapsOut) {
  WrittenNetcdf water = Water();
  water.variables[1].type = WrittenType::kShort;
  water.variables[1].values = {2000, -32767, 2500};
  water.variables[1].numbers = {
      {"scale_factor", 0.01}, {"add_offset", 273.15}, {"_FillValue", -32767}};
  water.variables[1].texts["units"] = "K";
  const Result<SoundProfile> profile = Read(water);
  ASSERT_TRUE(profile.ok()) << profile.error();
  ASSERT_EQ(profile->points().size(), 2U);
  EXPECT_NEAR(profile->SpeedAt(1000), 1550.744, 5e-4);
}

TEST_F(NetcdfProfile, TakesTheSpeedAndHeightsAsDepths) {
  WrittenNetcdf water = Water();
  water.variables[0].values = {-1000, -50, 0};
  water.variables[1].name = "sound_speed";
  water.variables[1].values = {1480, 1490, 1520};
  water.variables[1].texts.clear();
  const Result<SoundProfile> profile = Read(water);
  ASSERT_TRUE(profile.ok()) << profile.error();
  EXPECT_EQ(profile->SpeedAt(0), 1520);
  EXPECT_EQ(profile->SpeedAt(1000), 1480);
}

TEST_F(NetcdfProfile, RefusesSeveralPlacesAndWhatIsMissing) {
  WrittenNetcdf water = Water();
  water.dimensions[0].second = 2;
  for (size_t i : {1U, 2U}) water.variables[i].values.resize(6, 20);
  const Result<SoundProfile> several = Read(water);
  ASSERT_FALSE(several.ok());
  EXPECT_NE(several.error().find("'thetao' has 6 values where the depth has 3"), std::string::npos)
      << several.error();
  water = Water();
  water.variables.pop_back();
  const Result<SoundProfile> fresh = Read(water);
  ASSERT_FALSE(fresh.ok());
  EXPECT_NE(fresh.error().find("no variable is the salinity"), std::string::npos) << fresh.error();
}

}  // namespace shoal::netcdf_profile_test
