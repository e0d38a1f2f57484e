// A simulated WHOI Micro-Modem: sentences of its host on one side, packets through the water on the
// other. docs/micromodem.md lists the sentences.
//
//   MicroModem modem({.address = 1});
//   Pass(modem.Advance(now_us));                             // at least in every step
//   Pass(modem.Take("$CCMPC,1,2*5D\r\n", now_us));           // what the host has said
//   Pass(modem.Hear({.bytes = payload, .start_us = ..., .travel_us = ...}, now_us));
//
//   void Pass(const MicroModemOutput& output) {
//     Write(output.to_host);
//     for (const MicroModemSent& sent : output.to_water) Transmit(sent.bytes);
//   }
//
// Time is what the caller says, in microseconds, and never goes back. There is at most one packet
// on the air; more wait for their turn.
//
// A data cycle, after CCCYC:
//
//                    rate 0: cycle packet        0.1 s
//         CCCYC --> kAnnouncing ------------> kPausing --+
//           |                                            |
//           |  rates 1 to 5                              v      all frames, an empty frame,
//           +-----------------------------------> kAsking -----------------------------> kSending
//                                                  |  ^  |      or DTO with a frame       |
//                                             CADRQ|  |  |                           CATXF|
//                                                  v  |  | DTO without a frame,           v
//                                                 CCTXD  | another CCCYC, CCMSC         (none)
//                                                        +--> CAERR, (none)
//
// Another CCCYC is refused outside of kAsking. CCMSC ends a cycle in any state.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/codec/nmea_sentence.h"
#include "lib/modem/micromodem_cst.h"
#include "lib/modem/micromodem_packet.h"
#include "lib/modem/micromodem_settings.h"

namespace shoal {

class SentenceReader;

struct MicroModemOptions {
  int address = 0;             ///< 0 to 127. A host sets it with CCCFG,SRC.
  int64_t utc_at_zero_us = 0;  ///< UTC at time 0; a host sets the clock with CCCLK or CCTMS.
  /// The acoustic network's data rate; 0: not known. A packet of a slower rate is filled up with
  /// zeros, so that the network takes as long for it as that rate does; where the network is the
  /// slower one, the modem counts with the network.
  double water_bps = 0;
  size_t max_packet_bytes = 65'535;  ///< Packets are not filled up beyond; what the network takes.
  /// One-way travel times to LBL transponders A to D; absent: not there.
  std::array<std::optional<double>, 4> transponder_travel_s = {};
};

/// A packet to send through the water, now.
struct MicroModemSent {
  std::vector<uint8_t> bytes;
  int64_t air_us = 0;  ///< The modem sends nothing else for so long.
};

struct MicroModemOutput {
  std::string to_host;  ///< Sentences, each with its checksum, CR and LF.
  std::vector<MicroModemSent> to_water;
};

/// A packet that has come through the water; heard whole, whatever its bytes became.
struct MicroModemHeard {
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
  // From the water. Heard = understood + foreign + damaged_headers + own + overheard + no_cycle.
  int64_t understood = 0;
  int64_t foreign = 0;
  int64_t damaged_headers = 0;
  int64_t own = 0;             ///< With this modem's address as source: another has it too.
  int64_t overheard = 0;       ///< For others.
  int64_t no_cycle = 0;        ///< Data at rate 0 whose cycle packet was not heard.
  int64_t damaged_frames = 0;  ///< Of understood packets.
  // To the water.
  int64_t sent = 0;
  int64_t answers_dropped = 0;  ///< Answers to other modems for which too many were waiting.

  bool operator==(const MicroModemCounts&) const = default;
};

class MicroModem {
 public:
  static constexpr size_t kMaxLineBytes = 1024;  ///< CCTXD with 256 bytes takes half of it.
  static constexpr size_t kMaxWaiting = 8;       ///< Packets that wait for the air.

  explicit MicroModem(const MicroModemOptions& options);

  /// Takes one line of the host, with or without its line end.
  [[nodiscard]] MicroModemOutput Take(std::string_view line, int64_t now_us);
  /// Takes what came over a stream, however it is cut; CR or LF ends a line. A byte may be answered
  /// by 200, so give no more than some kilobytes at a time.
  [[nodiscard]] MicroModemOutput TakeBytes(std::string_view bytes, int64_t now_us);
  /// Forgets a line that has begun: its host has gone.
  void ForgetLine();
  /// Takes what came through the water.
  [[nodiscard]] MicroModemOutput Hear(const MicroModemHeard& heard, int64_t now_us);
  /// Does what is due.
  [[nodiscard]] MicroModemOutput Advance(int64_t now_us);
  /// Returns when Advance will have something to do, unless something else happens before.
  [[nodiscard]] std::optional<int64_t> NextEvent_us() const;

  /// Sets the modem's clock, as CCCLK does.
  void SetClock(int64_t utc_us, int64_t now_us);

  int address() const { return settings_.src; }
  bool is_on_the_air() const { return on_air_.has_value(); }
  bool is_in_a_cycle() const { return cycle_.has_value(); }
  const MicroModemCounts& counts() const { return counts_; }

 private:
  enum class CycleState : uint8_t { kAnnouncing, kPausing, kAsking, kSending };

  struct Cycle {
    CycleState state = CycleState::kAsking;
    MicroModemPacket packet;  ///< kData; grows by the host's frames.
    int num_wanted = 0;
    int64_t until_us = 0;  ///< kPausing, kAsking.
  };
  struct Outgoing {
    std::vector<uint8_t> bytes;
    int rate = 0;
    std::optional<int> told_bytes;  ///< What CATXP and CATXF say; absent: they are not said.
    bool is_of_cycle = false;
  };
  struct OnAir {
    int64_t end_us = 0;
    std::optional<int> told_bytes;
    bool is_of_cycle = false;
  };
  /// A frame that the host gave before it was asked.
  struct EarlyFrame {
    int destination = 0;
    MicroModemFrame frame;
    int64_t given_us = 0;
  };
  struct AwaitedData {
    int source = 0;
    int destination = 0;
    int num_frames = 0;
    int64_t until_us = 0;
  };
  enum class ErrorCode : int { kUnknown = 1, kBadField, kBusy, kNoData, kAbandoned };
  struct SentenceRow {
    std::string_view address;
    void (MicroModem::*answer)(const NmeaFields& sentence);
  };
  static const std::array<SentenceRow, 12> kSentences;

  // micromodem.cc: time, air and cycle.
  void CatchUp(int64_t now_us);
  void DoWhatIsDue();
  void EndTransmission();
  void StartTransmission();
  MicroModemOutput Finish();
  void Send(const MicroModemPacket& packet, std::optional<int> told_bytes, bool is_of_cycle);
  bool HasRoom() const { return waiting_.size() < kMaxWaiting; }
  void StartCycle(const MicroModemPacket& packet, int num_wanted);
  void AskForFrame();
  void SendData();
  void EndCycle(ErrorCode code, std::string_view module, std::string_view reason);
  void TimeOutRequest();
  void TimeOutAwaitedData();
  int64_t Utc_us(int64_t time_us) const;
  int64_t Utc_us() const { return Utc_us(now_us_); }
  void Say(std::string_view body);
  void SayError(std::string_view module, ErrorCode code, std::string_view reason);
  void SayRevision();
  void SayStatistics(const ReceptionStatistics& statistics);

  // micromodem_host.cc
  void TakeLine(std::string_view line);
  void Answer(const NmeaFields& sentence);
  void Refuse(std::string_view reason);
  void RefuseBusy(std::string_view reason);
  bool RefusesWhatIsWrong(const SentenceReader& reader);
  void SetConfiguration(const NmeaFields& sentence);
  void TellConfiguration(const NmeaFields& sentence);
  void Reboot(const NmeaFields& sentence);
  void SetCalendarClock(const NmeaFields& sentence);
  void SetIsoClock(const NmeaFields& sentence);
  void TellClock(const NmeaFields& sentence);
  void BeginCycle(const NmeaFields& sentence);
  void TakeData(const NmeaFields& sentence);
  void Ping(const NmeaFields& sentence);
  void SendMini(const NmeaFields& sentence);
  void RangeRemus(const NmeaFields& sentence);
  void RangeNarrowband(const NmeaFields& sentence);
  void RangeTransponders(const NmeaFields& sentence, size_t timeout_field);
  void SayTransponderTimes();

  // micromodem_water.cc
  void HearBytes(const MicroModemHeard& heard);
  void HearPacket(const MicroModemPacket& packet, const MicroModemHeard& heard);
  void HearCycle(const MicroModemPacket& packet, ReceptionStatistics statistics);
  void HearData(const MicroModemPacket& packet, ReceptionStatistics statistics);
  void HearAck(const MicroModemPacket& packet);
  void AnswerModem(MicroModemKind kind, int destination, int value);

  MicroModemOptions options_;
  MicroModemSettings settings_;
  MicroModemCounts counts_;
  MicroModemOutput output_;
  int64_t now_us_ = 0;
  int64_t clock_offset_us_ = 0;  ///< The modem's UTC less now_us_.
  bool is_refused_ = false;      ///< The sentence that is being answered.

  std::string line_;  ///< From TakeBytes, not ended yet.
  bool is_skipping_line_ = false;

  std::optional<OnAir> on_air_;
  std::deque<Outgoing> waiting_;
  std::optional<Cycle> cycle_;
  std::deque<EarlyFrame> early_;
  std::optional<AwaitedData> awaited_;
  std::optional<int64_t> boot_us_;          ///< When the modem says that it is up again.
  std::optional<int64_t> transponders_us_;  ///< When LBL times are told.
  double transponder_timeout_s_ = 0;
};

}  // namespace shoal
