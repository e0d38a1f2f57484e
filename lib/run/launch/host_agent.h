// `shoal host`: waits for missions of other computers and runs their parts, one at a time.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "lib/run/hosts/curve_link.h"
#include "lib/run/launch/host_session.h"
#include "lib/run/launch/launch_terminal.h"

namespace shoal {

/// What `shoal host` was asked for.
struct HostAgentOptions {
  std::string listen;              ///< "tcp://ADDRESS:PORT"
  std::string key_file;            ///< Empty: HostKeyPath().
  std::vector<std::string> allow;  ///< Public keys, or files with them.
  bool allow_programs = false;     ///< Missions may bring participants with commands of their own.
  bool once = false;               ///< Ends after one mission.
  int port_base = 0;               ///< Of the local ports; 0: the first free block.
};

/// Runs until a signal comes, or one mission has ended. Returns the exit code
/// (lib/base/check/result.h): 3 where it cannot listen, or where the only mission was lost.
int RunHostAgent(const HostAgentOptions& options);

class HostAgent {
 public:
  explicit HostAgent(const HostAgentOptions& options);

  /// Reads the keys and listens. Returns why not, or an empty text.
  std::string Open();
  int Run(int signal_fd);

 private:
  /// A computer that has connected.
  struct Peer {
    std::string key;
    LinkIntake intake;
    uint64_t next_sequence = 0;
    int64_t heard_us = 0;
    int64_t sent_us = 0;
    int64_t num_refused = 0;
    int64_t num_named = 0;  ///< Lines about what it sent wrongly.
    size_t pong_bytes = 0;  ///< That it was sent for its pings.
  };

  void ReadSignals(int signal_fd);
  void ReadDoor(int64_t wall_us);
  void OnMessage(const std::string& peer_id, const LinkMessage& message, int64_t wall_us);
  void OnOffer(const std::string& peer_id, const LinkMessage& message, int64_t wall_us);
  void Send(const std::string& peer_id, const LinkMessage& message);
  void Refuse(const std::string& peer_id, int64_t mission_id, const std::string& why);
  void WarnOf(const std::string& peer_id, const std::string& text);
  void LoseHome(const std::string& how, int64_t wall_us);
  void CheckHome(int64_t wall_us);
  void CheckSession();
  void ForgetPeers(int64_t wall_us);
  void NameUnproved();

  const HostAgentOptions options_;
  HostDoor door_;
  LaunchTerminal terminal_;
  int port_base_ = 0;  ///< Of the block that is claimed for all missions, one after the other.
  std::map<std::string, Peer> peers_;
  std::set<std::string> refused_keys_;  ///< Named already.
  int64_t num_unproved_named_ = 0;      ///< How many connections there were in the last line.
  std::string home_;                    ///< The peer whose mission runs; empty: none.
  std::unique_ptr<HostSession> session_;
  int64_t last_time_us_ = 0;
  bool has_news_ = true;  ///< The door is to be read: its descriptor shows so, or hides it.
  bool is_stopping_ = false;
  bool was_lost_ = false;
  int num_missions_ = 0;
};

}  // namespace shoal
