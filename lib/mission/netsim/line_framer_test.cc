#include "lib/mission/netsim/line_framer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace shoal::line_framer_test {

using Lines = std::vector<std::string>;

Lines PushAll(LineFramer* framer, const std::vector<std::string>& pieces) {
  Lines lines;
  for (const std::string& piece : pieces) {
    framer->Push(piece, [&](std::string_view line) { lines.emplace_back(line); });
  }
  return lines;
}

Lines Frame(const std::vector<std::string>& pieces, size_t max_line_bytes = 10) {
  LineFramer framer(max_line_bytes);
  return PushAll(&framer, pieces);
}

TEST(LineFramer, KeepsALineUntilItsEnd) {
  EXPECT_EQ(Frame({"ab", "", "c"}), Lines{});
  EXPECT_EQ(Frame({"ab", "c\nd"}), Lines{"abc"});
}

TEST(LineFramer, TakesManyLinesAtOnce) { EXPECT_EQ(Frame({"a\n\nb\n"}), (Lines{"a", "", "b"})); }

TEST(LineFramer, TakesOneCrOff) {
  EXPECT_EQ(Frame({"a\r\n\r\nb\r\r\n", "c\r", "\n"}), (Lines{"a", "", "b\r", "c"}));
}

TEST(LineFramer, TakesALineThatIsJustShortEnough) {
  LineFramer framer(3);
  EXPECT_EQ(PushAll(&framer, {"abc\n"}), Lines{"abc"});
  EXPECT_EQ(framer.num_too_long(), 0);
}

TEST(LineFramer, SkipsALineThatIsTooLong) {
  LineFramer framer(3);
  EXPECT_EQ(PushAll(&framer, {"abcd\nx\n"}), Lines{"x"});
  EXPECT_EQ(PushAll(&framer, {"abc", "d", "efghi", "j\nx", "\n"}), Lines{"x"});
  EXPECT_EQ(framer.num_too_long(), 2);
}

TEST(LineFramer, KeepsNoMoreThanALine) {
  LineFramer framer(100'000);
  for (int i = 0; i < 1000; ++i) PushAll(&framer, {std::string(10'000, 'x')});
  EXPECT_LT(framer.capacity(), 200'001U);
  EXPECT_EQ(framer.num_too_long(), 1);
}

TEST(LineFramer, GivesALongLinesMemoryBack) {
  LineFramer framer(1'000'000);
  EXPECT_EQ(PushAll(&framer, {std::string(500'000, 'x'), "\n"}).size(), 1U);
  EXPECT_LT(framer.capacity(), 10'000U);
}

RC_GTEST_PROP(LineFramer, GivesTheSameLinesInWhateverPieces, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '\r', '\n'));
  std::vector<std::string> pieces;
  for (size_t begin = 0; begin < text.size();) {
    const auto size = *rc::gen::inRange<size_t>(1, 8);
    pieces.push_back(text.substr(begin, size));
    begin += size;
  }
  RC_ASSERT(Frame(pieces) == Frame({text}));
}

}  // namespace shoal::line_framer_test
