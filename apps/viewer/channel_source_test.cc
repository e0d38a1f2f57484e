#include "apps/viewer/channel_source.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/tools/view/view_testing.h"

namespace shoal::channel_source_test {

using nlohmann::json;

std::vector<uint8_t> NavBytes(double x_m) {
  const Bytes bytes = Encoded(NavAt(1'000'000, x_m, 2));
  return {bytes.begin(), bytes.end()};
}

TEST(FieldName, IsAChannelAndAPath) {
  const auto name = ParseFieldName("NAV_ALPHA:x_m");
  ASSERT_TRUE(name.ok());
  EXPECT_EQ(name->channel, "NAV_ALPHA");
  EXPECT_EQ(name->path, "x_m");
  for (const char* text : {"", "NAV_ALPHA", ":x_m", "NAV_ALPHA:"}) {
    EXPECT_EQ(ParseFieldName(text).error(),
              "field must be CHANNEL:PATH, such as NAV_ALPHA:x_m, not '" + std::string(text) + "'");
  }
}

TEST(Message, IsShownWithItsTypeAndValues) {
  const json message =
      json::parse(MessageJsonOf({.channel = "NAV_ALPHA", .t_s = 1, .data = NavBytes(12.5)}));
  EXPECT_EQ(message["type"], "nav_t");
  const json x = {{"path", "x_m"}, {"text", "12.5"}, {"number", true}};
  EXPECT_NE(std::find(message["fields"].begin(), message["fields"].end(), x),
            message["fields"].end());
  EXPECT_EQ(message["left_out"], 0);
}

TEST(Message, OfUnknownBytesShowsItsFingerprintAndNoValues) {
  const json message =
      json::parse(MessageJsonOf({.channel = "X", .t_s = 1, .data = {1, 2, 3, 4, 5, 6, 7, 8, 9}}));
  EXPECT_EQ(message["type"], "fingerprint 0x0102030405060708");
  EXPECT_TRUE(message["fields"].empty());
}

TEST(Message, ThatIsVeryLongIsNotDecoded) {
  view_polygon_t polygon{};
  polygon.num_points = 100'000;
  polygon.x_m.resize(100'000);
  polygon.y_m.resize(100'000);
  const Bytes bytes = Encoded(polygon);
  const json message = json::parse(
      MessageJsonOf({.channel = "VIEW_POLYGON", .t_s = 1, .data = {bytes.begin(), bytes.end()}}));
  EXPECT_EQ(message["type"], "view_polygon_t");
  EXPECT_TRUE(message["fields"].empty());
}

TEST(Value, IsFoundByItsPathAndJoinedOverAllElements) {
  const std::vector<Leaf> leaves = {{.path = "n", .text = "7"},
                                    {.path = "aims[0].name", .text = "a"},
                                    {.path = "aims[1].name", .text = "b"},
                                    {.path = "aims[1].weight", .text = "3"},
                                    {.path = "aims[2].name", .text = "a"},
                                    {.path = "why", .text = "\"\""}};
  EXPECT_EQ(ValueAt(leaves, "n"), "7");
  EXPECT_EQ(ValueAt(leaves, "aims[1].name"), "b");
  EXPECT_EQ(ValueAt(leaves, "aims[].name"), "a, b");
  EXPECT_EQ(ValueAt(leaves, "why"), "");
  EXPECT_EQ(ValueAt(leaves, "aims[3].name"), std::nullopt);
}

TEST(FieldSearch, FindsAllWordsWithoutRegardToCase) {
  FieldSearch search("nav X_m");
  EXPECT_TRUE(search.Take("NAV_ALPHA", NavBytes(1)));
  EXPECT_TRUE(search.Take("OTHER", NavBytes(1)));
  const json found = json::parse(search.Json());
  EXPECT_EQ(found["fields"], json::parse(R"(["NAV_ALPHA:x_m"])"));
  EXPECT_EQ(found["more"], false);
}

TEST(FieldSearch, EndsWhereEnoughWasFound) {
  FieldSearch search("");
  int num = 0;
  while (search.Take("NAV_" + std::to_string(num), NavBytes(1))) ++num;
  const json found = json::parse(search.Json());
  EXPECT_EQ(found["fields"].size(), ChannelSource::kMaxFields);
  EXPECT_EQ(found["more"], true);
}

TEST(Series, IsOfNumbersOrOfTexts) {
  const json numbers = json::parse(SeriesJsonOf("A:b", {{1, "2.5"}, {2, "true"}, {3, "nan"}}));
  EXPECT_EQ(numbers["number"], true);
  EXPECT_EQ(numbers["value"], json::parse("[2.5, 1, null]"));
  const json texts = json::parse(SeriesJsonOf("A:b", {{1, "DRIVE"}, {2, "</script>"}}));
  EXPECT_EQ(texts["number"], false);
  EXPECT_EQ(texts["value"], json::parse(R"(["DRIVE", "</script>"])"));
}

}  // namespace shoal::channel_source_test
