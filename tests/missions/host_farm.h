// Hosts for a test: agents with keys and ports of their own, and missions placed on them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/missions/shoal_process.h"

namespace shoal {

/// A computer of a test: `shoal host` with a key of its own.
struct TestHost {
  std::string name;
  std::string address;
  std::string public_key_file;
  std::unique_ptr<RunningProcess> process;
};

class HostFarm {
 public:
  /// Makes home's key, and starts `count` agents on loopback with `options`.
  explicit HostFarm(size_t count, std::vector<std::string> options = {});

  /// Starts an agent (again) and awaits that it listens.
  void Start(size_t host, const std::vector<std::string>& options = {});

  /// Returns a copy of a mission with a [[host]] for each of `vehicles`; `more` stands in each.
  /// `addresses` replace those of the agents where they are not empty.
  std::string Placed(const std::string& mission, const std::vector<std::string>& vehicles,
                     const std::string& more = "", std::vector<std::string> addresses = {});

  /// Returns the command line of `shoal run` at full speed.
  std::vector<std::string> RunCommand(const std::string& mission_file,
                                      const std::vector<std::string>& more = {}) const;

  TestFolder folder;
  std::vector<TestHost> hosts;
  std::string home_key;  ///< The prefix of home's key files.
};

/// Carries TCP connections from a port of its own to another, each byte after a delay.
class DelayingProxy {
 public:
  DelayingProxy(int target_port, double delay_s);
  ~DelayingProxy();
  DelayingProxy(const DelayingProxy&) = delete;
  DelayingProxy& operator=(const DelayingProxy&) = delete;
  int port() const { return port_; }

 private:
  struct State;
  std::unique_ptr<State> state_;
  int port_ = 0;
};

}  // namespace shoal
