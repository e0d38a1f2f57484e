#include "lib/sea/ocean/esri_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace shoal::esri_grid_test {

constexpr const char* kHeader = "ncols 3\nnrows 2\nxllcorner 500\nyllcorner 6000\ncellsize 10\n";
const std::string kGood = std::string(kHeader) + "-30 -40 -50\n-10 -20 -60\n";

std::string ErrorOf(const std::string& text, const EsriGridOptions& options = {.name = "bay.asc"}) {
  const Result<DepthGrid> grid = ParseEsriGrid(text, options);
  return grid.ok() ? "no error" : grid.error();
}

void ExpectError(const std::string& text, const std::string& start, const std::string& remedy) {
  const std::string error = ErrorOf(text);
  EXPECT_EQ(error.substr(0, start.size()), start);
  EXPECT_NE(error.find(remedy), std::string::npos) << error;
}

/// Returns the good text with one part replaced.
std::string With(const std::string& old_part, const std::string& new_part) {
  std::string text = kGood;
  text.replace(text.find(old_part), old_part.size(), new_part);
  return text;
}

TEST(EsriGrid, HasItsNorthernmostRowFirstAndItsPointsInTheMiddleOfCells) {
  Result<DepthGrid> grid = ParseEsriGrid(kGood, {});
  ASSERT_TRUE(grid.ok()) << grid.error();
  EXPECT_EQ(grid->DepthAt({505, 6005}), 10);
  EXPECT_EQ(grid->DepthAt({525, 6005}), 60);
  EXPECT_EQ(grid->DepthAt({505, 6015}), 30);
  EXPECT_DOUBLE_EQ(grid->DepthAt({510, 6010}), 25);
}

TEST(EsriGrid, MayGiveTheMiddleOfItsCorner) {
  Result<DepthGrid> grid = ParseEsriGrid(
      "NCOLS 1\r\nNRows 2\r\nxllCenter 5\r\nyllcenter 7\r\ndx 1\r\ndy 2\r\n\r\n-3\r\n-4", {});
  ASSERT_TRUE(grid.ok()) << grid.error();
  EXPECT_EQ(grid->DepthAt({5, 7}), 4);
  EXPECT_EQ(grid->DepthAt({5, 9}), 3);
}

TEST(EsriGrid, IsMovedToTheMissionsOrigin) {
  Result<DepthGrid> grid = ParseEsriGrid(kGood, {.mission_origin_m = {505, 6005}});
  ASSERT_TRUE(grid.ok());
  EXPECT_EQ(grid->DepthAt({0, 0}), 10);
}

TEST(EsriGrid, HoldsDepthsOrElevations) {
  Result<DepthGrid> depths = ParseEsriGrid(With("-10", "10"), {.values = GridValues::kDepth});
  ASSERT_TRUE(depths.ok());
  EXPECT_EQ(depths->DepthAt({505, 6005}), 10);
  Result<DepthGrid> land = ParseEsriGrid(With("-10", "+10"), {});
  ASSERT_TRUE(land.ok());
  EXPECT_EQ(land->DepthAt({505, 6005}), 0);
}

TEST(EsriGrid, FillsItsGapsWhereTheMissionStatesHow) {
  const std::string text = With("-20", "-9999");
  ExpectError(text, "bay.asc:7: column 2 has no data", "fill the map's gaps");
  Result<DepthGrid> grid = ParseEsriGrid(text, {.nodata_depth_m = 15});
  ASSERT_TRUE(grid.ok());
  EXPECT_EQ(grid->DepthAt({515, 6005}), 15);
  ExpectError("nodata_value -1\n" + With("-20", "-1"), "bay.asc:8: column 2 has no data", "gaps");
}

TEST(EsriGrid, HasNoDataWhereItsNumbersAreNan) {
  for (const char* nan : {"nan", "NaN", "-nan", "1.#QNAN", "-1.#IND"}) {
    const std::string body = With("-20", nan);
    ExpectError(body, "bay.asc:7: column 2 has no data", "gaps");
    for (const std::string& text :
         {body, "NODATA_value -9999\n" + body, "NODATA_value " + std::string(nan) + "\n" + body}) {
      Result<DepthGrid> grid = ParseEsriGrid(text, {.nodata_depth_m = 15});
      ASSERT_TRUE(grid.ok()) << grid.error();
      EXPECT_EQ(grid->DepthAt({515, 6005}), 15) << nan;
    }
  }
  Result<DepthGrid> first = ParseEsriGrid(With("-30", "nan"), {.nodata_depth_m = 15});
  ASSERT_TRUE(first.ok()) << "the first number is one too: " << first.error();
  EXPECT_EQ(first->DepthAt({505, 6015}), 15);
}

TEST(EsriGrid, TakesCommonMarksForNoDataWhereNoOtherNumberIsNearThem) {
  for (const char* number : {"-9999", "9999", "-999"}) {
    const std::string text = "NODATA_value -1\n" + With("-20", number);
    ExpectError(text, "bay.asc:", "and none near it: it is taken to mark cells without data");
    const Result<EsriField> field = ParseEsriField(text, {.nodata_depth_m = 15});
    ASSERT_TRUE(field.ok()) << field.error();
    EXPECT_EQ(field->gap_marks.size(), 1U) << number;
    EXPECT_EQ(DepthGrid(field->frame, field->values).DepthAt({515, 6005}), 15) << number;
  }
  Result<DepthGrid> nan =
      ParseEsriGrid("NODATA_value nan\n" + With("-20", "-9999"), {.nodata_depth_m = 15});
  ASSERT_TRUE(nan.ok()) << nan.error();
  EXPECT_EQ(nan->DepthAt({515, 6005}), 15);
  std::string slope = With("-20", "-9999");
  slope.replace(slope.find("-10"), 3, "-9500");
  Result<DepthGrid> trench = ParseEsriGrid("NODATA_value -1\n" + slope, {});
  ASSERT_TRUE(trench.ok()) << trench.error();
  EXPECT_EQ(trench->DepthAt({515, 6005}), 9999) << "a slope leads there";
}

TEST(EsriGrid, HasNoDataWithinAMillionthOfItsMarkAndBeyond1e30) {
  const auto depth_m = [](const std::string& mark, const std::string& number) {
    Result<DepthGrid> grid =
        ParseEsriGrid("NODATA_value " + mark + "\n" + With("-20", number), {.nodata_depth_m = 15});
    return grid.ok() ? grid->DepthAt({515, 6005}) : -1;
  };
  EXPECT_EQ(depth_m("-3.39999999999999996e+38", "-3.3999999521443642e+38"), 15);
  EXPECT_EQ(depth_m("-9999.9", "-9999.900390625"), 15);
  EXPECT_EQ(depth_m("-9999", "3.4028234e+38"), 15) << "beyond 1e30 no number is a depth";
  EXPECT_EQ(depth_m("-5000", "-5000.0049"), 15);
  EXPECT_NEAR(depth_m("-5000", "-5000.0051"), 5000.0051, 1e-3);
  EXPECT_EQ(depth_m("-9999", "-1e29"), -1) << "further from the surface than 20 km";
  EXPECT_NEAR(depth_m("0", "-0.25"), 0.25, 1e-9);
}

TEST(EsriGrid, MayBreakItsLinesAnywhere) {
  for (const char* rows : {"-30 -40 -50 -10 -20 -60", "-30 -40\n-50 -10\n-20 -60\n",
                           "-30\n-40\n\n-50 -10 -20\r\n-60\r\n", " -30 -40 -50 -10\n-20 -60"}) {
    Result<DepthGrid> grid = ParseEsriGrid(kHeader + std::string(rows), {});
    ASSERT_TRUE(grid.ok()) << grid.error();
    EXPECT_EQ(grid->DepthAt({505, 6015}), 30) << rows;
    EXPECT_EQ(grid->DepthAt({505, 6005}), 10) << rows;
    EXPECT_EQ(grid->DepthAt({525, 6005}), 60) << rows;
  }
  ExpectError(kHeader + std::string("-30 -40\n-50 -10\n-20"),
              "bay.asc:8: the text ends after 5 of 6 numbers", "complete");
  ExpectError(kHeader + std::string("-30 -40 -50 -10\n-20 -60 -70"),
              "bay.asc:6: this line has 4 numbers, and ncols is 3", "correct the header");
}

TEST(EsriGrid, CountsOnWhichSideOfZeroItsNumbersAre) {
  const Result<EsriField> field =
      ParseEsriField(With("-10 -20", "0 7") + "", {.nodata_depth_m = 1});
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_EQ(field->signs.num_negative, 4U);
  EXPECT_EQ(field->signs.num_zero, 1U);
  EXPECT_EQ(field->signs.num_positive, 1U);
  const Result<EsriField> gaps =
      ParseEsriField(With("-10 -20", "nan -9999"), {.nodata_depth_m = 1});
  EXPECT_EQ(gaps->signs.num(), 4U) << "gaps are on neither side";
}

TEST(EsriGrid, WithAByteOrderMarkIsRead) {
  EXPECT_TRUE(ParseEsriGrid("\xEF\xBB\xBF" + kGood, {}).ok());
}

TEST(EsriGrid, HoldsVelocitiesOfAnySignAndGaps) {
  const EsriGridOptions options = {.name = "u.asc", .values = GridValues::kVelocity};
  Result<EsriField> field =
      ParseEsriField(std::string(kHeader) + "-0.5 0.25 -9999\n1 2 3\n", options);
  ASSERT_TRUE(field.ok()) << field.error();
  EXPECT_EQ(field->frame.south_west_m, Eigen::Vector2d(505, 6005));
  EXPECT_EQ(field->values[2], 3);
  EXPECT_EQ(field->values[3], -0.5F);
  EXPECT_TRUE(std::isnan(field->values[5]));
  EXPECT_EQ(ErrorOf(std::string(kHeader) + "-0.5 0.25 99\n1 2 3\n", options),
            "u.asc:6: column 3 is faster than 50 m/s; is it the mark for no data? Then set "
            "NODATA_value");
}

TEST(EsriGridErrors, NameTheLineAndTheRemedy) {
  ExpectError("", "bay.asc:0: the text ends before the first row", "complete");
  ExpectError("PK\x03\x04x",
              "bay.asc:1: 'PK?"
              "?x' is neither",
              "export");
  ExpectError(With("cellsize", "cellsze"), "bay.asc:5: 'cellsze' is neither", "export");
  ExpectError(With("cellsize 10\n", ""), "bay.asc:5: the header before this line has no cellsize",
              "add it");
  ExpectError(With("nrows 2", "nrows two"), "bay.asc:2: nrows needs a number, not 'two'", "");
  ExpectError(With("nrows 2", "nrows nan"), "bay.asc:2: nrows needs a number, not 'nan'", "");
  ExpectError(With("nrows 2", "nrows 2 3"), "bay.asc:2: nrows takes one number", "remove");
  ExpectError(With("nrows 2", "ncols 2"), "bay.asc:2: ncols stands here for the second", "remove");
  ExpectError(With("nrows 2", "nrows 2.5"), "bay.asc:2: ncols and nrows must be whole", "");
  ExpectError(With("cellsize 10", "cellsize 0.004166"),
              "bay.asc:5: cellsize must be from 0.05 to 1000000 metres", "projected");
  ExpectError(With("-40 ", ""), "bay.asc:6: this line has 2 numbers, and ncols is 3", "complete");
  ExpectError(With("-40", "-40 -41"), "bay.asc:6: this line has 4 numbers, and ncols is 3",
              "there are more numbers than the 6 of ncols and nrows");
  ExpectError(With("-40", "4o"), "bay.asc:6: '4o' is not a number", "");
  ExpectError(With("-40", "inf"), "bay.asc:6: 'inf' is not a number", "");
  ExpectError(With("-40", "-32768"), "bay.asc:6: column 2 is further", "NODATA_value");
  ExpectError(With("nrows 2", "nrows 3"), "bay.asc:7: the text ends after 6 of 9 numbers",
              "complete");
  ExpectError(With("nrows 2", "nrows 1"),
              "bay.asc:7: there are more numbers than the 3 of ncols and nrows", "header");
}

TEST(EsriGridErrors, ComeBeforeAnyMemoryIsTakenForAHugeHeader) {
  ExpectError(With("ncols 3\nnrows 2", "ncols 16000000\nnrows 16000000"),
              "bay.asc:2: ncols times nrows is more than 16000000", "cut out");
  ExpectError(With("ncols 3", "ncols 1e300"), "bay.asc:1: ncols must be from 1 to", "");
  ExpectError(With("ncols 3", "ncols -3"), "bay.asc:1: ncols must be from 1 to", "");
  ExpectError(With("ncols 3\nnrows 2", "ncols 4000\nnrows 4000"),
              "bay.asc:7: the text ends after 6 of", "complete");
}

TEST(EsriGridErrors, QuoteWhatIsThereShortAndPrintable) {
  const std::string error = ErrorOf(std::string(100'000, 'x') + "\x1b[31m");
  EXPECT_LT(error.size(), 200U);
  EXPECT_EQ(ErrorOf("\x1b\x07").find('\x1b'), std::string::npos);
}

RC_GTEST_PROP(EsriGrid, SurvivesAnyDamage, ()) {
  std::string text = kGood;
  for (int damage = *rc::gen::inRange(1, 6); damage > 0; --damage) {
    const auto at = *rc::gen::inRange<size_t>(0, text.size());
    const auto length = *rc::gen::inRange<size_t>(0, 6);
    text.replace(at, length, *rc::gen::arbitrary<std::string>());
  }
  Result<DepthGrid> grid = ParseEsriGrid(text, {});
  if (!grid.ok()) {
    RC_ASSERT(grid.error().starts_with("grid:"));
    return;
  }
  const double depth_m = grid->DepthAt({512, 6011});
  RC_ASSERT(depth_m >= 0);
  RC_ASSERT(depth_m <= 20'000);
}

}  // namespace shoal::esri_grid_test
