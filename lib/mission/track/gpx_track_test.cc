#include "lib/mission/track/gpx_track.h"

#include <gtest/gtest.h>

#include <string>

#include "lib/base/geodesy/local_frame.h"

namespace shoal::gpx_track_test {

const std::string kGood =
    "<?xml version=\"1.0\"?>\n"
    "<gpx version=\"1.1\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n"
    "<wpt lat=\"1\" lon=\"2\"><time>2020-01-01T00:00:00Z</time></wpt>\n"
    "<trk><name>Ferry</name><trkseg>\n"
    "<trkpt lat=\"54.4\" lon=\"10.2\"><ele>-3.5</ele><time>2026-11-23T09:30:00Z</time></trkpt>\n"
    "<trkpt lat=\"54.401\" lon=\"10.2\"><ele>-4</ele><time>\n 2026-11-23T09:31:00Z</time>\n"
    "<extensions><time>never</time></extensions></trkpt>\n"
    "</trkseg><trkseg>\n"
    "<trkpt lat=\"54.402\" lon=\"10.2\"><time>2026-11-23T09:32:00Z</time><ele>-5</ele></trkpt>\n"
    "</trkseg></trk></gpx>\n";

Result<ReplayTrack> Parse(std::string_view text, bool underwater = false) {
  static const LocalFrame frame({.lat_deg = 54.4, .lon_deg = 10.2});
  return ParseGpxTrack(text, {.name = "ferry.gpx", .frame = &frame, .underwater = underwater});
}

std::string With(const std::string& old_part, const std::string& new_part) {
  std::string text = kGood;
  text.replace(text.find(old_part), old_part.size(), new_part);
  return text;
}

void ExpectError(const std::string& text, const std::string& start, const std::string& remedy,
                 bool underwater = false) {
  const Result<ReplayTrack> track = Parse(text, underwater);
  const std::string error = track.ok() ? "no error" : track.error();
  EXPECT_EQ(error.substr(0, start.size()), start);
  EXPECT_NE(error.find(remedy), std::string::npos) << error;
}

TEST(GpxTrack, IsThePointsOfAllItsSegments) {
  const Result<ReplayTrack> track = Parse(kGood);
  ASSERT_TRUE(track.ok()) << track.error();
  ASSERT_EQ(track->fixes().size(), 3U);
  EXPECT_LT(track->fixes()[0].position_m.norm(), 1e-6);
  EXPECT_NEAR(track->fixes()[2].position_m.y(), 222.6, 0.1);
  EXPECT_EQ(track->fixes()[1].position_m.z(), 0) << "of a surface vessel ele is a height";
  EXPECT_EQ(track->last_us() - track->first_us(), 120'000'000);
}

TEST(GpxTrack, HasDepthsWhereItIsUnderWater) {
  const Result<ReplayTrack> track = Parse(kGood, true);
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->fixes()[0].position_m.z(), 3.5);
  EXPECT_EQ(track->fixes()[2].position_m.z(), 5);
}

TEST(GpxTrack, MayHaveAPrefixAndAnyEncodingOfXml) {
  const Result<ReplayTrack> track = Parse(
      "<g:gpx xmlns:g='x'><g:trk><g:trkseg><g:trkpt lon='10.2' lat='54.4'>"
      "<g:time>2026-11-23T09:30:00&#90;</g:time></g:trkpt></g:trkseg></g:trk></g:gpx>");
  EXPECT_TRUE(track.ok()) << track.error();
}

TEST(GpxTrackErrors, NameTheLineAndTheRemedy) {
  ExpectError("", "ferry.gpx:1: this is no sound XML (no element found)", "complete");
  ExpectError("t_s,x_m,y_m\n", "ferry.gpx:1: this is no sound XML", "GPX");
  ExpectError("<kml></kml>", "ferry.gpx:1: the document is <kml>", "must be <gpx>");
  ExpectError("<gpx><rte/></gpx>", "ferry.gpx: no <trkpt> in it", "export the track");
  ExpectError(kGood.substr(0, kGood.size() - 30), "ferry.gpx:10: this is no sound XML", "complete");
  ExpectError(With("<trkseg>", "<trkseg><b>"), "ferry.gpx:9: this is no sound XML (mismatched",
              "complete");
  ExpectError(With("lat=\"54.401\"", "lat=\"north\""), "ferry.gpx:6: this <trkpt> needs two",
              "lat=");
  ExpectError(With("lat=\"54.401\"", "lat=\"inf\""), "ferry.gpx:6: this <trkpt> needs two", "lat=");
  ExpectError(With("lat=\"54.401\"", "lat=\"95\""), "ferry.gpx:6: latitude 95", "-90 to 90");
  ExpectError(With("09:31:00Z", "09:61:00Z"), "ferry.gpx:7: <time> is '2026-11-23T09:61", "ISO");
  ExpectError(With("09:31:00Z", "09:29:00Z"), "ferry.gpx:6: the time is not after", "sort");
  ExpectError(With("<time>2026-11-23T09:30:00Z</time>", ""), "ferry.gpx:5: this <trkpt> has no",
              "with its times");
  ExpectError(With("<ele>-4</ele>", "<ele>deep</ele>"), "ferry.gpx:6: <ele> is 'deep'", "finite",
              true);
  ExpectError(With("<ele>-4</ele>", ""), "ferry.gpx:6: this <trkpt> has no <ele>", "-12", true);
  ExpectError(With("lat=\"54.402\" lon=\"10.2\">", "lat=\"54.402\" lon=\"10.2\"><trkpt/>"),
              "ferry.gpx:10: a <trkpt> within a <trkpt>", "damaged");
}

TEST(GpxTrackErrors, ComeBeforeAnyEntityGrows) {
  ExpectError(
      "<!DOCTYPE gpx [<!ENTITY a \"xxxxxxxxxx\"><!ENTITY b \"&a;&a;&a;&a;&a;\">]>\n<gpx>&b;</gpx>",
      "ferry.gpx:1: a DOCTYPE has no place in GPX", "remove");
}

}  // namespace shoal::gpx_track_test
