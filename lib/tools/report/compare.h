// Two selections of a campaign's cases, compared pair by pair: the same repetition, thus the same
// sea and the same losses, with one thing changed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/statistics/pairs.h"
#include "lib/tools/campaign/case_labels.h"
#include "lib/tools/campaign/results.h"

namespace shoal {

/// A pair in which a trial is an error or a timeout.
struct BrokenPair {
  std::string a;  ///< Names of the trials: "<case id>-<repetition>".
  std::string b;
  TrialOutcome outcome_a = TrialOutcome::kPass;
  TrialOutcome outcome_b = TrialOutcome::kPass;
};

/// A metric in the pairs of a point.
struct MetricComparison {
  int64_t num_without = 0;  ///< Pairs of which one trial or both have no value: in no other number.
  PairedMeans means;
};

/// What is compared where all other keys are equal.
struct ComparedPoint {
  CaseKeys rest;  ///< The keys that neither selection names.
  size_t case_a = 0;
  size_t case_b = 0;
  int64_t num_pairs = 0;
  int64_t both_pass = 0;  ///< Only a pass is one: error and timeout are not.
  int64_t only_a = 0;
  int64_t only_b = 0;
  int64_t neither = 0;
  double p = 1;           ///< Of the exact McNemar test.
  int64_t num_alone = 0;  ///< Trials without a partner: the other is missing or was not needed.
  int64_t num_other_seed = 0;             ///< Pairs whose seeds differ: no pairs in truth.
  std::vector<BrokenPair> broken;         ///< Each of them is in the counts above.
  std::vector<MetricComparison> metrics;  ///< In the order of CampaignResults::metrics.
};

struct CampaignComparison {
  std::string a;  ///< As the user wrote them.
  std::string b;
  double confidence = 0.95;
  std::vector<ComparedPoint> points;
  std::vector<size_t> without_partner;  ///< Cases of one selection that the other has not.
};

/// Compares the cases that `a` and `b` select: KEY=VALUE, several with commas between, where KEY is
/// a key of the sweep or "policy". Cases pair where all keys that neither names are equal. The
/// error is of a selection that is not KEY=VALUE, matches nothing, leaves several cases to a point,
/// or is the other's.
[[nodiscard]] Result<CampaignComparison> CompareCases(const CampaignResults& results,
                                                      std::string_view a, std::string_view b);

}  // namespace shoal
