// One trial of a campaign: which it is, and what became of it.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/enum_table.h"

namespace shoal {

enum class TrialOutcome {
  kPass,
  kFail,     ///< The mission missed an expectation, or vehicles collided.
  kError,    ///< It did not run to its end: a bad mission file, a crash, a full disk.
  kTimeout,  ///< It did not end within the campaign's timeout_s.
};
inline constexpr EnumTable<TrialOutcome, std::string_view> kTrialOutcomeNames = {
    "pass", "fail", "error", "timeout"};

[[nodiscard]] constexpr std::string_view NameOf(TrialOutcome outcome) {
  return kTrialOutcomeNames[outcome];
}

/// A trial's name: its case and its repetition, never a running number.
struct TrialKey {
  std::string case_id;     ///< Of a sweep point under a policy: 10 hexadecimal digits.
  int64_t repetition = 0;  ///< From 1.

  auto operator<=>(const TrialKey&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

/// Returns "4f2a91c3e0-17".
[[nodiscard]] inline std::string TrialName(const TrialKey& key) {
  return key.case_id + "-" + std::to_string(key.repetition);
}

/// What became of a trial.
struct TrialResult {
  /// The value of a metric that a trial has not: of an error, or an age of reports that never came.
  static constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

  TrialOutcome outcome = TrialOutcome::kError;
  std::string why;              ///< Of all but a pass: what was missed, or what went wrong.
  std::vector<double> metrics;  ///< In the order of the campaign's metric names; empty: none.
};

}  // namespace shoal
