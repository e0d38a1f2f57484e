// What the parts of a simulated Micro-Modem share: settings, clock, counts, and what goes out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/sea/modem/micromodem_cst.h"
#include "lib/sea/modem/micromodem_settings.h"

namespace shoal {

struct MicroModemOptions {
  int address = 0;             ///< 0 to 127. A host sets it with CCCFG,SRC.
  int64_t utc_at_zero_us = 0;  ///< UTC at time 0; a host sets the clock with CCCLK or CCTMS.
  /// 2: a Micro-Modem 2, with its firmware's number, CCTDP and CACST of version 6.
  int version = 1;
  size_t more_bytes = 0;  ///< That the network puts on the air with each packet: a checksum.
  /// One-way travel times to LBL transponders A to D; absent: not there.
  std::array<std::optional<double>, 4> transponder_travel_s = {};
};

/// A packet to transmit in this step.
struct MicroModemSent {
  std::vector<uint8_t> bytes;
  int bps = 0;         ///< The rate at which it is sent.
  int64_t air_us = 0;  ///< The modem sends nothing else for so long.
};

struct MicroModemOutput {
  std::string to_host;  ///< Sentences, each with its checksum, CR and LF.
  std::vector<MicroModemSent> to_water;
};

/// A packet that has arrived, as a whole, whatever its bytes became.
struct MicroModemArrival {
  std::span<const uint8_t> bytes = {};
  int64_t start_us = 0;   ///< When the first byte arrived.
  int64_t travel_us = 0;  ///< How long it was under way.
  std::optional<double> snr_db = {};
};

struct MicroModemCounts {
  // From the host. Lines taken = answered + refused + dropped.
  int64_t sentences_answered = 0;
  int64_t sentences_refused = 0;  ///< With CAERR.
  int64_t lines_dropped = 0;      ///< Too long, no sentence, or its checksum is wrong.
  // From the network. Arrivals = understood + foreign + damaged_headers + own + overheard +
  // no_cycle.
  int64_t understood = 0;
  int64_t foreign = 0;
  int64_t damaged_headers = 0;
  int64_t own = 0;             ///< From another modem that has this one's address.
  int64_t overheard = 0;       ///< Addressed to other modems.
  int64_t no_cycle = 0;        ///< Data at rate 0 without its cycle packet.
  int64_t damaged_frames = 0;  ///< In packets whose header was understood.
  // To the network.
  int64_t sent = 0;
  int64_t answers_dropped = 0;  ///< Not sent, since too many answers waited.

  bool operator==(const MicroModemCounts&) const = default;
};

/// The codes of CAERR.
enum class MicroModemError : int { kUnknown = 1, kBadField, kBusy, kNoData, kAbandoned };

struct MicroModemUnit {
  /// @pre options.address is 0 to kMaxMicroModemAddress, options.version is 1 or 2
  explicit MicroModemUnit(const MicroModemOptions& options);

  int address() const { return settings.src; }
  void SetClock(int64_t utc_us, int64_t time_us);
  int64_t Utc_us(int64_t time_us) const { return clock_offset_us + time_us; }
  int64_t Utc_us() const { return Utc_us(now_us); }

  /// Writes a sentence to the host; `body` is without $ and checksum.
  void Write(std::string_view body);
  void WriteError(std::string_view module, MicroModemError code, std::string_view reason);
  void WriteRevision();
  void WriteStatistics(const ReceptionStatistics& statistics);

  MicroModemOptions options;
  MicroModemSettings settings;
  MicroModemCounts counts;
  MicroModemOutput output;
  int64_t now_us = 0;
  int64_t clock_offset_us = 0;  ///< The modem's UTC less now_us.
};

}  // namespace shoal
