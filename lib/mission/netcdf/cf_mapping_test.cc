#include "lib/mission/netcdf/cf_mapping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/mission/netcdf/cf_testing.h"

namespace shoal::cf_mapping_test {

NetcdfVariable MappingOf(const std::string& name, const NumberAttributes& numbers) {
  FakeNetcdf file;
  file.Variable("crs", {}, {}, {{"grid_mapping_name", name}}, numbers);
  return file.header.variables.back();
}

Eigen::Vector2d PlaceOf(const std::string& name, const NumberAttributes& numbers,
                        const GeoPoint& point, double metres = 1) {
  const Result<MapProjection> projection = ProjectionOf(MappingOf(name, numbers), metres);
  EXPECT_TRUE(projection.ok()) << projection.error();
  return projection.ok() ? projection->Forward(point) : Eigen::Vector2d(NAN, NAN);
}

TEST(CfMapping, CountsLongitudesFromTheMeridianThatItNames) {
  NumberAttributes numbers = {{"longitude_of_central_meridian", {0}},
                              {"latitude_of_projection_origin", {46.5}},
                              {"standard_parallel", {44, 49}},
                              {"longitude_of_prime_meridian", {2.33722917}},
                              {"earth_radius", {6'371'000}}};
  const Eigen::Vector2d paris =
      PlaceOf("lambert_conformal_conic", numbers, {.lat_deg = 46.5, .lon_deg = 2.33722917});
  EXPECT_NEAR(paris.norm(), 0, 1e-6);
  numbers.erase("longitude_of_prime_meridian");
  NetcdfVariable unknown = MappingOf("lambert_conformal_conic", numbers);
  unknown.attributes.push_back({.name = "prime_meridian_name", .text = "Paris"});
  const auto refused = ProjectionOf(unknown, 1);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().find("'longitude_of_prime_meridian'; add it"), std::string::npos);
  unknown.attributes.back().text = "Greenwich";
  EXPECT_TRUE(ProjectionOf(unknown, 1).ok());
}

TEST(CfMapping, HasTheNumbersOfTheProjection) {
  // A map of the Arctic: the pole is its origin.
  const Eigen::Vector2d arctic = PlaceOf("polar_stereographic",
                                         {{"straight_vertical_longitude_from_pole", {58}},
                                          {"latitude_of_projection_origin", {90}},
                                          {"standard_parallel", {60}},
                                          {"earth_radius", {6'371'000}}},
                                         {.lat_deg = 90, .lon_deg = 0});
  EXPECT_NEAR(arctic.norm(), 0, 1e-6);
  // EPSG:32632 has 500 km there.
  const Eigen::Vector2d utm = PlaceOf("transverse_mercator",
                                      {{"longitude_of_central_meridian", {9}},
                                       {"latitude_of_projection_origin", {0}},
                                       {"scale_factor_at_central_meridian", {0.9996}},
                                       {"false_easting", {500'000}},
                                       {"false_northing", {0}},
                                       {"semi_major_axis", {6'378'137}},
                                       {"inverse_flattening", {298.257223563}}},
                                      {.lat_deg = 0, .lon_deg = 9});
  EXPECT_NEAR(utm.x(), 500'000, 1e-6);
  EXPECT_NEAR(utm.y(), 0, 1e-6);
  const Eigen::Vector2d conic = PlaceOf("lambert_conformal_conic",
                                        {{"standard_parallel", {77.5, 77.5}},
                                         {"longitude_of_central_meridian", {-25}},
                                         {"latitude_of_projection_origin", {77.5}},
                                         {"false_easting", {7}}},
                                        {.lat_deg = 77.5, .lon_deg = -25}, 1000);
  EXPECT_NEAR(conic.x(), 7000, 1e-6) << "in the units of the axes";
  EXPECT_NEAR(conic.y(), 0, 1e-6);
  // On a sphere, 45 degrees of longitude at the equator.
  const Eigen::Vector2d mercator = PlaceOf("mercator",
                                           {{"longitude_of_projection_origin", {0}},
                                            {"standard_parallel", {60}},
                                            {"earth_radius", {6'371'000}}},
                                           {.lat_deg = 0, .lon_deg = 45});
  EXPECT_NEAR(mercator.x(), 6'371'000 * std::acos(-1) / 4 * std::cos(std::acos(-1) / 3), 1e-3);
  const Eigen::Vector2d rotated =
      PlaceOf("rotated_latitude_longitude",
              {{"grid_north_pole_latitude", {39.25}}, {"grid_north_pole_longitude", {-162}}},
              {.lat_deg = 50.75, .lon_deg = 18});
  EXPECT_NEAR(rotated.norm(), 0, 1e-9);
}

TEST(CfMapping, IsRefusedWhereItIsNotKnownOrNotWhole) {
  const auto error = [](const std::string& name, const NumberAttributes& numbers) {
    const Result<MapProjection> projection = ProjectionOf(MappingOf(name, numbers), 1);
    return projection.ok() ? "no error" : projection.error();
  };
  EXPECT_TRUE(error("lambert_azimuthal_equal_area", {})
                  .starts_with("is on a map whose grid_mapping 'crs' is "
                               "'lambert_azimuthal_equal_area'; those read are "
                               "polar_stereographic"));
  EXPECT_NE(error("", {}).find("gdalwarp"), std::string::npos);
  EXPECT_EQ(error("polar_stereographic", {{"latitude_of_projection_origin", {90}}}),
            "has the grid_mapping 'crs', polar_stereographic, without the number "
            "'straight_vertical_longitude_from_pole'; add it");
  EXPECT_EQ(error("polar_stereographic", {{"latitude_of_projection_origin", {60}},
                                          {"straight_vertical_longitude_from_pole", {0}}}),
            "has the grid_mapping 'crs', polar_stereographic, with numbers that no such map has; "
            "correct them");
}

TEST(CfMapping, IsTheOneOfTheAxisWhereThereAreSeveral) {
  const auto found = [](const std::string& text) {
    FakeNetcdf file;
    file.Variable("plane", {}, {}).Variable("globe", {}, {});
    file.Variable("u", {}, {}, {{"grid_mapping", text}});
    const auto mapping = FindMapping(file.header, file.header.variables.back(), "X");
    if (!mapping.ok()) return mapping.error().substr(0, 27);
    return *mapping == nullptr ? std::string("none") : (*mapping)->name;
  };
  EXPECT_EQ(found(""), "none");
  EXPECT_EQ(found("plane"), "plane");
  EXPECT_EQ(found("globe: lat lon plane: X Y"), "plane");
  EXPECT_EQ(found("gone"), "has the grid_mapping 'gone'");
}

}  // namespace shoal::cf_mapping_test
