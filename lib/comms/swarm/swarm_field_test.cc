#include "lib/comms/swarm/swarm_field.h"

#include <gtest/gtest.h>

#include "lib/comms/swarm/recovery.h"
#include "tests/golden/read_swarm_golden.h"

namespace shoal::swarm_field_test {

TEST(SwarmField, HasTheNameOfTheSpecification) {
  EXPECT_EQ(NameOf(SwarmField::kType), "type");
  EXPECT_EQ(NameOf(SwarmField::kLeaderNextVel), "leader_next_vel");
  EXPECT_EQ(NameOf(SwarmField::kRspnStart), "rspn_start");
}

TEST(RecoveryStrategy, IsFoundByItsName) {
  for (size_t i = 0; i < kNumRecoveryStrategies; ++i) {
    const auto strategy = static_cast<RecoveryStrategy>(i);
    EXPECT_EQ(RecoveryStrategyOf(NameOf(strategy)), strategy) << NameOf(strategy);
  }
  EXPECT_EQ(NameOf(RecoveryStrategy::kSkip), "skip");
  EXPECT_EQ(RecoveryStrategyOf("Predict"), std::nullopt);
}

TEST(RecoveryPlan, IsMuNetsUnlessTheMissionHasAnother) {
  const nlohmann::json golden = ReadGoldenJson("munet/recovery.json");
  const nlohmann::json& orders = golden["default_dataRepair"];
  ASSERT_EQ(orders.size(), kNumSwarmFields);
  const RecoveryPlan plan;
  for (const auto& [name, order] : orders.items()) {
    const auto field = FieldNamed(name);
    ASSERT_TRUE(field) << name;
    std::vector<std::string> words;
    for (const RecoveryStrategy strategy : plan.of(*field)) words.emplace_back(NameOf(strategy));
    EXPECT_EQ(nlohmann::json(words), order) << name;
  }
}

}  // namespace shoal::swarm_field_test
