#include "lib/sea/acoustics/bit_errors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <numeric>

#include "tests/golden/read_golden.h"

namespace shoal::bit_errors_test {

using Bytes = std::vector<uint8_t>;

int64_t NumDifferentBits(const Bytes& a, const Bytes& b) {
  int64_t count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    count += std::popcount(static_cast<uint8_t>(a[i] ^ b[i]));
  }
  return count;
}

TEST(FlipBit, FlipsTheBitsOfTheGoldenTable) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/flip_bits.csv")) {
    Bytes bytes = FromHex(row.at("hex_in"));
    std::istringstream positions(row.at("bit_positions"));
    for (size_t position = 0; positions >> position;) FlipBit(bytes, position);
    EXPECT_EQ(bytes, FromHex(row.at("hex_out")));
  }
}

RC_GTEST_PROP(FlipRandomBits, FlipsAsManyDifferentBitsAsDemanded, (const Bytes& sent)) {
  const auto num_bits = static_cast<int64_t>(8 * sent.size());
  const int64_t count = *rc::gen::inRange<int64_t>(0, num_bits + 1);
  Bytes received = sent;
  Bytes scratch;
  Stream stream(1, "flips", sent.size());
  FlipRandomBits(count, &stream, received, &scratch);
  RC_ASSERT(NumDifferentBits(sent, received) == count);
}

TEST(FlipRandomBits, ChoosesEveryPairOfBitsEquallyOften) {
  constexpr int kDraws = 28 * 1000;
  std::vector<int> counts(256, 0);  // By the byte that comes out: 28 have two bits.
  Bytes scratch;
  for (int i = 0; i < kDraws; ++i) {
    Stream stream(1, "pairs", i);
    Bytes byte = {0};
    FlipRandomBits(2, &stream, byte, &scratch);
    ++counts[byte[0]];
  }
  double chi_square = 0;
  int num_pairs = 0;
  for (unsigned value = 0; value < 256; ++value) {
    if (std::popcount(value) != 2) continue;
    ++num_pairs;
    chi_square += (counts[value] - 1000.0) * (counts[value] - 1000.0) / 1000.0;
  }
  EXPECT_EQ(num_pairs, 28);
  EXPECT_LT(chi_square, 80.3);  // 27 degrees of freedom; exceeded with probability 1e-6 or less.
}

constexpr double kBytesPerS = 125;  ///< At 1000 bit/s.

Arrival MakeArrival(const Bytes& bytes, double start_s) {
  return {start_s, start_s + static_cast<double>(bytes.size()) / kBytesPerS, bytes};
}

TEST(FindByteWindow, CoversAllOfAPacketThatAnotherOfItsLengthMeetsAtOnce) {
  // 37 bytes take 0.296 s, and 0.296 * 125 is a little less than 37.
  const Bytes bytes(37);
  for (int i = 0; i < 1000; ++i) {
    const double start_s = 0.37 * i;
    const ByteWindow window =
        FindByteWindow(MakeArrival(bytes, start_s), MakeArrival(bytes, start_s), kBytesPerS);
    EXPECT_EQ(window.begin_a, 0U);
    EXPECT_EQ(window.begin_b, 0U);
    ASSERT_EQ(window.count, 37U) << start_s;
  }
}

TEST(FindByteWindow, CoversTheTailOfTheFirstAndTheHeadOfTheSecond) {
  const Bytes first(10);
  const Bytes second(20);
  const ByteWindow window =
      FindByteWindow(MakeArrival(first, 1), MakeArrival(second, 1 + 6 / kBytesPerS), kBytesPerS);
  EXPECT_EQ(window.begin_a, 6U);
  EXPECT_EQ(window.begin_b, 0U);
  EXPECT_EQ(window.count, 4U);
}

TEST(FindByteWindow, IsEmptyWherePacketsOnlyTouchOrShareLessThanAByte) {
  const Bytes bytes(10);
  for (const double bytes_apart : {9.1, 10.0, 11.0, 1e300}) {
    EXPECT_EQ(FindByteWindow(MakeArrival(bytes, 0), MakeArrival(bytes, bytes_apart / kBytesPerS),
                             kBytesPerS)
                  .count,
              0U);
  }
}

RC_GTEST_PROP(FindByteWindow, NeverLeavesThePackets,
              (const Bytes& first, const Bytes& second, double start_s)) {
  const Arrival a = MakeArrival(first, 0);
  const Arrival b = MakeArrival(second, start_s);
  const ByteWindow window = FindByteWindow(a, b, kBytesPerS);
  RC_ASSERT(window.begin_a + window.count <= first.size());
  RC_ASSERT(window.begin_b + window.count <= second.size());
}

TEST(XorOverlap, LeavesZerosWhereAPacketMeetsItsTwin) {
  Bytes sent(8);
  std::iota(sent.begin(), sent.end(), uint8_t{1});
  Bytes received = sent;
  XorOverlap(MakeArrival(sent, 0), MakeArrival(sent, 0), kBytesPerS, received);
  EXPECT_EQ(received, Bytes(8, 0));
}

// a: 4 bytes at 1 byte per second from 0 s; b: 8 bytes at 4 bytes per second from 1 s, so that it
// ends at 3 s.
TEST(XorOverlapOfRates, PutsOnEachByteWhatIsThereInItsMiddle) {
  const std::vector<uint8_t> slow = {0x10, 0x20, 0x30, 0x40};
  const std::vector<uint8_t> fast = {1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<uint8_t> received = slow;
  XorOverlapOfRates({0, 4, slow}, 1, {1, 3, fast}, 4, received);
  EXPECT_EQ(received, (std::vector<uint8_t>{0x10, 0x23, 0x37, 0x40}));
  received = fast;
  XorOverlapOfRates({1, 3, fast}, 4, {0, 4, slow}, 1, received);
  EXPECT_EQ(received, (std::vector<uint8_t>{0x21, 0x22, 0x23, 0x24, 0x35, 0x36, 0x37, 0x38}));
}

}  // namespace shoal::bit_errors_test
