#include "lib/run/broker/report_blocks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lib/bus/bus/bus.h"

namespace shoal::report_blocks_test {

BrokerSetup SetupOfFleet(int num_vehicles) {
  BrokerSetup setup;
  for (int i = 0; i < num_vehicles; ++i) setup.vehicles.push_back(fmt::format("boat_{}", i));
  return setup;
}

TEST(ReportBlocks, HasOneOfASmallFleetAndOfNone) {
  for (const int num_vehicles : {0, 1, 64}) {
    const ReportBlocks blocks(SetupOfFleet(num_vehicles));
    EXPECT_EQ(blocks.num_blocks(), 1U);
    EXPECT_EQ(blocks.BlockOf(0), 0U);
    EXPECT_EQ(blocks.BlockOf(kNoContact), 0U);
  }
}

TEST(ReportBlocks, FollowsTheOrderOfNamesNotThatOfTheMission) {
  const BrokerSetup setup = SetupOfFleet(200);
  const ReportBlocks blocks(setup);
  ASSERT_EQ(blocks.num_blocks(), 4U);
  std::vector<int> sizes(4);
  for (int32_t a = 0; a < 200; ++a) {
    ++sizes[blocks.BlockOf(a)];
    for (int32_t b = 0; b < 200; ++b) {
      if (setup.vehicles[static_cast<size_t>(a)] < setup.vehicles[static_cast<size_t>(b)]) {
        EXPECT_LE(blocks.BlockOf(a), blocks.BlockOf(b));
      }
    }
  }
  EXPECT_EQ(sizes, (std::vector<int>{64, 64, 64, 8}));
}

TEST(ReportBlocks, PutsVehiclesThatAreNotOfTheMissionIntoTheLast) {
  const ReportBlocks blocks(SetupOfFleet(100));
  EXPECT_EQ(blocks.BlockOf(100), 1U);
  EXPECT_EQ(blocks.BlockOf(kNoContact), 1U);
}

TEST(ReportBlocks, HasOneWhereReportsGoOverMediaOrGatewaysForwardThem) {
  BrokerSetup over_media = SetupOfFleet(200);
  over_media.rules.reports_over = {.names = {std::string(kAcousticMedium)}};
  EXPECT_EQ(ReportBlocks(over_media).num_blocks(), 1U);
  BrokerSetup with_gateway = SetupOfFleet(200);
  with_gateway.media.of_vehicles.resize(200);
  EXPECT_EQ(ReportBlocks(with_gateway).num_blocks(), 4U);
  with_gateway.media.of_vehicles[7].gateway.exists = true;
  EXPECT_EQ(ReportBlocks(with_gateway).num_blocks(), 1U);
}

TEST(ReportBlocks, HasNoMoreThanAStepHasPlaces) {
  const ReportBlocks blocks(SetupOfFleet(300'000));
  EXPECT_LE(blocks.num_blocks() + 2, size_t{kNumPlaces});
  EXPECT_GT(blocks.num_blocks(), size_t{kNumPlaces} / 2);
}

TEST(BrokerShare, HasAllBlocksWhereNoneIsNamed) {
  EXPECT_TRUE(BrokerShare().Has(3));
  const BrokerShare share = {.has_block = {false, true}, .has_rest = false};
  EXPECT_FALSE(share.Has(0));
  EXPECT_TRUE(share.Has(1));
}

}  // namespace shoal::report_blocks_test
