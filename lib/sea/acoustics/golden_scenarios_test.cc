// The scenarios of tests/golden/munet/net_timing_scenarios.json. Where muNet itself was wrong they
// have `right_deliveries`, and those hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "lib/sea/acoustics/validate_options.h"
#include "lib/sea/acoustics/water_testing.h"
#include "tests/golden/read_golden.h"

namespace shoal::golden_scenarios_test {

using Json = nlohmann::json;

constexpr double kTimeError_s = 1e-9;

template <class Choice>
void ReadChoice(const Json& config, const char* key, Choice* choice) {
  if (config.contains(key)) *choice = FindChoice<Choice>(config.at(key).get<std::string>()).value();
}

void ReadNumber(const Json& config, const char* key, double* number) {
  if (config.contains(key)) *number = config.at(key);
}

AcousticOptions OptionsOf(const Json& config) {
  AcousticOptions options;
  ReadChoice(config, "jitterType", &options.jitter);
  ReadChoice(config, "plrType", &options.packet_loss_model);
  ReadChoice(config, "berType", &options.bit_error_model);
  ReadChoice(config, "accessMode", &options.access_mode);
  ReadChoice(config, "orderMode", &options.channel_order);
  ReadChoice(config, "collType", &options.collisions);
  ReadNumber(config, "C_WATER", &options.sound_speed_mps);
  ReadNumber(config, "DATA_RATE", &options.data_rate_bps);
  ReadNumber(config, "BASE_FREQ", &options.base_freq_khz);
  ReadNumber(config, "BANDWIDTH", &options.bandwidth_khz);
  ReadNumber(config, "GUARD_BW", &options.guard_band_khz);
  ReadNumber(config, "CHAN_MINBW", &options.channel_bandwidth_khz);
  return options;
}

Eigen::Vector3d VectorOf(const Json& numbers) {
  return Eigen::Vector3d(numbers.at(0).get<double>(), numbers.at(1).get<double>(),
                         numbers.at(2).get<double>());
}

/// What arrived, and the step that it came in.
struct ArrivedInStep {
  Reception reception;
  Bytes bytes;
  double step_s = 0;
};

/// Plays a scenario as muNet does: step by step, first what is sent, then what has arrived.
std::vector<ArrivedInStep> Play(const Json& scenario, AcousticNetwork* network) {
  std::vector<int> all_nodes;
  std::map<int, int> index_of;
  for (const Json& node : scenario.at("nodes")) {
    const int index = static_cast<int>(all_nodes.size());
    index_of[node.at("addr")] = index;
    all_nodes.push_back(index);
  }
  const Json& transmissions = scenario.at("tx");
  const double dt_s = scenario.at("dt");
  const double end_s = scenario.at("t_end");
  std::vector<ArrivedInStep> arrived;
  size_t next = 0;
  for (int step = 0; step * dt_s <= end_s + dt_s; ++step) {
    double now_s = step * dt_s;
    for (; next < transmissions.size(); ++next) {
      const Json& sent = transmissions.at(next);
      const double time_s = sent.at("t");
      if (time_s > now_s + kTimeError_s) break;
      now_s = std::max(now_s, time_s);
      std::vector<Eigen::Vector3d> positions_m;
      for (const Json& node : scenario.at("nodes")) {
        positions_m.emplace_back(VectorOf(node.at("pos0")) + time_s * VectorOf(node.at("vel")));
      }
      network->Transmit(time_s, index_of.at(sent.at("src")), positions_m,
                        FromHex(sent.at("hex").get<std::string>()), all_nodes);
    }
    for (const Reception& reception : network->Deliver(now_s)) {
      arrived.push_back({reception, {reception.bytes.begin(), reception.bytes.end()}, now_s});
    }
  }
  EXPECT_EQ(next, transmissions.size());
  return arrived;
}

std::vector<AcousticNode> NodesOf(const Json& scenario) {
  std::vector<AcousticNode> nodes;
  for (const Json& node : scenario.at("nodes")) {
    nodes.push_back({.name = "node_" + node.at("addr").dump(),
                     .address = node.at("addr"),
                     .is_leader = node.at("leader")});
  }
  return nodes;
}

int AddressOf(const Json& scenario, int node) {
  return scenario.at("nodes").at(static_cast<size_t>(node)).at("addr");
}

/// Finds the reception that a golden delivery is about, and takes it out.
bool TakeMatch(const Json& scenario, const Json& golden, std::vector<ArrivedInStep>* arrived,
               ArrivedInStep* match) {
  const auto found = std::ranges::find_if(*arrived, [&](const ArrivedInStep& candidate) {
    const Reception& reception = candidate.reception;
    return AddressOf(scenario, reception.packet.source) == golden.at("src").get<int>() &&
           AddressOf(scenario, reception.receiver) == golden.at("dest").get<int>() &&
           std::abs(reception.end_s - golden.at("end_time").get<double>()) < kTimeError_s;
  });
  if (found == arrived->end()) return false;
  *match = *found;
  arrived->erase(found);
  return true;
}

/// muNet's own byte windows may miss a byte at each border where rounding decides.
void ExpectBytes(const Json& golden, const Bytes& bytes) {
  const Bytes expected = FromHex(golden.at("hex").get<std::string>());
  if (!golden.value("fragile", false)) {
    EXPECT_EQ(bytes, expected);
    return;
  }
  ASSERT_EQ(bytes.size(), expected.size());
  int num_different = 0;
  for (size_t i = 0; i < bytes.size(); ++i) num_different += bytes[i] != expected[i] ? 1 : 0;
  EXPECT_LE(num_different, 1);
}

void CheckScenario(const Json& scenario) {
  const AcousticOptions options = OptionsOf(scenario.at("config"));
  const std::vector<AcousticNode> nodes = NodesOf(scenario);
  ASSERT_TRUE(FindProblems(options, nodes).empty());
  AcousticNetwork network(options, 1, nodes);
  ASSERT_EQ(network.plan().channels().size(), scenario.at("channels").size());

  std::vector<ArrivedInStep> arrived = Play(scenario, &network);
  std::erase_if(arrived, [](const ArrivedInStep& one) {
    return one.reception.fate == AcousticFate::kNotListening;
  });
  const AcousticStatistics statistics = network.statistics();
  EXPECT_EQ(statistics.num_offered - statistics.NumOf(AcousticFate::kNotListening),
            scenario.at("stats").at("packetSent").get<int64_t>());
  EXPECT_EQ(statistics.num_in_transit, 0);

  const bool has_right = !scenario.at("right_deliveries").is_null();
  for (const Json& golden : scenario.at(has_right ? "right_deliveries" : "deliveries")) {
    SCOPED_TRACE(golden.dump().substr(0, 200));
    ArrivedInStep match;
    ASSERT_TRUE(TakeMatch(scenario, golden, &arrived, &match));
    const Reception& reception = match.reception;
    EXPECT_TRUE(HandsOver(reception.fate));
    ExpectBytes(golden, match.bytes);
    EXPECT_EQ(network.plan().channel(reception.channel).id, golden.at("cid").get<int>());
    if (!golden.contains("start_time")) continue;
    EXPECT_NEAR(reception.start_s, golden.at("start_time").get<double>(), kTimeError_s);
    EXPECT_NEAR(reception.range_m, golden.at("distance").get<double>(), 1e-9);
    EXPECT_NEAR(match.step_s, golden.at("t_deliver").get<double>(), kTimeError_s);
  }
  for (const ArrivedInStep& undelivered : arrived) {
    EXPECT_EQ(undelivered.reception.fate, AcousticFate::kCollided);
  }
}

TEST(GoldenScenarios, AreNineteenAndAllMatch) {
  const Json scenarios = ReadGoldenJson("munet/net_timing_scenarios.json");
  EXPECT_EQ(scenarios.size(), 19U);
  for (const Json& scenario : scenarios) {
    SCOPED_TRACE(scenario.at("name").get<std::string>());
    CheckScenario(scenario);
  }
}

}  // namespace shoal::golden_scenarios_test
