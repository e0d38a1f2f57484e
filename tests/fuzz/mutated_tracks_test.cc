// Tracks that were damaged: each is read, or refused with its place; none takes more memory than a
// bound. The same mutations in every run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>

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

constexpr std::array<std::string_view, 12> kWords = {
    "nan", "-1e308", "99999999999999999999",           "\xFF\xFE", "<trkpt>",
    "]]>", "&#0;",   "<!DOCTYPE a [<!ENTITY b 'c'>]>", "\"",       ",,,,",
    "\n",  "\r"};

struct Count {
  int read = 0;
  int refused = 0;
  std::string fault = "";  ///< The first text that was neither.
};

Count ReadMutations(const std::string& name,
                    const std::function<Result<ReplayTrack>(std::string_view)>& parse) {
  const std::string whole = TextOf(name);
  std::mt19937_64 generator(19);
  Count count;
  for (int i = 0; i < kNumMutations; ++i) {
    const std::string text = Mutated(whole, kWords, generator);
    const Result<ReplayTrack> track = parse(text);
    if (track.ok()) {
      ++count.read;
      const ReplayState state = track->At((track->first_us() + track->last_us()) / 2);
      if (!state.position_m.allFinite()) count.fault = text;
      continue;
    }
    ++count.refused;
    const std::string& error = track.error();
    const bool has_place = error.starts_with("track:") && error.size() < 500;
    const bool is_printable =
        std::ranges::all_of(error, [](char c) { return c >= ' ' && c <= '~'; });
    if (!has_place || !is_printable) count.fault = error;
  }
  return count;
}

TrackSource Source() {
  static const LocalFrame frame({.lat_deg = 54.4, .lon_deg = 10.2});
  return {.frame = &frame};
}

void ExpectReadOrRefused(const std::string& name,
                         const std::function<Result<ReplayTrack>(std::string_view)>& parse) {
  EXPECT_TRUE(LastsWithin(size_t{256} << 20, [&] {
    ReadMutations(name, parse);
    return true;
  })) << "a crash, or more than 256 MB";
  const Count count = ReadMutations(name, parse);
  EXPECT_EQ(count.fault, "");
  EXPECT_GT(count.read, kNumMutations / 100) << "most mutations must reach beyond the first check";
  EXPECT_GT(count.refused, kNumMutations / 4);
}

TEST(MutatedTracks, OfCsvAreReadOrRefusedWithTheirPlace) {
  ExpectReadOrRefused("launch.csv",
                      [](std::string_view text) { return ParseCsvTrack(text, Source()); });
}

TEST(MutatedTracks, OfGpxAreReadOrRefusedWithTheirPlace) {
  ExpectReadOrRefused("ferry.gpx",
                      [](std::string_view text) { return ParseGpxTrack(text, Source()); });
}

}  // namespace shoal::mutated_tracks_test
