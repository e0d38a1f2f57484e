#include "lib/run/verdict/acoustic_tally.h"

#include <gtest/gtest.h>

namespace shoal::acoustic_tally_test {

TEST(AcousticTally, IsSilentAboutAMissionWithoutAcousticTraffic) {
  EXPECT_TRUE(AcousticTally().IsEmpty());
  EXPECT_EQ(AcousticTally().Text(), "");
}

TEST(AcousticTally, CountsDamageByCollisionApartFromThatByBitErrors) {
  AcousticTally tally;
  tally.Add({.cause = "delivered"});
  tally.Add({.cause = "delivered", .num_colliders = 1});
  tally.Add({.cause = "collision", .num_colliders = 2});
  tally.Add({.cause = "damaged", .num_colliders = 1});
  tally.Add({.cause = "damaged", .bits_flipped = 3});
  tally.Add({.cause = "rejected", .bits_flipped = 2});
  tally.Add({.cause = "bit_errors", .bits_flipped = 1});
  tally.Add({.cause = "damaged", .bits_flipped = 4, .num_colliders = 1});
  EXPECT_EQ(tally.Csv(),
            "what,count\n"
            "receptions,8\n"
            "overlapped by others,4\n"
            "with bits flipped,4\n"
            "bits flipped,10\n"
            "damaged by collision,1\n"
            "damaged by bit errors,3\n"
            "damaged by either,1\n"
            "packets in transit,0\n");
  EXPECT_TRUE(
      tally.Text().starts_with("Acoustic network\n    receptions                        8\n"))
      << tally.Text();
}

TEST(AcousticTally, CountsPacketsWithoutAFateAsInTransit) {
  AcousticTally tally;
  for (int i = 0; i < 3; ++i) tally.AddSent("alpha");
  tally.AddSent("bravo");
  EXPECT_EQ(tally.NumInTransit(), 4);
  tally.AddFate("alpha", 0);
  tally.AddFate("alpha", 0);  // At another receiver.
  tally.AddFate("alpha", 2);
  EXPECT_EQ(tally.NumInTransit(), 2);
  tally.AddFate("alpha", 1);
  tally.AddFate("bravo", 0);
  tally.AddFate("charlie", 0);  // Sent before the log began.
  EXPECT_EQ(tally.NumInTransit(), 0);
}

}  // namespace shoal::acoustic_tally_test
