// Short campaigns for tests, and what they left.
#pragma once

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/missions/shoal_process.h"

namespace shoal {

/// A campaign of `repetitions` of berta at two ranges, with a sampled start: 2 * repetitions trials
/// of some 20 ms.
inline std::string BertaCampaign(int repetitions, const std::string& more = "") {
  return "[campaign]\nmission = \"" + MissionFile("berta.toml") +
         "\"\nrepetitions = " + std::to_string(repetitions) +
         "\n[sweep]\n\"comms.comms_range\" = [100, 250]\n"
         "[sample]\n\"vehicle.alpha.start.x_m\" = {uniform = [140, 160]}\n" +
         more;
}

inline Finished RunCampaignTo(const TestFolder& folder, const std::string& file,
                              const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments = {
      "campaign", "run", (folder / file).string(), "--out", (folder / out).string(), "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return RunShoal(folder, arguments);
}

/// Returns the whole lines of all shards of a folder.
inline std::vector<std::string> StoredLines(const std::filesystem::path& out) {
  std::vector<std::string> lines;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(out / "shards", error)) {
    const std::string text = ReadFile(entry.path());
    for (size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
      lines.push_back(text.substr(at, end - at));
    }
  }
  return lines;
}

}  // namespace shoal
