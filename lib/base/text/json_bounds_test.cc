#include "lib/base/text/json_bounds.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::json_bounds_test {

TEST(JsonBounds, AreOfListsAndObjectsWithinEachOther) {
  EXPECT_EQ(WhyNotWithin("[{\"a\": [1]}]", {.depth = 3, .num_values = 100}), "");
  EXPECT_EQ(WhyNotWithin("[\n{\"a\":\n [[1]]}]", {.depth = 3, .num_values = 100}),
            "line 3: nested more than 3 deep");
  EXPECT_EQ(WhyNotWithin("[[],[],{},[[]]]", {.depth = 3, .num_values = 100}), "");
  EXPECT_EQ(WhyNotWithin("]]]}[", {.depth = 1, .num_values = 100}), "")
      << "for the parser to refuse";
}

TEST(JsonBounds, PassOverWhatStandsInTexts) {
  EXPECT_EQ(WhyNotWithin(R"(["[[[[", "\"[[[", "\\"])", {.depth = 1, .num_values = 10}), "");
  EXPECT_NE(WhyNotWithin(R"(["\\", [[1]]])", {.depth = 2, .num_values = 10}), "");
  EXPECT_EQ(WhyNotWithin("\"[[[", {.depth = 1, .num_values = 10}), "");
  EXPECT_EQ(WhyNotWithin("\"\\", {.depth = 1, .num_values = 10}), "");
}

TEST(JsonBounds, AreOfValues) {
  std::string list = "[0";
  for (int i = 1; i < 9; ++i) list += ",\n" + std::to_string(i);
  EXPECT_EQ(WhyNotWithin(list + "]", {.depth = 1, .num_values = 10}), "");
  EXPECT_EQ(WhyNotWithin(list + ",9]", {.depth = 1, .num_values = 10}),
            "line 9: more than 10 values");
  EXPECT_EQ(WhyNotWithin(R"({"a": 1, "b": 2})", {.depth = 1, .num_values = 5}), "");
  EXPECT_NE(WhyNotWithin(R"({"a": 1, "b": 2})", {.depth = 1, .num_values = 4}), "");
}

}  // namespace shoal::json_bounds_test
