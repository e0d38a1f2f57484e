// What the rules have decided, carried out: deliveries to the receivers, at once or over the
// acoustic network, and every fate on COMMS_FATES, with a pulse of each delivery.
//
//   Delivery delivery(setup, bus, &router, &traffic);
//   router.Route(admission, utime, &decisions);
//   delivery.Conclude(utime, {.decisions = decisions, .raw = bytes, ...});
//   delivery.TakeArrivals(utime);
//   delivery.Flush(utime);
//
// Publishes NODE_REPORT_<V>, NODE_MESSAGE_<V> and ACK_MESSAGE_<V> (the bytes that came in, unless
// the acoustic network damaged them), ACOUSTIC_RX_<V>, COMMS_FATES and VIEW_COMMS_PULSE.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/shore_broker/acoustic_traffic.h"
#include "apps/shore_broker/fate_writer.h"
#include "apps/shore_broker/pulse_writer.h"
#include "lib/broker/broker_setup.h"
#include "lib/bus/bus.h"
#include "lib/routing/router.h"
#include "shoal/ack_message_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"

namespace shoal {

/// One transmission with its fates.
struct DecidedTransmission {
  std::span<const Decision> decisions = {};
  std::span<const std::string> unknown_names = {};  ///< Decision::unknown_name counts these.
  std::string_view written_source = {};             ///< The source's name where it is no contact.
  std::span<const uint8_t> raw = {};                ///< As it came to the broker.
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  bool has_pulses = false;
  std::string_view color = {};  ///< Of its pulses.
  /// Writes it for the air; asked only for what goes over the acoustic network.
  std::function<std::vector<uint8_t>()> air_bytes = {};
  std::optional<double> data_rate_bps = {};  ///< On the air; absent: the network's.
};

class Delivery {
 public:
  /// All must outlive this.
  Delivery(const BrokerSetup& setup, Bus& bus, Router* router, AcousticTraffic* traffic)
      : setup_(setup), bus_(bus), router_(*router), traffic_(*traffic), fates_(bus), pulses_(bus) {}

  /// Delivers what is delivered, sends what is in transit, and writes the fates of all others.
  void Conclude(int64_t utime, const DecidedTransmission& sent);
  /// Writes the fate of a transmission that intake refused.
  void Refuse(int64_t utime, const Decision& decision, std::string_view source) {
    fates_.Add(utime, decision, source, "");
  }
  /// Delivers what has arrived over the acoustic network by now.
  void TakeArrivals(int64_t utime);
  /// Publishes the fates and pulses of the step.
  void Flush(int64_t utime);

 private:
  /// Where one contact receives each kind.
  struct ReceiverChannels {
    std::string vehicle;  ///< Whose they are: an index may pass to another vehicle.
    std::array<std::string, kNumKinds> names;
  };

  void SendAcoustic(int64_t utime, const DecidedTransmission& sent);
  void TakeArrival(int64_t utime, const LegEnd& arrival);
  /// Publishes what arrived damaged as its receiver understands it. False: it makes no sense to it.
  bool DeliverDamaged(int64_t utime, const LegEnd& arrival);
  void DeliverPacket(int64_t utime, const LegEnd& arrival);
  const ReceiverChannels& ChannelsOf(int32_t index);

  const BrokerSetup& setup_;
  Bus& bus_;
  Router& router_;
  AcousticTraffic& traffic_;
  FateWriter fates_;
  PulseWriter pulses_;
  std::vector<ReceiverChannels> receiver_channels_;  ///< By index of contact.
  node_report_t report_;  ///< Decoded into, like the next two; keep their strings' memory.
  node_message_t message_;
  ack_message_t ack_;
};

}  // namespace shoal
