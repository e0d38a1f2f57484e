#include "lib/run/run/channel_set.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace shoal::channel_set_test {

TEST(ChannelSet, ContainsWhatWasAddedAndNothingElse) {
  ChannelSet set;
  EXPECT_FALSE(set.Contains(""));
  for (int i = 0; i < 2'000; i += 2) set.Add(fmt::format("NAV_BOAT_{}", i));
  set.Add("X");
  for (int i = 0; i < 2'000; ++i) {
    EXPECT_EQ(set.Contains(fmt::format("NAV_BOAT_{}", i)), i % 2 == 0) << i;
    EXPECT_FALSE(set.Contains(fmt::format("VAN_BOAT_{}", i))) << "the same end and size";
  }
  EXPECT_TRUE(set.Contains("X"));
  EXPECT_FALSE(set.Contains("Y"));
  EXPECT_FALSE(set.Contains(""));
}

}  // namespace shoal::channel_set_test
