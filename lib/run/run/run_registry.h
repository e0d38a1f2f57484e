// Where running missions are found: one small file per mission, so that `shoal send`, `shoal
// status`, scripts/spy and apps that users start need no port numbers.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/mission_secret.h"
#include "lib/mission/model/mission.h"

namespace shoal {

struct RunningMission {
  std::string name;
  std::string file;    ///< Absolute path of the mission file.
  std::string folder;  ///< The working folder in which it was started.
  int64_t mission_id = 0;
  int port_base = 0;
  Layout layout = Layout::kShared;
  std::string grouping = "app";  ///< Which participants share a process: lib/run/run/grouping.h.
  int pid = 0;                   ///< Of the launcher.
  std::vector<std::string> vehicles;
  std::string playback_of = {};  ///< A log that `shoal play` plays; empty: a mission runs.
  std::vector<std::string> without_helm = {};  ///< Those of them that have helm = "none".
  std::vector<std::string> overrides = {};     ///< `--set` of the run.
  std::map<std::string, std::vector<std::string>> groups = {};  ///< Members by group.
  std::vector<OrderWords> orders = {};                          ///< Those of the mission.

  PortPlan Ports() const { return PortPlan(port_base, layout, vehicles); }
};

/// Returns the path of the entry of the mission at `port_base`; it is there while the mission runs,
/// and stays when its launcher dies, until the missions are listed.
std::string EntryPath(int port_base);

/// The variables that lead a participant to its mission's secret: an open file, or a file's path.
inline constexpr char kSecretFdVariable[] = "SHOAL_SECRET_FD";
inline constexpr char kSecretFileVariable[] = "SHOAL_SECRET_FILE";

/// Returns the path of the secret of the mission at `port_base`, a file of mode 0600.
std::string SecretPath(int port_base);
/// Writes the secret to that file, for the participants that a user starts; Unregister removes it.
[[nodiscard]] Result<bool> KeepSecret(int port_base, const MissionSecret& secret);
/// Returns a file in memory that holds the secret, for those that the launcher starts; the caller
/// closes it.
[[nodiscard]] Result<int> SecretInMemory(const MissionSecret& secret);
/// Returns the secret of the mission at `port_base`, as this process can know it: by its variables,
/// or from SecretPath. The error states where it was looked for.
[[nodiscard]] Result<MissionSecret> FindSecret(int port_base);

/// Claims a free block of ports for as long as this process lives. `wanted_base` 0: the first
/// free one from PortPlan::kDefaultBase on. The error names the mission that has the ports where
/// that is known.
[[nodiscard]] Result<int> ClaimPorts(int wanted_base, int num_ports);

/// Writes or removes this process's entry in the run folder (lib/run/run/run_folder.h). A failure
/// to write is an error with the path.
[[nodiscard]] Result<bool> Register(const RunningMission& mission);
void Unregister(int port_base);

/// What a mission leaves for those that watched it, at its port, until the next one there.
struct EndedMission {
  int64_t mission_id = 0;
  std::string log = {};      ///< Of the recorder, an absolute path; empty: not recorded.
  std::string verdict = {};  ///< Director::VerdictText.
};
/// Writes it; to be called before Unregister.
[[nodiscard]] Result<bool> KeepEnded(int port_base, const EndedMission& ended);
/// Returns what the mission of this number left; nothing where it left nothing.
[[nodiscard]] std::optional<EndedMission> FindEnded(int port_base, int64_t mission_id);

/// Returns the missions of this user whose launchers are alive, in order of port; removes the
/// entries of the others. An error where the run folder is not to be trusted.
[[nodiscard]] Result<std::vector<RunningMission>> RunningMissions();

/// What a mission is looked for.
enum class Purpose { kLook, kCommand };

/// Chooses among missions: the one at `port_base`; with 0 the one that was started in `folder`, or,
/// to look at, the only one. The error lists them and states what chooses one. A command goes to no
/// mission that another folder has started unless its port is named: it may be another's.
[[nodiscard]] Result<RunningMission> ChooseMission(const std::vector<RunningMission>& missions,
                                                   int port_base, const std::string& folder,
                                                   Purpose purpose);

/// ChooseMission among those that run, for the working folder of this process.
[[nodiscard]] Result<RunningMission> FindRunningMission(int port_base,
                                                        Purpose purpose = Purpose::kLook);

/// Returns "berta (/home/ada/berta.toml), ports from 7665".
std::string Describe(const RunningMission& mission);

/// Returns the working folder of this process as RunningMission::folder has it; empty where it has
/// been removed.
std::string WorkingFolder();

}  // namespace shoal
