// Which trials are still to be run, and in which order: the first repetition of every case, then
// the second, and so on, so that what is there at any time is of use.
//
// With a stop rule a case goes on from one look to the next once all its trials up to the look are
// finished. A shard that lacks trials of other shards goes on without waiting for them: what is
// beyond the stop is not counted later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "lib/tools/trials/campaign_folder.h"
#include "lib/tools/trials/stop_values.h"
#include "lib/tools/trials/worker_pool.h"

namespace shoal {

/// One of `count` parts of a campaign.
struct Shard {
  int64_t number = 1;  ///< 1 to count.
  int64_t count = 1;

  bool Has(size_t case_number, int64_t repetition) const {
    return (static_cast<int64_t>(case_number) + repetition - 1) % count == number - 1;
  }
};

class TrialQueue {
 public:
  /// `folder` must outlive this. @pre 1 <= shard.number <= shard.count
  TrialQueue(const CampaignFolder& folder, const Shard& shard, const StoredTrials& stored);

  /// Returns the next trial, or nothing: none is left, or more depends on those under way.
  std::optional<TrialJob> Next();
  void Finish(const TrialJob& job, const TrialResult& result);

  /// Trials of this shard, should no case stop before its last repetition.
  int64_t num_planned() const { return num_planned_; }
  /// Of these, those that are finished.
  int64_t num_finished() const { return num_finished_; }
  /// Of these, those that need not be run: their case has stopped.
  int64_t num_spared() const { return num_spared_; }

 private:
  struct CaseState {
    int64_t next = 1;   ///< The next repetition to look at.
    int64_t limit = 0;  ///< The last one that may be run now.
    bool is_stopped = false;
    std::map<int64_t, double> values;  ///< Of the stop rule, by repetition.
    std::set<int64_t> finished;
    std::set<int64_t> under_way;
  };

  void Advance(size_t number);
  void Look(size_t number);

  const CampaignFolder& folder_;
  const Shard shard_;
  const std::optional<StopValues> stop_;
  std::vector<CaseState> cases_;
  std::set<std::pair<int64_t, size_t>> ready_;  ///< Next repetition and case.
  int64_t num_planned_ = 0;
  int64_t num_finished_ = 0;
  int64_t num_spared_ = 0;
};

}  // namespace shoal
