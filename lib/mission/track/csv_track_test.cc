#include "lib/mission/track/csv_track.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

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

std::string Warnings(std::string_view text, const TrackSource& source) {
  std::vector<std::string> warnings;
  const Result<ReplayTrack> track = ParseCsvTrack(text, source, &warnings);
  std::string all = track.ok() ? "" : "error: " + track.error();
  for (const std::string& warning : warnings) all += warning + "\n";
  return all;
}

std::string Warnings(std::string_view text, bool underwater = false) {
  return Warnings(text, {.name = "ferry.csv", .frame = &Frame(), .underwater = underwater});
}

TEST(CsvTrack, TakesTheLastOfPointsOfOneTimeAndWarns) {
  const std::string text = "t_s,x_m,y_m\n0,0,0\n1,1,0\n1,2,0\n1,3,0\n2,4,0\n";
  const Result<ReplayTrack> track = Parse(text);
  ASSERT_TRUE(track.ok()) << track.error();
  ASSERT_EQ(track->fixes().size(), 3U);
  EXPECT_EQ(track->fixes()[1].position_m.x(), 3);
  EXPECT_EQ(Warnings(text),
            "ferry.csv:4: 2 of its points have the time of the point before: the last of each time "
            "counts\n");
  EXPECT_EQ(Warnings("t_s,x_m,y_m\n0,0,0\n1,1,0\n"), "");
}

TEST(CsvTrack, RefusesPointsOfOneTimeThatAreFarApart) {
  EXPECT_EQ(ErrorOf("t_s,x_m,y_m\n0,0,0\n0,50,0\n1,51,0\n"), "no error");
  EXPECT_NE(ErrorOf("t_s,x_m,y_m\n0,0,0\n0,50.5,0\n").find("ferry.csv:3: "), std::string::npos);
  // Step by step is as far.
  EXPECT_NE(ErrorOf("t_s,x_m,y_m\n0,0,0\n0,30,0\n0,60,0\n").find("ferry.csv:4: "),
            std::string::npos);
  // The last of a time is within reach of the point before it.
  EXPECT_NE(ErrorOf("t_s,x_m,y_m\n0,0,0\n0.5,20,0\n0.5,40,0\n").find("would go at 80 m/s"),
            std::string::npos);
}

TEST(CsvTrack, TakesHeadingsAndSpeedsThatAreUnknownFromItsPoints) {
  for (const char* unknown : {"", "nan", "NaN", "NULL", "none", "N/A", "-", "511", "511.0"}) {
    const Result<ReplayTrack> track =
        Parse("t_s,x_m,y_m,heading\n0,0,0," + std::string(unknown) + "\n10,20,0,45\n20,40,0,45\n");
    ASSERT_TRUE(track.ok()) << unknown << ": " << track.error();
    EXPECT_NEAR(RadToDeg(track->At(0).heading_rad), 90, 1e-9) << unknown;
    EXPECT_NEAR(RadToDeg(track->At(10'000'000).heading_rad), 45, 1e-9) << unknown;
  }
  const Result<ReplayTrack> track =
      Parse("t_s,x_m,y_m,sog_mps\n0,0,0,4\n10,20,0,\n20,40,0,4\n30,60,0,4\n");
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_NEAR(track->At(5'000'000).speed_mps, 2, 1e-12);
  EXPECT_NEAR(track->At(25'000'000).speed_mps, 4, 1e-12);
}

TEST(CsvTrack, OfAShipInAisGoesWhereItsPointsAre) {
  const Result<ReplayTrack> track = Parse(
      "MMSI,Timestamp,LAT,LON,SOG,COG,Heading\n"
      "211,2024-05-01T10:00:00,54.4,10.2,5.0,90.0,511\n"
      "211,2024-05-01T10:01:00,54.4,10.2024,5.0,90.0,511\n");
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_NEAR(RadToDeg(track->At(track->first_us()).heading_rad), 90, 1e-2);
}

TEST(CsvTrack, LiesOnLongitudesOfEitherKindAndAcrossTheDateLine) {
  const LocalFrame frame({.lat_deg = -17, .lon_deg = 179.999});
  const Result<ReplayTrack> track =
      ParseCsvTrack("t_s,lat,lon\n0,-17,179.999\n60,-17,-179.999\n120,-17,180.003\n180,-17,-180\n",
                    {.name = "ferry.csv", .frame = &frame});
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_NEAR(track->fixes()[1].position_m.x(), 2 * 106.5, 0.1);
  EXPECT_NEAR(track->fixes()[2].position_m.x(), 4 * 106.5, 0.2);
  EXPECT_NEAR(track->fixes()[3].position_m.x(), 106.5, 0.1);
}

TEST(CsvTrack, AboveTheSurfaceIsRefusedWithTheKeyThatTurnsIt) {
  const std::string text =
      "time,lat,lon,depth\n2024-05-01T10:00:00Z,54.4,10.2,-5\n"
      "2024-05-01T10:01:00Z,54.401,10.2,-6\n";
  const std::string error = ErrorOf(text, true);
  EXPECT_TRUE(error.starts_with("ferry.csv:3: this point is 6 m above the surface")) << error;
  EXPECT_NE(error.find("write depth_positive = \"up\""), std::string::npos) << error;
  EXPECT_EQ(ErrorOf(text, false), "no error") << "its depths do not count";
  const Result<ReplayTrack> track = ParseCsvTrack(
      text, {.frame = &Frame(), .underwater = true, .depth_positive = DepthPositive::kUp});
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->fixes()[1].position_m.z(), 6);
}

TEST(CsvTrack, TurnedTheWrongWayIsRefusedWithTheOtherWord) {
  const Result<ReplayTrack> track =
      ParseCsvTrack("t_s,x_m,y_m,depth\n0,0,0,5\n60,1,0,6\n",
                    {.frame = &Frame(), .underwater = true, .depth_positive = DepthPositive::kUp});
  ASSERT_FALSE(track.ok());
  EXPECT_NE(track.error().find("write depth_positive = \"down\""), std::string::npos)
      << track.error();
}

TEST(CsvTrack, TakesNoiseAtTheSurfaceAsTheSurfaceAndWarns) {
  const std::string text = "t_s,x_m,y_m,z_m\n0,0,0,-0.3\n60,1,0,8\n120,2,0,-1.5\n";
  const Result<ReplayTrack> track = Parse(text, true);
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->fixes()[0].position_m.z(), 0);
  EXPECT_EQ(track->fixes()[1].position_m.z(), 8);
  EXPECT_EQ(track->fixes()[2].position_m.z(), 0);
  EXPECT_EQ(Warnings(text, true),
            "ferry.csv:2: 2 of its points are above the surface, by up to 1.5 m: they count as on "
            "it\n");
  const std::string error = ErrorOf("t_s,x_m,y_m,z_m\n0,0,0,0\n60,1,0,8\n120,2,0,-2.5\n", true);
  EXPECT_TRUE(
      error.starts_with("ferry.csv:4: this point is 2.5 m above the surface, and others are "
                        "up to 8 m below it"))
      << error;
}

TEST(CsvTrack, ThatNeverDivesOrMovesIsAWarning) {
  EXPECT_EQ(Warnings("t_s,x_m,y_m,z_m\n0,0,0,0\n60,1,0,0\n", true),
            "ferry.csv: no point is below the surface: it never dives\n");
  EXPECT_EQ(Warnings("t_s,x_m,y_m,z_m\n0,0,0,9.5\n60,1,0,-10.5\n"),
            "ferry.csv: z_m goes to -10.5 m, and does not count without underwater = true\n");
  EXPECT_EQ(Warnings("t_s,x_m,y_m\n0,5,5\n60,5,5\n"),
            "ferry.csv: its 2 points are all at one place: it never moves\n");
  EXPECT_EQ(Warnings("t_s,x_m,y_m\n0,5,5\n"),
            "ferry.csv: its points have one time in all: it lies still\n");
  EXPECT_EQ(Warnings("time,x_m,y_m\n1980-01-06T00:00Z,0,0\n1980-01-06T02:30Z,5,5\n"),
            "ferry.csv:3: this point is 2.5 h after the one before: it goes there straight and "
            "steadily\n");
  const LocalFrame null_island({.lat_deg = 0.001, .lon_deg = 0});
  EXPECT_EQ(
      Warnings("t_s,lat,lon\n0,0,0\n60,0.001,0\n", {.name = "ferry.csv", .frame = &null_island}),
      "ferry.csv:2: 1 of its points are at latitude 0, longitude 0, which receivers write "
      "without a fix\n");
}

/// A vessel that goes East at 5 m/s for 100 s, each line with `more` in the last column.
std::string Eastward(const std::string& column, const std::string& more, double unit_s = 1) {
  std::string text = "t_s,x_m,y_m," + column + "\n";
  for (int i = 0; i <= 10; ++i) {
    text += std::to_string(10 * i * unit_s) + "," + std::to_string(50 * i) + ",0," + more + "\n";
  }
  return text;
}

TEST(CsvTrack, WarnsOfSpeedsInAnotherUnit) {
  EXPECT_EQ(Warnings(Eastward("sog_mps", "5")), "");
  EXPECT_EQ(Warnings(Eastward("sog_mps", "7.9")), "") << "5 m/s in a current";
  EXPECT_EQ(Warnings(Eastward("sog_mps", "")), "");
  EXPECT_EQ(Warnings(Eastward("sog_mps", "9.72")),
            "ferry.csv: its speeds are 9.72 m/s on average, and from point to point it goes at 5 "
            "m/s: are speeds in m/s, and times in the unit of their column?\n");
  EXPECT_NE(Warnings(Eastward("sog_mps", "3.1")), "");
  EXPECT_NE(Warnings(Eastward("sog_mps", "0")), "") << "zeros in place of unknown speeds";
  EXPECT_EQ(Warnings(Eastward("sog_mps", "9.72", 3.1)), "") << "points too rare to know";
  EXPECT_EQ(Warnings("t_s,x_m,y_m,sog_mps\n0,0,0,0\n10,4,0,0\n20,0,0,0\n"), "") << "at anchor";
  // Milliseconds in a column of seconds.
  EXPECT_NE(Warnings("t_s,x_m,y_m,sog_mps\n0,0,0,5\n25,0.125,0,5\n"), "");
}

TEST(CsvTrack, WarnsOfHeadingsInAnotherUnitOrOfZeros) {
  EXPECT_EQ(Warnings(Eastward("heading", "90")), "");
  EXPECT_EQ(Warnings(Eastward("heading", "149")), "") << "in a strong current";
  EXPECT_EQ(Warnings(Eastward("heading", "-270")), "");
  EXPECT_EQ(Warnings(Eastward("heading", "511")), "");
  EXPECT_EQ(Warnings(Eastward("heading", "0")),
            "ferry.csv: its headings and its way from point to point are 90 degrees apart: are "
            "headings in degrees, true, clockwise from North, and empty where unknown?\n");
  EXPECT_NE(Warnings(Eastward("heading", "1.5708")), "") << "radians";
  EXPECT_NE(Warnings(Eastward("heading", "-90")), "") << "counted the other way round";
  EXPECT_NE(Warnings(Eastward("heading", "151")), "");
  EXPECT_EQ(Warnings("t_s,x_m,y_m,heading\n0,0,0,0\n10,4,0,0\n20,0,0,0\n"), "") << "at anchor";
}

/// Two boats near each other, in turns.
const std::string kTwoBoats =
    "mmsi,t_s,x_m,y_m,vessel_name\n211,0,0,0,Anna\n219,0,0,9,Berta\n211,10,20,0,Anna\n"
    "219,10,20,9,Berta\n,15,3,3,\n219,20,40,9,Berta\n";

TEST(CsvTrack, OfSeveralVesselsIsThatOfTheOneThatIsChosen) {
  EXPECT_EQ(ErrorOf(kTwoBoats),
            "ferry.csv: it has lines of several vessels: choose one by name = \"...\" beside file; "
            "by mmsi it has '211' (2 lines), '219' (3 lines)");
  for (const char* name : {"Berta", "219"}) {
    const Result<ReplayTrack> track = ParseCsvTrack(kTwoBoats, {.frame = &Frame(), .vessel = name});
    ASSERT_TRUE(track.ok()) << track.error();
    ASSERT_EQ(track->fixes().size(), 3U);
    EXPECT_EQ(track->fixes()[2].position_m, Eigen::Vector3d(40, 9, 0));
  }
}

TEST(CsvTrackErrors, NameTheVesselsThatAre) {
  const auto error_of = [](const std::string& text, const TrackSource& source) {
    const Result<ReplayTrack> track = ParseCsvTrack(text, source);
    return track.ok() ? "no error" : track.error();
  };
  EXPECT_EQ(error_of(kTwoBoats, {.frame = &Frame(), .vessel = "Carla"}),
            "track: no line is of the vessel 'Carla'; by mmsi it has '211' (2 lines), '219' (3 "
            "lines)");
  const std::string one = "t_s,x_m,y_m\n0,0,0\n";
  EXPECT_TRUE(
      error_of(one, {.frame = &Frame(), .vessel = "Anna"})
          .starts_with("track:1: name = chooses a vessel, and no column has it: name one of "
                       "mmsi, imo, "));
  EXPECT_TRUE(error_of(one, {.frame = &Frame(), .number = 2})
                  .starts_with("track:1: number = chooses a track of GPX"));
  std::string many = "mmsi,t_s,x_m,y_m\n";
  for (int i = 0; i < 1200; ++i) many += std::to_string(i) + ",0,0,0\n";
  const std::string error = error_of(many, {.frame = &Frame()});
  EXPECT_LT(error.size(), 400U) << error;
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
  ExpectError(head + "0,\"1,5\",2,0\n", "ferry.csv:2: x_m is '1,5'", "with a decimal point");
  ExpectError(head + "0,1,5,2,0\n", "ferry.csv:2: this line has 5 cells", "decimals have a point");
  ExpectError(head + "0,,2,0\n", "ferry.csv:2: x_m is ''", "leave out");
  ExpectError(head + "0,1,2,361\n", "ferry.csv:2: heading_deg is 361", "-360 to 360");
  ExpectError(head + "0,1,2,0\n0,52,2,0\n", "ferry.csv:3: this point has the time of the point",
              "leave one vessel");
  ExpectError(head + "5,1,2,0\n4.5,1,2,0\n", "ferry.csv:3: the time is not after", "(-0.5 s)");
  ExpectError(head + "0,1,2,0\n1,1e4,2,0\n", "ferry.csv:3: from the point before", "leave the");
  ExpectError(head + "0,1e7,2,0\n", "ferry.csv:2: this point is 10000 km", "origin in [mission]");
  ExpectError(head + "1e300,1,2,0\n", "ferry.csv:2: t_s is '1e300'", "must be a time: seconds");
  ExpectError("time,x,y\nnoon,1,2\n", "ferry.csv:2: time is 'noon'", "2026-11-23T09:30:00Z");
  ExpectError("utime,lat,lon\n1,91,2\n", "ferry.csv:2: latitude 91", "-90 to 90");
  ExpectError("utime,lat,lon\n1,-54,-170\n", "ferry.csv:2: latitude -54", "out of reach");
  ExpectError("utime,lat,lon\n1,64.4,10.2\n", "ferry.csv:2: latitude 64.4, longitude 10.2 is 1125",
              "set origin in [mission]");
  ExpectError("utime,lat,lon\n1,0,0\n", "ferry.csv:2: latitude 0, longitude 0", "without a fix");
  ExpectError("utime,lat,lon\n1,10.2,54.4\n", "ferry.csv:2: latitude 10.2", "swapped");
  ExpectError("utime,lat,lon\n1,5424.1,1012.5\n", "ferry.csv:2: latitude 5424.1", "-90 to 90");
  ExpectError("utime,lat,lon\n1,100.2,54.4\n", "ferry.csv:2: latitude 100.2",
              "are the two swapped");
  ExpectError("utime,lat,lon\n1,54.4,360.5\n", "ferry.csv:2: latitude 54.4, longitude 360.5",
              "-180 to 360");
  ExpectError(head + "0,1,2,512\n", "ferry.csv:2: heading_deg is 512", "or empty: unknown");
  ExpectError("t_s,x,y,sog_mps\n0,1,2,51\n", "ferry.csv:2: sog_mps is 51", "or empty: unknown");
  ExpectError(std::string("\xFF\xFEt\0_\0s\0", 8), "ferry.csv:0: this is not a table in UTF-8",
              "save it as CSV in UTF-8");
  ExpectError(std::string("t\0_\0s\0", 6), "ferry.csv:0: this is not a table in UTF-8", "UTF-16");
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
