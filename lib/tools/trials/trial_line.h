// One finished trial as one line of JSON: what shards hold.
//
//   {"case":"4f2a91c3e0","repetition":17,"outcome":"pass","why":"","metrics":{"expect_1":7.3},
//    "wall_s":0.021,"arithmetic":"0123456789abcdef"}
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/metrics/metric.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

struct FinishedTrial {
  TrialKey key;
  TrialResult result;
  double wall_s = 0;            ///< For estimates alone: no result depends on it.
  int64_t attempt = 0;          ///< 1, 2, ...: it was asked for again; the highest counts.
  std::string arithmetic = {};  ///< ArithmeticId() of what ran it; empty in folders of 0.2.
};

inline constexpr size_t kLongestTrialLine_bytes = size_t{64} * 1024;

/// Returns the line without its line feed. Texts are cut so that it is never too long.
[[nodiscard]] std::string TrialLine(const FinishedTrial& trial,
                                    const std::vector<MetricName>& metrics);

/// Returns the trial, or nothing where the line is none: torn, foreign, or of other metrics.
[[nodiscard]] std::optional<FinishedTrial> ParseTrialLine(std::string_view line,
                                                          const std::vector<MetricName>& metrics);

}  // namespace shoal
