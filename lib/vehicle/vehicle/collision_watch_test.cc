#include "lib/vehicle/vehicle/collision_watch.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "lib/vehicle/vehicle/contact.h"

namespace shoal::collision_watch_test {

using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

Pairs PairsOf(std::span<const Collision> collisions) {
  Pairs pairs;
  for (const Collision& collision : collisions)
    pairs.emplace_back(collision.first, collision.second);
  return pairs;
}

/// Two vehicles of 3 and 2 m, `distance_m` apart along y.
Pairs Meet(CollisionWatch* watch, double distance_m) {
  const std::vector<Eigen::Vector3d> positions_m = {{10, 20, 5}, {10, 20 + distance_m, 5}};
  const std::vector<uint32_t> seen = {0, 1};
  return PairsOf(watch->Look(seen, positions_m));
}

TEST(CollisionWatch, FindsAnEncounterOnceUntilTheyHaveParted) {
  CollisionWatch watch({3, 2});
  EXPECT_TRUE(Meet(&watch, 2.5).empty()) << "the mean of their lengths is not nearer than itself";
  EXPECT_EQ(Meet(&watch, 2.4), (Pairs{{0, 1}}));
  EXPECT_TRUE(Meet(&watch, 4.9).empty());
  EXPECT_TRUE(Meet(&watch, 1).empty()) << "still the same encounter";
  EXPECT_TRUE(Meet(&watch, 5.1).empty());
  EXPECT_EQ(Meet(&watch, 1), (Pairs{{0, 1}}));
}

TEST(CollisionWatch, StatesHowNearTheyCameAndHowNearIsAllowed) {
  CollisionWatch watch({3, 2});
  const std::vector<Eigen::Vector3d> positions_m = {{0, 0, 0}, {0, 1.2, 1.6}};
  const std::vector<uint32_t> seen = {0, 1};
  const std::span<const Collision> found = watch.Look(seen, positions_m);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].range_m, 2);
  EXPECT_DOUBLE_EQ(found[0].allowed_m, 2.5);
}

TEST(CollisionWatch, ComparesOnlyThoseThatWereSeen) {
  CollisionWatch watch({3, 3, 3});
  const std::vector<Eigen::Vector3d> positions_m = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  const std::vector<uint32_t> seen = {2, 0};
  EXPECT_EQ(PairsOf(watch.Look(seen, positions_m)), (Pairs{{0, 2}}));
}

RC_GTEST_PROP(CollisionWatch, FindsWhatComparingAllPairsFinds, ()) {
  const auto count = *rc::gen::inRange<size_t>(0, 30);
  std::vector<double> lengths_m;
  std::vector<Eigen::Vector3d> positions_m;
  for (size_t i = 0; i < count; ++i) {
    lengths_m.push_back(*rc::gen::inRange(0, 8));
    positions_m.emplace_back(*rc::gen::inRange(0, 20), *rc::gen::inRange(0, 40),
                             *rc::gen::inRange(0, 3));
  }
  std::vector<uint32_t> seen(count);
  std::iota(seen.begin(), seen.end(), 0U);
  Pairs expected;
  for (uint32_t a = 0; a < count; ++a) {
    for (uint32_t b = a + 1; b < count; ++b) {
      if (InContact(positions_m[a], lengths_m[a], positions_m[b], lengths_m[b])) {
        expected.emplace_back(a, b);
      }
    }
  }
  CollisionWatch watch(lengths_m);
  RC_ASSERT(PairsOf(watch.Look(seen, positions_m)) == expected);
  RC_ASSERT(watch.Look(seen, positions_m).empty());
}

}  // namespace shoal::collision_watch_test
