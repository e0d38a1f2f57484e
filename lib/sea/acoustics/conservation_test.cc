// At every moment each offered reception is decided or in transit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "lib/sea/acoustics/acoustic_counts_testing.h"
#include "lib/sea/acoustics/validate_options.h"
#include "lib/sea/acoustics/water_testing.h"

namespace shoal::conservation_test {

/// Counts what goes in and what comes out, apart from the network's own counters.
struct Ledger {
  int64_t num_offered = 0;
  int64_t num_transmissions = 0;
  std::array<int64_t, kNumAcousticFates> num_fates = {};
  int64_t num_bits_flipped = 0;
  std::set<std::pair<PacketId, int>> open;  ///< Packets and receivers without a fate.

  void Offer(const PacketId& packet, const std::vector<int>& receivers) {
    ++num_transmissions;
    for (const int receiver : receivers) {
      if (receiver != packet.source && open.insert({packet, receiver}).second) ++num_offered;
    }
  }

  void Take(const Reception& reception) {
    RC_ASSERT(open.erase({reception.packet, reception.receiver}) == 1U);
    ++num_fates[static_cast<size_t>(reception.fate)];
    num_bits_flipped += reception.num_bits_flipped;
  }

  void ExpectAgreement(const AcousticNetwork& network) const {
    const AcousticStatistics statistics = network.statistics();
    RC_ASSERT(statistics.num_transmissions == num_transmissions);
    RC_ASSERT(statistics.num_offered == num_offered);
    RC_ASSERT(statistics.num_fates == num_fates);
    RC_ASSERT(statistics.num_bits_flipped == num_bits_flipped);
    RC_ASSERT(statistics.num_in_transit == static_cast<int64_t>(open.size()));
    RC_ASSERT(statistics.num_offered == NumDecided(statistics) + statistics.num_in_transit);
  }
};

/// Sends and delivers at random, and checks the counters after each step.
void SendAndLook(TrafficGenerator* generator, AcousticNetwork* network, int num_steps,
                 double side_m) {
  Ledger ledger;
  double now_s = 0;
  double last_end_s = 0;
  std::vector<Reception> earlier;
  for (int step = 0; step < num_steps; ++step) {
    now_s += generator->Double(0, 0.5);
    const int source = generator->Int(0, network->num_nodes() - 1);
    std::vector<int> receivers;
    for (int i = generator->Int(0, 20); i > 0; --i) {
      receivers.push_back(generator->Int(0, network->num_nodes() - 1));
    }
    Positions positions_m = generator->RandomPositions(network->num_nodes(), side_m);
    if (generator->OneIn(10)) positions_m[0].x() = std::nan("");
    const int64_t number = network->Transmit(
        now_s, source, positions_m, generator->RandomBytes(generator->Int(0, 80)), receivers);
    ledger.Offer({source, number}, receivers);
    if (generator->OneIn(2)) continue;
    now_s += generator->Double(0, 0.5);
    for (const Reception& reception : network->Deliver(now_s)) {
      ledger.Take(reception);
      RC_ASSERT(reception.end_s >= last_end_s);
      RC_ASSERT(reception.end_s <= now_s);
      RC_ASSERT(reception.start_s >= reception.sent_s);
      last_end_s = reception.end_s;
    }
    ledger.ExpectAgreement(*network);
  }
  for (const Reception& reception : network->Deliver(1e9)) ledger.Take(reception);
  ledger.ExpectAgreement(*network);
  RC_ASSERT(network->num_in_transit() == 0);
}

RC_GTEST_PROP(Conservation, HoldsForAnyOptionsTrafficAndPlaces, (uint64_t seed)) {
  TrafficGenerator generator(seed);
  const std::vector<AcousticNode> nodes = TestNodes(generator.Int(1, 7));
  const AcousticOptions options = generator.RandomOptions();
  RC_ASSERT(FindProblems(options, nodes).empty());
  AcousticNetwork network(options, seed, nodes);
  SendAndLook(&generator, &network, generator.Int(1, 40), generator.OneIn(3) ? 1e5 : 3000);
}

TEST(Conservation, HoldsForAThousandNodes) {
  EXPECT_TRUE(rc::check("1,000 nodes", [](uint64_t seed) {
    TrafficGenerator generator(seed);
    AcousticOptions options = generator.RandomOptions();
    options.base_freq_khz = 1000;
    options.bandwidth_khz = 1300;
    const std::vector<AcousticNode> nodes = TestNodes(1000);
    RC_ASSERT(FindProblems(options, nodes).empty());
    AcousticNetwork network(options, seed, nodes);
    SendAndLook(&generator, &network, 5, 5000);
  }));
}

TEST(Conservation, HoldsWhereAThousandNodesReceiveEachOther) {
  for (const CollisionModel collisions : {CollisionModel::kDrop, CollisionModel::kOff}) {
    AcousticOptions options;
    options.access_mode = AccessMode::kShared;
    options.collisions = collisions;
    AcousticNetwork network(options, 1, TestNodes(1000));
    TrafficGenerator generator(1);
    const Positions positions_m = generator.RandomPositions(1000, 5000);
    const std::vector<int> all = AllOf(network);
    for (int i = 0; i < 10; ++i) {
      network.Transmit(0.2 * i, generator.Int(0, 999), positions_m, Bytes(37), all);
    }
    EXPECT_EQ(network.num_in_transit(), 9990);
    EXPECT_EQ(network.Deliver(100).size(), 9990U);
    EXPECT_EQ(NumDecided(network.statistics()), 9990);
    EXPECT_EQ(network.num_in_transit(), 0);
  }
}

}  // namespace shoal::conservation_test
