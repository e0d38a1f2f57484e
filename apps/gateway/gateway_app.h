// A gateway: what its vehicle has received by one medium goes on over others. Subscribes to
// RELAY_RX_<V>, publishes RELAY_TX.
//
// Each report, message and ack that it is given either waits until the rate lets it go, or is
// refused at once, which RELAY_TX states with the cause: the broker gives both a fate. Reports
// carry the gateways that have forwarded them as the extra field "via", messages behind their
// src_app. Their utime stays: a receiver sees how old they are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"
#include "lib/sea/media/relay_queue.h"

namespace shoal {

class GatewayApp : public App {
 public:
  /// @pre vehicle.media.gateway.exists
  GatewayApp(const Mission& mission, const Vehicle& vehicle, Bus& bus);

  void Tick(int64_t utime) override;
  StatusPage Status() const override;

 private:
  void TakeIn(int64_t utime, relay_t relay);
  void Refuse(int64_t utime, relay_t relay, Cause cause);
  /// Writes the gateways into what it holds. False: it does not decode.
  bool MarkWay(relay_t* relay);
  bool IsForOthers(const relay_t& relay);
  void Publish(int64_t utime, relay_t relay);

  const std::string name_;
  const GatewayOptions options_;
  Bus& bus_;
  const Channel<relay_t> tx_channel_ = channels::RelayTx();
  RelayQueue<relay_t> queue_;
  std::vector<relay_t> arrived_;  ///< Since the last step.
  StatusLog log_;
  int64_t num_received_ = 0;
  int64_t num_forwarded_ = 0;
  int64_t num_own_ = 0;  ///< Messages for the gateway's vehicle alone.
  int64_t num_refused_ = 0;
  node_report_t report_;  ///< Decoded into, like the next.
  node_message_t message_;
};

}  // namespace shoal
