#include "apps/viewer/view_request.h"

#include <gtest/gtest.h>

namespace shoal::view_request_test {

TEST(ViewRequest, ReadsATime) {
  EXPECT_EQ(*ParseTimeQuery({{"t", "12.5"}}), 12.5);
  EXPECT_EQ(*ParseTimeQuery({{"t", "-1e300"}}), -1e300);
  EXPECT_EQ(*ParseTimeQuery({}), kNoTimeGiven_s);
}

TEST(ViewRequest, RefusesTimesThatAreNoNumbers) {
  for (const char* text :
       {"", "nan", "inf", "-inf", "1e999", "1 ", " 1", "1x", "+1", "0x10", "1,5"}) {
    const auto time = ParseTimeQuery({{"t", text}});
    ASSERT_FALSE(time.ok()) << text;
    EXPECT_NE(time.error().find("t must be a number"), std::string::npos) << time.error();
  }
  EXPECT_FALSE(ParseTimeQuery({{"t", std::string(1'000'000, '1')}}).ok());
}

TEST(ViewRequest, NamesUnknownPartsOfAQuery) {
  const auto time = ParseTimeQuery({{"time", "1"}});
  ASSERT_FALSE(time.ok());
  EXPECT_EQ(time.error(), "unknown in this query: 'time'; known: t, token");
  EXPECT_FALSE(ParseTimeQuery({{"t", "1"}, {"t", "2"}}).ok());
}

TEST(ViewRequest, ReadsALink) {
  const auto link = ParseLinkQuery({{"from", "alpha"}, {"to", "bravo"}, {"t", "3"}});
  ASSERT_TRUE(link.ok());
  EXPECT_EQ(link->from, "alpha");
  EXPECT_EQ(link->to, "bravo");
  EXPECT_EQ(link->t_s, 3);
  EXPECT_FALSE(ParseLinkQuery({{"from", "alpha"}}).ok());
  EXPECT_FALSE(ParseLinkQuery({{"from", ""}, {"to", "bravo"}}).ok());
  EXPECT_FALSE(ParseLinkQuery({{"from", std::string(65, 'a')}, {"to", "bravo"}}).ok());
  EXPECT_FALSE(ParseLinkQuery({{"from", "a\n"}, {"to", "bravo"}}).ok());
}

TEST(ViewRequest, ReadsAVehicleWithinItsBounds) {
  const auto vehicle = ParseVehicleQuery({{"name", "alpha"}, {"window", "60"}});
  ASSERT_TRUE(vehicle.ok());
  EXPECT_EQ(vehicle->name, "alpha");
  EXPECT_EQ(vehicle->window_s, 60);
  EXPECT_EQ(ParseVehicleQuery({{"name", "alpha"}})->window_s, 120);
  for (const char* window : {"0.5", "3601", "nan", "-1"}) {
    EXPECT_FALSE(ParseVehicleQuery({{"name", "alpha"}, {"window", window}}).ok()) << window;
  }
}

TEST(ViewRequest, ReadsFates) {
  const auto query = ParseFateQuery({{"vehicle", "alpha"},
                                     {"kind", "report"},
                                     {"cause", "out_of_range"},
                                     {"blocked", "1"},
                                     {"after", "4711"},
                                     {"limit", "500"},
                                     {"t", "9"}});
  ASSERT_TRUE(query.ok());
  EXPECT_EQ(query->fates.vehicle, "alpha");
  EXPECT_EQ(query->fates.kind, "report");
  EXPECT_EQ(query->fates.cause, "out_of_range");
  EXPECT_TRUE(query->fates.only_blocked);
  EXPECT_EQ(query->fates.after, 4711);
  EXPECT_EQ(query->fates.limit, 500);
  EXPECT_EQ(query->t_s, 9);
  const auto all = ParseFateQuery({{"vehicle", ""}});
  ASSERT_TRUE(all.ok());
  EXPECT_EQ(all->fates.after, -1);
  EXPECT_EQ(all->fates.limit, 200);
  EXPECT_FALSE(all->fates.only_blocked);
}

TEST(ViewRequest, RefusesFatesBeyondTheirBounds) {
  EXPECT_FALSE(ParseFateQuery({{"limit", "0"}}).ok());
  EXPECT_FALSE(ParseFateQuery({{"limit", "501"}}).ok());
  EXPECT_FALSE(ParseFateQuery({{"limit", "2.5"}}).ok());
  EXPECT_FALSE(ParseFateQuery({{"after", "-2"}}).ok());
  EXPECT_FALSE(ParseFateQuery({{"after", "9223372036854775808"}}).ok());
  EXPECT_FALSE(ParseFateQuery({{"blocked", "yes"}}).ok());
}

TEST(ViewRequest, ReadsACommand) {
  const auto command = ParseCommandBody(R"({"target": "alpha", "words": ["goto", "100", "-50"]})");
  ASSERT_TRUE(command.ok());
  EXPECT_EQ(command->target, "alpha");
  EXPECT_EQ(command->words, (std::vector<std::string>{"goto", "100", "-50"}));
  EXPECT_TRUE(ParseCommandBody(R"({"words": [], "target": "x"})").ok());
}

TEST(ViewRequest, RefusesBodiesThatAreNoCommand) {
  for (const char* body :
       {"", "{", "null", "[]", "1", R"("x")", "{}", R"({"target": "a"})", R"({"words": []})",
        R"({"target": 1, "words": []})", R"({"target": "", "words": []})",
        R"({"target": "a", "words": "b"})", R"({"target": "a", "words": [1]})",
        R"({"target": "a", "words": [["b"]]})", R"({"target": "a", "words": [], "more": 1})",
        R"({"target": "a\u0000", "words": []})", R"({"target": "a", "words": ["\n"]})",
        R"({"target": "a", "words": []} x)", "{\"target\": \"\xff\", \"words\": []}"}) {
    EXPECT_FALSE(ParseCommandBody(body).ok()) << body;
  }
}

TEST(ViewRequest, BoundsACommand) {
  const auto body = [](size_t num_words, size_t length) {
    std::string words;
    for (size_t i = 0; i < num_words; ++i) {
      words += (i == 0 ? "\"" : ",\"") + std::string(length, 'w') + "\"";
    }
    return R"({"target": "a", "words": [)" + words + "]}";
  };
  EXPECT_TRUE(ParseCommandBody(body(64, 10)).ok());
  EXPECT_FALSE(ParseCommandBody(body(65, 10)).ok());
  EXPECT_TRUE(ParseCommandBody(body(1, 1000)).ok());
  EXPECT_FALSE(ParseCommandBody(body(1, 1001)).ok());
  const std::string deep(60'000, '[');
  EXPECT_FALSE(ParseCommandBody(deep).ok());
  EXPECT_FALSE(ParseCommandBody(R"({"target": "a", "words": )" + deep).ok());
  EXPECT_FALSE(
      ParseCommandBody(R"({"target": "a", "words": )" + deep + std::string(60'000, ']') + "}")
          .ok());
}

}  // namespace shoal::view_request_test
