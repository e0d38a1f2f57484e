#include "apps/shoal_play/playback_log.h"

#include <gtest/gtest.h>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::playback_log_test {

class PlaybackLogTest : public ::testing::Test {
 protected:
  /// Writes `num` events, ten at a time, a second apart.
  void Write(const std::string& path, int num) {
    std::vector<TestEvent> events = {{5'000'000, "COMMS_RULES", {7}}};
    for (int i = 0; i < num; ++i) {
      events.push_back({5'000'000 + i / 10 * 1'000'000, i % 2 == 0 ? "NAV_ALPHA" : "NAV_BRAVO",
                        Bytes(500, static_cast<uint8_t>(i))});
    }
    WriteLog(path, events);
  }

  TestDirectory directory_;
};

TEST_F(PlaybackLogTest, KnowsItsSpanVehiclesAndRules) {
  Write(directory_.File("a.lcm"), 100);
  const auto log = PlaybackLog::Open(directory_.File("a.lcm"));
  ASSERT_TRUE(log.ok()) << log.error();
  EXPECT_EQ(log->first_utime(), 5'000'000);
  EXPECT_EQ(log->last_utime(), 14'000'000);
  EXPECT_EQ(log->vehicles(), (std::vector<std::string>{"alpha", "bravo"}));
  EXPECT_EQ(log->rules(), Bytes{7});
}

TEST_F(PlaybackLogTest, FindsEachTimePlainAndCompressed) {
  for (const char* name : {"a.lcm", "a.lcm.zst"}) {
    Write(directory_.File(name), 8000);
    auto log = PlaybackLog::Open(directory_.File(name));
    ASSERT_TRUE(log.ok()) << log.error();
    for (const int64_t second : {0, 1, 399, 400, 798, 799}) {
      log->SeekTo(5'000'000 + second * 1'000'000);
      const auto event = log->Next();
      ASSERT_TRUE(event) << name << " " << second;
      EXPECT_EQ(event->utime, 5'000'000 + second * 1'000'000);
      EXPECT_EQ(event->number, second == 0 ? 0 : second * 10 + 1) << name;
    }
    log->SeekTo(5'000'000 + 1);
    EXPECT_EQ(log->Next()->utime, 6'000'000);
    log->SeekTo(900'000'000);
    EXPECT_FALSE(log->Next());
  }
}

TEST_F(PlaybackLogTest, GoesToTheRightPlaceWhereTimesGoBack) {
  // Two recordings behind one another, each of 100 s from 5 s on.
  std::vector<TestEvent> events;
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 20; ++j) {
      events.push_back(
          {5'000'000 + i % 100 * 1'000'000, "A", Bytes(2000, static_cast<uint8_t>(i))});
    }
  }
  WriteLog(directory_.File("a.lcm"), events);
  auto log = PlaybackLog::Open(directory_.File("a.lcm"));
  ASSERT_TRUE(log.ok()) << log.error();
  EXPECT_EQ(log->last_utime(), 5'000'000 + 199'000'000 - 1'000'000);
  log->SeekTo(5'000'000 + 150'000'000);
  const auto event = log->Next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->data[0], 151) << "the second begins where the first ended";
  EXPECT_EQ(event->utime, 155'000'000);
  int64_t last_utime = 0;
  for (auto next = log->Next(); next; next = log->Next()) {
    EXPECT_GE(next->utime, last_utime) << "times never fall";
    last_utime = next->utime;
  }
  EXPECT_EQ(last_utime, log->last_utime());
}

TEST_F(PlaybackLogTest, CountsAStrayTimeAsThatOfItsNeighbours) {
  std::vector<TestEvent> events;
  for (int64_t i = 0; i < 40; ++i) events.push_back({i * 1'000'000, "A", {1}});
  events[20].utime = 1'000'000'000'000'000;
  events[39].utime = INT64_MAX;
  WriteLog(directory_.File("a.lcm"), events);
  auto log = PlaybackLog::Open(directory_.File("a.lcm"));
  ASSERT_TRUE(log.ok()) << log.error();
  EXPECT_EQ(log->last_utime(), 38'000'000);
  log->SeekTo(19'000'000);
  EXPECT_EQ(log->Next()->utime, 19'000'000);
  EXPECT_EQ(log->Next()->utime, 19'000'000) << "the stray one";
  EXPECT_EQ(log->Next()->utime, 21'000'000);
}

TEST_F(PlaybackLogTest, RefusesTimesThatNoneCanHave) {
  WriteLog(directory_.File("a.lcm"), {{200'000'000'000'000'000, "A", {1}}});
  const auto log = PlaybackLog::Open(directory_.File("a.lcm"));
  ASSERT_FALSE(log.ok());
  EXPECT_NE(log.error().find("farther than 100000000000000000 microseconds"), std::string::npos);
}

TEST_F(PlaybackLogTest, HasWhatHoldsWhereItWent) {
  std::vector<TestEvent> events = {{0, "COMMS_RULES", {1}}, {0, "MODEM_STATS", {5}}};
  for (int i = 0; i < 4000; ++i) {
    events.push_back({i * 100'000, "NAV_ALPHA", Bytes(500)});
    if (i % 10 == 0) {
      events.push_back({i * 100'000, "HELM_STATE_ALPHA", {static_cast<uint8_t>(i / 10)}});
    }
    if (i == 1000) events.push_back({i * 100'000, "COMMS_RULES", {2}});
    if (i == 3000) events.push_back({i * 100'000, "COMMS_RULES", {3}});
  }
  WriteLog(directory_.File("a.lcm"), events);
  auto log = PlaybackLog::Open(directory_.File("a.lcm"));
  ASSERT_TRUE(log.ok()) << log.error();
  log->SeekTo(0);
  EXPECT_TRUE(log->holding().empty());
  EXPECT_EQ(log->rules(), Bytes{1});
  log->SeekTo(200'050'000);
  EXPECT_EQ(log->rules(), Bytes{2});
  ASSERT_EQ(log->holding().size(), 3U);
  EXPECT_EQ(log->holding()[0].channel, "MODEM_STATS");
  EXPECT_EQ(log->holding()[1].data, Bytes{2});
  EXPECT_EQ(log->holding()[2].channel, "HELM_STATE_ALPHA");
  EXPECT_EQ(log->holding()[2].data, Bytes{200});
  log->SeekTo(350'000'000);
  EXPECT_EQ(log->rules(), Bytes{3});
  log->SeekTo(10'000'000);
  EXPECT_EQ(log->rules(), Bytes{1}) << "back again";
}

TEST_F(PlaybackLogTest, RefusesWhatHoldsNoEvent) {
  WriteLog(directory_.File("empty.lcm"), {});
  const auto log = PlaybackLog::Open(directory_.File("empty.lcm"));
  ASSERT_FALSE(log.ok());
  EXPECT_NE(log.error().find("no event that can be played"), std::string::npos);
  EXPECT_FALSE(PlaybackLog::Open(directory_.File("none.lcm")).ok());
}

}  // namespace shoal::playback_log_test
