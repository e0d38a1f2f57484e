// The acoustic network between the nodes: what one sends arrives at the others late, damaged or not
// at all, and each reception states why.
//
//   AcousticNetwork network(options, mission.seed, {{.name = "alpha"}, {.name = "bravo"}});
//   network.Transmit(time_s, kAlpha, positions_m, bytes, receivers); // for all that was sent, then
//   for (const Reception& reception : network.Deliver(time_s)) ...   // in order of arrival
//
// A packet leaves its source at `time_s`, takes `8 bytes / data_rate_bps` to be sent and, to each
// receiver, `range / sound_speed_mps` to get there, with the positions of that moment, plus jitter;
// where sound bends, as long as its rays take (ray_channel.h).
// What overlaps at a receiver on one channel collides, whether or not it is lost otherwise. With
// `half_duplex`, what overlaps a transmission of the receiver's own is not received.
//
// Draws come from streams keyed by seed, source, the source's packet number and receiver: another
// node, receiver or effect changes none of them. Costs grow with the logarithm of the packets in
// flight, but for packets that overlap, where collisions corrupt: each pays for each other.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/random/stream.h"
#include "lib/sea/acoustics/acoustic_options.h"
#include "lib/sea/acoustics/acoustic_statistics.h"
#include "lib/sea/acoustics/air_lane.h"
#include "lib/sea/acoustics/channel_plan.h"
#include "lib/sea/acoustics/event_queue.h"
#include "lib/sea/acoustics/lane_table.h"
#include "lib/sea/acoustics/path_effects.h"
#include "lib/sea/acoustics/places.h"
#include "lib/sea/acoustics/reception.h"
#include "lib/sea/acoustics/transmission_store.h"

namespace shoal {

/// What a packet has of its own.
struct PacketOptions {
  /// It lasts as long, and comes as far, as this rate does; absent: the network's. @pre > 0
  std::optional<double> data_rate_bps = {};
  /// An index of the plan's channels; absent: the source's own. Only nodes that receive on it get
  /// the packet, and only packets on it collide with it. @pre the plan has it
  std::optional<int> channel = {};
  /// How each node moves over ground, x East, y North, z down, in the order of the positions;
  /// empty: none moves. Matters where sound bends, for Doppler.
  std::span<const Eigen::Vector3d> velocities_mps = {};
};

class AcousticNetwork {
 public:
  /// Half the circumference of the Earth.
  static constexpr double kMaxRange_m = 2.1e7;

  /// Nodes have the indices 0, 1 ... in this order.
  /// @pre FindProblems(options, nodes).empty(), names are unique, and the surroundings have what
  /// AcousticOptions::rays names.
  AcousticNetwork(const AcousticOptions& options, uint64_t seed,
                  std::span<const AcousticNode> nodes, const RaySurroundings& surroundings = {});

  /// Takes one more node in and returns its index, or states why it cannot take part.
  Result<int> AddNode(const AcousticNode& node);

  const AcousticOptions& options() const { return options_; }
  const ChannelPlan& plan() const { return plan_; }
  int num_nodes() const { return static_cast<int>(nodes_.size()); }

  /// Sends `bytes` once, for these receivers, in any order; the source itself and repetitions are
  /// passed over. `positions_m` has one for each node, x East, y North, z down; those of nodes that
  /// are not involved do not matter, and one that is not finite is not known. Returns the packet's
  /// number, which counts the source's.
  /// @pre time_s is finite and not before that of an earlier Transmit or Deliver
  int64_t Transmit(double time_s, int source, std::span<const Eigen::Vector3d> positions_m,
                   std::span<const uint8_t> bytes, std::span<const int> receivers,
                   const PacketOptions& options = {});

  /// Returns what ended until `until_s` and was not returned before, in order of end; at the same
  /// moment in the order in which they were sent, then of receivers. Valid until the next call of
  /// Transmit or Deliver.
  /// @pre until_s is not before that of an earlier Transmit or Deliver.
  std::span<const Reception> Deliver(double until_s);

  /// Returns a moment before which Deliver has nothing to return, unless more is sent; infinity
  /// where it never has.
  double NextEvent_s() const;

  /// Counts a packet that was handed over and that its receiver refused.
  void CountRejection() { ++statistics_.num_rejected; }

  /// Returns all numbers so far.
  AcousticStatistics statistics() const;
  /// Receptions without a fate yet.
  int64_t num_in_transit() const { return static_cast<int64_t>(receptions_.num_used()); }
  /// Returns how many packets, receptions and links there is room for: what memory grows with.
  /// Packets in flight at the busiest moment so far bound it.
  size_t NumPlaces() const {
    return transmissions_.num_places() + receptions_.num_places() + lanes_.num_places();
  }

 private:
  struct Node {
    Node(const std::string& name, uint64_t seed)
        : sends(StreamKey(seed, "acoustic link").With(name)),
          receives(StreamKey(seed, "acoustic receiver").With(name).low()) {}

    StreamKey sends;    ///< Key of the draws of all that it sends.
    uint64_t receives;  ///< Its name, as part of the keys of what it receives.
    int64_t num_sent = 0;
    int64_t last_offered = -1;  ///< Turn of the transmission that it was last meant for.
    // Half duplex; these follow the events.
    int64_t num_started = 0;      ///< Own transmissions so far.
    int64_t last_started = -1;    ///< The number of the last of them.
    double sends_until_s = 0;     ///< The end of the one among them that ends last ...
    int64_t longest_number = -1;  ///< ... and its number.
  };

  /// A reception that has no fate yet, or the place for one; Reception has the meanings.
  struct Pending {
    double start_s = 0;
    double end_s = 0;
    double range_m = -1;
    double travel_s = -1;
    PathEffects path;
    std::optional<RayReception> rays;
    AirLane::Ticket ticket;
    int64_t own_number = -1;      ///< The receiver's transmission when this one began; or -1.
    int64_t num_own_started = 0;  ///< Transmissions that the receiver had begun by then.
    int32_t receiver = -1;
    int32_t transmission = -1;
    int32_t lane = -1;                 ///< -1: not on the air, or collisions are off.
    std::optional<AcousticFate> fate;  ///< Known from the beginning.
  };

  void Recycle();
  void Offer(const AcousticTransmission& transmission, int32_t index, int receiver,
             std::span<const Eigen::Vector3d> positions_m,
             std::span<const Eigen::Vector3d> velocities_mps);
  /// Finds its way, if it has one. @pre both positions are known
  void FindPath(const AcousticTransmission& transmission, const RayEnd& from, const RayEnd& to,
                Pending* pending);
  StreamKey KeyOf(const AcousticTransmission& transmission, int receiver) const {
    return transmission.key.With(nodes_[static_cast<size_t>(receiver)].receives);
  }

  void StartReception(int32_t slot);
  void EndReception(int32_t slot);
  void StartTransmission(int32_t index);
  AcousticFate Decide(const Pending& pending, Reception* reception);
  int64_t OwnNumber(const Pending& pending) const;
  void NameColliders(const Pending& pending, Reception* reception) const;
  AcousticFate HandOver(const Pending& pending, Reception* reception);
  void XorColliders(const Pending& pending, std::span<uint8_t> received) const;
  std::span<uint8_t> CopyToDamage(std::span<const uint8_t> bytes);
  void LeaveLane(const Pending& pending);

  AcousticOptions options_;
  ChannelPlan plan_;
  PathModel path_;
  std::optional<RayChannel> rays_;
  uint64_t seed_;
  std::vector<Node> nodes_;
  std::set<std::string, std::less<>> names_;
  double now_s_;                   ///< Of the last Transmit or Deliver.
  AcousticStatistics statistics_;  ///< But for what is in transit.

  EventQueue events_;
  Places<Pending> receptions_;
  TransmissionStore transmissions_;
  LaneTable lanes_;

  std::vector<Reception> results_;
  std::vector<std::vector<uint8_t>>
      damaged_;  ///< Bytes of results; the front num_damaged_ of them.
  size_t num_damaged_ = 0;
  std::vector<uint8_t> scratch_;
  std::vector<int32_t> unneeded_;  ///< Kept for its memory.
};

}  // namespace shoal
