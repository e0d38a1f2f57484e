#include "lib/sea/media/relay_path.h"

#include <gtest/gtest.h>

namespace shoal::relay_path_test {

TEST(RelayPath, CountsItsHops) {
  EXPECT_EQ(NumHops(""), 0);
  EXPECT_EQ(NumHops("buoy"), 1);
  EXPECT_EQ(NumHops("buoy:mast:ship"), 3);
}

TEST(RelayPath, GrowsAtItsEnd) {
  EXPECT_EQ(WithHop("", "buoy"), "buoy");
  EXPECT_EQ(WithHop("buoy", "mast"), "buoy:mast");
}

TEST(RelayPath, FindsWholeNamesInAnyCase) {
  EXPECT_TRUE(IsVia("Buoy:mast", "buoy"));
  EXPECT_TRUE(IsVia("buoy:mast", "MAST"));
  EXPECT_FALSE(IsVia("buoy:mast", "mas"));
  EXPECT_FALSE(IsVia("buoy2", "buoy"));
  EXPECT_FALSE(IsVia("", "buoy"));
}

}  // namespace shoal::relay_path_test
