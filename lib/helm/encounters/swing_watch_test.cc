#include "lib/helm/encounters/swing_watch.h"

#include <gtest/gtest.h>

#include <vector>

#include "lib/base/geometry/angles.h"

namespace shoal::swing_watch_test {

/// Turns by one degree at a time from one heading to the next, the shorter way.
int SwingsAlong(const std::vector<double>& headings_deg) {
  SwingWatch watch;
  double heading_deg = headings_deg.front();
  watch.Look(heading_deg);
  for (const double next_deg : headings_deg) {
    while (Wrap180(next_deg - heading_deg) != 0) {
      heading_deg = Wrap360(heading_deg + (Wrap180(next_deg - heading_deg) > 0 ? 1 : -1));
      watch.Look(heading_deg);
    }
  }
  return watch.num_swings();
}

TEST(SwingWatch, CountsChangesOfMoreThanFortyDegreesFromOneTurningPointToTheNext) {
  EXPECT_EQ(SwingsAlong({350, 30}), 0);
  EXPECT_EQ(SwingsAlong({350, 31}), 1);
  EXPECT_EQ(SwingsAlong({350, 31, 350}), 2);
  EXPECT_EQ(SwingsAlong({350, 31, 10, 80, 350, 300}), 2);
  EXPECT_EQ(SwingsAlong({350, 31, 350, 31}), 3);
}

TEST(SwingWatch, CountsAFullCircleToOneSideOnce) {
  EXPECT_EQ(SwingsAlong({0, 120, 240, 0, 120}), 1);
}

}  // namespace shoal::swing_watch_test
