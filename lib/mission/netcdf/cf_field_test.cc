#include "lib/mission/netcdf/cf_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lib/mission/netcdf/cf_testing.h"

namespace shoal::cf_field_test {

Result<CfField> Read(const FakeNetcdf& file, const std::string& variable = "z",
                     CfQuantity quantity = CfQuantity::kMetres) {
  return ReadCfField(file.source(), variable, quantity);
}

FakeNetcdf Degrees(const TextAttributes& texts = {}, const NumberAttributes& numbers = {},
                   NetcdfType type = NetcdfType::kFloat) {
  return FakeNetcdf()
      .Axis("lat", {54, 54.5}, kNorthDegrees)
      .Axis("lon", {10, 11, 12}, kEastDegrees)
      .Variable("z", {"lat", "lon"}, {1, 2, 3, 4, 5, 6}, texts, numbers, type);
}

TEST(CfField, HasLatitudesAndLongitudesByTheirUnits) {
  const Result<CfField> field = Read(Degrees());
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_TRUE(field->is_geographic);
  EXPECT_EQ(field->x, (std::vector<double>{10, 11, 12}));
  EXPECT_EQ(field->y, (std::vector<double>{54, 54.5}));
  EXPECT_EQ(field->values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_FALSE(field->has_time);
}

TEST(CfField, TurnsDescendingAxesAndOrdersDimensions) {
  const FakeNetcdf file = FakeNetcdf()
                              .Axis("lon", {12, 11, 10}, kEastDegrees)
                              .Axis("lat", {54.5, 54}, kNorthDegrees)
                              .Variable("z", {"lon", "lat"}, {6, 3, 5, 2, 4, 1});
  const Result<CfField> field = Read(file);
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_EQ(field->x, (std::vector<double>{10, 11, 12}));
  EXPECT_EQ(field->y, (std::vector<double>{54, 54.5}));
  EXPECT_EQ(field->values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST(CfField, OrdersTimeAndDepthBeforeThePlane) {
  FakeNetcdf file;
  file.Axis("time", {0, 2}, {{"units", "hours since 1970-01-01"}})
      .Axis("height", {-10, 0}, {{"units", "m"}, {"positive", "up"}})
      .Axis("lat", {54}, kNorthDegrees)
      .Axis("lon", {10, 11}, kEastDegrees)
      .Variable("z", {"lat", "lon", "height", "time"}, {0, 1, 2, 3, 10, 11, 12, 13});
  const Result<CfField> field = Read(file);
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_TRUE(field->has_time);
  EXPECT_EQ(field->times_s, (std::vector<double>{0, 7200}));
  EXPECT_EQ(field->depths_m, (std::vector<double>{0, 10}));
  // Of each time each depth: at the surface stand the odd pairs.
  EXPECT_EQ(field->values, (std::vector<float>{2, 12, 0, 10, 3, 13, 1, 11}));
}

TEST(CfField, LetsLongitudesGoOnAtTheDateLineAndRoundTheEarth) {
  FakeNetcdf file;
  file.Axis("lat", {0}, kNorthDegrees)
      .Axis("lon", {179, 180, -179}, kEastDegrees)
      .Variable("z", {"lat", "lon"}, {1, 2, 3});
  EXPECT_EQ(Read(file)->x, (std::vector<double>{179, 180, 181}));
  FakeNetcdf round;
  round.Axis("lat", {0}, kNorthDegrees)
      .Axis("lon", {0, 90, 180, 270}, kEastDegrees)
      .Variable("z", {"lat", "lon"}, {1, 2, 3, 4});
  const Result<CfField> field = Read(round);
  EXPECT_EQ(field->x, (std::vector<double>{0, 90, 180, 270, 360}));
  EXPECT_EQ(field->values, (std::vector<float>{1, 2, 3, 4, 1}));
}

TEST(CfField, HasMetresByStandardNamesAlsoInKilometres) {
  FakeNetcdf file;
  file.Axis("e", {1, 2}, {{"standard_name", "projection_x_coordinate"}, {"units", "km"}})
      .Axis("n", {500}, {{"standard_name", "projection_y_coordinate"}, {"units", "m"}})
      .Variable("z", {"n", "e"}, {7, 8});
  const Result<CfField> field = Read(file);
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_FALSE(field->is_geographic);
  EXPECT_EQ(field->x, (std::vector<double>{1000, 2000}));
}

TEST(CfField, UnpacksAndMarksGapsByWhatStandsInTheFile) {
  const NumberAttributes packing = {{"scale_factor", {0.5}},
                                    {"add_offset", {10}},
                                    {"_FillValue", {3}},
                                    {"missing_value", {4}},
                                    {"valid_range", {2, 5}}};
  const Result<CfField> field = Read(Degrees({}, packing, NetcdfType::kShort));
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_TRUE(std::isnan(field->values[0])) << "below valid_range";
  EXPECT_EQ(field->values[1], 11);
  EXPECT_TRUE(std::isnan(field->values[2])) << "_FillValue";
  EXPECT_TRUE(std::isnan(field->values[3])) << "missing_value";
  EXPECT_EQ(field->values[4], 12.5);
  EXPECT_TRUE(std::isnan(field->values[5])) << "above valid_range";
}

TEST(CfField, MarksWhatWasNeverWrittenAndReadsUnsignedNumbers) {
  FakeNetcdf file = Degrees({}, {}, NetcdfType::kShort);
  file.values["z"] = {-32767, 0, 1, 2, 3, 4};
  EXPECT_TRUE(std::isnan(Read(file)->values[0]));
  FakeNetcdf bytes = Degrees({{"_Unsigned", "true"}}, {{"_FillValue", {-1}}}, NetcdfType::kByte);
  bytes.values["z"] = {-1, -2, -128, 0, 127, 1};
  const Result<CfField> field = Read(bytes);
  EXPECT_TRUE(std::isnan(field->values[0]));
  EXPECT_EQ(field->values[1], 254);
  EXPECT_EQ(field->values[2], 128);
  FakeNetcdf floats = Degrees({}, {{"missing_value", {-1e34}}});
  floats.values["z"][0] = static_cast<float>(-1e34);
  EXPECT_TRUE(std::isnan(Read(floats)->values[0])) << "in the precision of the variable";
}

TEST(CfField, TakesCentimetresPerSecond) {
  const Result<CfField> field =
      Read(Degrees({{"units", "cm s-1"}}), "z", CfQuantity::kMetresPerSecond);
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_FLOAT_EQ(field->values[5], 0.06F);
  for (const char* units : {"m s-1", "m/s", "meter second-1", "m s^-1", "metres/sec"}) {
    EXPECT_EQ(Read(Degrees({{"units", units}}), "z", CfQuantity::kMetresPerSecond)->values[5], 6)
        << units;
  }
}

void ExpectError(const FakeNetcdf& file, const std::string& start, const std::string& remedy,
                 CfQuantity quantity = CfQuantity::kMetres) {
  const Result<CfField> field = Read(file, "z", quantity);
  ASSERT_FALSE(field.ok()) << start;
  EXPECT_TRUE(field.error().starts_with(start)) << field.error();
  EXPECT_NE(field.error().find(remedy), std::string::npos) << field.error();
}

TEST(CfFieldErrors, NameTheVariableAndTheRemedy) {
  ExpectError(FakeNetcdf().Axis("lat", {1}, kNorthDegrees),
              "bay.nc: there is no variable 'z' in it", "name one of these");
  ExpectError(Degrees({{"units", "K"}}), "bay.nc: variable 'z' is in 'K', not in metres",
              "file.nc:variable");
  ExpectError(Degrees({{"units", "knots"}}), "bay.nc: variable 'z' is in 'knots', not in m s-1",
              "file.nc:variable", CfQuantity::kMetresPerSecond);
  ExpectError(FakeNetcdf()
                  .Axis("lat", {1, 3, 2}, kNorthDegrees)
                  .Axis("lon", {1}, kEastDegrees)
                  .Variable("z", {"lat", "lon"}, {1, 2, 3}),
              "bay.nc: variable 'z' has an axis 'lat' that is empty, or whose values neither",
              "write the file again");
  ExpectError(FakeNetcdf()
                  .Axis("row", {1, 2}, {})
                  .Axis("lon", {1}, kEastDegrees)
                  .Variable("z", {"row", "lon"}, {1, 2}),
              "bay.nc: variable 'z' has an axis 'row' of no known kind", "degrees_north");
  ExpectError(FakeNetcdf()
                  .Dimension("eta", 2)
                  .Axis("lon", {1}, kEastDegrees)
                  .Variable("z", {"eta", "lon"}, {1, 2}, {{"coordinates", "lat_rho lon_rho"}}),
              "bay.nc: variable 'z' has a dimension 'eta' without a variable", "cdo remapbil");
  ExpectError(FakeNetcdf()
                  .Axis("lat", {1, 2}, kNorthDegrees)
                  .Axis("latitude", {1}, kNorthDegrees)
                  .Variable("z", {"lat", "latitude"}, {1, 2}),
              "bay.nc: variable 'z' has two axes of one kind", "correct their units");
  ExpectError(FakeNetcdf().Axis("lat", {1, 2}, kNorthDegrees).Variable("z", {"lat"}, {1, 2}),
              "bay.nc: variable 'z' has no axes of latitude and longitude", "file.nc:variable");
  ExpectError(FakeNetcdf()
                  .Axis("lat", {80, 100}, kNorthDegrees)
                  .Axis("lon", {1}, kEastDegrees)
                  .Variable("z", {"lat", "lon"}, {1, 2}),
              "bay.nc: variable 'z' has latitudes beyond 90 degrees", "its units are wrong");
}

TEST(CfFieldErrors, NameTimesAndLevelsThatHaveNoMeaning) {
  const auto with_axis = [](const std::string& name, const TextAttributes& texts) {
    return FakeNetcdf()
        .Axis(name, {1, 2}, texts)
        .Axis("lat", {1}, kNorthDegrees)
        .Axis("lon", {1}, kEastDegrees)
        .Variable("z", {name, "lat", "lon"}, {1, 2});
  };
  ExpectError(with_axis("time", {{"units", "months since 2000-01-01"}}),
              "bay.nc: variable 'z' has times in 'months since 2000-01-01'", "seconds, minutes");
  ExpectError(with_axis("time", {{"units", "days since 2000-01-01"}, {"calendar", "360_day"}}),
              "bay.nc: variable 'z' has times in 'days since 2000-01-01' of the calendar '360_day'",
              "standard calendar");
  ExpectError(with_axis("lev", {{"units", "sigma"}, {"axis", "Z"}}),
              "bay.nc: variable 'z' has an axis 'lev' in 'sigma'", "interpolated to depths");
}

TEST(CfField, DoesNotTakeACoordinateOfAnotherDimensionForItsAxis) {
  // 'lat' exists, of another dimension and longer: using it would read beyond the values.
  const FakeNetcdf file =
      FakeNetcdf()
          .Dimension("lat", 2)
          .Dimension("other", 9)
          .Axis("lon", {1, 2}, kEastDegrees)
          .Variable("lat", {"other"}, {1, 2, 3, 4, 5, 6, 7, 8, 9}, kNorthDegrees)
          .Variable("z", {"lat", "lon"}, {1, 2, 3, 4});
  ExpectError(file, "bay.nc: variable 'z' has a dimension 'lat' without a variable of that name",
              "add it");
}

FakeNetcdf WithDepths(const std::string& name, const std::vector<double>& points,
                      const TextAttributes& texts) {
  FakeNetcdf file;
  std::vector<double> values(points.size());
  for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  file.Axis(name, points, texts)
      .Axis("lat", {54}, kNorthDegrees)
      .Axis("lon", {10}, kEastDegrees)
      .Variable("z", {name, "lat", "lon"}, values);
  return file;
}

TEST(CfField, TakesDepthsByTheirNumbersWhereTheirAttributesPlaceThemAboveTheSurface) {
  const FakeNetcdf up = WithDepths("depth", {0, 10, 30}, {{"units", "m"}, {"positive", "up"}});
  const FakeNetcdf down =
      WithDepths("depth", {0, -10, -30}, {{"units", "m"}, {"positive", "down"}});
  const FakeNetcdf none = WithDepths("lev", {0, -10, -30}, {{"units", "m"}});
  const FakeNetcdf turned =
      WithDepths("depth", {-30, -10, 0}, {{"units", "m"}, {"positive", "down"}});
  for (const FakeNetcdf* file : {&up, &down, &none, &turned}) {
    const Result<CfField> field = Read(*file);
    ASSERT_TRUE(field.ok()) << field.error();
    EXPECT_EQ(field->depths_m, (std::vector<double>{0, 10, 30}));
    EXPECT_EQ(field->values,
              file == &turned ? (std::vector<float>{2, 1, 0}) : (std::vector<float>{0, 1, 2}));
    ASSERT_EQ(field->warnings.size(), 1U);
    EXPECT_NE(field->warnings[0].find("place all of it above the surface"), std::string::npos);
  }
}

TEST(CfField, WarnsOfDepthsThatBeginAboveTheSurface) {
  const Result<CfField> field =
      Read(WithDepths("depth", {-2, 10}, {{"units", "m"}, {"positive", "down"}}));
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_EQ(field->depths_m, (std::vector<double>{-2, 10}));
  EXPECT_EQ(field->warnings,
            std::vector<std::string>{"has an axis 'depth' that begins 2 m above the surface"});
  EXPECT_TRUE(Read(WithDepths("depth", {0, 10}, {{"positive", "down"}}))->warnings.empty());
  EXPECT_TRUE(Read(WithDepths("height", {-10, 0}, {{"positive", "up"}}))->warnings.empty());
}

TEST(CfFieldErrors, NameLevelsThatCountNoDepthsWhateverTheirUnits) {
  ExpectError(WithDepths("s_rho", {-0.75, -0.25},
                         {{"standard_name", "ocean_s_coordinate_g2"}, {"positive", "up"}}),
              "bay.nc: variable 'z' has an axis 's_rho' in ''", "interpolated to depths");
  ExpectError(WithDepths("lev", {1, 2}, {{"formula_terms", "s: lev"}, {"positive", "down"}}),
              "bay.nc: variable 'z' has an axis 'lev' in ''", "interpolated to depths");
  ExpectError(
      WithDepths("hab", {1, 2}, {{"standard_name", "height_above_sea_floor"}, {"positive", "up"}}),
      "bay.nc: variable 'z' has an axis 'hab'", "interpolated to depths");
}

TEST(CfFieldErrors, NameSharesOfTheDepthThatHaveNoUnits) {
  const std::string start = "bay.nc: variable 'z' has an axis 'depth' in ''";
  for (const std::vector<double>& shares :
       {std::vector<double>{0, 1}, {-1, 0}, {0.1, 0.5}, {-0.9, -0.1}}) {
    ExpectError(WithDepths("depth", shares, {}), "bay.nc: variable 'z' has an axis 'depth' without",
                "give it units = \"m\"");
  }
  for (const char* name : {"sigma level", "S-coordinate at RHO-points"}) {
    ExpectError(WithDepths("depth", {0, 40}, {{"long_name", name}}), start, "interpolated");
  }
  EXPECT_TRUE(Read(WithDepths("depth", {0, 1}, {{"units", "m"}})).ok());
  EXPECT_TRUE(Read(WithDepths("depth", {0, 1.5}, {})).ok());
  EXPECT_TRUE(Read(WithDepths("depth", {0, 1.5}, {}))->warnings.empty());
}

TEST(CfField, HasHeightsWhateverBlanksStandInItsAttributes) {
  const Result<CfField> field =
      Read(WithDepths("depth", {-100, 5}, {{"units", "m"}, {"positive", "up "}}));
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_EQ(field->depths_m, (std::vector<double>{-5, 100}));
}

TEST(CfFieldErrors, NameAnglesThatAreNoDegrees) {
  ExpectError(FakeNetcdf()
                  .Axis("lat", {1.03, 1.05}, {{"units", "radians"}})
                  .Axis("lon", {0.07, 0.09}, {{"units", "radians"}})
                  .Variable("z", {"lat", "lon"}, {1, 2, 3, 4}),
              "bay.nc: variable 'z' has an axis 'lon' in 'radians'", "must be in degrees");
}

TEST(CfField, HasItsBoundsAsUnpackedNumbersWhereTheyAreOfThatType) {
  const auto valid = [](NetcdfType bound_type) {
    FakeNetcdf file =
        Degrees({}, {{"scale_factor", {0.001}}, {"valid_range", {-2, 2}}}, NetcdfType::kShort);
    file.values["z"] = {-3000, -2000, -2, 2, 1000, 3000};
    for (NetcdfAttribute& each : file.header.variables.back().attributes) {
      if (each.name == "valid_range") each.type = bound_type;
    }
    std::string marks;
    const Result<CfField> field = Read(file);
    for (const float value : field->values) marks += std::isnan(value) ? '-' : 'x';
    return marks;
  };
  EXPECT_EQ(valid(NetcdfType::kFloat), "-xxxx-");
  EXPECT_EQ(valid(NetcdfType::kShort), "--xx--");
  FakeNetcdf bytes =
      Degrees({{"_Unsigned", "true"}}, {{"valid_range", {0, -2}}}, NetcdfType::kByte);
  bytes.values["z"] = {100, -1, -2, 0, 127, 1};
  const Result<CfField> field = Read(bytes);
  EXPECT_EQ(field->values[0], 100);
  EXPECT_TRUE(std::isnan(field->values[1])) << "255, and 254 is the last";
  EXPECT_EQ(field->values[2], 254);
}

TEST(CfField, CountsLongitudesFromTheMeridianOfItsMapping) {
  FakeNetcdf file = Degrees({{"grid_mapping", "crs"}});
  file.Variable("crs", {}, {}, {{"grid_mapping_name", "latitude_longitude"}},
                {{"longitude_of_prime_meridian", {2.5}}});
  EXPECT_EQ(Read(file)->x, (std::vector<double>{12.5, 13.5, 14.5}));
}

TEST(CfField, CountsTimesByTheCalendarOfTheFile) {
  const auto read = [](const TextAttributes& texts) {
    FakeNetcdf file;
    file.Axis("time", {17'758'680}, texts)
        .Axis("lat", {54}, kNorthDegrees)
        .Axis("lon", {10}, kEastDegrees)
        .Variable("z", {"time", "lat", "lon"}, {1});
    return Read(file);
  };
  constexpr double k2026_s = 1'795'478'400;  // 2026-11-24
  const TextAttributes units = {{"units", "hours since 1-1-1"}};
  EXPECT_EQ(read({{"units", "hours since 1-1-1"}, {"calendar", "standard"}})->times_s.front(),
            k2026_s);
  EXPECT_TRUE(read({{"units", "hours since 1-1-1"}, {"calendar", "standard"}})->warnings.empty());
  EXPECT_EQ(read(units)->times_s.front(), k2026_s);
  ASSERT_EQ(read(units)->warnings.size(), 1U) << "that it has no calendar";
  EXPECT_EQ(
      read({{"units", "hours since 1-1-1"}, {"calendar", "proleptic_gregorian"}})->times_s.front(),
      k2026_s + 2 * 86'400.0);
}

/// A grid with metres along X and Y, and a mapping.
FakeNetcdf Projected(const TextAttributes& mapping, const NumberAttributes& numbers,
                     const TextAttributes& texts = {{"grid_mapping", "crs"}}) {
  FakeNetcdf file;
  file.Axis("Y", {-1277, -1257}, {{"standard_name", "projection_y_coordinate"}, {"units", "km"}})
      .Axis("X", {-1011, -991}, {{"standard_name", "projection_x_coordinate"}, {"units", "km"}})
      .Variable("crs", {}, {}, mapping, numbers)
      .Variable("z", {"Y", "X"}, {1, 2, 3, 4}, texts);
  return file;
}
const NumberAttributes kArctic = {{"straight_vertical_longitude_from_pole", {58}},
                                  {"latitude_of_projection_origin", {90}},
                                  {"standard_parallel", {60}},
                                  {"earth_radius", {6'371'000}}};

TEST(CfField, HasTheProjectionOfItsGridMapping) {
  const Result<CfField> field =
      Read(Projected({{"grid_mapping_name", "polar_stereographic"}}, kArctic));
  ASSERT_TRUE(field.ok()) << field.error();
  ASSERT_TRUE(field->projection.has_value());
  EXPECT_EQ(field->x, (std::vector<double>{-1'011'000, -991'000}));
  EXPECT_NEAR(field->projection->Reverse({-991'000, -1'257'000}).lon_deg, 19.748, 1e-3);
  EXPECT_TRUE(field->warnings.empty());
}

TEST(CfField, IsOnASphereWhereItsMapHasNoFigureOfTheEarthAndWarnsOfIt) {
  NumberAttributes numbers = kArctic;
  numbers.erase("earth_radius");
  const Result<CfField> field =
      Read(Projected({{"grid_mapping_name", "polar_stereographic"}}, numbers));
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_NEAR(field->projection->Reverse({-991'000, -1'257'000}).lat_deg, 74.6636, 1e-3);
  ASSERT_EQ(field->warnings.size(), 1U);
  EXPECT_NE(field->warnings[0].find("earth_radius"), std::string::npos);
  const Result<CfField> named = Read(Projected(
      {{"grid_mapping_name", "polar_stereographic"}, {"reference_ellipsoid_name", "WGS 84"}},
      numbers));
  ASSERT_TRUE(named.ok()) << named.error();
  EXPECT_TRUE(named->warnings.empty());
  EXPECT_GT(std::abs(named->projection->Reverse({-991'000, -1'257'000}).lat_deg - 74.6636), 0.02);
}

TEST(CfFieldErrors, NameMapsThatAreNotKnown) {
  ExpectError(Projected({{"grid_mapping_name", "geostationary"}}, {}),
              "bay.nc: variable 'z' is on a map whose grid_mapping 'crs' is 'geostationary'",
              "gdalwarp");
  ExpectError(Projected({{"grid_mapping_name", "latitude_longitude"}}, {}),
              "bay.nc: variable 'z' is on a map whose grid_mapping 'crs' is 'latitude_longitude'",
              "cdo remapbil");
  ExpectError(Projected({}, {}, {{"grid_mapping", "gone"}}),
              "bay.nc: variable 'z' has the grid_mapping 'gone'", "copy that variable");
  ExpectError(
      Projected({{"grid_mapping_name", "rotated_latitude_longitude"}},
                {{"grid_north_pole_latitude", {39}}, {"grid_north_pole_longitude", {-162}}}),
      "bay.nc: variable 'z' has axes that are not those of its grid_mapping",
      "correct their standard_names");
  const Result<CfField> unmapped = Read(Projected({}, {}, {}));
  ASSERT_TRUE(unmapped.ok()) << unmapped.error();
  ASSERT_EQ(unmapped->warnings.size(), 1U);
  EXPECT_NE(unmapped->warnings[0].find("no grid_mapping"), std::string::npos);
}

FakeNetcdf Rotated(const TextAttributes& texts) {
  FakeNetcdf file;
  file.Axis("rlat", {-1, 1}, {{"standard_name", "grid_latitude"}, {"units", "degrees"}})
      .Axis("rlon", {359, 0, 1}, {{"standard_name", "grid_longitude"}, {"units", "degrees"}})
      .Variable("pole", {}, {}, {{"grid_mapping_name", "rotated_latitude_longitude"}},
                {{"grid_north_pole_latitude", {39.25}}, {"grid_north_pole_longitude", {-162}}})
      .Variable("z", {"rlat", "rlon"}, {1, 2, 3, 4, 5, 6}, texts);
  return file;
}

TEST(CfField, MayLieAboutAnotherPole) {
  const Result<CfField> field = Read(Rotated({{"grid_mapping", "pole"}}));
  ASSERT_TRUE(field.ok()) << field.error();
  ASSERT_TRUE(field->projection.has_value());
  EXPECT_FALSE(field->is_geographic);
  EXPECT_EQ(field->x, (std::vector<double>{359, 360, 361}));
  ExpectError(Rotated({}), "bay.nc: variable 'z' is on a grid about another pole", "copy");
}

/// A curvilinear grid of 2 rows and 3 columns, stored with the columns first where `is_turned`.
FakeNetcdf Curvilinear(bool is_turned, const TextAttributes& texts = {}) {
  FakeNetcdf file;
  file.Dimension("eta", 2).Dimension("xi", 3);
  file.Variable("lat_psi", {"eta"}, {0, 0}, kNorthDegrees);
  file.Variable("lat_rho", {"eta", "xi"}, {60, 60.1, 60.2, 61, 61.1, 61.2}, kNorthDegrees);
  file.Variable("lon_rho", {"eta", "xi"}, {5, 6, 7, 4.9, 5.9, 6.9}, kEastDegrees);
  if (is_turned) {
    file.Variable("z", {"xi", "eta"}, {1, 4, 2, 5, 3, 6}, texts);
  } else {
    file.Variable("z", {"eta", "xi"}, {1, 2, 3, 4, 5, 6}, texts);
  }
  return file;
}

TEST(CfField, MayHaveAPlaceOfItsOwnForEachPoint) {
  for (const bool is_turned : {false, true}) {
    const Result<CfField> field =
        Read(Curvilinear(is_turned, {{"coordinates", "lon_rho lat_rho"}}));
    ASSERT_TRUE(field.ok()) << field.error();
    EXPECT_TRUE(field->is_curvilinear());
    EXPECT_EQ(field->x.size(), 3U);
    EXPECT_EQ(field->y.size(), 2U);
    EXPECT_EQ(field->lats_deg, (std::vector<double>{60, 60.1, 60.2, 61, 61.1, 61.2}));
    EXPECT_EQ(field->lons_deg[3], 4.9);
    EXPECT_EQ(field->values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  }
}

TEST(CfField, GoesByLatitudesOfTwoDimensionsRatherThanByAxesThatCountPoints) {
  FakeNetcdf file;
  file.Axis("y", {1, 2}, {}).Axis("x", {1, 2}, {});
  file.Variable("nav_lat", {"y", "x"}, {60, 60, 61, 61}, kNorthDegrees);
  file.Variable("nav_lon", {"y", "x"}, {5, 6, 5, 6}, kEastDegrees);
  file.Variable("z", {"y", "x"}, {1, 2, 3, 4});
  const Result<CfField> field = Read(file);
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_TRUE(field->is_curvilinear());
  EXPECT_EQ(field->lats_deg.back(), 61);
}

}  // namespace shoal::cf_field_test
