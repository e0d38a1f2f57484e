// The line of progress of a campaign: on a terminal twice a second in place, elsewhere a line every
// half minute.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "lib/tools/metrics/trial.h"

namespace shoal {

/// Returns "1.4 s", "35 s", "12 min" or "3.1 h".
[[nodiscard]] std::string DurationText(double seconds);

class CampaignProgress {
 public:
  explicit CampaignProgress(bool is_quiet);

  /// Counts a trial that has just finished.
  void Count(TrialOutcome outcome) { ++counts_[static_cast<size_t>(outcome)]; }
  /// Shows the line where it is time to, and `note` after it.
  void Show(int64_t num_finished, int64_t num_planned, int64_t wall_us,
            const std::string& note = {});
  /// Ends the line, so that other text can follow.
  void End();

  /// "  412 of 1000 (41 %)  96.2 per s  398 pass  14 fail  0 error  0 timeout  6 s left"
  [[nodiscard]] std::string Line(int64_t num_finished, int64_t num_planned, int64_t wall_us) const;

 private:
  const bool is_quiet_;
  const bool on_terminal_;
  const int64_t begin_us_;
  int64_t next_us_;
  bool is_shown_ = false;
  std::array<int64_t, kNumEnumerators<TrialOutcome>> counts_ = {};
};

}  // namespace shoal
