#include "lib/mission/track/csv_track.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "lib/base/geodesy/local_frame.h"
#include "lib/base/geometry/angles.h"

namespace shoal::csv_track_test {

const LocalFrame& Frame() {
  static const LocalFrame frame({.lat_deg = 54.4, .lon_deg = 10.2});
  return frame;
}

Result<ReplayTrack> Parse(std::string_view text, bool underwater = false) {
  return ParseCsvTrack(text, {.name = "ferry.csv", .frame = &Frame(), .underwater = underwater});
}

std::string ErrorOf(std::string_view text, bool underwater = false) {
  const Result<ReplayTrack> track = Parse(text, underwater);
  return track.ok() ? "no error" : track.error();
}

void ExpectError(const std::string& text, const std::string& start, const std::string& remedy) {
  const std::string error = ErrorOf(text);
  EXPECT_EQ(error.substr(0, start.size()), start);
  EXPECT_NE(error.find(remedy), std::string::npos) << error;
}

TEST(CsvTrack, HasItsColumnsInAnyOrderAndOthersBeside) {
  const Result<ReplayTrack> track =
      Parse("name,Y_m,t_s,X_m\n# noted by hand\na,2,0,1\n\nb,4.5,10,-3e0\n");
  ASSERT_TRUE(track.ok()) << track.error();
  ASSERT_EQ(track->fixes().size(), 2U);
  EXPECT_EQ(track->fixes()[0].position_m, Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(track->fixes()[1].position_m, Eigen::Vector3d(-3, 4.5, 0));
  EXPECT_EQ(track->last_us(), 10'000'000);
  EXPECT_FALSE(track->columns().heading);
}

TEST(CsvTrack, TakesLatitudeAndLongitudeInTheMissionsFrame) {
  const Result<ReplayTrack> track =
      Parse("time,latitude,longitude\n2026-11-23T09:30:00Z,54.4,10.2\n1795426260,54.41,10.2\n");
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_LT(track->fixes()[0].position_m.norm(), 1e-6);
  EXPECT_EQ(track->last_us() - track->first_us(), 60'000'000);
  // A hundredth of a degree of latitude at 54.4 N: the meridian's radius of curvature times it.
  EXPECT_NEAR(track->fixes()[1].position_m.y(), 1113.16, 0.5);
}

TEST(CsvTrack, ReadsWhatShoalLogCsvWrites) {
  const Result<ReplayTrack> track = Parse(
      "time_s,utime_s,x_m,y_m,z_m,lat_deg,lon_deg,heading_deg,speed_mps,speed_over_ground_mps\n"
      "0.1,0.1,0,0,3,54.4,10.2,350,1,2\n0.2,0.2,0,0.2,4,54.4000018,10.2,10,1,2\n",
      true);
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->first_us(), 100'000);
  EXPECT_EQ(track->fixes()[1].position_m.z(), 4);
  EXPECT_EQ(track->fixes()[0].speed_mps, 2) << "over ground";
  EXPECT_NEAR(RadToDeg(track->fixes()[0].heading_rad), 350, 1e-9);
  EXPECT_TRUE(track->columns().depth && track->columns().heading && track->columns().speed);
}

TEST(CsvTrack, TakesSemicolonsTabsQuotesAndAByteOrderMark) {
  EXPECT_TRUE(Parse("t_s;x;y\r\n0;1;2\r\n").ok());
  EXPECT_TRUE(Parse("\xEF\xBB\xBFt\tx_m\ty_m\n0\t1\t2").ok());
  const Result<ReplayTrack> track =
      Parse("\"t_s\",\"x_m\",\"y_m\",\"note\"\n\"0\",\"1\",\"2\",\"a, b\"\n");
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->fixes()[0].position_m.y(), 2);
}

TEST(CsvTrack, PassesOverDepthsOfASurfaceVessel) {
  const Result<ReplayTrack> track = Parse("t_s,x_m,y_m,depth_m\n0,1,2,none\n");
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->fixes()[0].position_m.z(), 0);
}

TEST(CsvTrackErrors, NameTheLineAndTheRemedy) {
  const std::string head = "t_s,x_m,y_m,heading_deg\n";
  ExpectError("", "ferry.csv:0: the file is empty", "t_s,x_m,y_m");
  ExpectError("x_m,y_m\n1,2\n", "ferry.csv:1: no column has the time", "there is 'x_m', 'y_m'");
  ExpectError("t_s,x_m\n1,2\n", "ferry.csv:1: no columns have the place", "lat_deg and lon_deg");
  ExpectError(head, "ferry.csv: no point", "complete");
  ExpectError(head + "0,1,2\n", "ferry.csv:2: this line has 3 cells", "4 columns");
  ExpectError(head + "\n0,1,two,0\n", "ferry.csv:3: y_m is 'two'", "finite number");
  ExpectError(head + "0,nan,2,0\n", "ferry.csv:2: x_m is 'nan'", "finite number");
  ExpectError(head + "0,,2,0\n", "ferry.csv:2: x_m is ''", "leave out");
  ExpectError(head + "0,1,2,361\n", "ferry.csv:2: heading_deg is 361", "-360 to 360");
  ExpectError(head + "0,1,2,0\n0,1,2,0\n", "ferry.csv:3: the time is not after", "sort");
  ExpectError(head + "5,1,2,0\n4.5,1,2,0\n", "ferry.csv:3: the time is not after", "(-0.5 s)");
  ExpectError(head + "0,1,2,0\n1,1e4,2,0\n", "ferry.csv:3: from the point before", "leave the");
  ExpectError(head + "0,1e7,2,0\n", "ferry.csv:2: this point is 10000 km", "origin in [mission]");
  ExpectError(head + "1e300,1,2,0\n", "ferry.csv:2: t_s is '1e300'", "must be a time: seconds");
  ExpectError("time,x,y\nnoon,1,2\n", "ferry.csv:2: time is 'noon'", "2026-11-23T09:30:00Z");
  ExpectError("utime,lat,lon\n1,91,2\n", "ferry.csv:2: latitude 91", "-90 to 90");
  ExpectError("utime,lat,lon\n1,-54,-170\n", "ferry.csv:2: latitude -54", "out of reach");
  EXPECT_EQ(ErrorOf("t_s,x_m,y_m\n0,1,2\n", true).substr(0, 28), "ferry.csv: it has no depths,");
  EXPECT_NE(ErrorOf("t_s,x_m,y_m,z_m\n0,1,2,30000\n", true).find("ferry.csv:2: a depth of 30000"),
            std::string::npos);
}

TEST(CsvTrackErrors, QuoteWhatIsThereShortAndPrintable) {
  const std::string error = ErrorOf("t_s,x_m,y_m\n0,\x1b[31m" + std::string(100'000, 'x') + ",1\n");
  EXPECT_LT(error.size(), 200U);
  EXPECT_EQ(error.find('\x1b'), std::string::npos);
}

RC_GTEST_PROP(CsvTrack, SurvivesAnyDamage, ()) {
  std::string text =
      "time,lat_deg,lon_deg,heading_deg\n2026-11-23T09:30:00Z,54.4,10.2,3\n"
      "2026-11-23T09:31:00Z,54.401,10.2,359\n";
  for (int damage = *rc::gen::inRange(1, 6); damage > 0; --damage) {
    const auto at = *rc::gen::inRange<size_t>(0, text.size());
    const auto length = *rc::gen::inRange<size_t>(0, 6);
    text.replace(at, length, *rc::gen::arbitrary<std::string>());
  }
  const Result<ReplayTrack> track = Parse(text);
  const bool is_sound = track.ok() ? track->At(track->first_us()).position_m.allFinite()
                                   : track.error().starts_with("ferry.csv:");
  RC_ASSERT(is_sound);
}

}  // namespace shoal::csv_track_test
