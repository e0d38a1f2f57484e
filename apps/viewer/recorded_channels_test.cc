#include "apps/viewer/recorded_channels.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/tools/view/recorded_testing.h"

namespace shoal::recorded_channels_test {

using nlohmann::json;

class RecordedChannelsTest : public testing::Test {
 protected:
  RecordedChannelsTest() {
    std::ofstream(directory_.File("mission.toml")) << kTrafficMissionText;
    std::vector<TestEvent> events;
    for (int i = 0; i <= 100; ++i) {
      const int64_t utime = i * 100'000;
      events.push_back(
          {.utime = utime, .channel = "NAV_ALPHA", .data = Encoded(NavAt(utime, i, 0))});
    }
    events.push_back({.utime = 10'000'000, .channel = "ODD", .data = {1, 2, 3}});
    WriteLog(directory_.File("mission.lcm"), events);
  }
  TestDirectory directory_;
};

TEST_F(RecordedChannelsTest, AreThoseOfTheMoment) {
  RecordedChannels channels(directory_.File("mission.lcm"), "");
  const json early = json::parse(channels.ChannelsJson(5))["channels"];
  ASSERT_EQ(early.size(), 1);
  EXPECT_EQ(early[0]["type"], "nav_t");
  EXPECT_EQ(early[0]["count"], 51);
  EXPECT_EQ(early[0]["t"], 5);
  EXPECT_NEAR(early[0]["rate_hz"].get<double>(), 10, 0.5);
  EXPECT_EQ(json::parse(channels.ChannelsJson(1e12))["channels"].size(), 2);
}

TEST_F(RecordedChannelsTest, ShowTheLastMessageBeforeTheTime) {
  RecordedChannels channels(directory_.File("mission.lcm"), "");
  const auto message = channels.MessageJson("NAV_ALPHA", 3.25);
  ASSERT_TRUE(message.ok()) << message.error();
  EXPECT_NE(message->find(R"({"path":"x_m","text":"32","number":true})"), std::string::npos);
  EXPECT_EQ(channels.MessageJson("ODD", 3).error(), "ODD has no message yet at this time");
  EXPECT_EQ(channels.MessageJson("NAV_ALPHE", 3).error(),
            "the log has no channel 'NAV_ALPHE' (did you mean 'NAV_ALPHA'?)");
}

TEST_F(RecordedChannelsTest, HaveSeriesOfAWindow) {
  RecordedChannels channels(directory_.File("mission.lcm"), "");
  const auto series = channels.SeriesJson("NAV_ALPHA:x_m", 2, 0.35);
  ASSERT_TRUE(series.ok()) << series.error();
  EXPECT_EQ(json::parse(*series)["value"], json::parse("[17, 18, 19, 20]"));
  EXPECT_FALSE(channels.SeriesJson("NAV_ALPHA", 2, 1).ok());
  EXPECT_EQ(channels.SeriesJson("NAV_ALPHA:x_n", 2, 1).error(),
            "NAV_ALPHA has no field 'x_n' (did you mean 'x_m'?)");
}

TEST_F(RecordedChannelsTest, OfALongLogKeepEverySecondMessageOrFewer) {
  RecordedChannels channels(directory_.File("mission.lcm"), "", 30);
  const json list = json::parse(channels.ChannelsJson(1e12))["channels"];
  EXPECT_EQ(list[0]["count"], 101);
  const auto series = channels.SeriesJson("NAV_ALPHA:x_m", 1e12, 1e13);
  ASSERT_TRUE(series.ok());
  const json values = json::parse(*series)["value"];
  EXPECT_LE(values.size(), 30);
  EXPECT_GE(values.size(), 12);
  EXPECT_GT(values.back(), 90);
}

TEST_F(RecordedChannelsTest, OfNoLogAreNone) {
  RecordedChannels channels(directory_.File("none.lcm"), "");
  EXPECT_EQ(channels.ChannelsJson(1), R"({"channels":[]})");
  EXPECT_FALSE(channels.MessageJson("NAV_ALPHA", 1).ok());
}

}  // namespace shoal::recorded_channels_test
