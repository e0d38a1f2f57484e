#include "lib/vehicle/vehicle/obstacle_watch.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace shoal::obstacle_watch_test {

const std::vector<Polygon> kSquare = {{{10, -5}, {20, -5}, {20, 5}, {10, 5}}};

TEST(ObstacleWatch, FindsAHitOnceUntilTheVehicleWasClearOfIt) {
  ObstacleWatch watch({4}, kSquare);
  const std::array<uint32_t, 1> seen = {0};
  const auto at = [&](double x_m) {
    return watch.Look(seen, std::array{Eigen::Vector3d(x_m, 0, 0)}).size();
  };
  EXPECT_EQ(at(7.9), 0U);
  EXPECT_EQ(at(8.1), 1U) << "nearer than half of its length";
  EXPECT_EQ(at(15), 0U) << "the same hit";
  EXPECT_EQ(at(7), 0U) << "clear, but not by its length";
  EXPECT_EQ(at(9), 0U);
  EXPECT_EQ(at(5), 0U);
  EXPECT_EQ(at(9), 1U);
}

TEST(ObstacleWatch, NamesVehicleObstacleAndDistance) {
  ObstacleWatch watch({4, 2}, {{{100, 100}, {110, 100}, {110, 110}}, kSquare[0]});
  const std::array<uint32_t, 2> seen = {0, 1};
  const auto hits =
      watch.Look(seen, std::array{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(12, 0, 30)});
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].vehicle, 1U);
  EXPECT_EQ(hits[0].obstacle, 1U);
  EXPECT_DOUBLE_EQ(hits[0].distance_m, -2);
  EXPECT_DOUBLE_EQ(hits[0].allowed_m, 1);
}

TEST(TouchedObstacle, IsTheOneThatAVehicleIsNearerToThanHalfOfItsLength) {
  EXPECT_EQ(TouchedObstacle(kSquare, {9, 0}, 3), 0);
  EXPECT_EQ(TouchedObstacle(kSquare, {8, 0}, 3), -1);
  EXPECT_EQ(TouchedObstacle(kSquare, {std::numeric_limits<double>::quiet_NaN(), 0}, 3), -1);
  EXPECT_EQ(TouchedObstacle({}, {9, 0}, 3), -1);
}

}  // namespace shoal::obstacle_watch_test
