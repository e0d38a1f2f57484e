// What COMMS_FATES amounts to over a mission, for its verdict. Where several parts of a mission
// decide about reports, each counts its own decisions, and one adds the others' counts at the end.
//
//   FateTally tally({"alpha", "bravo"});
//   tally.Take(message.fates);
//   tally.AppendTo(&bytes);                      // in one part
//   if (!of_all.Add(bytes)) return Fail();       // in another, of the same mission
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/comms/routing/kind.h"
#include "lib/run/verdict/acoustic_tally.h"
#include "lib/run/verdict/fate_counts.h"
#include "shoal/fate_t.hpp"

namespace shoal {

class FateTally {
 public:
  explicit FateTally(const std::vector<std::string>& vehicles)
      : fates_(kNumKinds, FateCounts(vehicles)) {}

  void Take(std::span<const fate_t> fates);

  FateCounts& fates(Kind kind) { return fates_[static_cast<size_t>(kind)]; }
  const FateCounts& fates(Kind kind) const { return fates_[static_cast<size_t>(kind)]; }
  AcousticTally& acoustic() { return acoustic_; }
  const AcousticTally& acoustic() const { return acoustic_; }

  /// Appends all counts.
  void AppendTo(std::vector<uint8_t>* bytes) const;
  /// Adds what another tally of the same vehicles has appended. Returns false where it is damaged;
  /// the counts are of no use then.
  [[nodiscard]] bool Add(std::span<const uint8_t> bytes);

 private:
  std::vector<FateCounts> fates_;  ///< By kind.
  AcousticTally acoustic_;
};

}  // namespace shoal
