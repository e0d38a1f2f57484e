#include "lib/bus/record/channel_choice.h"

#include <gtest/gtest.h>

namespace shoal::channel_choice_test {

TEST(ChannelChoice, TakesAllWhereNothingIsChosen) {
  EXPECT_TRUE(ChannelChoice{}.TakesAll());
  EXPECT_TRUE(ChannelChoice{}.Takes("NAV_ALPHA"));
}

TEST(ChannelChoice, TakesNamesAndPatternsAndNothingElse) {
  const ChannelChoice choice{.only = {"NAV_*", "CLOCK"}};
  EXPECT_TRUE(choice.Takes("NAV_ALPHA"));
  EXPECT_TRUE(choice.Takes("CLOCK"));
  EXPECT_FALSE(choice.Takes("CLOCK_STATE"));
  EXPECT_FALSE(choice.Takes("MEASURED_NAV_ALPHA"));
}

TEST(ChannelChoice, LeavesOutEvenWhatIsNamed) {
  const ChannelChoice choice{.only = {"NAV_*"}, .without = {"NAV_[AB]*"}};
  EXPECT_FALSE(choice.Takes("NAV_ALPHA"));
  EXPECT_TRUE(choice.Takes("NAV_CESAR"));
  EXPECT_FALSE((ChannelChoice{.without = {"*"}}).Takes("NAV_CESAR"));
}

}  // namespace shoal::channel_choice_test
