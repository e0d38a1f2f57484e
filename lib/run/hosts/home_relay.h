// Home's relay: on the bus of `shoal run` it plays the participants that run on hosts.
//
//   TICK k on the bus --> wait until all of step k-1 is here --> one batch to each host:
//                         what it may want of step k-1, then TICK k
//   batch of a host   --> its messages onto the bus, then its answers, STEP_DONE k
//
// The clock and the other participants do not notice the difference, so results do not depend on
// which computer ran what. Time comes in as an argument. Pure but for the transport.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lib/run/hosts/relay_bus.h"

namespace shoal {

/// What a relay needs to know of one host.
struct RelayedHost {
  /// May a host publish on this channel? `publisher`: empty for a message without a seal.
  using MayPublish = std::function<bool(std::string_view publisher, std::string_view channel)>;

  std::set<std::string, std::less<>> participants;      ///< By their names on the bus.
  std::function<bool(std::string_view channel)> wants;  ///< May its participants subscribe to it?
  MayPublish may_publish;
};

class HomeRelay {
 public:
  /// `send(host, message)` puts a message on the link to that host.
  using SendToHost = std::function<void(size_t host, LinkMessage message)>;

  HomeRelay(RelayOptions options, PortPlan plan, Transport& transport,
            std::vector<RelayedHost> hosts, SendToHost send);

  /// Takes a datagram from home's bus.
  void OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                  int64_t wall_us);
  /// Takes a message of kind kDone or kAside from a host's link. Returns the first channel in it on
  /// which that host must not publish, for a terminal; empty if there is none. What is on such a
  /// channel is dropped and counted.
  std::string OnMessage(size_t host, const LinkMessage& message, int64_t wall_us);
  /// Does what is due: requests for what is missing here.
  void OnTime(int64_t wall_us);
  int64_t NextDeadline() const;

  /// Sends batches to this host from now on, or no more.
  void SetConnected(size_t host, bool is_connected) { hosts_[host].is_connected = is_connected; }

  /// How the answers of a host came, over the whole run. An answer is late where the step lasted
  /// longer than it may at the warp of its TICK: tick / warp.
  struct Timing {
    std::vector<int32_t> answer_us = {};  ///< Per step: from its TICK here to the host's answer.
    int64_t num_late = 0;
    int64_t worst_late_us = 0;
  };
  const Timing& timing(size_t host) const { return hosts_[host].timing; }
  /// Returns for how long a host owes the answer of the present step, microseconds, where it has
  /// given that of the step before; else 0: it may have nothing that takes part.
  int64_t WaitedFor(size_t host, int64_t wall_us) const;
  /// True while a TICK waits for messages of the step before it.
  bool awaits_data() const { return pending_.has_value(); }
  int64_t step() const { return step_; }
  int64_t num_refused() const { return bus_.num_refused(); }
  /// Returns how many messages of a host were on channels on which it must not publish.
  int64_t num_dropped(size_t host) const { return hosts_[host].num_dropped; }

 private:
  struct Host {
    RelayedHost relayed;
    bool is_connected = false;
    Timing timing = {};
    int64_t timed_step = -1;
    int64_t num_dropped = 0;
  };

  void OnTick(std::span<const uint8_t> datagram, int64_t wall_us);
  bool IsPlayed(std::string_view publisher) const;
  bool MayPublish(const Host& host, const LinkPart& part) const;
  std::string PublisherOfAnswer(const Host& host, const LinkPart& part);
  /// Calls `use(total)` for each total of the pending tick of which messages are missing.
  template <class Use>
  void ForEachMissing(Use use) const;
  void TrySend();
  LinkMessage BatchFor(size_t number) const;

  RelayBus bus_;
  SendToHost send_;
  std::vector<Host> hosts_;
  OutsideQueue outside_;
  int64_t step_ = -1;    ///< Of the newest TICK ...
  bool is_end_ = false;  ///< ... which is END, and no step.
  int64_t tick_at_us_ = 0;
  int64_t due_us_ = 0;             ///< When the present step's answers are due; with warp 0 never.
  std::optional<tick_t> pending_;  ///< The tick that has not gone to the hosts yet.
  LinkPart tick_part_;
  int64_t num_awaited_ = 0;
  int64_t next_request_us_ = 0;
  std::map<std::string, LinkPart> answers_;  ///< Of hosts, of the present step, by publisher.
};

/// Returns on which channels a host may publish that runs the apps of `vehicles` and `programs`,
/// participants of the mission's own, by the table of lib/bus/bus/channels.h: those of its
/// vehicles, and those of the shore that vehicles' apps publish. Its programs may publish on any,
/// and in messages without a seal the host, too, if it has programs.
[[nodiscard]] RelayedHost::MayPublish ChannelsFrom(
    const std::vector<std::string>& all_vehicles, const std::vector<std::string>& vehicles,
    const std::set<std::string, std::less<>>& programs);

/// Returns which channels the participants of some vehicles may subscribe to: those of the shore
/// and of these vehicles, and `others`, such as the NAV of a vehicle that they follow.
[[nodiscard]] std::function<bool(std::string_view channel)> ChannelsOf(
    const std::vector<std::string>& all_vehicles, const std::vector<std::string>& vehicles,
    const std::vector<std::string>& others);

}  // namespace shoal
