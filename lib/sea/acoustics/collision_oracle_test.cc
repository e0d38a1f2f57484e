// Collisions and half duplex against an oracle that compares every packet with every other, in the
// plainest way, from the times of arrival alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/sea/acoustics/water_testing.h"

namespace shoal::collision_oracle_test {

struct Schedule {
  AcousticOptions options;
  int num_nodes = 0;
  Positions positions_m;
  std::vector<Sent> sent;  ///< In order of time.
};

/// Makes schedules in which packets meet, in pairs and in crowds, and often only touch: half of
/// them keep to a raster of one byte's time, with all nodes in one place.
Schedule MakeSchedule(TrafficGenerator* generator, CollisionModel collisions, bool half_duplex) {
  Schedule schedule;
  const bool on_raster = generator->OneIn(2);
  AcousticOptions& options = schedule.options;
  options = IdealOptions(static_cast<AccessMode>(generator->Int(0, 3)));
  options.collisions = collisions;
  options.half_duplex = half_duplex;
  options.data_rate_bps = 1024;  // A byte takes 2^-7 s: sums of such times are exact.
  if (!on_raster && generator->OneIn(2)) options.jitter = JitterModel::kUniform;
  schedule.num_nodes = generator->Int(2, 6);
  schedule.positions_m = on_raster ? Positions(6, Eigen::Vector3d::Zero())
                                   : generator->RandomPositions(schedule.num_nodes, 3000);
  schedule.positions_m.resize(static_cast<size_t>(schedule.num_nodes), Eigen::Vector3d::Zero());
  const int duration_bytes = generator->Int(8, 400);
  const int num_sent = generator->Int(1, 14);
  for (int i = 0; i < num_sent; ++i) {
    Sent sent;
    sent.time_s = on_raster ? generator->Int(0, duration_bytes) / 128.0
                            : generator->Double(0, duration_bytes / 128.0);
    sent.source = generator->Int(0, schedule.num_nodes - 1);
    sent.bytes = generator->RandomBytes(generator->Int(0, 60));
    for (int node = 0; node < schedule.num_nodes; ++node) {
      if (!generator->OneIn(8)) sent.receivers.push_back(node);
    }
    schedule.sent.push_back(sent);
  }
  std::ranges::stable_sort(schedule.sent, {}, &Sent::time_s);
  return schedule;
}

/// Plays a schedule with deliveries in between, at moments that make no difference.
std::vector<Arrived> Play(const Schedule& schedule, TrafficGenerator* generator,
                          AcousticNetwork* network) {
  std::vector<Arrived> arrived;
  for (const Sent& sent : schedule.sent) {
    if (generator->OneIn(2)) DeliverTo(network, sent.time_s, &arrived);
    network->Transmit(sent.time_s, sent.source, schedule.positions_m, sent.bytes, sent.receivers);
  }
  DeliverTo(network, 1e6, &arrived);
  return arrived;
}

/// The oracle's result for one reception.
struct Verdict {
  std::vector<PacketId> colliders;  ///< Sorted.
  Bytes bytes;                      ///< After collisions.
  bool sent_itself = false;
};

/// Returns the bytes of each packet of each source.
std::vector<std::vector<Sent>> BySource(const Schedule& schedule) {
  std::vector<std::vector<Sent>> packets(static_cast<size_t>(schedule.num_nodes));
  for (const Sent& sent : schedule.sent) packets[static_cast<size_t>(sent.source)].push_back(sent);
  return packets;
}

const Sent& Find(const std::vector<std::vector<Sent>>& packets, const PacketId& id) {
  return packets[static_cast<size_t>(id.source)][static_cast<size_t>(id.number)];
}

Verdict Judge(const Schedule& schedule, const std::vector<std::vector<Sent>>& packets,
              const std::vector<Arrived>& all, const Reception& mine) {
  Verdict verdict;
  const double byte_s = 8 / schedule.options.data_rate_bps;
  verdict.bytes = Find(packets, mine.packet).bytes;
  for (const Arrived& arrived : all) {
    const Reception& other = arrived.reception;
    if (other.packet == mine.packet || other.receiver != mine.receiver ||
        other.channel != mine.channel || other.fate == AcousticFate::kNotListening) {
      continue;
    }
    const double from_s = std::max(mine.start_s, other.start_s);
    const double until_s = std::min(mine.end_s, other.end_s);
    if (!(from_s < until_s)) continue;
    verdict.colliders.push_back(other.packet);
    const Bytes& theirs = Find(packets, other.packet).bytes;
    const double my_first = std::floor((from_s - mine.start_s) / byte_s + 1e-6);
    const double their_first = std::floor((from_s - other.start_s) / byte_s + 1e-6);
    const double count = std::floor((until_s - from_s) / byte_s + 1e-6);
    for (double i = 0; i < count; ++i) {
      const auto here = static_cast<size_t>(my_first + i);
      const auto there = static_cast<size_t>(their_first + i);
      if (here < verdict.bytes.size() && there < theirs.size())
        verdict.bytes[here] ^= theirs[there];
    }
  }
  std::ranges::sort(verdict.colliders);
  for (const Sent& own : packets[static_cast<size_t>(mine.receiver)]) {
    const double own_end_s = own.time_s + static_cast<double>(own.bytes.size()) * byte_s;
    if (std::max(own.time_s, mine.start_s) < std::min(own_end_s, mine.end_s)) {
      verdict.sent_itself = true;
    }
  }
  return verdict;
}

/// Compares one reception with the verdict. Returns how many packets it met.
size_t Compare(const Schedule& schedule, const std::vector<std::vector<Sent>>& packets,
               const std::vector<Arrived>& all, const Arrived& arrived) {
  const Reception& reception = arrived.reception;
  const Verdict verdict = Judge(schedule, packets, all, reception);
  const Bytes& sent = Find(packets, reception.packet).bytes;
  EXPECT_EQ(reception.num_colliders, static_cast<int64_t>(verdict.colliders.size()));
  const size_t num_named = std::min<size_t>(verdict.colliders.size(), kMaxNamedColliders);
  const std::vector<PacketId> named(reception.colliders.begin(),
                                    reception.colliders.begin() + static_cast<int>(num_named));
  EXPECT_TRUE(std::ranges::is_sorted(named));
  EXPECT_EQ(std::ranges::adjacent_find(named), named.end());
  EXPECT_TRUE(std::ranges::includes(verdict.colliders, named));

  const bool drops = schedule.options.collisions == CollisionModel::kDrop;
  AcousticFate expected = AcousticFate::kDelivered;
  if (schedule.options.half_duplex && verdict.sent_itself) {
    expected = AcousticFate::kHalfDuplex;
  } else if (drops && !verdict.colliders.empty()) {
    expected = AcousticFate::kCollided;
  } else if (!drops && verdict.bytes != sent) {
    expected = AcousticFate::kDamagedByCollision;
  }
  EXPECT_EQ(AcousticFateText(reception.fate), AcousticFateText(expected));
  if (HandsOver(expected)) {
    EXPECT_EQ(arrived.bytes, drops ? sent : verdict.bytes);
  } else {
    EXPECT_TRUE(arrived.bytes.empty());
  }
  return verdict.colliders.size();
}

/// How many receptions met none, one, two, and three or more others.
struct Meetings {
  std::array<int, 4> count = {};
};

void PlayAndCompare(CollisionModel collisions, bool half_duplex, uint64_t seed,
                    Meetings* meetings) {
  TrafficGenerator generator(seed);
  const Schedule schedule = MakeSchedule(&generator, collisions, half_duplex);
  AcousticNetwork network(schedule.options, 1, TestNodes(schedule.num_nodes));
  const std::vector<Arrived> all = Play(schedule, &generator, &network);
  const auto packets = BySource(schedule);
  for (const Arrived& arrived : all) {
    if (arrived.reception.fate == AcousticFate::kNotListening) continue;
    ++meetings->count[std::min<size_t>(3, Compare(schedule, packets, all, arrived))];
  }
}

void PlayMany(CollisionModel collisions, bool half_duplex) {
  Meetings meetings;
  for (uint64_t seed = 0; seed < 1000 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    PlayAndCompare(collisions, half_duplex, seed, &meetings);
  }
  for (const int count : meetings.count) EXPECT_GT(count, 1000);
}

TEST(CollisionOracle, AgreesWhereCollisionsDrop) { PlayMany(CollisionModel::kDrop, false); }

TEST(CollisionOracle, AgreesWhereCollisionsCorrupt) { PlayMany(CollisionModel::kCorrupt, false); }

TEST(CollisionOracle, AgreesWhereNodesDoNotReceiveWhileTheySend) {
  PlayMany(CollisionModel::kDrop, true);
}

TEST(CollisionOracle, AgreesOnCorruptionWhereNodesDoNotReceiveWhileTheySend) {
  PlayMany(CollisionModel::kCorrupt, true);
}

}  // namespace shoal::collision_oracle_test
