// What the log of a mission will be, before it is run: how large, compressed or not, and what is
// strange about it. For `shoal check`, and for what writes logs.
//
//   const LogPlan plan = PlanLog(mission, {}, "runs/mine");
//   for (const std::string& warning : plan.warnings) Warn(warning);
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/bus/record/channel_choice.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// `shoal run --record` compresses a log that is expected to be larger. Below, it is as quickly
/// written and read as it is, and every LCM program reads it.
inline constexpr double kPlainLog_bytes = 200e6;

/// Returns how large the log will be, within a factor of two: what shoal's own participants publish
/// where every report reaches those that are in range at the start. Messages of your own programs
/// are not known, nor acoustic packets other than those of swarms.
[[nodiscard]] double EstimateLog_bytes(const Mission& mission, const ChannelChoice& choice = {});

/// Returns the share of a log that is left of it when it is compressed.
inline constexpr double kCompressedShare = 0.15;

/// Returns "597 MB".
[[nodiscard]] std::string BytesText(double bytes);

struct LogPlan {
  double bytes = 0;       ///< Of the log, not compressed.
  double file_bytes = 0;  ///< Of the file.
  bool is_compressed = false;
  /// One line for each problem: the disk may not hold the log, or a name or pattern matches no
  /// channel of the mission.
  std::vector<std::string> warnings = {};
};

/// `path`: of the log (compressed where it ends in ".zst"), or the folder of a recording, in which
/// `compress` decides; absent: the size. What does not exist yet counts as its nearest folder.
[[nodiscard]] LogPlan PlanLog(const Mission& mission, const ChannelChoice& choice,
                              const std::string& path, std::optional<bool> compress = std::nullopt);

}  // namespace shoal
