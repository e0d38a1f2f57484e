#include "lib/sea/acoustics/acoustic_statistics.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "lib/sea/acoustics/acoustic_counts_testing.h"

namespace shoal::acoustic_statistics_test {

TEST(AcousticFateText, IsDifferentForEachFate) {
  std::set<std::string_view> texts;
  for (size_t i = 0; i < kNumAcousticFates; ++i) {
    texts.insert(AcousticFateText(static_cast<AcousticFate>(i)));
  }
  EXPECT_EQ(texts.size(), kNumAcousticFates);
  EXPECT_EQ(AcousticFateText(AcousticFate::kHalfDuplex), "half_duplex");
  EXPECT_EQ(AcousticFateText(AcousticFate::kDelivered), "delivered");
}

TEST(HandsOver, IsTrueForWhatArrivesInAnyState) {
  EXPECT_TRUE(HandsOver(AcousticFate::kDelivered));
  EXPECT_TRUE(HandsOver(AcousticFate::kDamagedByBitErrors));
  EXPECT_TRUE(HandsOver(AcousticFate::kDamagedByCollision));
  EXPECT_FALSE(HandsOver(AcousticFate::kLost));
  EXPECT_FALSE(HandsOver(AcousticFate::kCollided));
  EXPECT_FALSE(HandsOver(AcousticFate::kHalfDuplex));
  EXPECT_FALSE(HandsOver(AcousticFate::kNoPath));
  EXPECT_FALSE(HandsOver(AcousticFate::kNotListening));
}

TEST(StatisticsText, GivesEveryNumberALineAndAShareOfWhatWasOffered) {
  const AcousticStatistics statistics = {.num_transmissions = 70,
                                         .num_offered = 210,
                                         .num_fates = {10, 1, 0, 2, 3, 4, 5, 20, 160},
                                         .num_in_transit = 5,
                                         .num_collided = 8,
                                         .num_bits_flipped = 31,
                                         .num_bit_errors = 22,
                                         .num_rejected = 37};
  EXPECT_EQ(statistics.NumHandedOver(), 185);
  EXPECT_EQ(NumDecided(statistics), 205);
  EXPECT_EQ(StatisticsText(statistics),
            "transmissions                   70\n"
            "offered to listeners           200\n"
            "not_listening                   10\n"
            "no_path                          1  0.5 %\n"
            "half_duplex                      2  1 %\n"
            "collision                        3  1.5 %\n"
            "packet_loss                      4  2 %\n"
            "damaged_by_collision             5  2.5 %\n"
            "damaged_by_bit_errors           20  10 %\n"
            "delivered                      160  80 %\n"
            "in transit                       5  2.5 %\n"
            "overlapped by others             8  4 %\n"
            "with bits flipped               22  11 %\n"
            "bits flipped                    31\n"
            "rejected by receivers           37  20 %\n");
}

TEST(StatisticsText, OfNothingHasNoShares) {
  EXPECT_EQ(StatisticsText({}).find('%'), std::string::npos);
}

}  // namespace shoal::acoustic_statistics_test
