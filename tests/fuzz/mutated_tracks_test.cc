// Tracks that were damaged: each is read, or refused with its place; none takes more memory than a
// bound. The same mutations in every run.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>

#include "lib/geodesy/local_frame.h"
#include "lib/track/csv_track.h"
#include "lib/track/gpx_track.h"

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

/// Returns a text with one to five places changed: bytes, bits, words that mean harm, parts left
/// out, doubled, or cut off.
std::string Mutated(std::string text, std::mt19937_64& generator) {
  constexpr std::array<std::string_view, 12> kWords = {
      "nan", "-1e308", "99999999999999999999",           "\xFF\xFE", "<trkpt>",
      "]]>", "&#0;",   "<!DOCTYPE a [<!ENTITY b 'c'>]>", "\"",       ",,,,",
      "\n",  "\r"};
  const auto draw = [&](size_t below) { return static_cast<size_t>(generator() % below); };
  for (size_t i = draw(5) + 1; i > 0 && !text.empty(); --i) {
    const size_t at = draw(text.size());
    const size_t length = std::min(draw(40) + 1, text.size() - at);
    switch (draw(6)) {
      case 0:
        text[at] = static_cast<char>(draw(256));
        break;
      case 1:
        text[at] = static_cast<char>(text[at] ^ (1 << draw(8)));
        break;
      case 2:
        text.insert(at, kWords[draw(kWords.size())]);
        break;
      case 3:
        text.erase(at, length);
        break;
      case 4:
        text.insert(at, text.substr(at, length));
        break;
      default:
        if (draw(4) == 0) text.resize(at);
    }
  }
  return text;
}

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
    const std::string text = Mutated(whole, generator);
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

/// Reads all mutations in a child with little more memory than it starts with; false: it crashed.
bool LastsWithLittleMemory(const std::function<void()>& read) {
  constexpr rlim_t kMost_bytes = rlim_t{256} << 20;
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit = {kMost_bytes, kMost_bytes};
    setrlimit(RLIMIT_DATA, &limit);
    read();
    _exit(0);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void ExpectReadOrRefused(const std::string& name,
                         const std::function<Result<ReplayTrack>(std::string_view)>& parse) {
  EXPECT_TRUE(LastsWithLittleMemory([&] { ReadMutations(name, parse); }));
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
