// Hosts for a test: agents with keys and ports of their own, and missions placed on them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/missions/shoal_process.h"

namespace shoal {

/// No machine is so busy that a host is silent for so long.
inline constexpr char kPatient[] = "timeout_s = 60\n";
/// For tests in which silence is to be noticed; the default is below a second.
inline constexpr char kAttentive[] = "timeout_s = 3\n";
inline constexpr double kAttentive_s = 3;

/// Runs a mission by `shoal sim` and returns its log.
std::string LogOfSim(const TestFolder& folder, const std::string& mission);

/// Takes events and expectations out of a mission's file, so that it may be cut short.
void TakeOutWhatComesLater(const std::string& mission);

/// The same, and sets how long the mission is.
void Shorten(const std::string& mission, int duration_s);

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

  /// Runs that command to its end.
  Finished Run(const std::string& mission_file, const std::vector<std::string>& more = {}) const;

  /// The TCP port of an agent.
  int PortOf(size_t host) const;

  TestFolder folder;
  std::vector<TestHost> hosts;
  std::string home_key;  ///< The prefix of home's key files.
};

/// Berta with bravo on a host, well under way, with a recording.
struct MissionUnderWay {
  /// `more` is in the [[host]]. `way`: returns the address at which home reaches the host,
  /// instead of the agent's own. `options`: of `shoal run`.
  explicit MissionUnderWay(const std::string& more,
                           const std::function<std::string(const HostFarm&)>& way = {},
                           const std::vector<std::string>& options = {});

  /// Returns how many events the recording has; -1: it is not whole.
  int64_t NumEvents() const;

  HostFarm farm;
  std::string mission;
  std::string dir = (farm.folder / "rec").string();
  std::unique_ptr<RunningProcess> process;
};

}  // namespace shoal
