// Decides which vehicle receives what. Subscribes to NODE_REPORT_LOCAL, NODE_REPORT,
// NODE_MESSAGE_LOCAL, NODE_MESSAGE, ACK_MESSAGE, RELAY_TX, ACOUSTIC_TX(_ON), MODEM_TX, UNC_* and
// HELM_COMMAND, and where there is an acoustic network or vehicles have media of their own to
// NAV_<V>, by which media and the rules for packets decide; publishes what delivery.h lists,
// COMMS_RULES, NODE_REPORT_UNC and HELM_COMMAND_<V>. Outside stepping it answers COMMS_RULES_REQ
// with COMMS_RULES_NOW.
//
// A step: commands are handed on, rules change, the reports of the step are taken in and routed
// (report_traffic.h), then messages, acks, what gateways forward, and packets, in the order in
// which they came; what has arrived over media by now is delivered; vehicles that were silent for
// too long are forgotten.
//
//            first step is the mission's first
//   BEGINS ------------------------------------------------> WORKS
//     | first step is a later one: UNC_CONTROLS_REQ            ^
//     +--> HOLDS what comes in -- UNC_CONTROLS, or 1 s passed ---+
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/shore_broker/broker_inbox.h"
#include "apps/shore_broker/delivery.h"
#include "apps/shore_broker/media_traffic.h"
#include "apps/shore_broker/repeat_memory.h"
#include "apps/shore_broker/report_intake.h"
#include "apps/shore_broker/report_traffic.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/router.h"
#include "lib/mission/model/mission.h"
#include "lib/run/broker/broker.h"
#include "lib/run/broker/broker_setup.h"
#include "lib/run/broker/report_blocks.h"
#include "lib/run/run/app.h"

namespace shoal {

class ShoreBrokerApp : public Broker {
 public:
  ShoreBrokerApp(const Mission& mission, Bus& bus) : ShoreBrokerApp(SetupOf(mission), bus) {}
  /// `share`: where several brokers share a mission, each in a part of its own.
  ShoreBrokerApp(BrokerSetup setup, Bus& bus, BrokerShare share = {});

  void OnWarp(double warp) override { reports_.shared().OnWarp(warp); }
  void Tick(int64_t utime) override;
  /// COMMS_RULES_REQ: the rules in force, on COMMS_RULES_NOW.
  std::vector<std::string> RequestChannels() const override;
  std::optional<RequestAnswer> Answer(std::string_view channel,
                                      std::span<const uint8_t> data) const override;
  StatusPage Status() const override;
  std::optional<int64_t> NextArrivalUtime() const override { return traffic_.NextUtime(); }

  const Router& router() const { return router_; }
  /// The network of [acoustics].
  const AcousticTraffic& traffic() const { return traffic_.acoustic(); }

 private:
  struct WaitingControl {
    const ControlRow* row = nullptr;
    unc_control_t control;
  };

  void PlaceTruth(const std::string& name, const nav_t& nav);
  void Begin(int64_t utime);
  bool Holds(int64_t utime);
  void KeepControls(const Message& message);
  void ApplyControls(int64_t utime);
  void HandOnCommands(int64_t utime);
  void RouteMessage(int64_t utime, const BrokerInbox::Item& item);
  void RouteAck(int64_t utime, const BrokerInbox::Item& item);
  void RouteRelay(int64_t utime, const BrokerInbox::Item& item);
  /// Routes what relay_ holds. False: it is not one of its kind.
  bool RouteRelayed(int64_t utime, const MediaChoice& over);
  void RoutePacket(int64_t utime, const BrokerInbox::Item& item);
  void RouteBytes(int64_t utime, const BrokerInbox::Item& item, const std::string& source,
                  const std::vector<uint8_t>& payload, const PacketOptions& options);
  void Forget(int64_t utime);
  /// Has decisions_ carried out, and clears them.
  void Conclude(int64_t utime, DecidedTransmission sent);
  /// Of decisions_.
  Eigen::Vector3d PositionOfSource() const;
  std::string_view MessageColor(const node_message_t& message);

  const BrokerSetup setup_;
  const bool has_rays_;
  const BrokerShare share_;
  Bus& bus_;
  StatusLog log_;
  BrokerInbox inbox_;
  Router router_;
  MediaTraffic traffic_;
  Delivery delivery_;
  ReportIntake intake_;
  ReportTraffic reports_;

  int64_t start_utime_ = 0;
  int64_t now_utime_ = 0;
  bool began_ = false;
  bool holds_ = false;
  bool has_published_rules_ = false;  ///< COMMS_RULES, for the first time.
  bool rules_changed_ = false;
  int64_t num_commands_handed_on_ = 0;

  std::optional<unc_controls_t> kept_controls_;
  std::vector<WaitingControl> controls_;

  node_report_t report_;  ///< Decoded into, like the next six; keep their strings' memory.
  node_message_t message_;
  ack_message_t ack_;
  relay_t relay_;
  acoustic_tx_t packet_;
  acoustic_tx_on_t channel_packet_;
  modem_tx_t modem_packet_;
  std::vector<Decision> decisions_;         ///< Of one transmission.
  std::vector<std::string> unknown_names_;  ///< Destinations of one transmission.

  RepeatMemory repeats_;
};

}  // namespace shoal
