#include "lib/sea/modem/raw_modem.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace shoal::raw_modem_test {

using Bytes = std::vector<uint8_t>;

/// Gives the stream in parts of `step` bytes.
std::vector<Bytes> TakeInParts(const Bytes& stream, size_t step, RawModemReader* reader) {
  std::vector<Bytes> all;
  for (size_t i = 0; i < stream.size(); i += step) {
    const auto part =
        std::span<const uint8_t>(stream).subspan(i, std::min(step, stream.size() - i));
    for (Bytes& payload : reader->Take(part)) all.push_back(std::move(payload));
  }
  return all;
}

TEST(RawModem, PutsTheLengthInFrontMostSignificantByteFirst) {
  EXPECT_EQ(EncodeRawPiece(Bytes{'h', 'i'}), (Bytes{0, 2, 'h', 'i'}));
  const Bytes longest = EncodeRawPiece(Bytes(65'535, 1));
  EXPECT_EQ(longest.size(), 65'537U);
  EXPECT_EQ(longest[0] << 8 | longest[1], 65'535);
  EXPECT_EQ(EncodeRawPiece(Bytes(0x0102, 1))[0], 1);
}

TEST(RawModem, MakesNoPieceOfWhatNoneCanHold) {
  EXPECT_TRUE(EncodeRawPiece({}).empty());
  EXPECT_TRUE(EncodeRawPiece(Bytes(65'536, 1)).empty());
}

TEST(RawModemReader, ForgetsThePieceOfAClientThatHasGoneAndKeepsTheCounts) {
  const Bytes first = {0, 1, 'a', 0, 0, 0, 9, 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i', 'j'};
  const Bytes second = {0, 1, 'z'};
  for (size_t length = 0; length <= first.size(); ++length) {
    RawModemReader reader({.max_bytes = 8});
    (void)reader.Take(std::span<const uint8_t>(first).first(length));
    reader.ForgetPiece();
    EXPECT_TRUE(reader.is_between_pieces());
    EXPECT_EQ(reader.Take(second), std::vector<Bytes>{{'z'}}) << length;
    const RawModemCounts& counts = reader.counts();
    EXPECT_EQ(counts.received, counts.delivered + counts.empty + counts.too_long + counts.cut_off);
    EXPECT_EQ(counts.received, 1 + (length >= 2) + (length >= 5) + (length >= 7));
    EXPECT_EQ(counts.cut_off, length == 2 ? 1 : 0);
  }
}

TEST(RawModemReader, FindsPiecesHoweverTheStreamIsCut) {
  const Bytes stream = {0, 1, 'a', 0, 3, 'b', 'c', 'd', 0, 2, 'e'};
  for (size_t step = 1; step <= stream.size(); ++step) {
    RawModemReader reader({});
    EXPECT_EQ(TakeInParts(stream, step, &reader), (std::vector<Bytes>{{'a'}, {'b', 'c', 'd'}}));
    EXPECT_FALSE(reader.is_between_pieces());
    EXPECT_EQ(reader.Take(Bytes{'f'}), (std::vector<Bytes>{{'e', 'f'}}));
    EXPECT_TRUE(reader.is_between_pieces());
  }
}

TEST(RawModemReader, SkipsWhatIsTooLongAndWhatIsEmpty) {
  const Bytes stream = {0, 0, 0, 4, 1, 2, 3, 4, 0, 3, 5, 6, 7, 0, 0, 0, 1, 8};
  for (size_t step = 1; step <= stream.size(); ++step) {
    RawModemReader reader({.max_bytes = 3});
    EXPECT_EQ(TakeInParts(stream, step, &reader), (std::vector<Bytes>{{5, 6, 7}, {8}}));
    EXPECT_EQ(reader.counts(),
              (RawModemCounts{.received = 5, .delivered = 2, .empty = 2, .too_long = 1}));
  }
}

RC_GTEST_PROP(RawModemReaderProperty, ReturnsWhatWasSent, (const std::vector<Bytes>& sent)) {
  Bytes stream;
  std::vector<Bytes> expected;
  for (const Bytes& payload : sent) {
    const Bytes piece = EncodeRawPiece(payload);
    stream.insert(stream.end(), piece.begin(), piece.end());
    if (!payload.empty()) expected.push_back(payload);
  }
  RawModemReader reader({});
  RC_ASSERT(TakeInParts(stream, *rc::gen::inRange<size_t>(1, 50), &reader) == expected);
  RC_ASSERT(reader.is_between_pieces());
}

RC_GTEST_PROP(RawModemReaderProperty, CountsEachPieceOnceWhateverTheBytesAre,
              (const Bytes& stream)) {
  RawModemReader reader({.max_bytes = 20});
  const auto payloads = TakeInParts(stream, 7, &reader);
  const RawModemCounts& counts = reader.counts();
  RC_ASSERT(counts.received == counts.delivered + counts.empty + counts.too_long);
  RC_ASSERT(std::ssize(payloads) <= counts.delivered);
  RC_ASSERT(counts.delivered <= std::ssize(payloads) + 1);
  for (const Bytes& payload : payloads) RC_ASSERT(!payload.empty() && payload.size() <= 20);
}

}  // namespace shoal::raw_modem_test
