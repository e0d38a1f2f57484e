// One end of the bridge between two buses of one mission: what home's relay and the host's have in
// common. Each plays, on its own bus, the participants of the other side: it sends what they
// publish, as it is, and answers RESEND for it. Pure but for the transport.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/mission_secret.h"
#include "lib/bus/bus/transport.h"
#include "lib/run/hosts/kept_messages.h"
#include "lib/run/hosts/link_message.h"
#include "shoal/step_done_t.hpp"
#include "shoal/tick_t.hpp"

namespace shoal {

/// Silence after which a relay asks again: as participants and the clock do.
inline constexpr int64_t kRelayRepeat_us = 50'000;

struct RelayOptions {
  std::string name;  ///< In the seals of its requests.
  int64_t mission_id = 0;
  MissionSecret secret = {};
  int64_t tick_us = 100'000;  ///< Of mission time: with the warp, when an answer is late.
};

class RelayBus {
 public:
  RelayBus(RelayOptions options, PortPlan plan, Transport& transport);

  /// Returns the content of a message of the step protocol; nothing where its seal is not genuine.
  struct Opened {
    std::string publisher;
    std::span<const uint8_t> message;
  };
  std::optional<Opened> Open(std::string_view channel, std::span<const uint8_t> datagram);

  /// Sends a sealed message of the other side here, and keeps it. Refuses and counts one that is
  /// not genuine, or whose publisher the other side does not run.
  void SendSealed(const LinkPart& part,
                  const std::function<bool(std::string_view publisher)>& runs_there);
  /// Sends as it is on the channel's port: TICK, STEP_DONE, pages.
  void SendPlain(const LinkPart& part);
  /// Sends a message from outside, whose echo from this bus IsEcho then knows.
  void SendOutside(const LinkPart& part);
  /// True where this datagram without a seal is one that SendOutside sent.
  bool IsEcho(std::string_view channel, std::span<const uint8_t> datagram);

  /// Answers a RESEND for what `is_played(publisher)` published and this end sent.
  void OnResend(std::span<const uint8_t> datagram,
                const std::function<bool(std::string_view publisher)>& is_played, int64_t wall_us);
  /// Asks `publisher` on this bus for its messages of `step` on `channel` again.
  void Request(int64_t step, const std::string& publisher, const std::string& channel);

  KeptMessages& kept() { return kept_; }
  const KeptMessages& kept() const { return kept_; }
  const PortPlan& plan() const { return plan_; }
  int64_t mission_id() const { return options_.mission_id; }
  int64_t tick_us() const { return options_.tick_us; }
  void CountRefused() { ++num_refused_; }
  /// Messages and parts whose seals do not prove the mission's secret, or another's name.
  int64_t num_refused() const { return num_refused_ + kept_.num_refused(); }

 private:
  const RelayOptions options_;
  const PortPlan plan_;
  Transport& transport_;
  KeptMessages kept_;
  std::map<std::pair<std::string, Bytes>, int> echoes_;  ///< Outside messages sent, not yet back.
  size_t echo_bytes_ = 0;
  std::map<std::pair<std::string, std::string>, int64_t> next_resends_;
  int64_t num_refused_ = 0;
};

/// Outside messages that wait for the next batch; at most as many as a participant takes in a step.
class OutsideQueue {
 public:
  static constexpr size_t kThisBus = static_cast<size_t>(-1);

  struct Waiting {
    LinkPart part;
    size_t from = kThisBus;  ///< The host whose bus it is on already.
  };

  void Add(std::string_view channel, std::span<const uint8_t> datagram, size_t from = kThisBus);
  const std::vector<Waiting>& waiting() const { return waiting_; }
  void Clear();

 private:
  std::vector<Waiting> waiting_;
  size_t bytes_ = 0;
};

}  // namespace shoal
