// What an acoustic network has done so far, in numbers.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "lib/sea/acoustics/reception.h"

namespace shoal {

/// A reception is one packet at one receiver. num_offered = sum of num_fates + num_in_transit, at
/// every moment.
struct AcousticStatistics {
  int64_t num_transmissions = 0;
  int64_t num_offered = 0;  ///< Receptions.
  std::array<int64_t, kNumAcousticFates> num_fates = {};
  int64_t num_in_transit = 0;
  int64_t num_collided = 0;      ///< Receptions that others overlapped, whatever came of it.
  int64_t num_bits_flipped = 0;  ///< By bit errors.
  int64_t num_bit_errors = 0;    ///< Receptions with bits flipped.
  int64_t num_rejected = 0;      ///< Handed over, and refused by the receiver.

  int64_t NumOf(AcousticFate fate) const { return num_fates[static_cast<size_t>(fate)]; }
  /// Receptions handed over to their receivers, damaged ones and rejected ones included.
  int64_t NumHandedOver() const;

  bool operator==(const AcousticStatistics&) const = default;
};

/// Returns the numbers as a page of text, a line each, with shares of what was offered to
/// listening receivers.
[[nodiscard]] std::string StatisticsText(const AcousticStatistics& statistics);

}  // namespace shoal
