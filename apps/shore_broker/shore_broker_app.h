// Decides who hears whom. Hears NODE_REPORT_LOCAL, NODE_REPORT, NODE_MESSAGE_LOCAL, NODE_MESSAGE,
// ACK_MESSAGE, ACOUSTIC_TX, UNC_* and HELM_COMMAND; says NODE_REPORT_<V>, NODE_MESSAGE_<V> and
// ACK_MESSAGE_<V> (the very bytes that came in, unless the water damaged them), ACOUSTIC_RX_<V>,
// COMMS_FATES, COMMS_RULES, VIEW_COMMS_PULSE, NODE_REPORT_UNC and HELM_COMMAND_<V>.
//
// A step: commands are handed on, rules change, all reports of the step are taken in, then each is
// routed, then messages, acks and packets, in the order in which they came; what has come through
// the water by now is delivered; who was silent for too long is forgotten.
//
//            first step is the mission's first
//   BEGINS ------------------------------------------------> WORKS
//     | first step is a later one: UNC_CONTROLS_REQ            ^
//     +--> HOLDS what it hears -- UNC_CONTROLS, or 1 s passed --+
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/shore_broker/acoustic_traffic.h"
#include "apps/shore_broker/fate_writer.h"
#include "apps/shore_broker/pulse_writer.h"
#include "apps/shore_broker/repeat_memory.h"
#include "lib/broker/broker.h"
#include "lib/broker/broker_setup.h"
#include "lib/bus/bus.h"
#include "lib/bus/channels.h"
#include "lib/mission/mission.h"
#include "lib/routing/router.h"
#include "lib/run/app.h"

namespace shoal {

class ShoreBrokerApp : public Broker {
 public:
  ShoreBrokerApp(const Mission& mission, Bus& bus) : ShoreBrokerApp(SetupOf(mission), bus) {}
  ShoreBrokerApp(BrokerSetup setup, Bus& bus);

  void OnWarp(double warp) override;
  void Tick(int64_t utime) override;
  StatusPage Status() const override;
  std::optional<int64_t> NextArrivalUtime() const override { return water_.NextUtime(); }

  const Router& router() const { return router_; }
  const AcousticTraffic& water() const { return water_; }

 private:
  /// A message that waits for Tick; its bytes lie in arena_.
  struct Waiting {
    size_t begin = 0;
    size_t size = 0;
    bool from_outside = false;  ///< Came on the channel of vehicles from outside.
  };
  struct WaitingReport {
    Waiting raw;
    Admission admission = {};
  };
  struct WaitingControl {
    const ControlRow* row = nullptr;
    unc_control_t control;
  };
  /// Where one contact hears each kind.
  struct ReceiverChannels {
    std::string vehicle;  ///< Whose they are: an index may pass from one stranger to another.
    std::array<std::string, kNumKinds> names;
  };
  /// What decisions_ are about.
  struct Sent {
    std::string_view written_source;
    const Waiting& raw;
    Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
    bool has_pulses = false;
    std::string_view color = {};  ///< Of its pulses.
    /// Writes it for the air; asked only for what goes through the water.
    std::function<std::vector<uint8_t>()> air_bytes = {};
  };

  Waiting Keep(const Message& message, bool from_outside);
  std::span<const uint8_t> BytesOf(const Waiting& waiting) const;
  /// Decodes, or counts and warns.
  template <class T>
  bool DecodeWaiting(const Waiting& waiting, const Channel<T>& channel, T* message) {
    if (Decode(BytesOf(waiting), message)) return true;
    bus_.CountUndecodable(channel.name);
    log_.Warn(channel.name + ": undecodable bytes dropped");
    return false;
  }

  void Begin(int64_t utime);
  bool Holds(int64_t utime);
  void KeepControls(const Message& message);
  void ApplyControls(int64_t utime);
  void HandOnCommands(int64_t utime);
  bool TakeIn(int64_t utime, WaitingReport* report);
  void RouteReport(int64_t utime, const WaitingReport& report);
  void RouteMessage(int64_t utime, const Waiting& waiting);
  void RouteAck(int64_t utime, const Waiting& waiting);
  void RoutePacket(int64_t utime, const Waiting& waiting);
  void Share(int64_t utime, const WaitingReport& report);
  void Forget(int64_t utime);
  /// Delivers what decisions_ say is delivered, sends what is in transit, and tells the fates of
  /// all others, with pulses of the deliveries.
  void Conclude(int64_t utime, const Sent& sent);
  void SendThroughTheWater(int64_t utime, const Sent& sent);
  void TakeArrival(int64_t utime, const Arrival& arrival);
  /// Publishes what arrived damaged as its receiver understands it. False: it makes no sense to it.
  bool DeliverDamaged(int64_t utime, const Arrival& arrival);
  void DeliverPacket(int64_t utime, const Arrival& arrival);
  /// Of decisions_.
  Eigen::Vector3d PositionOfSource() const;
  const ReceiverChannels& ChannelsOf(int32_t index);
  std::string_view MessageColor(const node_message_t& message);

  const BrokerSetup setup_;
  Bus& bus_;
  Router router_;
  AcousticTraffic water_;
  FateWriter fates_;
  PulseWriter pulses_;
  StatusLog log_;

  int64_t start_utime_ = 0;
  int64_t now_utime_ = 0;
  bool began_ = false;
  bool holds_ = false;
  bool began_to_work_ = false;  ///< COMMS_RULES has been said.
  bool rules_changed_ = false;
  double warp_;
  int64_t num_commands_handed_on_ = 0;
  int64_t num_shared_ = 0;

  Bytes arena_;
  std::optional<unc_controls_t> kept_controls_;
  std::vector<WaitingControl> controls_;
  std::vector<Waiting> commands_;
  std::vector<WaitingReport> reports_;
  std::vector<Waiting> messages_;
  std::vector<Waiting> acks_;
  std::vector<Waiting> packets_;

  node_report_t report_;  ///< Decoded into, like the next three; keep their strings' memory.
  node_message_t message_;
  ack_message_t ack_;
  acoustic_tx_t packet_;
  std::vector<Decision> decisions_;                  ///< Of one transmission.
  std::vector<std::string> unknown_names_;           ///< Destinations of one transmission.
  std::vector<ReceiverChannels> receiver_channels_;  ///< By index of contact.
  std::vector<std::pair<std::string, int64_t>> shared_utimes_;  ///< By index; whose, and when.

  RepeatMemory repeats_;
};

}  // namespace shoal
