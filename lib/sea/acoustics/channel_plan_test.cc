#include "lib/sea/acoustics/channel_plan.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "tests/golden/read_golden.h"

namespace shoal::channel_plan_test {

using Json = nlohmann::json;

constexpr double kFreqError_khz = 1e-9;

AcousticOptions OptionsOf(const Json& table) {
  AcousticOptions options;
  options.channel_order =
      FindChoice<ChannelOrder>(table.at("orderMode").get<std::string>()).value();
  options.bandwidth_khz = table.at("BANDWIDTH");
  if (table.contains("GUARD_BW")) {
    options.guard_band_khz = table.at("GUARD_BW");
    options.channel_bandwidth_khz = table.at("CHAN_MINBW");
    options.base_freq_khz = table.at("BASE_FREQ");
  }
  return options;
}

std::vector<AcousticNode> NodesOf(const std::vector<int>& addresses) {
  std::vector<AcousticNode> nodes;
  for (const int address : addresses) {
    nodes.push_back({.name = "node_" + std::to_string(address), .address = address});
  }
  return nodes;
}

std::vector<AcousticNode> NumberedNodes(int count) {
  std::vector<int> addresses;
  for (int i = 1; i <= count; ++i) addresses.push_back(i);
  return NodesOf(addresses);
}

TEST(ChannelPlan, HasTheGoldenCapacitiesAndFrequenciesOfFdma) {
  const Json tables = ReadGoldenJson("munet/net_channel_tables.json").at("fdma");
  for (const Json& table : tables) {
    const AcousticOptions options = OptionsOf(table);
    SCOPED_TRACE(table.dump().substr(0, 150));
    EXPECT_EQ(ChannelCapacity(options), table.at("capacity_right").get<int>());
    const std::vector<double> freqs_khz = ChannelFreqs_khz(options, 1);
    ASSERT_EQ(freqs_khz.size(), table.at("generator_yields").get<size_t>());
    for (const Json& channel : table.at("generated")) {
      EXPECT_NEAR(freqs_khz.at(channel.at("n")), channel.at("freq_kHz").get<double>(),
                  kFreqError_khz);
    }
  }
}

TEST(ChannelPlan, RegistersNodesAsTheGoldenTableDoes) {
  const Json tables = ReadGoldenJson("munet/net_channel_tables.json").at("fdma");
  int num_confirmed = 0;
  for (const Json& table : tables) {
    SCOPED_TRACE(table.dump().substr(0, 150));
    std::vector<int> addresses;
    for (const Json& row : table.at("registration")) {
      if (row.at("status") == "CONFIRMED") addresses.push_back(row.at("addr"));
    }
    const Result<ChannelPlan> plan = ChannelPlan::Make(OptionsOf(table), NodesOf(addresses));
    ASSERT_TRUE(plan.ok()) << plan.error();
    for (int node = 0; node < plan->num_nodes(); ++node, ++num_confirmed) {
      const Json& row = table.at("registration").at(static_cast<size_t>(node));
      const AcousticChannel& channel = plan->channel(plan->SendsOn(node));
      EXPECT_EQ(channel.id, row.at("tx").at(0).get<int>());
      EXPECT_NEAR(channel.freq_khz, row.at("freq_kHz").get<double>(), kFreqError_khz);
      const Json& golden = table.at("final_node_channels").at(row.at("addr").dump());
      std::vector<int> received_on;
      for (int i = 0; i < static_cast<int>(plan->channels().size()); ++i) {
        if (plan->ReceivesOn(node, i)) received_on.push_back(plan->channel(i).id);
      }
      std::vector<int> golden_received_on = golden.at("rx");
      std::ranges::sort(received_on);
      std::ranges::sort(golden_received_on);
      EXPECT_EQ(received_on, golden_received_on);
    }
  }
  EXPECT_GT(num_confirmed, 100);
}

TEST(ChannelPlan, HasTheGoldenChannelsOfTheOtherModes) {
  const Json tables = ReadGoldenJson("munet/net_channel_tables.json").at("other");
  for (const Json& table : tables) {
    SCOPED_TRACE(table.dump().substr(0, 100));
    AcousticOptions options = OptionsOf(table);
    options.access_mode = FindChoice<AccessMode>(table.at("accessMode").get<std::string>()).value();
    std::vector<AcousticNode> nodes = NumberedNodes(3);
    for (AcousticNode& node : nodes) {
      node.is_leader = table.at("nodes").at(std::to_string(node.address)).at("leader");
    }
    const Result<ChannelPlan> plan = ChannelPlan::Make(options, nodes);
    ASSERT_TRUE(plan.ok()) << plan.error();
    ASSERT_EQ(plan->channels().size(), table.at("channels").size());
    for (size_t i = 0; i < plan->channels().size(); ++i) {
      const Json& golden = table.at("channels").at(i);
      const AcousticChannel& channel = plan->channels()[i];
      EXPECT_EQ(channel.id, golden.at("cid").get<int>());
      EXPECT_NEAR(channel.freq_khz, golden.at("freq_kHz").get<double>(), kFreqError_khz);
      EXPECT_EQ(channel.bandwidth_khz, golden.at("bw_kHz").get<double>());
      EXPECT_EQ(channel.is_broadcast, golden.at("isBcst").get<bool>());
    }
    for (int node = 0; node < 3; ++node) {
      const Json& golden = table.at("nodes").at(std::to_string(node + 1));
      EXPECT_EQ(plan->channel(plan->SendsOn(node)).id, golden.at("tx").at(0).get<int>());
      std::vector<int> received_on;
      for (int i = 0; i < static_cast<int>(plan->channels().size()); ++i) {
        if (plan->ReceivesOn(node, i)) received_on.push_back(plan->channel(i).id);
      }
      EXPECT_EQ(received_on, golden.at("rx").get<std::vector<int>>());
    }
  }
}

TEST(ChannelPlan, StatesWhatNodesThatDoNotFitWouldNeed) {
  const Result<ChannelPlan> plan = ChannelPlan::Make({}, NumberedNodes(8));
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error(),
            "fdma: 8 nodes need 10.25 kHz (8 x 1 for channels, 9 x 0.25 for guard bands), "
            "bandwidth_khz = 10 holds 7 channels; widen bandwidth_khz, or narrow "
            "channel_bandwidth_khz or guard_band_khz");
}

TEST(ChannelPlan, MovesTheChannelsByHalfARasterWhereAnEvenNumberFillsTheBand) {
  AcousticOptions options;
  options.bandwidth_khz = 10.25;
  const Result<ChannelPlan> plan = ChannelPlan::Make(options, NumberedNodes(8));
  ASSERT_TRUE(plan.ok()) << plan.error();
  std::vector<double> freqs_khz;
  for (const AcousticChannel& channel : plan->channels()) freqs_khz.push_back(channel.freq_khz);
  EXPECT_EQ(freqs_khz,
            (std::vector<double>{24.625, 23.375, 25.875, 22.125, 27.125, 20.875, 28.375, 19.625}));
}

TEST(ChannelPlan, GivesLateNodesWhatIsLeftAndNothingBeyond) {
  Result<ChannelPlan> plan = ChannelPlan::Make({}, NumberedNodes(6));
  ASSERT_TRUE(plan.ok());
  const std::vector<AcousticChannel> before(plan->channels().begin(), plan->channels().end());
  const Result<int> seventh = plan->Add({.name = "late", .address = 3});
  ASSERT_TRUE(seventh.ok()) << seventh.error();
  EXPECT_EQ(*seventh, 6);
  EXPECT_EQ(plan->channel(plan->SendsOn(6)).id, 7);  // 3 to 6 are taken.
  EXPECT_TRUE(std::ranges::equal(before, plan->channels().first(6)));
  const Result<int> eighth = plan->Add({.name = "later", .address = 8});
  ASSERT_FALSE(eighth.ok());
  EXPECT_NE(eighth.error().find("no channel is left for 'later': 8 nodes need 10.25 kHz"),
            std::string::npos)
      << eighth.error();
  EXPECT_EQ(plan->num_nodes(), 7);
}

TEST(ChannelPlan, RefusesTdmaLfWithoutALeader) {
  AcousticOptions options;
  options.access_mode = AccessMode::kTdmaLf;
  EXPECT_FALSE(ChannelPlan::Make(options, NumberedNodes(3)).ok());
}

RC_GTEST_PROP(ChannelPlan, KeepsEveryChannelInTheBandAndAGuardBandFromTheNext, ()) {
  AcousticOptions options;
  options.channel_order = *rc::gen::element(ChannelOrder::kCenterOut, ChannelOrder::kEdgeIn);
  options.bandwidth_khz = *rc::gen::inRange(1, 4000) / 100.0;
  options.guard_band_khz = *rc::gen::inRange(0, 100) / 100.0;
  options.channel_bandwidth_khz = *rc::gen::inRange(1, 300) / 100.0;
  const int capacity = ChannelCapacity(options);
  RC_PRE(capacity > 0);
  const int count = *rc::gen::inRange(1, std::min(capacity, 200) + 1);
  const Result<ChannelPlan> plan = ChannelPlan::Make(options, NumberedNodes(count));
  RC_ASSERT(plan.ok());
  std::vector<double> freqs_khz;
  for (const AcousticChannel& channel : plan->channels()) freqs_khz.push_back(channel.freq_khz);
  std::ranges::sort(freqs_khz);
  const double edge_khz =
      options.bandwidth_khz / 2 - options.guard_band_khz - options.channel_bandwidth_khz / 2;
  RC_ASSERT(freqs_khz.front() >= options.base_freq_khz - edge_khz - 1e-6);
  RC_ASSERT(freqs_khz.back() <= options.base_freq_khz + edge_khz + 1e-6);
  for (size_t i = 1; i < freqs_khz.size(); ++i) {
    RC_ASSERT(freqs_khz[i] - freqs_khz[i - 1] >=
              options.guard_band_khz + options.channel_bandwidth_khz - 1e-6);
  }
}

}  // namespace shoal::channel_plan_test
