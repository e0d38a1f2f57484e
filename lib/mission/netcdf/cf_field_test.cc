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
              "make the file anew");
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

}  // namespace shoal::cf_field_test
