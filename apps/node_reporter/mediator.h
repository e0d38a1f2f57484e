// A vehicle's part in acknowledged messages. As the receiver, answers each message that asks for it
// with an ACK_MESSAGE. As the sender, sends what it is given on MEDIATED_MESSAGE_<V> and repeats it
// until it is acknowledged.
//
//            MEDIATED_MESSAGE_V          all have acknowledged
//   (none) ----------------------> SENT ------------------------> done
//           NODE_MESSAGE_LOCAL     ^  | no ack for ack_timeout_s
//                                  |  | fewer than max_repeats: NODE_MESSAGE_LOCAL again
//                                  +--+------- otherwise: given up
//
// "All" are the other vehicles in dest_node; of a message to a group or to all, one is enough.
//
// A flood of messages must not become a flood of acks, which would overload the bus: of one step
// at most kMaxAcksPerStep messages are acknowledged, and kMaxAcksWaiting acks wait for their time.
// Senders repeat the others.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/status_page.h"

namespace shoal {

struct MediatorCounters {
  int64_t given = 0;         ///< Messages to be sent until they are acknowledged.
  int64_t acknowledged = 0;  ///< Of these.
  int64_t given_up = 0;      ///< Of these.
  int64_t refused = 0;       ///< Of these: not sent at all.
  int64_t repeats = 0;
  int64_t acks_sent = 0;        ///< For messages of others.
  int64_t acks_unsent = 0;      ///< The same, but too many in one step, or with too long an ack_id.
  int64_t acks_unexpected = 0;  ///< Received, but for no message that waits.
};

class Mediator {
 public:
  /// More waiting messages than this are refused.
  static constexpr size_t kMaxWaiting = 1000;
  /// Refused too if it would make the waiting messages longer than this, all together: all of them
  /// may be repeated at once.
  static constexpr size_t kMaxWaitingBytes = 2'000'000;
  static constexpr size_t kMaxAcksPerStep = 1000;
  static constexpr size_t kMaxAcksWaiting = 10'000;
  /// A message with a longer ack_id is not acknowledged.
  static constexpr size_t kLongestAckId = 1000;

  /// Subscribes; `log` must outlive it. Jitter is drawn by seed, vehicle and number.
  Mediator(std::string vehicle, const MessageOptions& options, uint64_t seed, Bus& bus,
           StatusLog* log);

  void Tick(int64_t utime);

  /// given = acknowledged + given_up + refused + num_waiting(), after each Tick.
  const MediatorCounters& counters() const { return counters_; }
  size_t num_waiting() const { return waiting_.size(); }

 private:
  struct WaitingMessage {
    node_message_t message;
    std::set<std::string> silent;  ///< Keys of vehicles yet to acknowledge; empty: any vehicle.
    int64_t repeat_utime = 0;      ///< It is repeated then, or given up.
    int64_t number = 0;            ///< Of those that were given.
    int64_t num_repeats = 0;
  };
  struct WaitingAck {
    ack_message_t ack;
    std::optional<int64_t> due_utime;  ///< Absent: it has come since the last step.
  };

  void Send(int64_t utime, node_message_t message);
  void Acknowledge(int64_t utime);
  int64_t RepeatUtime(int64_t utime, const WaitingMessage& entry) const;
  void TakeAck(int64_t utime, const ack_message_t& ack);
  void Repeat(int64_t utime);
  std::map<std::string, WaitingMessage>::iterator Remove(
      std::map<std::string, WaitingMessage>::iterator entry);

  std::vector<node_message_t> to_send_;
  std::vector<WaitingAck> to_acknowledge_;
  size_t num_acks_of_step_ = 0;  ///< Taken since the last Tick.
  std::vector<ack_message_t> received_acks_;
  std::map<std::string, WaitingMessage> waiting_;  ///< By ack_id.
  size_t waiting_bytes_ = 0;                       ///< Of these, as they are sent.

  const std::string vehicle_;
  const MessageOptions options_;
  const StreamKey ack_key_;
  const StreamKey repeat_key_;
  int64_t num_acks_ = 0;  ///< That were asked for.
  Bus& bus_;
  StatusLog* log_;
  MediatorCounters counters_;
};

}  // namespace shoal
