#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/base/schema/schema.h"

namespace shoal::parse_test {

std::string ErrorOf(const std::string& text) {
  const auto parsed = ParseLcm({.file = "a.lcm", .text = text});
  return parsed.ok() ? "" : parsed.error();
}

TEST(ParseLcm, ReadsPackagesStructsMembersAndConstants) {
  const auto parsed = ParseLcm({.file = "a.lcm", .text = R"(
package a.b; /* a block
comment */ struct first_t {
  int32_t n, m;  // two of a kind
  double x[n][0x3];
  other_t nested; c.far_t far;
  const int8_t LOW = -1, HIGH = 0x7f; const double SCALE = -1.5e-3;
}
struct second_t { })"});
  ASSERT_TRUE(parsed.ok()) << parsed.error();
  ASSERT_EQ(parsed->size(), 2U);

  const StructType& first = (*parsed)[0];
  EXPECT_EQ(first.FullName(), "a.b.first_t");
  ASSERT_EQ(first.members.size(), 5U);
  EXPECT_EQ(first.members[1].name, "m");
  EXPECT_EQ(first.members[1].primitive, Primitive::kInt32);
  ASSERT_EQ(first.members[2].dimensions.size(), 2U);
  EXPECT_TRUE(first.members[2].dimensions[0].is_variable());
  EXPECT_EQ(first.members[2].dimensions[0].text, "n");
  EXPECT_EQ(first.members[2].dimensions[1].fixed_size, 3);
  EXPECT_EQ(first.members[2].dimensions[1].text, "0x3");
  EXPECT_TRUE(first.members[0].length_slot);
  EXPECT_FALSE(first.members[1].length_slot);
  EXPECT_EQ(first.members[3].type_name, "a.b.other_t");
  EXPECT_EQ(first.members[4].type_name, "c.far_t");
  ASSERT_EQ(first.constants.size(), 3U);
  EXPECT_EQ(first.constants[1].name, "HIGH");
  EXPECT_EQ(first.constants[1].value, "0x7f");
  EXPECT_EQ(first.constants[2].value, "-1.5e-3");

  EXPECT_EQ((*parsed)[1].FullName(), "a.b.second_t");
  EXPECT_TRUE((*parsed)[1].members.empty());
}

TEST(ParseLcm, ReportsWhereAndWhatIsWrong) {
  EXPECT_EQ(ErrorOf("struct t {\n  int32_t a\n}"), "a.lcm:3:1: expected ';', found '}'");
  EXPECT_EQ(ErrorOf("struct t { int32_t 1a; }"),
            "a.lcm:1:20: expected the name of a member, found '1a'");
  EXPECT_EQ(ErrorOf("struct t { int32_t a; double a; }"), "a.lcm:1:30: 'a' is there twice");
  EXPECT_EQ(ErrorOf("struct t { int32_t a; const int8_t a = 1; }"),
            "a.lcm:1:36: 'a' is there twice");
  EXPECT_EQ(ErrorOf("struct t { double x[n]; }"),
            "a.lcm:1:21: an array's length is a number, or a constant or a member that its struct "
            "declares before it, found 'n'");
  EXPECT_EQ(ErrorOf("struct t { double n; double x[n]; }"),
            "a.lcm:1:31: an array's length must be a single integer, found 'n'");
  EXPECT_EQ(ErrorOf("struct t { int8_t n[2]; double x[n]; }"),
            "a.lcm:1:34: an array's length must be a single integer, found 'n'");
  for (const char* size : {"0", "1.5", "08", "99999999999999999999"}) {
    EXPECT_EQ(ErrorOf("struct t { double x[" + std::string(size) + "]; }"),
              "a.lcm:1:21: an array's size is a whole number greater than 0");
  }
  EXPECT_EQ(ErrorOf("struct t { const string A = 1; }"),
            "a.lcm:1:18: a constant is an integer, a float or a double");
  EXPECT_EQ(ErrorOf("struct t { const int8_t A = x; }"),
            "a.lcm:1:29: expected a number of type int8_t, found 'x'");
  EXPECT_EQ(ErrorOf("enum e { A }"),
            "a.lcm:1:1: enums have no place in LCM's C++; use constants of int8_t");
  EXPECT_EQ(ErrorOf("struct t {"),
            "a.lcm:1:11: expected the name of a member's type, found the end of the file");
  EXPECT_EQ(ErrorOf("/* open"), "");
}

RC_GTEST_PROP(ParseLcm, EndsWhateverTheText, ()) {
  const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "package", "struct", "const", "int32_t", "string", "n", "m", "{", "}", "[", "]", ";", ",",
      "=", "-", "3", "0x", "/*", "*/", "//", "\n", ".", std::string(1, '\0'), "\xff"));
  std::string text;
  for (const std::string& word : words) text += word + " ";
  const auto parsed = ParseLcm({.file = "a.lcm", .text = text});
  if (!parsed.ok()) RC_ASSERT(parsed.error().starts_with("a.lcm:"));
}

}  // namespace shoal::parse_test
