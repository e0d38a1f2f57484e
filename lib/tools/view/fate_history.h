// The last fates, each with a number of its own.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/view/fate_facts.h"
#include "lib/tools/view/view_source.h"

namespace shoal {

/// A fate as it is kept, with its names.
struct KeptFate {
  int64_t id = 0;  ///< Counts all fates from 1.
  FateFacts facts;
  std::string source;
  std::string destination;
  std::vector<std::string> colliders;
  std::string medium;

  FateView view() const;
};

class FateHistory {
 public:
  static constexpr size_t kMaxFates = 20'000;
  static constexpr int kMaxAnswer = 500;      ///< Of Find.
  static constexpr size_t kMaxColliders = 4;  ///< Names that are kept of each.

  /// `first_id`: of the first fate that will be added.
  /// @pre first_id >= 1, max_fates >= 1
  explicit FateHistory(int64_t first_id = 1, size_t max_fates = kMaxFates)
      : max_fates_(max_fates), next_id_(first_id) {}

  void Add(const FateView& fate);
  /// Adds to the fate of `medium.facts` what COMMS_MEDIA has of it. Those of one step come behind
  /// its fates and in their order; where the fate is not kept, nothing happens.
  void AddMedium(const FateView& medium);
  /// Counts these as seen: of fates before the first that will be added.
  void MarkSeen(const std::vector<bool>& kinds, const std::vector<bool>& causes) {
    kinds_seen_ = kinds;
    causes_seen_ = causes;
  }

  /// Returns the fates that match, the newest first. With `after` >= 0 the oldest `limit` of
  /// those behind it are taken, so that a client that asks again and again misses none; else the
  /// newest.
  /// Pointers are valid until the next Add.
  std::vector<const KeptFate*> Find(const FateQuery& query) const;
  /// Returns the last `limit` of one link, the newest first; names without regard to case.
  std::vector<const KeptFate*> OfLink(std::string_view from, std::string_view to,
                                      size_t limit) const;

  /// What was ever added.
  const std::vector<bool>& kinds_seen() const { return kinds_seen_; }    ///< By kind.
  const std::vector<bool>& causes_seen() const { return causes_seen_; }  ///< By cause.
  /// Fates from id 1 on that are no longer kept.
  int64_t num_forgotten() const;
  size_t size() const { return fates_.size(); }

 private:
  const KeptFate& FromNewest(size_t i) const;
  KeptFate& ById(int64_t id);

  size_t max_fates_;
  int64_t next_id_;
  std::vector<KeptFate> fates_;  ///< A ring; the oldest at next_.
  size_t next_ = 0;
  int64_t next_medium_id_ = 0;  ///< Fates before this have what COMMS_MEDIA has of them.
  std::vector<bool> kinds_seen_ = std::vector<bool>(kNumKinds);
  std::vector<bool> causes_seen_ = std::vector<bool>(kNumCauses);
};

}  // namespace shoal
