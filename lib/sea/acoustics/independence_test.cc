// The draws of one link do not change when something else does.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "lib/sea/acoustics/water_testing.h"

namespace shoal::independence_test {

/// A packet at a receiver, by names.
using Link = std::tuple<std::string, std::string, int64_t>;

/// Which nodes send when and to which, by name, so that other nodes can be added or removed.
struct Plan {
  std::vector<AcousticNode> nodes;
  AcousticOptions options;
  std::vector<Sent> sent;  ///< Sources and receivers are indices into kNames.
};

const std::vector<std::string> kNames = {"alpha", "bravo", "charlie", "delta"};

/// Every node is in the same place at the same time in every plan.
Eigen::Vector3d PositionOf(const std::string& name) {
  Stream stream(7, "position", name);
  return {2000 * stream.Uniform(), 2000 * stream.Uniform(), 50 * stream.Uniform()};
}

Plan BasePlan(TrafficGenerator* generator) {
  Plan plan;
  for (const std::string& name : kNames) plan.nodes.push_back({.name = name, .address = 1});
  plan.options.access_mode = AccessMode::kShared;
  plan.options.collisions = CollisionModel::kOff;
  plan.options.packet_loss_model = PacketLossModel::kUniform;
  plan.options.packet_loss = 0.3;
  plan.options.bit_error_rate = 0.01;
  double time_s = 0;
  for (int i = 0; i < 15; ++i) {
    time_s += generator->Double(0, 0.4);
    const int source = generator->Int(0, 3);
    plan.sent.push_back({time_s, source, generator->RandomBytes(37), {0, 1, 2, 3}});
  }
  return plan;
}

std::map<Link, Arrived> Play(const Plan& plan) {
  AcousticNetwork network(plan.options, 42, plan.nodes);
  std::map<std::string, int> index_of;
  Positions positions_m;
  for (const AcousticNode& node : plan.nodes) {
    index_of[node.name] = static_cast<int>(positions_m.size());
    positions_m.push_back(PositionOf(node.name));
  }
  const auto name_of = [&](int node) { return plan.nodes[static_cast<size_t>(node)].name; };
  for (const Sent& sent : plan.sent) {
    std::vector<int> receivers;
    for (const int receiver : sent.receivers) {
      receivers.push_back(index_of.at(kNames[static_cast<size_t>(receiver)]));
    }
    for (const AcousticNode& node : plan.nodes) {
      if (node.name.starts_with("new")) receivers.push_back(index_of.at(node.name));
    }
    network.Transmit(sent.time_s, index_of.at(kNames[static_cast<size_t>(sent.source)]),
                     positions_m, sent.bytes, receivers);
  }
  std::map<Link, Arrived> by_link;
  for (const Arrived& arrived : DeliverAll(&network)) {
    const Reception& reception = arrived.reception;
    by_link[{name_of(reception.packet.source), name_of(reception.receiver),
             reception.packet.number}] = arrived;
  }
  return by_link;
}

/// What random draws decided. Jitter and wrong bits can only be seen where they are switched on.
void ExpectSameDraws(const std::map<Link, Arrived>& before, const std::map<Link, Arrived>& after,
                     size_t num_expected) {
  size_t num_compared = 0;
  for (const auto& [link, one] : before) {
    const auto found = after.find(link);
    if (found == after.end()) continue;
    const Arrived& two = found->second;
    ++num_compared;
    RC_ASSERT(one.reception.jitter_s == two.reception.jitter_s);
    RC_ASSERT(one.reception.fate == two.reception.fate);
    RC_ASSERT(one.reception.num_bits_flipped == two.reception.num_bits_flipped);
    RC_ASSERT(one.bytes == two.bytes);
  }
  RC_ASSERT(num_compared == num_expected);
}

constexpr size_t kNumReceptions = 15 * 3;

RC_GTEST_PROP(Draws, StayTheSameWhenNodesJoinAnywhereAndReceiveEverything, (uint64_t seed)) {
  TrafficGenerator generator(seed);
  const Plan plan = BasePlan(&generator);
  Plan larger = plan;
  for (int i = 0; i < 3; ++i) {
    larger.nodes.insert(
        larger.nodes.begin() + generator.Int(0, static_cast<int>(larger.nodes.size())),
        {.name = "new_" + std::to_string(i), .address = 1});
  }
  const auto before = Play(plan);
  const auto after = Play(larger);
  RC_ASSERT(after.size() == kNumReceptions + 15 * 3);
  ExpectSameDraws(before, after, kNumReceptions);
}

RC_GTEST_PROP(Draws, StayTheSameWhenReceiversAreLeftOutOrTurnedRound, (uint64_t seed)) {
  TrafficGenerator generator(seed);
  const Plan plan = BasePlan(&generator);
  Plan changed = plan;
  size_t num_expected = 0;
  for (Sent& sent : changed.sent) {
    std::erase_if(sent.receivers, [&](int) { return generator.OneIn(3); });
    std::ranges::reverse(sent.receivers);
    num_expected += static_cast<size_t>(std::ranges::count_if(
        sent.receivers, [&](int receiver) { return receiver != sent.source; }));
  }
  ExpectSameDraws(Play(plan), Play(changed), num_expected);
}

RC_GTEST_PROP(Draws, StayTheSameWhenOtherEffectsAreSwitched, (uint64_t seed)) {
  TrafficGenerator generator(seed);
  const Plan plan = BasePlan(&generator);
  const auto before = Play(plan);

  Plan no_jitter = plan;
  no_jitter.options.jitter = JitterModel::kOff;
  Plan no_loss = plan;
  no_loss.options.packet_loss_model = PacketLossModel::kOff;
  Plan no_errors = plan;
  no_errors.options.bit_error_model = BitErrorModel::kOff;
  const auto without_jitter = Play(no_jitter);
  const auto without_loss = Play(no_loss);
  const auto without_errors = Play(no_errors);
  int num_lost = 0;
  for (const auto& [link, one] : before) {
    const bool is_lost = one.reception.fate == AcousticFate::kLost;
    num_lost += is_lost ? 1 : 0;
    RC_ASSERT((without_jitter.at(link).reception.fate == AcousticFate::kLost) == is_lost);
    RC_ASSERT((without_errors.at(link).reception.fate == AcousticFate::kLost) == is_lost);
    RC_ASSERT(without_loss.at(link).reception.jitter_s == one.reception.jitter_s);
    RC_ASSERT(without_errors.at(link).reception.jitter_s == one.reception.jitter_s);
    if (is_lost) continue;
    RC_ASSERT(without_jitter.at(link).bytes == one.bytes);
    RC_ASSERT(without_loss.at(link).bytes == one.bytes);
  }
  RC_ASSERT(num_lost > 0);
}

RC_GTEST_PROP(Draws, StayTheSameInHalfDuplexAndWithCollisions, (uint64_t seed)) {
  TrafficGenerator generator(seed);
  const Plan plan = BasePlan(&generator);
  Plan strict = plan;
  strict.options.half_duplex = true;
  strict.options.collisions = CollisionModel::kDrop;
  const auto before = Play(plan);
  const auto after = Play(strict);
  RC_ASSERT(before.size() == after.size());
  for (const auto& [link, one] : before) {
    const Arrived& two = after.at(link);
    RC_ASSERT(one.reception.jitter_s == two.reception.jitter_s);
    const bool is_stopped = two.reception.fate == AcousticFate::kCollided ||
                            two.reception.fate == AcousticFate::kHalfDuplex;
    if (is_stopped) continue;
    RC_ASSERT(one.reception.fate == two.reception.fate);
    RC_ASSERT(one.bytes == two.bytes);
  }
}

RC_GTEST_PROP(Receptions, ComeInTheSameOrderHoweverOftenOneAsks, (uint64_t seed)) {
  TrafficGenerator generator(seed);
  Plan plan = BasePlan(&generator);
  plan.options.jitter = JitterModel::kOff;
  AcousticNetwork once(plan.options, 42, plan.nodes);
  AcousticNetwork often(plan.options, 42, plan.nodes);
  const Positions one_place(4, Eigen::Vector3d::Zero());
  std::vector<Arrived> asked_often;
  for (const Sent& sent : plan.sent) {
    once.Transmit(sent.time_s, sent.source, one_place, sent.bytes, sent.receivers);
    if (generator.OneIn(2)) DeliverTo(&often, sent.time_s, &asked_often);
    often.Transmit(sent.time_s, sent.source, one_place, sent.bytes, sent.receivers);
  }
  const std::vector<Arrived> asked_once = DeliverAll(&once);
  DeliverTo(&often, 1e9, &asked_often);
  RC_ASSERT(asked_once.size() == asked_often.size());
  for (size_t i = 0; i < asked_once.size(); ++i) {
    RC_ASSERT(asked_once[i].reception.packet == asked_often[i].reception.packet);
    RC_ASSERT(asked_once[i].reception.receiver == asked_often[i].reception.receiver);
    RC_ASSERT(asked_once[i].reception.fate == asked_often[i].reception.fate);
    RC_ASSERT(asked_once[i].bytes == asked_often[i].bytes);
  }
}

}  // namespace shoal::independence_test
