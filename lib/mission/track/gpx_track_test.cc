#include "lib/mission/track/gpx_track.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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

TrackSource Source(bool underwater = false) {
  static const LocalFrame frame({.lat_deg = 54.4, .lon_deg = 10.2});
  return {.name = "ferry.gpx", .frame = &frame, .underwater = underwater};
}

Result<ReplayTrack> Parse(std::string_view text, bool underwater = false) {
  return ParseGpxTrack(text, Source(underwater));
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

/// A point at 54.4 N or a little North of it, with a time of 2024-05-01.
std::string Point(double north_deg, double lon_deg, const std::string& time,
                  const std::string& ele = "") {
  return "<trkpt lat=\"" + std::to_string(54.4 + north_deg) + "\" lon=\"" +
         std::to_string(lon_deg) + "\">" + (ele.empty() ? "" : "<ele>" + ele + "</ele>") +
         "<time>2024-05-01T" + time + "Z</time></trkpt>\n";
}

std::string Track(const std::string& name, const std::string& points) {
  return "<trk>" + (name.empty() ? "" : "<name>" + name + "</name>") + "<trkseg>\n" + points +
         "</trkseg></trk>\n";
}

std::string Gpx(const std::string& tracks) { return "<gpx>\n" + tracks + "</gpx>\n"; }

/// As plotters export two boats: tracks of the same minutes.
std::string TwoBoats(const std::string& first, const std::string& second) {
  return Gpx(Track(first, Point(0, 10.2, "10:00:00") + Point(0.001, 10.2, "10:01:00")) +
             Track(second, Point(0, 10.21, "10:00:30") + Point(0.001, 10.21, "10:01:30")));
}

std::string ErrorOf(const std::string& text, const TrackSource& source) {
  const Result<ReplayTrack> track = ParseGpxTrack(text, source);
  return track.ok() ? "no error" : track.error();
}

TEST(GpxTrack, OfSeveralThatOverlapIsTheOneThatIsChosen) {
  EXPECT_EQ(ErrorOf(TwoBoats("Anna", ""), Source()),
            "ferry.gpx:7: this track begins 30 s before the one in front of it ends: choose one by "
            "name = \"...\" or number = N beside file: 1 'Anna' (2 points from "
            "2024-05-01T10:00:00Z to 2024-05-01T10:01:00Z), 2 without a name (2 points from "
            "2024-05-01T10:00:30Z to 2024-05-01T10:01:30Z)");
  TrackSource source = Source();
  source.number = 2;
  const Result<ReplayTrack> second = ParseGpxTrack(TwoBoats("Anna", ""), source);
  ASSERT_TRUE(second.ok()) << second.error();
  ASSERT_EQ(second->fixes().size(), 2U);
  EXPECT_NEAR(second->fixes()[0].position_m.x(), 649.4, 0.5);
  source = Source();
  source.vessel = "Anna";
  const Result<ReplayTrack> first = ParseGpxTrack(TwoBoats("Anna", ""), source);
  ASSERT_TRUE(first.ok()) << first.error();
  EXPECT_LT(first->fixes()[0].position_m.norm(), 1e-6);
}

TEST(GpxTrack, ThatIsNotChosenMayHaveFaults) {
  const std::string text =
      Gpx(Track("Anna", "<trkpt lat=\"54.4\" lon=\"10.2\"/>\n") + "<trk/>\n" +
          Track("Berta", Point(0, 10.2, "10:00:00") + Point(0.001, 10.2, "10:01:00")));
  TrackSource source = Source();
  source.number = 3;
  EXPECT_EQ(ErrorOf(text, source), "no error") << "a track without points has its number";
  source.number = 1;
  EXPECT_EQ(ErrorOf(text, source).substr(0, 38), "ferry.gpx:3: this <trkpt> has no <time");
  EXPECT_EQ(ErrorOf(text, Source()).substr(0, 38), "ferry.gpx:3: this <trkpt> has no <time");
}

TEST(GpxTrack, ThatCannotBeChosenListsThoseThatAre) {
  TrackSource source = Source();
  source.number = 3;
  EXPECT_NE(
      ErrorOf(TwoBoats("Anna", "Anna"), source).find("none of its tracks is the number 3: 1 "),
      std::string::npos);
  source = Source();
  source.vessel = "Carla";
  EXPECT_NE(
      ErrorOf(TwoBoats("Anna", "Anna"), source).find("none of its tracks is 'Carla': 1 'Anna'"),
      std::string::npos);
  source.vessel = "Anna";
  EXPECT_NE(ErrorOf(TwoBoats("Anna", "Anna"), source)
                .find("several of its tracks are 'Anna'; choose one by its number: 1 "),
            std::string::npos)
      << ErrorOf(TwoBoats("Anna", "Anna"), source);
}

TEST(GpxTrack, OfSeveralOneBehindTheOtherIsAllOfThemWithAWarning) {
  const std::string text =
      Gpx(Track("Monday", Point(0, 10.2, "10:00:00") + Point(0.001, 10.2, "10:01:00")) +
          Track("Tuesday", Point(0.001, 10.2, "10:30:00") + Point(0.002, 10.2, "10:31:00")));
  std::vector<std::string> warnings;
  const Result<ReplayTrack> track = ParseGpxTrack(text, Source(), &warnings);
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->fixes().size(), 4U);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(
      warnings[0].starts_with("ferry.gpx: its 2 tracks count as one; if they are not of one "
                              "vessel, choose one by name"))
      << warnings[0];
  warnings.clear();
  ASSERT_TRUE(ParseGpxTrack(kGood, Source(), &warnings).ok());
  EXPECT_EQ(warnings, std::vector<std::string>{}) << "segments of one track";
}

TEST(GpxTrack, OfSeveralTooFarApartListsThem) {
  const std::string text =
      Gpx(Track("Anna", Point(0, 10.2, "10:00:00")) + Track("Berta", Point(0, 10.3, "10:00:10")));
  EXPECT_NE(
      ErrorOf(text, Source())
          .find("ferry.gpx:6: this track begins 10 s after the one in front of it ends, too far "
                "from there: choose one by name"),
      std::string::npos)
      << ErrorOf(text, Source());
  const std::string no_place =
      Gpx(Track("Anna", Point(0, 10.2, "10:00:00")) + Track("Berta", Point(40, 10.2, "10:00:10")));
  EXPECT_NE(ErrorOf(no_place, Source()).find("ferry.gpx:6: latitude 94.4"), std::string::npos);
}

TEST(GpxTrack, TakesTheLastOfPointsOfOneTimeAndWarns) {
  const std::string text =
      Gpx(Track("", Point(0, 10.2, "10:00:00") + Point(0.0001, 10.2, "10:00:05") +
                        Point(0.00011, 10.2, "10:00:05") + Point(0.0002, 10.2, "10:00:10")));
  std::vector<std::string> warnings;
  const Result<ReplayTrack> track = ParseGpxTrack(text, Source(), &warnings);
  ASSERT_TRUE(track.ok()) << track.error();
  ASSERT_EQ(track->fixes().size(), 3U);
  EXPECT_NEAR(track->fixes()[1].position_m.y(), 0.00011 * 111316, 0.01);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings[0].starts_with("ferry.gpx:5: 1 of its points have the time of the point"))
      << warnings[0];
}

TEST(GpxTrack, HasTimesBefore1970AndAtTheEndOfADay) {
  const Result<ReplayTrack> old =
      Parse(Gpx("<trk><trkseg><trkpt lat=\"54.4\" lon=\"10.2\"><time>1969-05-01T10:00:00Z</time>"
                "</trkpt><trkpt lat=\"54.401\" lon=\"10.2\"><time>1969-05-01T10:01Z</time></trkpt>"
                "</trkseg></trk>"));
  ASSERT_TRUE(old.ok()) << old.error();
  EXPECT_EQ(old->last_us() - old->first_us(), 60'000'000);
  const Result<ReplayTrack> midnight =
      Parse(Gpx("<trk><trkseg><trkpt lat=\"54.4\" lon=\"10.2\"><time>2024-05-01T24:00:00Z</time>"
                "</trkpt><trkpt lat=\"54.401\" lon=\"10.2\"><time>2024-05-02T00:01:00Z</time>"
                "</trkpt></trkseg></trk>"));
  ASSERT_TRUE(midnight.ok()) << midnight.error();
  EXPECT_EQ(midnight->last_us() - midnight->first_us(), 60'000'000);
}

TEST(GpxTrack, AboveTheSurfaceIsRefusedWithTheKeyThatTurnsIt) {
  const std::string text =
      Gpx(Track("", Point(0, 10.2, "10:00:00", "5") + Point(0.001, 10.2, "10:01:00", "6")));
  const std::string error = ErrorOf(text, Source(true));
  EXPECT_TRUE(error.starts_with("ferry.gpx:4: this point is 6 m above the surface")) << error;
  EXPECT_NE(error.find("write depth_positive = \"down\""), std::string::npos) << error;
  TrackSource source = Source(true);
  source.depth_positive = DepthPositive::kDown;
  const Result<ReplayTrack> track = ParseGpxTrack(text, source);
  ASSERT_TRUE(track.ok()) << track.error();
  EXPECT_EQ(track->fixes()[1].position_m.z(), 6);
}

TEST(GpxTrackErrors, NameAnEncodingThatIsNotRead) {
  ExpectError("<?xml version=\"1.0\" encoding=\"windows-1252\"?>\n<gpx/>",
              "ferry.gpx:1: the encoding of the file is 'windows-1252'", "save it as UTF-8");
  ExpectError("<?xml version=\"1.0\" encoding=\"Shift_JIS\"?>\n<gpx/>",
              "ferry.gpx:1: the encoding of the file is 'Shift_JIS'", "save it as UTF-8");
  ExpectError("<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n<gpx/>",
              "ferry.gpx:1: the text is not in the encoding", "save it as UTF-8");
  ExpectError(With("Ferry", "F\xE4hre"), "ferry.gpx:4: the text is not in the encoding",
              "save it as UTF-8");
  EXPECT_TRUE(
      Parse(With("<?xml version=\"1.0\"?>", "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>"))
          .ok());
}

std::string Repeated(const std::string& part, size_t count) {
  std::string text;
  for (size_t i = 0; i < count; ++i) text += part;
  return text;
}

TEST(GpxTrackErrors, ComeBeforeAnyMemoryGrows) {
  ExpectError("<gpx>\n" + Repeated("<a>", 1'000'000), "ferry.gpx:2: elements are nested more than",
              "100 deep");
  EXPECT_TRUE(Parse("<gpx>" + Repeated("<a>", 99) + Repeated("</a>", 99) +
                    kGood.substr(kGood.find("<trk>")))
                  .ok());
  ExpectError("<gpx>\n<a b=\"" + std::string(4'000'000, 'x') + "\"/></gpx>",
              "ferry.gpx:2: an element is longer than", "is this GPX?");
  std::string names = "<gpx>\n";
  for (int i = 0; i < 1001; ++i) names += "<a" + std::to_string(i) + "/>";
  ExpectError(names, "ferry.gpx:2: more than 1000 names", "is this GPX?");
  std::string attributes = "<gpx>\n";
  for (int i = 0; i < 1001; ++i) attributes += "<a b" + std::to_string(i) + "=\"\"/>";
  ExpectError(attributes, "ferry.gpx:2: more than 1000 names", "is this GPX?");
  ExpectError("<gpx>\n" + Repeated("<trk><trkpt/></trk>", 10'001), "ferry.gpx:2: more than 10000",
              "divide the file");
}

TEST(GpxTrackErrors, NameTheLineAndTheRemedy) {
  ExpectError("", "ferry.gpx:1: this is not well-formed XML (no element found)", "complete");
  ExpectError("t_s,x_m,y_m\n", "ferry.gpx:1: this is not well-formed XML", "GPX");
  ExpectError("<kml></kml>", "ferry.gpx:1: the document is <kml>", "must be <gpx>");
  ExpectError("<gpx><rte/></gpx>", "ferry.gpx: no <trkpt> in it", "export the track");
  ExpectError(kGood.substr(0, kGood.size() - 30), "ferry.gpx:10: this is not well-formed XML",
              "complete");
  ExpectError(With("<trkseg>", "<trkseg><b>"),
              "ferry.gpx:9: this is not well-formed XML (mismatched", "complete");
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
