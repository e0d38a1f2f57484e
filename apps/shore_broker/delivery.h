// What the rules have decided, carried out: deliveries to the receivers, at once or over media,
// and every fate on COMMS_FATES, with a pulse of each delivery. What a gateway receives goes to its
// app too.
//
//   Delivery delivery(setup, bus, &router, &traffic, &log);
//   router.Route(admission, utime, &decisions);
//   delivery.Conclude(utime, {.decisions = decisions, .raw = bytes, ...});
//   delivery.TakeArrivals(utime);
//   delivery.Flush(utime);
//
// Publishes NODE_REPORT_<V>, NODE_MESSAGE_<V> and ACK_MESSAGE_<V> (the bytes that came in, unless
// an acoustic network damaged them), ACOUSTIC_RX_<V>, ACOUSTIC_RX_ON_<V>, RELAY_RX_<V>,
// COMMS_FATES, VIEW_COMMS_PULSE and, where vehicles have media of their own, COMMS_MEDIA, and where
// sound bends, COMMS_ARRIVALS.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/shore_broker/arrival_writer.h"
#include "apps/shore_broker/fate_writer.h"
#include "apps/shore_broker/media_traffic.h"
#include "apps/shore_broker/media_writer.h"
#include "apps/shore_broker/pulse_writer.h"
#include "apps/shore_broker/received_memory.h"
#include "lib/bus/bus/bus.h"
#include "lib/comms/routing/router.h"
#include "lib/run/broker/broker_setup.h"
#include "lib/run/run/status_page.h"
#include "shoal/ack_message_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"

namespace shoal {

/// One transmission with its fates.
struct DecidedTransmission {
  std::span<const Decision> decisions = {};
  std::span<const std::string> unknown_names = {};  ///< Decision::unknown_name counts these.
  std::string_view written_source = {};  ///< The source's name where it is not a contact.
  std::span<const uint8_t> raw = {};     ///< As it came to the broker.
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  bool has_pulses = false;
  std::string_view color = {};  ///< Of its pulses.
  /// Writes it for the air; asked only for what goes over media.
  std::function<std::vector<uint8_t>()> air_bytes = {};
  std::optional<double> data_rate_bps = {};  ///< On the air; absent: the network's.
  std::optional<int> channel = {};           ///< Its id; absent: the sender's own.
  const MediaChoice* over = nullptr;         ///< What may carry it.
  Provenance provenance = {};                ///< Without an origin: the source has made it.
};

class Delivery {
 public:
  /// All must outlive this.
  Delivery(const BrokerSetup& setup, Bus& bus, Router* router, MediaTraffic* traffic,
           StatusLog* log, FateWriter::OnFates on_fates)
      : setup_(setup),
        bus_(bus),
        router_(*router),
        traffic_(*traffic),
        log_(*log),
        has_gateways_(!traffic->Gateways().empty()),
        fates_(bus, std::move(on_fates)),
        media_(bus),
        arrivals_(bus),
        pulses_(bus) {}

  /// Delivers what is delivered, sends what is in transit, and writes the fates of all others.
  void Conclude(int64_t utime, const DecidedTransmission& sent);
  /// Writes the fate of a transmission that intake refused.
  void Refuse(int64_t utime, const Decision& decision, std::string_view source) {
    fates_.Add(utime, decision, source, "");
  }
  /// Delivers what has arrived over media by now.
  void TakeArrivals(int64_t utime);
  /// Publishes the fates and pulses since the last call.
  void Flush(int64_t utime);

 private:
  /// Where one contact receives each kind.
  struct ReceiverChannels {
    std::string vehicle;  ///< Whose they are: an index may pass to another vehicle.
    std::array<std::string, kNumKinds> names;
  };

  void SendOverMedia(int64_t utime, const DecidedTransmission& sent);
  /// Gives the legs to vehicles that have made or forwarded it their fate, and removes them.
  void EndWhereItWas(int64_t utime, Shipment* shipment);
  void TakeLegEnd(int64_t utime, const LegEnd& end);
  /// Publishes it as it was sent, on the receiver's channel.
  void Deliver(const ShipmentLeg& leg, const Shipment& shipment);
  void Conclude(int64_t utime, const LegEnd& end, Cause cause);
  /// Returns the gateway at the end of the leg, where it forwards what came by it; else nullptr.
  const GatewayOptions* ForwarderOf(const LegEnd& arrival) const;
  /// Hands what the vehicle has received to its gateway, where it is one that forwards such.
  void HandToGateway(int64_t utime, const LegEnd& arrival);
  /// Publishes what arrived damaged as its receiver understands it. False: it makes no sense to it.
  bool DeliverDamaged(int64_t utime, const LegEnd& arrival);
  void DeliverPacket(int64_t utime, const LegEnd& arrival);
  const ReceiverChannels& ChannelsOf(int32_t index);

  const BrokerSetup& setup_;
  Bus& bus_;
  Router& router_;
  MediaTraffic& traffic_;
  StatusLog& log_;
  const bool has_gateways_;
  ReceivedMemory received_;
  FateWriter fates_;
  MediaWriter media_;
  ArrivalWriter arrivals_;
  PulseWriter pulses_;
  std::vector<ReceiverChannels> receiver_channels_;  ///< By index of contact.
  node_report_t report_;  ///< Decoded into, like the next two; keep their strings' memory.
  node_message_t message_;
  ack_message_t ack_;
};

}  // namespace shoal
