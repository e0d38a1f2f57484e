#include "lib/mission/netcdf/cf_variables.h"

#include <gtest/gtest.h>

#include "lib/mission/netcdf/cf_testing.h"

namespace shoal::cf_variables_test {

FakeNetcdf WithVariables(const std::vector<std::pair<std::string, TextAttributes>>& variables) {
  FakeNetcdf file;
  file.Axis("lat", {54, 55}, kNorthDegrees).Axis("lon", {10, 11}, kEastDegrees);
  for (const auto& [name, texts] : variables) {
    file.Variable(name, {"lat", "lon"}, {1, 2, 3, 4}, texts);
  }
  return file;
}

std::string FloorOf(const std::vector<std::pair<std::string, TextAttributes>>& variables) {
  const Result<std::string> found = FindFloorVariable(WithVariables(variables).header, "bay.nc");
  return found.ok() ? *found : found.error();
}

TEST(FloorVariable, IsFoundInTheFormsOfTheCommonMaps) {
  EXPECT_EQ(FloorOf({{"tid", {}}, {"elevation", {}}}), "elevation") << "GEBCO";
  EXPECT_EQ(FloorOf({{"crs", {}}, {"z", {}}}), "z") << "ETOPO";
  EXPECT_EQ(FloorOf({{"other", {}}, {"Band1", {}}}), "Band1") << "GDAL";
  EXPECT_EQ(FloorOf({{"a", {}}, {"b", {{"standard_name", "sea_floor_depth_below_geoid"}}}}), "b");
  EXPECT_EQ(FloorOf({{"anything", {}}}), "anything") << "the only one";
}

TEST(FloorVariable, IsAskedForWhereItIsNotClear) {
  EXPECT_EQ(FloorOf({{"one", {}}, {"two", {}}}),
            "bay.nc: which variable is the sea floor is not clear; name it after the file, "
            "bay.nc:variable; there are: one, two");
  EXPECT_EQ(FloorOf({}),
            "bay.nc: which variable is the sea floor is not clear; name it after the file, "
            "bay.nc:variable; there are: none");
}

TEST(FloorVariable, StatesWhetherItHoldsDepths) {
  const auto holds = [](const TextAttributes& texts) {
    return HoldsDepths(WithVariables({{"z", texts}}).header.variables.back());
  };
  EXPECT_EQ(holds({{"positive", "down"}}), true);
  EXPECT_EQ(holds({{"positive", "up"}, {"standard_name", "sea_floor_depth"}}), false);
  EXPECT_EQ(holds({{"standard_name", "sea_floor_depth_below_mean_sea_level"}}), true);
  EXPECT_EQ(holds({{"standard_name", "height_above_mean_sea_level"}}), false);
  EXPECT_EQ(holds({}), std::nullopt);
}

TEST(CurrentVariables, AreFoundByStandardNameThenByName) {
  const auto found = [](const std::vector<std::pair<std::string, TextAttributes>>& variables) {
    const auto pair = FindCurrentVariables(WithVariables(variables).header, "tide.nc");
    return pair.ok() ? pair->first + " " + pair->second : pair.error();
  };
  EXPECT_EQ(found({{"v", {}},
                   {"u", {}},
                   {"a", {{"standard_name", "northward_sea_water_velocity"}}},
                   {"b", {{"standard_name", "eastward_sea_water_velocity"}}}}),
            "b a");
  EXPECT_EQ(found({{"vo", {}}, {"uo", {}}}), "uo vo");
  EXPECT_EQ(found({{"U", {}}, {"V", {}}}), "U V");
  EXPECT_EQ(found({{"water_u", {}}, {"water_v", {}}}), "water_u water_v");
  EXPECT_EQ(found({{"u", {}}}),
            "tide.nc: which variables are the current is not clear; name both, grid_east = "
            "\"tide.nc:variable\" and grid_north; there are: u");
}

}  // namespace shoal::cf_variables_test
