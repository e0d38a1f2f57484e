#include "lib/tools/view/kept_index.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "lib/bus/record/log_testing.h"
#include "lib/tools/view/recorded_testing.h"

namespace shoal::kept_index_test {

using nlohmann::json;

class KeptIndexTest : public ::testing::Test {
 protected:
  KeptIndexTest() {
    (void)OpenTraffic(directory_, TrafficMaker(5).Make(400));
    EXPECT_FALSE(std::filesystem::exists(index_path_)) << "of a small log none is kept";
  }

  std::unique_ptr<RecordedView> Open() const {
    auto view = RecordedView::Open(path_, {.least_indexed_bytes = 0});
    EXPECT_TRUE(view.ok()) << view.error();
    return std::move(*view);
  }

  /// All answers, at several times.
  static std::vector<std::string> Answers(RecordedView& view) {
    std::vector<std::string> answers = {view.SetupJson(false), view.TrailsJson(),
                                        view.EventsJson()};
    for (const double t_s : {0.0, 7.3, 21.0, 40.0}) {
      answers.push_back(view.FrameJson(t_s));
      answers.push_back(view.LinksJson(t_s));
      answers.push_back(view.FatesJson({}, t_s));
      for (const char* name : {"Bravo", "ship"}) {
        answers.push_back(
            view.LinkJson("alpha", name, t_s).ok() ? *view.LinkJson("alpha", name, t_s) : "none");
        answers.push_back(view.VehicleJson(name, t_s, 60).ok() ? *view.VehicleJson(name, t_s, 60)
                                                               : "none");
      }
    }
    return answers;
  }

  /// The bytes of the view's part, and its key.
  std::pair<std::vector<uint8_t>, std::string> Part() const {
    const Bytes file = FileBytes(index_path_);
    const std::string key(file.begin() + 44, file.begin() + 44 + file[40]);
    auto log = LogReader::Open(path_);
    const auto part = ReadIndexPart(*log, IndexPart::kView, key, 0);
    EXPECT_TRUE(part);
    return {part.value_or(std::vector<uint8_t>()), key};
  }

  void Keep(const std::vector<uint8_t>& part, const std::string& key) const {
    KeepIndexPart(*LogReader::Open(path_), IndexPart::kView, key, part, 0);
  }

  TestDirectory directory_;
  const std::string path_ = directory_.File("mission.lcm");
  const std::string index_path_ = path_ + ".idx";
};

TEST_F(KeptIndexTest, AnswersAsTheLogDoes) {
  const std::vector<std::string> read = Answers(*Open());
  ASSERT_TRUE(std::filesystem::exists(index_path_));
  EXPECT_EQ(Answers(*Open()), read);
  EXPECT_EQ(Answers(*OpenTraffic(directory_, TrafficMaker(5).Make(400))), read);
}

TEST_F(KeptIndexTest, IsUsedWhereItFitsAndNotWithAnotherMission) {
  (void)Open();
  auto [part, key] = Part();
  part.at(8) ^= 1;  // The end of the line.
  Keep(part, key);
  const double end_s = Open()->end_s();
  EXPECT_NE(end_s, 40) << "it is what the index has";
  std::ofstream(directory_.File("mission.toml"), std::ios::app)
      << "\n[comms]\npulse_duration = 9\n";
  EXPECT_EQ(Open()->end_s(), 40) << "read again";
}

TEST_F(KeptIndexTest, AnswersWithJsonWhateverItHolds) {
  (void)Open();
  const auto [part, key] = Part();
  constexpr size_t kTries = 24;
  size_t num_taken = 0;
  for (size_t i = 0; i < kTries; ++i) {
    auto bytes = part;
    const size_t at = i < kTries / 2 ? i * 5 : bytes.size() / kTries * i;
    bytes.at(at) ^= static_cast<uint8_t>(i % 3 == 0 ? 0xff : 1 << (i % 8));
    Keep(bytes, key);
    const auto view = Open();
    if (Part().first == bytes) ++num_taken;
    for (const std::string& answer :
         {view->FrameJson(12), view->TrailsJson(), view->EventsJson(), view->LinksJson(30)}) {
      ASSERT_TRUE(json::accept(answer)) << at;
    }
  }
  EXPECT_GT(num_taken, 2U) << "numbers that can be";
  EXPECT_LT(num_taken, kTries) << "and others, for which the log is read";
  for (const size_t size : {size_t{0}, size_t{3}, part.size() / 2, part.size() - 1}) {
    Keep({part.begin(), part.begin() + static_cast<ptrdiff_t>(size)}, key);
    EXPECT_EQ(Open()->end_s(), 40);
  }
}

TEST_F(KeptIndexTest, LeavesAnIndexThatCannotBeKeptAsItIs) {
  KeptIndex kept;
  kept.troubles.resize(101);
  kept.index.events.push_back(
      {.utime = 5, .kind = EventKind::kWaypoint, .vehicles = {}, .text = "waypoint 1"});
  Keyframe& keyframe = kept.index.keyframes.emplace_back(
      Keyframe{.timeline = RecordedTimeline(0), .links = {}, .media_links = {}, .standing = {}});
  keyframe.offset = 77;
  keyframe.kinds_seen[1] = true;
  keyframe.standing.push_back({.offset = 33, .scene_utime = 44});
  EXPECT_TRUE(IndexBytes(&kept).empty());
  EXPECT_EQ(kept.index.events[0].utime, 5);
  EXPECT_EQ(kept.index.events[0].kind, EventKind::kWaypoint);
  EXPECT_EQ(keyframe.offset, 77U);
  EXPECT_TRUE(keyframe.kinds_seen[1]);
  EXPECT_EQ(keyframe.standing[0].offset, 33U);
  kept.troubles.pop_back();
  EXPECT_FALSE(IndexBytes(&kept).empty());
}

}  // namespace shoal::kept_index_test
