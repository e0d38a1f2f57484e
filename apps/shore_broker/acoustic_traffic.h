// What the broker sends over one acoustic network, from the moment at which it is chosen for some
// of its receivers to its arrival.
//
//   AcousticTraffic traffic(setup, setup.media.acoustics, setup.seed, setup.nodes);
//   traffic.Place("alpha", position_m);                  // with every report
//   traffic.Send(utime, std::move(shipment));            // legs: one for each receiver
//   traffic.Deliver(utime, [&](const LegEnd& end) { ... });
//
// What the broker handles at `utime` was published one step before, and leaves its source then;
// with a queue not before the source's packet before it has been sent and has arrived, whatever the
// jitter, so that a vehicle's own packets never meet.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "apps/shore_broker/shipment.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/router.h"
#include "lib/run/broker/broker_setup.h"
#include "lib/sea/acoustics/acoustic_network.h"

namespace shoal {

class AcousticTraffic {
 public:
  /// No payload is longer, whatever the modem.
  static constexpr int64_t kMaxPayload_bytes = 65'535;
  /// A packet in transit is kept with its whole message, which has texts that are not sent over
  /// the air. Longer messages are refused.
  static constexpr int64_t kMaxMessage_bytes = 2 * kMaxPayload_bytes;
  /// A vehicle that sends faster than the network carries has at most this many packets in transit.
  static constexpr int kMaxPacketsOfOne = 256;

  /// `nodes`: those of the mission's vehicles that can use it.
  AcousticTraffic(const BrokerSetup& setup, const Acoustics& acoustics, uint64_t seed,
                  std::span<const AcousticNode> nodes);

  /// Why no vehicle of the mission can take part; empty: they can.
  const std::string& problem() const { return problem_; }
  const AcousticNetwork& network() const { return network_; }

  /// The most that a packet holds.
  int64_t max_payload_bytes() const { return max_payload_bytes_; }

  /// Sets where a vehicle is, below which its modem may hang, and how it moves over ground. One
  /// that is not of the mission joins the network, if it has room.
  void Place(std::string_view name, const Eigen::Vector3d& position_m,
             const Eigen::Vector3d& velocity_mps = Eigen::Vector3d::Zero());

  /// Sends it, at the time of the step before `utime`. Returns the legs that it cannot go, with
  /// their causes: all, or those to vehicles without a channel.
  struct Refusal {
    ShipmentLeg leg;
    Cause cause;
  };
  std::vector<Refusal> Send(int64_t utime, Shipment shipment);

  /// Calls `take` for each leg that ended until `utime`, in order of arrival.
  void Deliver(int64_t utime, const TakeLegEnd& take);

  /// Counts what arrived damaged and was thrown away by its receiver.
  void CountRejection() { network_.CountRejection(); }

  /// Returns how many bytes of it are on the air.
  int32_t FrameBytes(const Shipment& shipment) const {
    return static_cast<int32_t>(shipment.payload.size()) + (crc_ ? 4 : 0);
  }
  /// Returns the mission time of a moment of the network, to the microsecond.
  int64_t UtimeOf(double time_s) const { return epoch_utime_ + Microseconds(time_s); }
  /// Legs without a fate, of packets that wait too.
  int64_t num_in_transit() const { return network_.num_in_transit() + num_waiting_legs_; }
  /// Returns a mission time before which Deliver has nothing to report, unless more is sent;
  /// nothing where nothing is in transit.
  std::optional<int64_t> NextUtime() const;

  /// Returns a number that names a vehicle of the network, or nothing.
  std::optional<uint32_t> AddressOf(std::string_view name) const;
  /// Returns the vehicle with this address; empty: none.
  std::string_view VehicleAt(uint32_t address) const;
  /// Returns a packet's name: "alpha 12".
  std::string NameOf(const PacketId& packet) const;
  /// Returns the channel with this id, an index of the network's plan, or nothing.
  std::optional<int> ChannelWith(int id) const;
  int ChannelId(int32_t channel) const {
    return channel < 0 ? -1 : network_.plan().channel(channel).id;
  }

 private:
  struct Node {
    std::string name;
    uint32_t address = 0;
    double modem_depth_m = 0;  ///< Its modem hangs so far below it.
    int num_packets = 0;       ///< In transit.
    std::deque<Shipment> waiting = {};
    double free_s = -std::numeric_limits<double>::infinity();  ///< The next may be sent then.
  };
  struct PacketHash {
    size_t operator()(const PacketId& packet) const {
      return std::hash<int64_t>()(packet.number * 8191 + packet.source);
    }
  };
  struct UnderWay {
    Shipment shipment;
    int64_t sent_utime = 0;
    size_t num_legs_left = 0;
  };

  std::optional<int> FindNode(std::string_view name) const;
  double SecondsOf(int64_t utime) const { return Seconds(utime - epoch_utime_); }
  int64_t SentUtime(int64_t utime) const;
  /// Sends it now. @pre its legs have nodes, in their order
  void Launch(double time_s, int source, Shipment shipment);
  /// Launches what waits and may be sent until `until_s`, in order of time, then of vehicles.
  void LaunchWaiting(double until_s);
  /// Returns the vehicle whose waiting packet may be sent first; nothing where none waits.
  std::optional<int> NextToLaunch() const;
  Cause CauseOf(const Reception& reception, const Shipment& shipment) const;

  bool crc_;
  bool queues_;
  size_t queue_length_;
  Acoustics::QueueDrop queue_drop_;
  int64_t tick_us_;
  int64_t epoch_utime_;  ///< The network's time is counted from here.
  int64_t max_payload_bytes_;
  std::string problem_;
  AcousticNetwork network_;
  std::vector<Node> nodes_;
  size_t max_nodes_ = 0;                             ///< Invented names must not fill the memory.
  std::map<std::string, int, std::less<>> node_of_;  ///< By key of the name.
  std::vector<Eigen::Vector3d> positions_m_;         ///< By node.
  std::vector<Eigen::Vector3d> velocities_mps_;      ///< Likewise.
  std::unordered_map<PacketId, UnderWay, PacketHash> under_way_;
  std::optional<int64_t> delivered_utime_;  ///< Of the last Deliver.
  int64_t num_waiting_legs_ = 0;            ///< Of packets that wait, or were thrown away ...
  std::vector<Shipment> thrown_away_;       ///< ... since the last Deliver.
};

}  // namespace shoal
