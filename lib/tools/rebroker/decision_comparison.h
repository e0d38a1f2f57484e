// Whether a broker decided as the recorded one did.
//
//   DecisionComparison comparison(SameDecision::kWhole);
//   comparison.Compare(utime, recorded_fates, fates_now);      // once per step
//   comparison.num_reproduced(); comparison.first_difference();
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "shoal/fate_t.hpp"

namespace shoal {

/// When two decisions are the same.
enum class SameDecision {
  kWhole,           ///< Every member is equal, and their places in the step are.
  kWithoutNumbers,  ///< The same, but for `number`: reports that were lost are not counted.
  /// The transmission and its fate are equal; the numbers that decided need not be, since times are
  /// not exact. Nor is the order.
  kFateOnly,
};

class DecisionComparison {
 public:
  explicit DecisionComparison(SameDecision same) : same_(same) {}

  /// Compares the decisions of one step.
  void Compare(int64_t utime, std::span<const fate_t> recorded, std::span<const fate_t> now);

  int64_t num_recorded() const { return num_recorded_; }
  int64_t num_now() const { return num_now_; }
  int64_t num_reproduced() const { return num_reproduced_; }
  bool IsEqual() const { return num_reproduced_ == num_recorded_ && num_now_ == num_recorded_; }

  /// Returns what was decided and what is decided instead, two lines; empty: there is no
  /// difference.
  const std::string& first_difference() const { return first_difference_; }

 private:
  std::string KeyOf(const fate_t& fate) const;

  SameDecision same_;
  int64_t num_recorded_ = 0;
  int64_t num_now_ = 0;
  int64_t num_reproduced_ = 0;
  std::string first_difference_;
};

/// Returns "report 12 alpha -> bravo: out_of_range range_m=120 limit_m=100".
[[nodiscard]] std::string FateLine(const fate_t& fate);

}  // namespace shoal
