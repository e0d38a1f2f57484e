// Whatever a mission file holds, the loader answers with errors or with a mission, never with a
// crash.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/mission/file/load_testing.h"

namespace shoal::load_hostile_test {

constexpr std::string_view kEverything = R"([mission]
name = "m"
duration_s = 60
origin = {lat_deg = 43, lon_deg = -70}
[comms]
comms_range = "nolimit"
reports_over = "acoustic"
[acoustics]
bandwidth_khz = 11
access_mode = "fdma"
channel_bandwidth_khz = 2
modem = "nanomodem_v3"
sea = {wind_mps = 3, absorption = "thorp"}
[template.t]
start = {x_m = 1}
[[template.t.task]]
kind = "waypoints"
name = "w"
points = [[1, 2], [3, 4.5]]
points_frame = "start"
[[vehicle]]
name = "alpha"
template = "t"
acoustic_address = 9
[vehicle.surface_craft]
thrust_map = [[50, 1], [100, 2]]
[vehicle.reporter]
extra = {A = "b"}
[[fleet]]
template = "t"
count = 3
[[event]]
at_s = 1
vehicle = "all"
command = "task"
argument = "w"
[[participant]]
name = "p"
command = ["./p", "x"]
[[expect]]
kind = "laps"
vehicle = "alpha"
task = "w"
[[expect]]
kind = "packets"
at_least_pct = 80
)";

/// Returns kEverything with random edits.
std::string Edited(uint64_t seed) {
  constexpr std::array<std::string_view, 24> kPieces = {"nan",
                                                        "inf",
                                                        "-1",
                                                        "1e308",
                                                        "9223372036854775807",
                                                        "\"\"",
                                                        "[",
                                                        "]",
                                                        "{",
                                                        "}",
                                                        "=",
                                                        ".",
                                                        "\n",
                                                        "\"",
                                                        "#",
                                                        "[[vehicle]]\n",
                                                        "'''",
                                                        "true",
                                                        "\xff",
                                                        "{n}",
                                                        "\\u0000",
                                                        "0x",
                                                        "a.",
                                                        "[template.t.template]\n"};
  std::mt19937_64 random(seed);
  const auto below = [&](size_t limit) { return static_cast<size_t>(random() % limit); };
  std::string text(kEverything);
  for (size_t edits = 1 + below(4); edits > 0; --edits) {
    const size_t at = below(text.size() + 1);
    switch (below(5)) {
      case 0:
        text.erase(at, below(20));
        break;
      case 1:
        text.insert(at, kPieces.at(below(kPieces.size())));
        break;
      case 2:
        text.insert(at, 1, static_cast<char>(below(256)));
        break;
      case 3: {
        // A value becomes another one.
        const size_t value = text.find("= ", at);
        if (value == std::string::npos) break;
        const size_t end = text.find('\n', value);
        text.replace(value + 2, end - value - 2, kPieces.at(below(kPieces.size())));
        break;
      }
      default:
        text.insert(at, text.substr(below(text.size()), below(60)));
    }
    if (text.empty()) text = "x";
  }
  return text;
}

RC_GTEST_PROP(LoadHostile, AnswersAnyEditWithErrorsOrWithAMissionThatLoadsAgain, (uint64_t seed)) {
  const LoadedMission loaded = LoadMissionText(Edited(seed), "m.toml");
  for (const std::string& error : loaded.errors) RC_ASSERT(error.starts_with("m.toml:"));
  if (!loaded.errors.empty()) return;
  const std::string explained = Explain(loaded.mission);
  const LoadedMission again = LoadMissionText(explained, "m.toml");
  RC_ASSERT(again.errors == std::vector<std::string>{});
  RC_ASSERT(Explain(again.mission) == explained);
}

RC_GTEST_PROP(LoadHostile, AnswersAnyOverrideWithErrorsOrWithAMission,
              (const std::string& path, const std::string& value)) {
  const auto loaded = LoadMissionText(
      kEverything, "m.toml",
      {path + "=" + value, "vehicle.alpha." + path + "=" + value, "mission.name=" + value, value});
  for (const std::string& error : loaded.errors) {
    RC_ASSERT(error.starts_with("--set ") || error.starts_with("m.toml:"));
    RC_ASSERT(std::none_of(error.begin(), error.end(),
                           [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
  }
}

TEST(LoadHostile, KnowsThatItsOwnExampleIsRight) { EXPECT_EQ(ErrorsOf(kEverything), ""); }

/// A key of `parts` parts, two bytes each but for the last.
std::string KeyOf(size_t parts) {
  std::string key = "a";
  for (size_t i = 1; i < parts; ++i) key += ".a";
  return key;
}

TEST(LoadHostile, SurvivesAKeyOfAHundredThousandParts) {
  const std::string key = KeyOf(100'000);
  EXPECT_EQ(ErrorsOf("[" + key + "]\n"),
            "1:1: nested deeper than 32 levels; no part of a mission file is\n");
  EXPECT_EQ(ErrorsOf("\n" + key + " = 1\n"),
            "2:65: nested deeper than 32 levels; no part of a mission file is\n");
  EXPECT_EQ(ErrorsAfter("", {key + "=1"}).substr(0, 10), "--set a.a.");
}

TEST(LoadHostile, SurvivesAKeyOfAHundredThousandPartsBehindAFourthQuote) {
  // Of four quotes at the end of a text of many lines, the first belongs to the text.
  for (const std::string quotes : {R"(""")", "'''"}) {
    const std::string text =
        "x = [" + quotes + "x" + quotes + quotes.front() + ", {" + KeyOf(130'000) + "=1}]\n";
    EXPECT_EQ(ErrorsOf(text), "1:77: nested deeper than 32 levels; no part of a mission file is\n");
    // The parser gives up behind it, and destroys what it has read.
    EXPECT_EQ(ErrorsOf(text + "=").substr(0, 4), "2:1:");
  }
}

TEST(LoadHostile, SurvivesTheDeepestTextOfTheLongestLength) {
  constexpr size_t kLongest = size_t{4} << 20;
  const std::string longest = "[" + KeyOf(kLongest / 2 - 1) + "]";
  ASSERT_EQ(longest.size(), kLongest - 1);
  EXPECT_EQ(ErrorsOf(longest + "\n"),
            "1:1: nested deeper than 32 levels; no part of a mission file is\n");
  EXPECT_EQ(ErrorsOf(longest + "\n\n"),
            " is 4194305 bytes long; a mission file has at most 4194304\n");
}

TEST(LoadHostile, AnswersToAnArrayOfAsManyPointsAsTheLongestTextHolds) {
  std::string points = "points = [";
  for (int i = 0; i < 600'000; ++i) points += "[1,2],";
  EXPECT_EQ(ErrorsAfter("[[vehicle.task]]\nkind = \"waypoints\"\n" + points + "]\n").substr(0, 60),
            "7:10: points has 600000 elements; allowed: at most 10000\n7:1");
}

TEST(LoadHostile, SurvivesDeepBrackets) {
  EXPECT_NE(ErrorsOf("a = " + std::string(100'000, '[')), "");
  EXPECT_EQ(ErrorsOf("a = " + std::string(100, '[') + std::string(100, ']')),
            "1:37: nested deeper than 32 levels; no part of a mission file is\n");
}

TEST(LoadHostile, SurvivesGiantTextsAndNumbers) {
  const std::string giant(100'000, 'x');
  EXPECT_EQ(ErrorsAfter("color = \"" + giant + "\"\n"),
            "5:9: color is 100000 bytes long; allowed: at most 64\n");
  EXPECT_LT(ErrorsAfter(giant + " = 1\n").size(), 1000U);
  EXPECT_NE(ErrorsAfter("length_m = 1e999\n"), "");
  EXPECT_NE(ErrorsAfter("length_m = 99999999999999999999\n"), "");
}

TEST(LoadHostile, OfAnEmptyFileStatesWhatAMissionNeeds) {
  EXPECT_EQ(
      ErrorsOf(""),
      "1:1: the file lacks 'mission'; for example: [mission], followed by duration_s = 600\n"
      "1:1: the file lacks 'vehicle'; for example: [[vehicle]], followed by name = \"alpha\"; "
      "or a [[fleet]]\n");
}

}  // namespace shoal::load_hostile_test
