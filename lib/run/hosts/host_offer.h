// What home gives a host before the first step: the mission with all its files, and which part of
// it the host runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/mission_secret.h"
#include "lib/mission/model/mission.h"
#include "lib/run/command_line/build_facts.h"
#include "lib/run/hosts/link_message.h"
#include "lib/run/run/grouping.h"
#include "lib/run/run/roster.h"

namespace shoal {

/// A file of a mission.
struct OfferedFile {
  std::string path;  ///< Relative, without "..".
  std::string text;

  bool operator==(const OfferedFile&) const = default;
};

struct HostOffer {
  BuildFacts build = {};                       ///< Of home's shoal.
  std::string host = {};                       ///< The name of the [[host]].
  std::vector<OfferedFile> files = {};         ///< The mission file first.
  std::vector<std::string> overrides = {};     ///< --set
  std::string digest = {};                     ///< MissionDigest of what home has loaded.
  std::vector<std::string> participants = {};  ///< Of the roster, by their names on the bus.
  Grouping grouping = {};                      ///< How participants share processes.
  MissionSecret secret = {};
  Layout layout = Layout::kShared;
  double timeout_s = 0;  ///< Of the link, as the mission's [[host]] has it.
};

/// Limits of timeout_s, those of [[host]] in a mission file.
inline constexpr double kShortestHostTimeout_s = 0.1;
inline constexpr double kLongestHostTimeout_s = 3600;

/// Returns 64 hexadecimal digits: BLAKE2b of the mission with all defaults, and of its files. (Its
/// path does not count, nor which computer runs what.)
[[nodiscard]] std::string MissionDigest(const Mission& mission,
                                        const std::vector<OfferedFile>& files);

/// Reads the files of a mission: its own, and those that loading it reads. The error names a file
/// that cannot travel: an absolute path, which is another file on a host, or all of them too large.
[[nodiscard]] Result<std::vector<OfferedFile>> FilesOfMission(
    const std::string& mission_file, const std::vector<std::string>& overrides);

/// Writes the offered files below `folder`, which exists. Returns the path of the mission file. An
/// error where a path would leave the folder.
[[nodiscard]] Result<std::string> WriteOfferedFiles(const std::vector<OfferedFile>& files,
                                                    const std::string& folder);

/// Writes the offered files below `folder`, which exists and is empty, and loads the mission from
/// there. Nothing outside of the folder is read, so that what was loaded is what the digest covers,
/// and an error quotes no file of this computer's. The error is for home's user.
[[nodiscard]] Result<Mission> LoadOffered(const HostOffer& offer, const std::string& folder);

/// Returns what of the mission the host is to run. It accepts processes of vehicles that the
/// mission places on it and, where `allow_programs`, [[participant]] commands that the mission
/// places there. shore_broker, netsim_manager and the recorder run at home, whatever an offer
/// states.
[[nodiscard]] Result<std::vector<RosterEntry>> OfferedRoster(const HostOffer& offer,
                                                             const Mission& mission,
                                                             bool allow_programs);

[[nodiscard]] LinkMessage ToLinkMessage(const HostOffer& offer, int64_t mission_id);
/// Returns HostOffer::build of an offer of any version; what the offer lacks is empty.
[[nodiscard]] BuildFacts BuildOf(const LinkMessage& offer);
/// Reads what ToLinkMessage returned; an error where a part is missing or wrong.
[[nodiscard]] Result<HostOffer> OfferOf(const LinkMessage& message);

/// Returns the answer to an offer that is not accepted. It has the mission's id, without which home
/// would drop it.
[[nodiscard]] LinkMessage RefusalOf(int64_t mission_id, std::string_view why);

/// How a process on a host ended; what lib/run/launch makes of it is a ChildExit.
struct HostExit {
  std::string name;
  int64_t pid = 0;
  bool clean = false;
  std::string how;
  std::vector<std::string> last_lines;

  bool operator==(const HostExit&) const = default;
};

[[nodiscard]] LinkMessage ToLinkMessage(const HostExit& exit, int64_t mission_id);
/// Texts are made fit for a terminal; of the lines the first few are taken.
[[nodiscard]] HostExit ExitOf(const LinkMessage& message);

}  // namespace shoal
