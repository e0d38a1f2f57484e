#include "lib/mission/netcdf/cf_variables.h"

#include <gtest/gtest.h>

#include <optional>

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

TEST(FloorVariable, IsNoOtherQuantityInMetres) {
  for (const auto& [name, texts] : std::vector<std::pair<std::string, TextAttributes>>{
           {"zos", {{"standard_name", "sea_surface_height_above_geoid"}}},
           {"height", {{"standard_name", "sea_surface_wave_significant_height"}}},
           {"h", {{"standard_name", "ocean_mixed_layer_thickness"}}},
           {"depth", {{"standard_name", "ocean_mixed_layer_depth"}}},
           {"z", {{"standard_name", "sea_ice_thickness"}}},
           {"zeta", {{"long_name", "time-averaged free-surface"}}},
           {"ssh", {{"long_name", "Sea Surface Height"}}}}) {
    EXPECT_NE(FloorOf({{name, texts}}).find("is not clear"), std::string::npos) << name;
    EXPECT_EQ(FloorOf({{name, texts}, {"other", {}}}), "other") << name;
  }
  EXPECT_EQ(FloorOf({{"a", {{"long_name", "bathymetry below sea surface height"}}}}), "a");
  EXPECT_EQ(FloorOf({{"a", {{"standard_name", "depth"}}}}), "a");
}

TEST(FloorVariable, IsFoundByTheStandardNamesAndNamesOfModels) {
  for (const char* name :
       {"sea_floor_depth_below_sea_level", "sea_floor_depth_below_reference_ellipsoid",
        "sea_floor_depth_below_geopotential_datum", "model_sea_floor_depth_below_geoid",
        "height_above_reference_ellipsoid"}) {
    EXPECT_EQ(FloorOf({{"a", {}}, {"b", {{"standard_name", name}}}}), "b") << name;
  }
  for (const char* name : {"h", "Depth", "deptho", "Bathymetry", "hdepth"}) {
    EXPECT_EQ(FloorOf({{"mask", {}}, {name, {}}}), name);
    EXPECT_TRUE(IsNamedAsDepths({.name = name})) << name;
  }
  EXPECT_EQ(FloorOf({{"h", {}}, {"elevation", {}}}), "elevation");
  EXPECT_FALSE(IsNamedAsDepths({.name = "elevation"}));
}

TEST(FloorVariable, StatesWhetherItHoldsDepths) {
  const auto holds = [](const TextAttributes& texts) -> std::optional<bool> {
    const auto stated = StatementOf(WithVariables({{"z", texts}}).header.variables.back());
    return stated ? std::optional(stated->are_depths) : std::nullopt;
  };
  EXPECT_EQ(holds({{"positive", "down"}}), true);
  EXPECT_EQ(holds({{"positive", "up"}, {"standard_name", "sea_floor_depth"}}), false);
  for (const char* depths :
       {"sea_floor_depth", "sea_floor_depth_below_mean_sea_level",
        "sea_floor_depth_below_sea_level", "sea_floor_depth_below_geoid",
        "sea_floor_depth_below_sea_surface", "sea_floor_depth_below_reference_ellipsoid",
        "sea_floor_depth_below_geopotential_datum", "model_sea_floor_depth_below_sea_level"}) {
    EXPECT_EQ(holds({{"standard_name", depths}}), true) << depths;
  }
  EXPECT_EQ(holds({{"standard_name", "height_above_mean_sea_level"}}), false);
  EXPECT_EQ(holds({{"standard_name", "height_above_reference_ellipsoid"}}), false);
  EXPECT_EQ(holds({}), std::nullopt);
}

TEST(FloorVariable, MayCountFromTheEllipsoid) {
  const auto counts = [](const std::string& name) {
    return CountsFromEllipsoid(
        WithVariables({{"z", {{"standard_name", name}}}}).header.variables.back());
  };
  EXPECT_TRUE(counts("sea_floor_depth_below_reference_ellipsoid"));
  EXPECT_TRUE(counts("height_above_reference_ellipsoid"));
  EXPECT_FALSE(counts("sea_floor_depth_below_geoid"));
}

TEST(CurrentVariables, RunAlongEarthOrGridByTheirStandardName) {
  const auto direction = [](const std::string& name) {
    return DirectionOf(WithVariables({{"u", {{"standard_name", name}}}}).header.variables.back());
  };
  EXPECT_EQ(direction("eastward_sea_water_velocity"), CfDirection::kEast);
  EXPECT_EQ(direction("surface_northward_sea_water_velocity"), CfDirection::kNorth);
  EXPECT_EQ(direction("sea_water_x_velocity"), CfDirection::kX);
  EXPECT_EQ(direction("x_sea_water_velocity"), CfDirection::kX);
  EXPECT_EQ(direction("barotropic_sea_water_y_velocity"), CfDirection::kY);
  EXPECT_EQ(direction("grid_eastward_sea_water_velocity"), CfDirection::kX);
  EXPECT_EQ(direction(""), CfDirection::kUnknown);
  const auto by_long_name = [](const TextAttributes& texts) {
    return DirectionOf(WithVariables({{"u", texts}}).header.variables.back());
  };
  EXPECT_EQ(by_long_name({{"long_name", "Eastward velocity"}}), CfDirection::kEast);
  EXPECT_EQ(by_long_name({{"long_name", "Northward current"}}), CfDirection::kNorth);
  EXPECT_EQ(by_long_name({{"long_name", "eastward along the grid"}}), CfDirection::kUnknown);
  EXPECT_EQ(by_long_name({{"long_name", "zonal velocity"}}), CfDirection::kUnknown);
  EXPECT_EQ(by_long_name({{"long_name", "eastward"}, {"standard_name", "sea_water_x_velocity"}}),
            CfDirection::kX);
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
  EXPECT_EQ(found({{"u", {}},
                   {"v", {}},
                   {"a", {{"standard_name", "sea_water_y_velocity"}}},
                   {"b", {{"standard_name", "sea_water_x_velocity"}}}}),
            "b a");
  EXPECT_EQ(found({{"u", {{"standard_name", "sea_water_x_velocity"}}},
                   {"v", {{"standard_name", "sea_water_y_velocity"}}},
                   {"ue", {{"standard_name", "eastward_sea_water_velocity"}}},
                   {"vn", {{"standard_name", "northward_sea_water_velocity"}}}}),
            "ue vn");
  const TextAttributes eastward = {{"standard_name", "eastward_sea_water_velocity"}};
  const TextAttributes northward = {{"standard_name", "northward_sea_water_velocity"}};
  const std::string not_clear = "tide.nc: which variables are the current is not clear";
  EXPECT_TRUE(found({{"a", eastward},
                     {"b", eastward},
                     {"c", northward},
                     {"ubar", {{"standard_name", "barotropic_eastward_sea_water_velocity"}}},
                     {"vbar", {{"standard_name", "barotropic_northward_sea_water_velocity"}}}})
                  .starts_with(not_clear))
      << "no other current takes its place";
  EXPECT_TRUE(found({{"a", eastward}, {"u", {}}, {"v", {}}}).starts_with(not_clear));
  EXPECT_TRUE(found({{"u", {}}, {"ubar", {}}, {"vbar", {}}}).starts_with(not_clear));
  EXPECT_TRUE(found({{"u", {{"standard_name", "eastward_wind"}}},
                     {"v", {{"standard_name", "northward_wind"}}}})
                  .starts_with(not_clear));
  EXPECT_EQ(found({{"vo", {}}, {"uo", {}}}), "uo vo");
  EXPECT_EQ(found({{"U", {}}, {"V", {}}}), "U V");
  EXPECT_EQ(found({{"water_u", {}}, {"water_v", {}}}), "water_u water_v");
  EXPECT_EQ(found({{"u", {}}}),
            "tide.nc: which variables are the current is not clear; name both, grid_east = "
            "\"tide.nc:variable\" and grid_north; there are: u");
}

}  // namespace shoal::cf_variables_test
