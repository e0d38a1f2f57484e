#include "lib/bus/record/valid_utf8.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace shoal::valid_utf8_test {

const std::string kMark = "\xEF\xBF\xBD";

TEST(ValidUtf8, LeavesTextAsItIs) {
  for (const char* text :
       {"", "alpha", "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x90\x9F", "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(ValidUtf8(text), text);
  }
}

TEST(ValidUtf8, ReplacesBytesThatAreNoText) {
  EXPECT_EQ(ValidUtf8("a\xFF"
                      "b"),
            "a" + kMark + "b");
  EXPECT_EQ(ValidUtf8("\xC3"), kMark) << "cut off";
  EXPECT_EQ(ValidUtf8("\xC0\xAF"), kMark + kMark) << "longer than need be";
  EXPECT_EQ(ValidUtf8("\xED\xA0\x80"), kMark + kMark + kMark) << "a surrogate";
  EXPECT_EQ(ValidUtf8("\xF4\x90\x80\x80"), kMark + kMark + kMark + kMark) << "too large";
}

RC_GTEST_PROP(ValidUtf8, MakesTextOfAnyBytes, (const std::string& bytes)) {
  const std::string valid = ValidUtf8(bytes);
  RC_ASSERT(ValidUtf8(valid) == valid);
}

}  // namespace shoal::valid_utf8_test
