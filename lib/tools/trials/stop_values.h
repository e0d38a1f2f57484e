// What a campaign's stop rule looks at, as the queue and the reducer need it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "lib/tools/campaign/stopping.h"
#include "lib/tools/trials/campaign_folder.h"

namespace shoal {

class StopValues {
 public:
  StopValues(const StopRule& rule, int64_t repetitions, size_t metric)
      : stopping_(rule, repetitions), metric_(metric) {}

  [[nodiscard]] double Of(const TrialResult& result) const {
    return StopValueOf(stopping_.rule(), metric_, result);
  }

  /// Returns after which repetition a case stops, by its values up to `last`, each by its
  /// repetition; what follows a gap is not looked at.
  [[nodiscard]] std::optional<int64_t> StopsAfter(const std::map<int64_t, double>& values,
                                                  int64_t last) const;

 private:
  Stopping stopping_;
  size_t metric_;
};

/// Returns nothing where the campaign has no stop rule.
[[nodiscard]] std::optional<StopValues> StopValuesOf(const CampaignFolder& folder);

}  // namespace shoal
