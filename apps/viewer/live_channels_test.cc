#include "apps/viewer/live_channels.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/tools/view/view_testing.h"

namespace shoal::live_channels_test {

using nlohmann::json;

int64_t now_us = 0;

class LiveChannelsTest : public testing::Test {
 protected:
  LiveChannelsTest() { now_us = 1'000'000; }
  void Take(double t_s, double x_m) { channels_.Take("NAV_ALPHA", Encoded(NavAt(0, x_m, 0)), t_s); }
  LiveChannels channels_{[] { return now_us; }};
};

TEST_F(LiveChannelsTest, AreTakenOnlyWhileAPageAsks) {
  EXPECT_FALSE(channels_.Wants());
  const std::string asked = channels_.ChannelsJson(0);
  EXPECT_TRUE(channels_.Wants());
  now_us += LiveChannels::kLookLasts_us - 1;
  EXPECT_TRUE(channels_.Wants());
  now_us += 1;
  EXPECT_FALSE(channels_.Wants());
}

TEST_F(LiveChannelsTest, ShowRateCountAndTheLastMessage) {
  for (int i = 0; i < 21; ++i) Take(0.5 * i, i);
  const json channel = json::parse(channels_.ChannelsJson(0))["channels"][0];
  EXPECT_EQ(channel, json::parse(R"({"name": "NAV_ALPHA", "type": "nav_t", "count": 21,
                                     "rate_hz": 2, "t": 10})"));
  const auto message = channels_.MessageJson("NAV_ALPHA", 0);
  ASSERT_TRUE(message.ok());
  EXPECT_NE(message->find(R"({"path":"x_m","text":"20","number":true})"), std::string::npos);
  EXPECT_FALSE(channels_.MessageJson("NAV_BRAVO", 0).ok());
}

TEST_F(LiveChannelsTest, HaveSeriesFromTheFirstQuestionOn) {
  Take(1, 1);
  EXPECT_EQ(json::parse(*channels_.SeriesJson("NAV_ALPHA:x_m", 0, 100))["t"].size(), 0);
  for (int i = 2; i < 12; ++i) Take(i, 10.0 * i);
  const json series = json::parse(*channels_.SeriesJson("NAV_ALPHA:x_m", 0, 3));
  EXPECT_EQ(series["t"], json::parse("[8, 9, 10, 11]"));
  EXPECT_EQ(series["value"], json::parse("[80, 90, 100, 110]"));
  EXPECT_EQ(channels_.SeriesJson("NAV_ALPHA:x_n", 0, 3).error(),
            "NAV_ALPHA has no field 'x_n' (did you mean 'x_m'?)");
}

TEST_F(LiveChannelsTest, ForgetSeriesThatNoPageAsksForOnlyWhereOthersNeedTheirPlace) {
  for (size_t i = 0; i < LiveChannels::kMaxSeries; ++i) {
    ASSERT_TRUE(channels_.SeriesJson("LATER:v" + std::to_string(i), 0, 3).ok());
  }
  EXPECT_FALSE(channels_.SeriesJson("NAV_ALPHA:x_m", 0, 3).ok());
  now_us += 61'000'000;
  EXPECT_TRUE(channels_.SeriesJson("NAV_ALPHA:x_m", 0, 3).ok());
}

}  // namespace shoal::live_channels_test
