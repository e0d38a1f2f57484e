#include "lib/run/verdict/separation_watch.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace shoal::separation_watch_test {

Sighting At(double x_m, double y_m, double z_m = 0) {
  return {.seen = true, .position_m = {x_m, y_m, z_m}};
}

TEST(SeparationWatch, FindsNoPairWhereFewerThanTwoWereSeen) {
  SeparationWatch watch;
  const std::vector<Sighting> vehicles = {At(0, 0), {}};
  watch.Look(vehicles, 0);
  EXPECT_EQ(watch.closest().first, -1);
}

TEST(SeparationWatch, RemembersTheClosestOfAllTimes) {
  SeparationWatch watch;
  const std::vector<std::vector<Sighting>> steps = {
      {At(0, 0), At(100, 0), At(50, 300)},
      {At(0, 0), At(100, 0), At(3, 4)},
      {At(0, 0), At(50, 0), At(300, 300)},
  };
  for (size_t i = 0; i < steps.size(); ++i) watch.Look(steps[i], static_cast<int64_t>(i));
  EXPECT_EQ(watch.closest().first, 0);
  EXPECT_EQ(watch.closest().second, 2);
  EXPECT_EQ(watch.closest().range_m, 5);
  EXPECT_EQ(watch.closest().utime, 1);
}

TEST(SeparationWatch, CountsTheDepth) {
  SeparationWatch watch;
  const std::vector<Sighting> vehicles = {At(0, 0, 2), At(0, 0, 32)};
  watch.Look(vehicles, 0);
  EXPECT_EQ(watch.closest().range_m, 30);
}

RC_GTEST_PROP(SeparationWatch, FindsWhatComparingAllPairsFinds, ()) {
  SeparationWatch watch;
  double closest_m = std::numeric_limits<double>::infinity();
  const auto count = *rc::gen::inRange<size_t>(0, 12);
  for (int step = 0; step < 3; ++step) {
    std::vector<Sighting> vehicles(count);
    for (Sighting& vehicle : vehicles) {
      vehicle =
          At(*rc::gen::inRange(-50, 50), *rc::gen::inRange(-500, 500), *rc::gen::inRange(0, 20));
      vehicle.seen = *rc::gen::inRange(0, 5) > 0;
    }
    watch.Look(vehicles, step);
    for (size_t i = 0; i < count; ++i) {
      for (size_t j = i + 1; j < count; ++j) {
        if (!vehicles[i].seen || !vehicles[j].seen) continue;
        closest_m = std::min(closest_m, (vehicles[i].position_m - vehicles[j].position_m).norm());
      }
    }
    RC_ASSERT(watch.closest().range_m == closest_m);
  }
}

}  // namespace shoal::separation_watch_test
