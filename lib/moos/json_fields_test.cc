#include "lib/moos/json_fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace shoal {
namespace {

using Fields = std::vector<MoosField>;

Fields Parsed(std::string_view text) {
  auto fields = ParseJsonFields(text);
  EXPECT_TRUE(fields.ok()) << (fields.ok() ? "" : fields.error());
  return fields.ok() ? *fields : Fields();
}

std::string ErrorOf(std::string_view text) {
  const auto fields = ParseJsonFields(text);
  return fields.ok() ? "" : fields.error();
}

TEST(ParseJsonFields, KeepsOrderAndRepeatedNames) {
  EXPECT_EQ(Parsed(R"( {"B":"x, y","A":1,"B":""} )"),
            (Fields{{"B", "x, y"}, {"A", "1"}, {"B", ""}}));
  EXPECT_EQ(Parsed("{}"), Fields());
}

TEST(ParseJsonFields, KeepsNumbersAsTheyAreWritten) {
  EXPECT_EQ(Parsed(R"({"T":1252348077.590001,"N":-5,"U":18446744073709551615,"E":1.50e3})"),
            (Fields{{"T", "1252348077.590001"},
                    {"N", "-5"},
                    {"U", "18446744073709551615"},
                    {"E", "1.50e3"}}));
}

TEST(ParseJsonFields, MakesCompactJsonOfWhatIsNested) {
  EXPECT_EQ(Parsed(R"({"T": [ {"x": 1, "y": ["a\"", null]}, {}, [], true ], "Z": {"k": -1}})"),
            (Fields{{"T", R"([{"x":1,"y":["a\"",null]},{},[],true])"}, {"Z", R"({"k":-1})"}}));
}

TEST(ParseJsonFields, ReportsWhereTheJsonIsBroken) {
  EXPECT_EQ(ErrorOf(R"({"A":1,})"), "the JSON is broken at byte 8, near '1,}'");
  EXPECT_NE(ErrorOf(R"({"A":1} x)"), "");
  EXPECT_NE(ErrorOf(R"({"A":1e999})"), "");
  EXPECT_NE(ErrorOf("{\"A\":\"\xff\"}"), "");
  EXPECT_EQ(ErrorOf("[1]"), "JSON text must begin with '{'");
  EXPECT_EQ(ErrorOf(""), "JSON text must begin with '{'");
}

TEST(ParseJsonFields, TakesNestingOfAnyDepth) {
  constexpr size_t kDepth = 200'000;
  const std::string nested = std::string(kDepth, '[') + std::string(kDepth, ']');
  const Fields fields = Parsed("{\"A\":" + nested + "}");
  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].value, nested);
  EXPECT_NE(ErrorOf("{\"A\":" + std::string(kDepth, '[')), "");
}

RC_GTEST_PROP(ParseJsonFields, SurvivesAnyText, ()) {
  const auto text = *rc::gen::container<std::string>(
      rc::gen::element('{', '}', '[', ']', '"', ':', ',', '1', 'e', '\\', 'u', '\0', ' ', '\xff'));
  auto fields = ParseJsonFields("{" + text);
  RC_ASSERT((fields.ok() || !fields.error().empty()));
}

TEST(AppendJsonString, ReplacesBytesThatAreNotUtf8) {
  std::string text;
  AppendJsonString("a\xff\"\n", &text);
  EXPECT_EQ(text, "\"a\xEF\xBF\xBD\\\"\\n\"");
}

}  // namespace
}  // namespace shoal
