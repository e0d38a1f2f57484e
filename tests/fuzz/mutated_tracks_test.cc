// Tracks that were damaged: each is read, or refused with its place; none takes more memory than a
// bound, and none flies, or lies still where the whole one moves or dives, without a warning. The
// same mutations in every run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/geodesy/local_frame.h"
#include "lib/mission/track/csv_track.h"
#include "lib/mission/track/gpx_track.h"
#include "tests/fuzz/mutation.h"

namespace shoal::mutated_tracks_test {

constexpr int kNumMutations = 5000;

std::string TextOf(const std::string& name) {
  std::ifstream file(std::string(SHOAL_SOURCE_DIR) + "/missions/tracks/" + name);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  // Some of the points are as good as all, and quicker; the document stays a whole one.
  const size_t end = text.find("\n    </trkseg>");
  if (end == std::string::npos) return text.substr(0, text.find('\n', 1000));
  return text.substr(0, text.find("\n", 1500)) + text.substr(end);
}

/// A vehicle that dives and comes up again.
std::string DivingCsv() {
  std::string text = "time,lat_deg,lon_deg,depth_m,heading_deg,sog_mps,vessel\n";
  for (int i = 0; i < 20; ++i) {
    text += fmt::format("2026-06-03T08:{:02}:00Z,{:.5f},10.2,{},,1.5,auv\n", i, 54.4 + 0.0005 * i,
                        std::min(i, 20 - i));
  }
  return text;
}

/// Two tracks of the same minutes, of vehicles that dive.
std::string DivingGpx() {
  std::string text = "<?xml version=\"1.0\"?>\n<gpx>\n";
  for (const char* name : {"a", "b"}) {
    text += fmt::format("<trk><name>{}</name><trkseg>\n", name);
    for (int i = 0; i < 12; ++i) {
      text += fmt::format(
          "<trkpt lat=\"{:.5f}\" lon=\"10.2\"><ele>-{}</ele><time>2026-06-03T08:{:02}:00Z</time>"
          "</trkpt>\n",
          54.4 + 0.0005 * i, std::min(i, 12 - i), i);
    }
    text += "</trkseg></trk>\n";
  }
  return text + "</gpx>\n";
}

constexpr std::array<std::string_view, 19> kWords = {"nan",
                                                     "-1e308",
                                                     "99999999999999999999",
                                                     "\xFF\xFE",
                                                     "<trkpt>",
                                                     "]]>",
                                                     "&#0;",
                                                     "<!DOCTYPE a [<!ENTITY b 'c'>]>",
                                                     "\"",
                                                     ",,,,",
                                                     "\n",
                                                     "\r",
                                                     "-",
                                                     "0",
                                                     "511",
                                                     "1970",
                                                     "24:00",
                                                     "<trk>",
                                                     "</trk>"};

using ParseTrack = Result<ReplayTrack> (*)(std::string_view, const TrackSource&,
                                           std::vector<std::string>*);

/// A form of file, and how it is read.
struct Form {
  std::string whole;
  ParseTrack parse = nullptr;
  TrackSource source;
};

/// Returns what is wrong with a track that was read; empty: nothing.
std::string FaultOf(const ReplayTrack& track, const TrackSource& source, bool has_warnings) {
  const std::vector<ReplayFix>& fixes = track.fixes();
  const ReplayState state = track.At((track.first_us() + track.last_us()) / 2);
  if (!state.position_m.allFinite() || !std::isfinite(state.heading_rad) ||
      !std::isfinite(state.speed_mps)) {
    return "not finite";
  }
  if (std::ranges::any_of(fixes, [](const ReplayFix& fix) { return fix.position_m.z() < 0; })) {
    return "it flies";
  }
  if (has_warnings) return "";
  const bool moves = std::ranges::any_of(
      fixes, [&](const ReplayFix& fix) { return fix.position_m != fixes.front().position_m; });
  if (!moves) return "it lies still without a warning";
  const bool dives =
      std::ranges::any_of(fixes, [](const ReplayFix& fix) { return fix.position_m.z() > 0; });
  if (source.underwater && !dives) return "it never dives without a warning";
  const bool has_gap = std::ranges::adjacent_find(fixes, [](const auto& a, const auto& b) {
                         return b.time_us - a.time_us > 3'600'000'000;
                       }) != fixes.end();
  return has_gap ? "it nearly stands without a warning" : "";
}

struct Count {
  int read = 0;
  int refused = 0;
  std::string fault = "";  ///< The first text that was neither.
};

Count ReadMutations(const Form& form) {
  std::mt19937_64 generator(19);
  Count count;
  for (int i = 0; i < kNumMutations; ++i) {
    const std::string text = Mutated(form.whole, kWords, generator);
    std::vector<std::string> warnings;
    const Result<ReplayTrack> track = form.parse(text, form.source, &warnings);
    if (track.ok()) {
      ++count.read;
      const std::string fault = FaultOf(*track, form.source, !warnings.empty());
      if (!fault.empty()) count.fault = fault + ":\n" + text;
    } else {
      ++count.refused;
      warnings.push_back(track.error());
    }
    for (const std::string& message : warnings) {
      const bool has_place = message.starts_with("track:") && message.size() < 500;
      const bool is_printable =
          std::ranges::all_of(message, [](char c) { return c >= ' ' && c <= '~'; });
      if (!has_place || !is_printable) count.fault = message;
    }
  }
  return count;
}

TrackSource Source(bool underwater = false) {
  static const LocalFrame frame({.lat_deg = 54.4, .lon_deg = 10.2});
  return {.frame = &frame, .underwater = underwater};
}

void ExpectReadOrRefused(const Form& form) {
  ASSERT_TRUE(form.parse(form.whole, form.source, nullptr).ok())
      << form.parse(form.whole, form.source, nullptr).error();
  EXPECT_TRUE(LastsWithin(size_t{256} << 20, [&] {
    ReadMutations(form);
    return true;
  })) << "a crash, or more than 256 MB";
  const Count count = ReadMutations(form);
  EXPECT_EQ(count.fault, "");
  EXPECT_GT(count.read, kNumMutations / 100) << "most mutations must reach beyond the first check";
  EXPECT_GT(count.refused, kNumMutations / 4);
}

TEST(MutatedTracks, OfCsvAreReadOrRefusedWithTheirPlace) {
  ExpectReadOrRefused({.whole = TextOf("launch.csv"), .parse = ParseCsvTrack, .source = Source()});
}

TEST(MutatedTracks, OfGpxAreReadOrRefusedWithTheirPlace) {
  ExpectReadOrRefused({.whole = TextOf("ferry.gpx"), .parse = ParseGpxTrack, .source = Source()});
}

TEST(MutatedTracks, OfCsvUnderWaterNeverFly) {
  ExpectReadOrRefused({.whole = DivingCsv(), .parse = ParseCsvTrack, .source = Source(true)});
}

TEST(MutatedTracks, OfCsvThatCountsUpNeverFly) {
  std::string text = DivingCsv();
  for (size_t at = text.find(",10.2,"); at != std::string::npos; at = text.find(",10.2,", at + 6)) {
    text.insert(at + 6, "-");
  }
  TrackSource source = Source(true);
  source.depth_positive = DepthPositive::kUp;
  source.vessel = "auv";
  ExpectReadOrRefused({.whole = text, .parse = ParseCsvTrack, .source = source});
}

TEST(MutatedTracks, OfOneOfTwoInGpxNeverFly) {
  TrackSource source = Source(true);
  source.vessel = "b";
  ExpectReadOrRefused({.whole = DivingGpx(), .parse = ParseGpxTrack, .source = source});
}

// Files that are made to take memory: as many open elements, names, tracks or vessels as fit in.
TEST(HostileTracks, TakeLittleMemory) {
  const auto times = [](std::string_view part, size_t bytes) {
    std::string text;
    text.reserve(bytes + part.size());
    while (text.size() < bytes) text += part;
    return text;
  };
  constexpr size_t kSize = 9'000'000;
  std::string names = "<gpx>";
  std::string vessels = "mmsi,t_s,x_m,y_m\n";
  for (int i = 0; names.size() < kSize / 3; ++i) names += fmt::format("<a{}/>", i);
  for (int i = 0; vessels.size() < kSize / 3; ++i) vessels += fmt::format("{},0,0,0\n", i);
  const std::array<std::pair<std::string, ParseTrack>, 7> files = {{
      {"<gpx>" + times("<a>", kSize), ParseGpxTrack},
      {"<gpx><a b='" + times("x", kSize), ParseGpxTrack},
      {"<gpx>" + times("<trk><trkpt/></trk>", kSize), ParseGpxTrack},
      {names, ParseGpxTrack},
      {vessels, ParseCsvTrack},
      {times(",", kSize), ParseCsvTrack},
      {"t_s,x_m,y_m\n0,0," + times("1", kSize), ParseCsvTrack},
  }};
  for (const auto& [text, parse] : files) {
    EXPECT_TRUE(LastsWithin(size_t{96} << 20, [&] { return !parse(text, Source(), nullptr).ok(); }))
        << text.substr(0, 30);
  }
}

}  // namespace shoal::mutated_tracks_test
