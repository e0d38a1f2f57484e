// CACST, what a modem reports of one reception: 29 fields. Those of a Micro-Modem 2, version 6,
// stand behind the version's number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace shoal {

enum class CstMode : int { kGood = 0, kBadCrc = 1, kTimeout = 2 };
enum class CstPacketType : int { kFsk = 1, kFskMini = 2, kPsk = 3, kFlexible = 5 };

struct ReceptionStatistics {
  CstMode mode = CstMode::kGood;
  int64_t arrived_utc_us = 0;  ///< The first byte, by the modem's clock.
  int rate = 0;
  int source = 0;
  int destination = 0;
  CstPacketType type = CstPacketType::kFskMini;
  int num_frames = 0;
  int num_bad_frames = 0;
  /// Where the acoustic model knows it: SNR in and out, and for PSK the equalizer's error, the
  /// same with the other sign, within -15 to 0 dB.
  std::optional<double> snr_db = {};
};

/// Returns the sentence's body. Gains, levels, carrier and bandwidth are those of a typical
/// reception, always the same: nothing here simulates them. Clock mode is 1, not synchronous: the
/// time of arrival is no travel time.
/// `modem_version`: 1 or 2, which of the Micro-Modems writes it.
[[nodiscard]] std::string CstText(const ReceptionStatistics& statistics, int modem_version = 1);

}  // namespace shoal
