#include "lib/base/random/stream.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "lib/base/random/philox.h"

namespace shoal::stream_test {

// Vectors of Random123's kat_vectors, philox4x32 with 10 rounds.
TEST(Philox, GivesThePublishedAnswers) {
  EXPECT_EQ(Philox4x32({0, 0, 0, 0}, {0, 0}),
            (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(Philox4x32({~0U, ~0U, ~0U, ~0U}, {~0U, ~0U}),
            (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(Philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// Recorded missions depend on these bits, worked out from the contract of StreamKey by a second
// implementation.
TEST(Stream, HashesItsNameAsDocumented) {
  Stream stream(7, "blackout", "alpha", 3);
  EXPECT_EQ(stream.Bits(), 0x2f18e6b023551f8eU);
  EXPECT_EQ(stream.Bits(), 0x641c93fc0711496dU);
  EXPECT_EQ(stream.Bits(), 0x3e52c34b1ab5118dU);
  EXPECT_EQ(stream.Bits(), 0xa0416bc87f43accdU);
}

TEST(Stream, IsTheSameForTheSameName) {
  Stream a(1, "loss", "alpha", "bravo", 17);
  Stream b(StreamKey(1, "loss").With("alpha").With("bravo").With(17));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(a.Bits(), b.Bits());
}

TEST(Stream, DiffersWhereAnyPartOfTheNameDiffers) {
  std::vector<Stream> streams = {
      Stream(1, "loss"),
      Stream(2, "loss"),
      Stream(1, "delay"),
      Stream(1, "loss", ""),
      Stream(1, "loss", 0),
      Stream(1, "loss", "alpha", "bravo"),
      Stream(1, "loss", "bravo", "alpha"),
      Stream(1, "loss", "alphabravo"),
      Stream(1, "loss", "alphab", "ravo"),
      Stream(1, "loss", "alpha", "bravo", 1),
      Stream(1, "loss", "alpha", "bravo", -1),
      Stream(1, "loss", std::string("alpha\0", 6), "bravo"),
  };
  std::set<uint64_t> first_bits;
  for (Stream& stream : streams) first_bits.insert(stream.Bits());
  EXPECT_EQ(first_bits.size(), streams.size());
}

RC_GTEST_PROP(Stream, HasNoTwinAmongOtherNames, (const std::string& a, const std::string& b)) {
  RC_PRE(a != b);
  Stream first(1, "loss", a);
  Stream second(1, "loss", b);
  RC_ASSERT(first.Bits() != second.Bits());
}

TEST(Stream, IsIndependentOfOtherStreamsDraws) {
  Stream alone(5, "loss", "alpha", "bravo");
  Stream beside(5, "loss", "alpha", "bravo");
  Stream newcomer(5, "loss", "alpha", "charlie");
  for (int i = 0; i < 100; ++i) {
    newcomer.Normal();
    EXPECT_EQ(alone.Uniform(), beside.Uniform());
  }
}

// Kolmogorov and Smirnov: sqrt(n) D exceeds 1.95 with probability 0.001.
TEST(Uniform, PassesKolmogorovSmirnovAtOneInAThousand) {
  constexpr int kCount = 20'000;
  Stream stream(11, "test");
  std::vector<double> draws(kCount);
  for (double& draw : draws) {
    draw = stream.Uniform();
    ASSERT_GE(draw, 0);
    ASSERT_LT(draw, 1);
  }
  std::sort(draws.begin(), draws.end());
  double largest = 0;
  for (int i = 0; i < kCount; ++i) {
    const double expected = (i + 0.5) / kCount;
    largest = std::max(largest, std::abs(draws[static_cast<size_t>(i)] - expected));
  }
  EXPECT_LT(std::sqrt(kCount) * largest, 1.95);
}

TEST(Normal, PassesKolmogorovSmirnovAtOneInAThousand) {
  constexpr int kCount = 20'000;
  Stream stream(12, "test");
  std::vector<double> draws(kCount);
  for (double& draw : draws) draw = stream.Normal();
  std::sort(draws.begin(), draws.end());
  double largest = 0;
  for (int i = 0; i < kCount; ++i) {
    const double cumulative = 0.5 * std::erfc(-draws[static_cast<size_t>(i)] / std::sqrt(2.0));
    largest = std::max(largest, std::abs(cumulative - (i + 0.5) / kCount));
  }
  EXPECT_LT(std::sqrt(kCount) * largest, 1.95);
}

// First draws of streams whose names differ by one number are as good as one stream's draws.
TEST(Stream, IsIndependentOfItsNeighbours) {
  constexpr int kCount = 20'000;
  const StreamKey link = StreamKey(13, "test").With("alpha").With("bravo");
  double sum = 0;
  double previous = Stream(link.With(-1)).Uniform() - 0.5;
  for (int i = 0; i < kCount; ++i) {
    const double draw = Stream(link.With(i)).Uniform() - 0.5;
    sum += draw * previous;
    previous = draw;
  }
  // The products have mean 0 and deviation 1/12; 3.3 deviations of the mean are one in a thousand.
  EXPECT_LT(std::abs(sum / kCount), 3.3 / 12 / std::sqrt(kCount));
}

TEST(UniformInt, HitsEveryValueEquallyOften) {
  constexpr int kCount = 70'000;
  Stream stream(14, "test");
  std::vector<int> counts(7);
  for (int i = 0; i < kCount; ++i) ++counts[stream.UniformInt(7)];
  double chi_square = 0;
  for (const int count : counts) chi_square += (count - 10'000.0) * (count - 10'000.0) / 10'000.0;
  EXPECT_LT(chi_square, 22.46);  // 6 degrees of freedom, one in a thousand.
}

RC_GTEST_PROP(UniformInt, StaysBelowItsBound, (uint64_t seed, uint64_t bound)) {
  RC_PRE(bound > 0);
  Stream stream(seed, "test");
  RC_ASSERT(stream.UniformInt(bound) < bound);
}

}  // namespace shoal::stream_test
