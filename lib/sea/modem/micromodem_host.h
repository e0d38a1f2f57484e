// The sentences of a Micro-Modem's host, and the answers to them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/codec/nmea_sentence.h"
#include "lib/sea/modem/micromodem_air.h"
#include "lib/sea/modem/micromodem_cycle.h"
#include "lib/sea/modem/micromodem_receiver.h"
#include "lib/sea/modem/micromodem_unit.h"

namespace shoal {

class SentenceReader;

class MicroModemHost {
 public:
  static constexpr size_t kMaxLineBytes = 1024;  ///< CCTXD with 256 bytes takes half of it.

  MicroModemHost(MicroModemUnit& unit, MicroModemAir& air, MicroModemCycle& cycle,
                 MicroModemReceiver& receiver)
      : unit_(unit), air_(air), cycle_(cycle), receiver_(receiver) {}

  /// Takes one line, with or without its line end.
  void TakeLine(std::string_view line);
  /// Takes a piece of a stream; CR or LF ends a line.
  void TakeBytes(std::string_view bytes);
  /// Drops a line that has begun.
  void ForgetLine();

  /// Does what is due.
  void OnTime();
  std::optional<int64_t> NextEvent_us() const;

 private:
  struct SentenceRow {
    std::string_view address;
    void (MicroModemHost::*answer)(const NmeaFields& sentence);
    int since_version = 1;  ///< Of the modem.
  };
  static const std::array<SentenceRow, 13> kSentences;

  void Answer(const NmeaFields& sentence);
  void Refuse(std::string_view reason);
  void RefuseBusy(std::string_view reason);
  bool RefusesWhatIsWrong(const SentenceReader& reader);
  void SetConfiguration(const NmeaFields& sentence);
  void ShowConfiguration(const NmeaFields& sentence);
  void Reboot(const NmeaFields& sentence);
  void SetCalendarClock(const NmeaFields& sentence);
  void SetIsoClock(const NmeaFields& sentence);
  void ShowClock(const NmeaFields& sentence);
  void BeginCycle(const NmeaFields& sentence);
  void TakeData(const NmeaFields& sentence);
  void Ping(const NmeaFields& sentence);
  void SendMini(const NmeaFields& sentence);
  void SendFlexible(const NmeaFields& sentence);
  void RangeRemus(const NmeaFields& sentence);
  void RangeNarrowband(const NmeaFields& sentence);
  void RangeTransponders(const NmeaFields& sentence, size_t timeout_field);
  void WriteTransponderTimes();

  MicroModemUnit& unit_;
  MicroModemAir& air_;
  MicroModemCycle& cycle_;
  MicroModemReceiver& receiver_;
  bool is_refused_ = false;  ///< The sentence that is being answered.
  std::string line_;         ///< From TakeBytes, not ended yet.
  bool is_skipping_line_ = false;
  std::optional<int64_t> boot_us_;          ///< When the modem is up again.
  std::optional<int64_t> transponders_us_;  ///< When LBL times are due.
  double transponder_timeout_s_ = 0;
};

}  // namespace shoal
