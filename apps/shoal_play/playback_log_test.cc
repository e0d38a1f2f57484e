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

TEST_F(PlaybackLogTest, RefusesWhatHoldsNoEvent) {
  WriteLog(directory_.File("empty.lcm"), {});
  const auto log = PlaybackLog::Open(directory_.File("empty.lcm"));
  ASSERT_FALSE(log.ok());
  EXPECT_NE(log.error().find("no event that can be played"), std::string::npos);
  EXPECT_FALSE(PlaybackLog::Open(directory_.File("none.lcm")).ok());
}

}  // namespace shoal::playback_log_test
