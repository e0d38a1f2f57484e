#include "lib/tools/plot/plot_distances.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

namespace shoal::plot_distances_test {

TEST(NearestDistances, AreInfiniteForOneAlone) {
  const std::vector<Eigen::Vector3d> one = {{1, 2, 3}};
  EXPECT_EQ(NearestDistances_m(one), std::vector{std::numeric_limits<double>::infinity()});
  EXPECT_TRUE(NearestDistances_m({}).empty());
}

TEST(NearestDistances, CountDepth) {
  const std::vector<Eigen::Vector3d> two = {{0, 0, 0}, {3, 0, 4}};
  EXPECT_EQ(NearestDistances_m(two), (std::vector<double>{5, 5}));
}

RC_GTEST_PROP(NearestDistances, AreThoseOfAllPairs, ()) {
  const auto raw = *rc::gen::arbitrary<std::vector<std::tuple<int8_t, int8_t, int8_t>>>();
  std::vector<Eigen::Vector3d> positions;
  for (const auto& [x, y, z] : raw) positions.emplace_back(x, y, z);
  const std::vector<double> found = NearestDistances_m(positions);
  for (size_t i = 0; i < positions.size(); ++i) {
    double expected = std::numeric_limits<double>::infinity();
    for (size_t j = 0; j < positions.size(); ++j) {
      if (j != i) expected = std::min(expected, (positions[i] - positions[j]).norm());
    }
    RC_ASSERT(found[i] == expected);
  }
}

}  // namespace shoal::plot_distances_test
