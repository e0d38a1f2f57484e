// The hosts of a mission, as `shoal run` sees them: a link to each, and the relay that plays their
// participants on this computer's bus.
//
//   CONNECTING --the link opens--> OFFERED --accepted--> RUNNING --silence, end of the link--> LOST
//       |  10 s                       |  refused                                                |
//       +------- trouble, fatal ------+              CONNECTING again, where on_loss = "restart" +
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "lib/bus/bus/transport.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/run/hosts/curve_link.h"
#include "lib/run/hosts/home_relay.h"
#include "lib/run/hosts/host_offer.h"
#include "lib/run/launch/launch_plan.h"
#include "lib/run/run/launched_apps.h"

namespace shoal {

/// What is wrong with a host.
struct HostTrouble {
  std::string host;
  std::string how;        ///< "host lab2 (tcp://10.0.0.2:7700) was silent for 0.9 s".
  bool is_fatal = false;  ///< It never ran its part; on_loss does not count.
};

/// What links need beside the mission, found before anything is started.
struct HostAccess {
  HostKey key;                                     ///< Of this computer.
  std::map<std::string, std::string> public_keys;  ///< By host.
  std::vector<OfferedFile> files;
  /// Channels that shoal's own apps on hosts subscribe to, by participant.
  std::map<std::string, std::vector<std::string>> subscriptions = {};
};

/// Returns the hosts of the mission that run something.
[[nodiscard]] std::vector<HostOptions> HostsInUse(const Mission& mission);

/// Reads keys and files. The error names what is missing, and the remedy.
[[nodiscard]] Result<HostAccess> PrepareHosts(const Mission& mission, const RunOptions& options,
                                              const LaunchedApps& apps);

class MissionHosts {
 public:
  /// `context` and `transport`, this computer's bus, must outlive this. Begins to connect.
  MissionHosts(const LaunchContext& context, const MissionSecret& secret,
               const std::vector<RosterProcess>& processes, Transport& transport,
               HostAccess access);

  /// Takes a datagram of the bus.
  void OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                  int64_t wall_us) {
    relay_->OnDatagram(port, channel, datagram, wall_us);
  }
  /// True while a message that this computer's bus owes keeps a step from the hosts.
  bool awaits_data() const { return relay_->awaits_data(); }
  /// Takes what has arrived over the links and does what is due.
  void OnTime(int64_t wall_us);
  int64_t NextDeadline() const;
  /// Readable where OnTime has something to take, or a descriptor that was given to WatchToo is.
  int fd() const { return poll_.get(); }
  void WatchToo(int descriptor);

  /// Starts a process again, on its host.
  void Start(const RosterProcess& process);
  void Signal(const RosterProcess& process, int signal);
  /// `name`: of a process.
  bool IsRunning(const std::string& name) const;
  /// Lets all hosts end their processes.
  void End();

  std::vector<HostExit> TakeExits();
  std::vector<HostTrouble> TakeTroubles();
  /// Lines that a user is to see.
  std::vector<std::string> TakeNotes();
  /// A line per host, for the summary; empty without steps.
  std::string Summary() const;

 private:
  enum class State { kConnecting, kOffered, kRunning, kLost };

  struct Host {
    HostOptions options;
    std::vector<std::string> participants = {};
    std::vector<std::string> processes = {};
    std::unique_ptr<HomeLink> link = {};
    LinkIntake intake = {};
    State state = State::kConnecting;
    bool was_running = false;
    uint64_t next_sequence = 0;
    int64_t since_us = 0;  ///< Of the state.
    int64_t heard_us = 0;  ///< When its last message came.
    int64_t sent_us = 0;
    int64_t retry_us = 0;                ///< When to connect again; 0: not planned.
    std::set<std::string> running = {};  ///< Processes that have not ended.
    int64_t num_refused = 0;             ///< Over all links.
    bool has_shown_dropped = false;      ///< That it publishes where it must not.
    int64_t slow_us = 0;                 ///< The longest wait for an answer that has been named.
    bool has_news = true;  ///< The link is to be read: its descriptor shows so, or hides it.
  };

  std::string Describe(const Host& host) const;
  void Connect(Host* host, int64_t wall_us);
  void Send(Host* host, const LinkMessage& message);
  void ReadLink(size_t number, int64_t wall_us);
  void Refuse(Host* host, const std::string& what);
  void OnMessage(size_t number, const LinkMessage& message, int64_t wall_us);
  void Offer(Host* host);
  void CheckTimes(size_t number, int64_t wall_us);
  void CheckAnswer(size_t number, int64_t wall_us);
  void Lose(size_t number, const std::string& how, int64_t wall_us);

  const LaunchContext& context_;
  const HostAccess access_;
  const MissionSecret secret_;
  std::string digest_;
  std::vector<Host> hosts_;
  std::unique_ptr<HomeRelay> relay_;
  FileDescriptor poll_;
  int64_t last_time_us_ = 0;
  bool is_ending_ = false;
  std::vector<HostExit> exits_;
  std::vector<HostTrouble> troubles_;
  std::vector<std::string> notes_;
};

}  // namespace shoal
