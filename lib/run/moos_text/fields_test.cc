#include "lib/run/moos_text/fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace shoal::fields_test {

using Fields = std::vector<MoosField>;

Fields Parsed(std::string_view text) {
  auto fields = ParseFields(text);
  EXPECT_TRUE(fields.ok()) << (fields.ok() ? "" : fields.error());
  return fields.ok() ? *fields : Fields();
}

std::string ErrorOf(std::string_view text) {
  const auto fields = ParseFields(text);
  return fields.ok() ? "" : fields.error();
}

std::string Written(const Fields& fields) {
  std::string text;
  for (const MoosField& field : fields) AppendField(field.key, field.value, &text);
  return text;
}

TEST(ParseFields, TakesBlanksAroundKeysAndValuesAway) {
  EXPECT_EQ(Parsed(" NAME = alpha , X= 5 "), (Fields{{"NAME", "alpha"}, {"X", "5"}}));
}

TEST(ParseFields, PassesOverEmptyFields) {
  EXPECT_EQ(Parsed(",A=1,, ,B=2,"), (Fields{{"A", "1"}, {"B", "2"}}));
  EXPECT_EQ(Parsed(""), Fields());
}

TEST(ParseFields, LeavesEqualsSignsAndBackslashesInAValueAlone) {
  EXPECT_EQ(Parsed("A=b=c\\n,D="), (Fields{{"A", "b=c\\n"}, {"D", ""}}));
}

TEST(ParseFields, LetsQuotesProtectCommas) {
  EXPECT_EQ(Parsed(R"(A="x, y" ,B=2)"), (Fields{{"A", "x, y"}, {"B", "2"}}));
  EXPECT_EQ(Parsed(R"(A="\"\\\n\x1b\q")"), (Fields{{"A", "\"\\\n\x1b\\q"}}));
}

TEST(ParseFields, LetsBracesProtectCommas) {
  EXPECT_EQ(Parsed("T={1,2:{3,4}},B=2"), (Fields{{"T", "{1,2:{3,4}}"}, {"B", "2"}}));
}

TEST(ParseFields, NamesTheFieldThatIsWrong) {
  EXPECT_EQ(ErrorOf("A=1,hello, world"),
            "field 2, 'hello', has no '='; write KEY=VALUE, and a value that holds a comma in "
            "double quotes");
  EXPECT_EQ(ErrorOf("A=1,=2"), "field 2 has no key; write KEY=VALUE");
  EXPECT_EQ(ErrorOf("A=\"x"), "the double quote of 'A' is never closed");
  EXPECT_EQ(ErrorOf("A=\"x\\\""), "the double quote of 'A' is never closed");
  EXPECT_EQ(ErrorOf("\"A=1"), "the double quote that begins field 1 is never closed");
  EXPECT_EQ(ErrorOf("A={{1}"),
            "the '{' of 'A' is never closed; write such a value in double quotes");
  EXPECT_EQ(ErrorOf("A=\"x\"y"),
            "'y' follows the closing quote of 'A'; write \\\" for a quote within quotes");
}

TEST(AppendField, WritesPlainWhatIsPlain) {
  EXPECT_EQ(Written({{"NAME", "alpha"}, {"MODE", "A@B:C=d"}, {"T", "{1,2}"}, {"E", ""}}),
            "NAME=alpha,MODE=A@B:C=d,T={1,2},E=");
}

TEST(AppendField, QuotesWhatWouldBeReadOtherwise) {
  EXPECT_EQ(Written({{"A", "x, y"}, {"B", "a \"hi\""}, {"C", " c"}, {"D", "{1"}, {"E", "a\nb"}}),
            R"(A="x, y",B="a \"hi\"",C=" c",D="{1",E="a\nb")");
  EXPECT_EQ(Written({{"k=v", "1"}, {"", "2"}}), R"("k=v"=1,""=2)");
}

/// Mostly the characters that mean something.
rc::Gen<std::string> OddText() {
  return rc::gen::container<std::string>(rc::gen::oneOf(
      rc::gen::element('a', ',', '"', '\\', '=', '{', '}', ' ', '\n', 'x', '1', '\0'),
      rc::gen::arbitrary<char>()));
}

RC_GTEST_PROP(AppendField, IsReadBackWhateverTheKeyAndTheValue, ()) {
  const auto pairs =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<std::pair<std::string, std::string>>>(
          rc::gen::pair(OddText(), OddText())));
  Fields fields;
  for (const auto& [key, value] : pairs) fields.push_back({key, value});
  const std::string text = Written(fields);
  RC_ASSERT(text.find('\n') == std::string::npos);
  Result<Fields> again = ParseFields(text);
  RC_ASSERT(again.ok());
  RC_ASSERT(*again == fields);
}

RC_GTEST_PROP(ParseFields, SurvivesAnyText, ()) {
  const std::string text = *OddText();
  Result<Fields> fields = ParseFields(text);
  RC_ASSERT((fields.ok() || !fields.error().empty()));
}

TEST(ParseFields, TakesTimeInProportionToTheLength) {
  constexpr size_t kSize = 1 << 20;
  EXPECT_NE(ErrorOf("A=" + std::string(kSize, '{')), "");
  EXPECT_NE(ErrorOf("A=\"" + std::string(kSize, '\\')), "");
  EXPECT_EQ(Parsed(std::string(kSize, ',')), Fields());
  EXPECT_LT(ErrorOf(std::string(kSize, 'k')).size(), 300U);
}

}  // namespace shoal::fields_test
