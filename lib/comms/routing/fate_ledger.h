// Numbers transmissions and counts their fates: of all, and of each contact.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/comms/routing/contact.h"
#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/rules.h"

namespace shoal {

class FateLedger {
 public:
  /// Returns the number of the next transmission of this kind. `source` may be null.
  int64_t TakeNumber(Kind kind, Contact* source);

  /// Counts a fate and appends it; what the rules let pass may be in transit. `source` and
  /// `receiver` may be null.
  void Record(const RoutingRules& rules, const Decision& decision, Contact* source,
              Contact* receiver, std::vector<Decision>* decisions);
  /// Counts a fate at intake. `source` may be null.
  void RecordRefusal(Kind kind, Cause cause, Contact* source);

  /// Gives a transmission that is in transit its fate. `source` or `receiver` is null if that
  /// vehicle was forgotten. @pre a cause other than kInTransit
  void Conclude(Kind kind, Cause cause, Contact* source, Contact* receiver);

  /// All fates so far by cause, those of refused transmissions included.
  const CauseCounts& counts(Kind kind) const { return counts_[static_cast<size_t>(kind)]; }
  /// Transmissions of this kind that came in.
  int64_t num_offered(Kind kind) const { return num_offered_[static_cast<size_t>(kind)]; }
  /// Returns what is in transit, of all kinds.
  int64_t NumInTransit() const;

 private:
  std::array<int64_t, kNumKinds> num_of_unknown_ = {};  ///< Numbers what has no known sender.
  std::array<int64_t, kNumKinds> num_offered_ = {};
  KindCounts counts_ = {};
};

}  // namespace shoal
