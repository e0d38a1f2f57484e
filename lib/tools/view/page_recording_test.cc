#include "lib/tools/view/page_recording.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lib/tools/view/page_backgrounds.h"
#include "lib/tools/view/recorded_testing.h"

namespace shoal::page_recording_test {

using nlohmann::json;

/// As applyChange of web/net/page_recording.js.
json Applied(const json& before, const json& change) {
  if (change == 0) return before;
  if (change.is_array()) return change[0];
  json after = before;
  for (const auto& [key, part] : change.items()) {
    if (after.is_array()) {
      const size_t place = std::stoul(key);
      if (place == after.size()) after.push_back(nullptr);
      after[place] = Applied(after[place], part);
    } else if (part == 0) {
      after.erase(key);
    } else {
      after[key] = Applied(after.value(key, json()), part);
    }
  }
  return after;
}

TEST(ChangeOf, NamesWhatDiffersAndNothingElse) {
  EXPECT_EQ(
      ChangeOf({{"a", 1}, {"b", {{"c", 2}, {"d", 3}}}}, {{"a", 1}, {"b", {{"c", 2}, {"d", 4}}}}),
      json::parse(R"({"b":{"d":[4]}})"));
  EXPECT_EQ(ChangeOf({{"a", 1}}, {{"b", 2}}), json::parse(R"({"a":0,"b":[2]})"));
  EXPECT_EQ(ChangeOf({{"a", 1}}, json()), json::parse("[null]"));
  EXPECT_EQ(ChangeOf(json::parse(R"([{"x":1},{"x":2}])"), json::parse(R"([{"x":1},{"x":3},{}])")),
            json::parse(R"({"1":{"x":[3]},"2":[{}]})"));
  EXPECT_EQ(ChangeOf(json::parse("[1,2]"), json::parse("[1,3]")), json::parse("[[1,3]]"));
}

json RecordingOf(const PageRecordingOptions& options, ViewSource& view, double end_s) {
  return json::parse(RecordForPage(view, 0, end_s, options).json);
}

TEST(PageRecording, HoldsTheFramesOfTheViewer) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(1).Make(600));
  const json recording = RecordingOf({.step_s = 1}, *view, view->end_s());
  const json& states = recording["frames"]["states"];
  ASSERT_EQ(states.size(), 62) << "one per second and the end";
  json state = states[0];
  for (size_t i = 1; i < states.size(); ++i) {
    state = Applied(state, states[i]);
    json frame = json::parse(view->FrameJson(std::min(static_cast<double>(i), view->end_s())));
    frame.erase("pulses");
    frame.erase("packets");
    ASSERT_EQ(state, frame) << i;
  }
}

TEST(PageRecording, HoldsEveryFateOnceInTheirOrder) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(2).Make(600));
  const json fates = RecordingOf({.step_s = 5}, *view, view->end_s())["fates"];
  const json frame = json::parse(view->FrameJson(view->end_s()));
  ASSERT_EQ(fates.size(), frame["num_fates"]);
  for (size_t i = 0; i < fates.size(); ++i) ASSERT_EQ(fates[i][0], i + 1);
}

TEST(PageRecording, HasTheVerdictAndABackgroundOnlyWithItsFile) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(2).Make(60));
  const json all = RecordingOf({.step_s = 5}, *view, view->end_s());
  EXPECT_EQ(all["verdict"], json::parse(view->VerdictJson()));
  EXPECT_EQ(all["setup"]["backgrounds"], json::array());
  EXPECT_EQ(all["backgrounds"], json::array());
}

TEST(PageRecording, HoldsSmallBackgroundsAndNamesTheOthers) {
  const TestDirectory directory;
  const std::filesystem::path folder = directory.File("");
  std::ofstream(folder / "bay.png") << "pixels";
  std::ofstream(folder / "bay.pgw") << "1";
  std::ofstream(folder / "large.tif") << std::string(2'000'000, 'x');
  std::ofstream(folder / "coast.json") << "{}";
  std::vector<std::string> notes;
  const json held = BackgroundsForPage(
      {.folder = folder,
       .files = {"bay.png", "large.tif", "gone.png", "sea.mbtiles", "coast.json"}},
      1'000'000, &notes);
  EXPECT_EQ(held, json::parse(R"([{"file": "bay.png", "bytes": "cGl4ZWxz", "world": "MQ=="},
                                  {"file": "coast.json", "bytes": "e30=", "world": ""}])"));
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[0],
            "the background large.tif (2.0 MB) is too large for the page: drop it onto the map");
  EXPECT_NE(notes[1].find("gone.png"), std::string::npos);
  EXPECT_EQ(notes[2], "the tiles sea.mbtiles are not in the page: drop them onto the map");
}

TEST(PageRecording, KeepsTheNewestFatesAndStatesHowManyAreLeftOut) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(2).Make(600));
  const auto recording = RecordForPage(*view, 0, view->end_s(), {.step_s = 5, .max_fates = 10});
  const json all = json::parse(recording.json);
  const int64_t num = json::parse(view->FrameJson(view->end_s()))["num_fates"];
  ASSERT_EQ(all["fates"].size(), 10);
  EXPECT_EQ(all["fates"][9][0], num);
  ASSERT_EQ(recording.notes.size(), 2);
  EXPECT_EQ(all["setup"]["notes"].back(), recording.notes[1]);
  EXPECT_NE(recording.notes[1].find("the last 10 fates; " + std::to_string(num - 10)),
            std::string::npos);
}

TEST(PageRecording, ThinsOutWhatTheMapCannotShowAllOf) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(3).Make(600));
  const json all = RecordingOf({.step_s = 0.5}, *view, view->end_s());
  const json thinned = RecordingOf({.step_s = 0.5, .max_transmissions = 20}, *view, view->end_s());
  ASSERT_GT(all["pulses"].size(), 40);
  EXPECT_LE(thinned["pulses"].size(), 20);
  EXPECT_GT(thinned["pulses"].size(), 5);
  EXPECT_GT(thinned["pulses"].back()["t"], 40) << "all along the mission";
}

TEST(PageStep, GivesAtMostTwoThousandFrames) {
  EXPECT_EQ(PageStep_s(0), 0.5);
  EXPECT_EQ(PageStep_s(1000), 0.5);
  EXPECT_EQ(PageStep_s(1001), 1);
  EXPECT_EQ(PageStep_s(1800), 1);
  EXPECT_EQ(PageStep_s(86'400), 60);
  EXPECT_EQ(PageStep_s(1'000'000), 500);
}

}  // namespace shoal::page_recording_test
