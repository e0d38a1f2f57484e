#include "lib/vehicle/guidance/echo_memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace shoal::echo_memory_test {

using Eigen::Vector3d;

TEST(EchoMemory, ShowsAnEchoFromWhereTheVehicleIsNow) {
  EchoMemory memory;
  memory.Take({0, 0, 20}, std::vector<SonarEcho>{{.direction = {1, 0, 0}, .range_m = 30}}, 0);
  const auto echoes = memory.Recall({30, -10, 20}, 5, 20);
  ASSERT_EQ(echoes.size(), 1u);
  EXPECT_NEAR(echoes[0].range_m, 10, 1e-12);
  EXPECT_LT((echoes[0].direction - Vector3d::UnitY()).norm(), 1e-12);
}

TEST(EchoMemory, ForgetsAfterItsTime) {
  EchoMemory memory;
  memory.Take({0, 0, 0}, std::vector<SonarEcho>{{.range_m = 30}}, 0);
  EXPECT_EQ(memory.Recall({0, 0, 0}, 20, 20).size(), 1u);
  EXPECT_EQ(memory.Recall({0, 0, 0}, 20.1, 20).size(), 0u);
  EXPECT_EQ(memory.Recall({0, 0, 0}, 10, 20).size(), 0u) << "it is gone for good";
}

TEST(EchoMemory, KeepsOneEchoOfEachPlaceAndTheLastOfIt) {
  EchoMemory memory;
  for (int i = 0; i < 100; ++i) {
    memory.Take({0, 0, 0}, std::vector<SonarEcho>{{.range_m = 30.5 + 0.001 * i}}, i);
  }
  const auto echoes = memory.Recall({0, 0, 0}, 100, 20);
  ASSERT_EQ(echoes.size(), 1u);
  EXPECT_NEAR(echoes[0].range_m, 30.599, 1e-9);
}

TEST(EchoMemory, HoldsNoMoreThanItsBound) {
  EchoMemory memory;
  for (int i = 0; i < 3000; ++i) {
    memory.Take({0, 0, 0}, std::vector<SonarEcho>{{.range_m = 3.0 * i}}, 0);
  }
  EXPECT_LE(memory.Recall({-1, 0, 0}, 0, 20).size(), EchoMemory::kMaxEchoes);
  memory.Take({0, 0, 0}, std::vector<SonarEcho>{{.range_m = 9000}}, 30);
  EXPECT_EQ(memory.Recall({-1, 0, 0}, 30, 20).size(), 0u) << "there was no room for it";
  memory.Take({0, 0, 0}, std::vector<SonarEcho>{{.range_m = 9000}}, 30);
  EXPECT_EQ(memory.Recall({-1, 0, 0}, 30, 20).size(), 1u) << "the old ones have made room";
}

TEST(EchoMemory, PassesOverAnEchoAtTheVehicleItself) {
  EchoMemory memory;
  memory.Take({5, 5, 5}, std::vector<SonarEcho>{{.range_m = 0}}, 0);
  EXPECT_EQ(memory.Recall({5, 5, 5}, 0, 20).size(), 0u) << "it has no direction";
}

}  // namespace shoal::echo_memory_test
