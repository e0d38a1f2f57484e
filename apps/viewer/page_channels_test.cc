#include "apps/viewer/page_channels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace shoal::page_channels_test {

using nlohmann::json;

/// One channel with a message in every second, of which every other has a second field.
class SecondsChannel : public ChannelSource {
 public:
  std::string ChannelsJson(double) override {
    return R"({"channels": [{"name": "A", "type": "a_t", "count": 11, "rate_hz": 1, "t": 10},
                            {"name": "B", "type": "b_t", "count": 0, "rate_hz": 0, "t": 0}]})";
  }
  Result<std::string> MessageJson(const std::string& channel, double t_s) override {
    if (channel != "A") return Error{"no message"};
    const int t = static_cast<int>(std::floor(t_s));
    const std::string more =
        t % 2 == 0 ? "" : R"(, {"path": "odd", "text": "yes", "number": false})";
    return fmt::format(R"({{"channel": "A", "type": "a_t", "t": {}, "bytes": 8, "left_out": 0,
                           "fields": [{{"path": "x_m", "text": "{}.5", "number": true}}{}]}})",
                       t, t, more);
  }
  std::string FieldsJson(const std::string&, double) override { return "{}"; }
  Result<std::string> SeriesJson(const std::string&, double, double) override {
    return Error{"not asked"};
  }
};

TEST(PageChannels, HoldSomeMessagesOfEachEvenlyOverTheRecording) {
  SecondsChannel channels;
  std::vector<std::string> notes;
  const json held = ChannelsForPage(channels, 0, 10, {.max_samples = 5}, &notes);
  ASSERT_EQ(held.size(), 2u);
  EXPECT_EQ(held[0]["fields"], json::parse(R"([["x_m", true]])"));
  ASSERT_EQ(held[0]["samples"].size(), 6u);
  EXPECT_EQ(held[0]["samples"][1], json::parse(R"([2, 8, "2.5"])"));
  EXPECT_EQ(held[0]["count"], 11);
  EXPECT_EQ(held[1]["samples"], json::array());
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "of each channel it has 6 messages at most, 2 s apart");
}

TEST(PageChannels, HoldAMessageOnceAndNothingForAFieldThatItLacks) {
  SecondsChannel channels;
  std::vector<std::string> notes;
  const json held = ChannelsForPage(channels, 0, 3, {.max_samples = 30}, &notes);
  ASSERT_EQ(held[0]["samples"].size(), 4u);
  EXPECT_EQ(held[0]["samples"][0], json::parse(R"([0, 8, "0.5", null])"));
  EXPECT_EQ(held[0]["samples"][3], json::parse(R"([3, 8, "3.5", "yes"])"));
}

TEST(PageChannels, AreFewerOfManyValues) {
  SecondsChannel channels;
  std::vector<std::string> notes;
  const json held = ChannelsForPage(channels, 0, 10, {.max_samples = 100, .max_values = 6}, &notes);
  EXPECT_EQ(held[0]["samples"].size(), 4u);
}

}  // namespace shoal::page_channels_test
