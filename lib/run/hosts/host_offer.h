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
#include "lib/run/hosts/link_message.h"
#include "lib/run/run/grouping.h"

namespace shoal {

/// A file of a mission.
struct OfferedFile {
  std::string path;  ///< Relative, without "..".
  std::string text;

  bool operator==(const OfferedFile&) const = default;
};

struct HostOffer {
  std::string build = {};                      ///< BuildId() of home's shoal.
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

/// Returns 64 hexadecimal digits: BLAKE2b of the mission with all defaults, and of its files. (Its
/// path does not count, nor which computer runs what.)
[[nodiscard]] std::string MissionDigest(const Mission& mission,
                                        const std::vector<OfferedFile>& files);

/// Reads the files of a mission: its own, and those that loading it reads. The error names a file
/// that cannot travel: an absolute path, or all of them too large.
[[nodiscard]] Result<std::vector<OfferedFile>> FilesOfMission(
    const std::string& mission_file, const std::vector<std::string>& overrides);

/// Writes the offered files below `folder`, which exists. Returns the path of the mission file. An
/// error where a path would leave the folder.
[[nodiscard]] Result<std::string> WriteOfferedFiles(const std::vector<OfferedFile>& files,
                                                    const std::string& folder);

[[nodiscard]] LinkMessage ToLinkMessage(const HostOffer& offer, int64_t mission_id);
/// Reads what ToLinkMessage returned; an error where a part is missing or wrong.
[[nodiscard]] Result<HostOffer> OfferOf(const LinkMessage& message);

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
[[nodiscard]] HostExit ExitOf(const LinkMessage& message);

}  // namespace shoal
