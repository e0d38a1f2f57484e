// A simulated WHOI Micro-Modem: sentences of its host on one side, packets of the acoustic network
// on the other. docs/communication/micromodem.md lists the sentences.
//
//   MicroModem modem({.address = 1});
//   Pass(modem.Advance(now_us));                             // at least in every step
//   Pass(modem.Take("$CCMPC,1,2*5D\r\n", now_us));           // a line of the host
//   Pass(modem.Receive({.bytes = payload, .start_us = ..., .travel_us = ...}, now_us));
//   Pass(modem.Transmit(step_us));                           // in the step that takes packets
//
//   void Pass(const MicroModemOutput& output) {
//     Write(output.to_host);
//     for (const MicroModemSent& sent : output.to_water) Publish(sent.bytes, sent.bps);
//   }
//
// Time is an argument, in microseconds, and never goes back. Its parts: the host's sentences
// (micromodem_host.h), the data cycle (micromodem_cycle.h), packets received
// (micromodem_receiver.h) and sent (micromodem_air.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/sea/modem/micromodem_air.h"
#include "lib/sea/modem/micromodem_cycle.h"
#include "lib/sea/modem/micromodem_host.h"
#include "lib/sea/modem/micromodem_receiver.h"
#include "lib/sea/modem/micromodem_unit.h"

namespace shoal {

class MicroModem {
 public:
  static constexpr size_t kMaxLineBytes = MicroModemHost::kMaxLineBytes;
  static constexpr size_t kMaxWaiting = MicroModemAir::kMaxWaiting;

  explicit MicroModem(const MicroModemOptions& options);
  MicroModem(const MicroModem&) = delete;  // Its parts refer to one another.
  MicroModem& operator=(const MicroModem&) = delete;

  /// Takes one line of the host, with or without its line end.
  [[nodiscard]] MicroModemOutput Take(std::string_view line, int64_t now_us);
  /// Takes what came over a stream, however it is cut; CR or LF ends a line. A byte may be answered
  /// by 200, so give no more than some kilobytes at a time.
  [[nodiscard]] MicroModemOutput TakeBytes(std::string_view bytes, int64_t now_us);
  /// Drops a line that has begun: its host has gone.
  void ForgetLine() { host_.ForgetLine(); }
  /// Takes a packet that has arrived.
  [[nodiscard]] MicroModemOutput Receive(const MicroModemArrival& arrival, int64_t now_us);
  /// Does what is due.
  [[nodiscard]] MicroModemOutput Advance(int64_t now_us);
  /// Does what is due, and starts the next transmission where one waits and none is on the air:
  /// alone of all it fills to_water. To be called when the network takes packets, since their time
  /// on the air counts from `now_us`.
  [[nodiscard]] MicroModemOutput Transmit(int64_t now_us);
  /// Returns when Advance will have something to do, unless something else happens before. What
  /// waits for Transmit is no event.
  [[nodiscard]] std::optional<int64_t> NextEvent_us() const;

  /// Sets the modem's clock, as CCCLK does.
  void SetClock(int64_t utc_us, int64_t now_us) { unit_.SetClock(utc_us, now_us); }

  int address() const { return unit_.address(); }
  bool is_on_the_air() const { return air_.is_busy(); }
  bool is_in_a_cycle() const { return cycle_.is_under_way(); }
  const MicroModemCounts& counts() const { return unit_.counts; }

 private:
  void CatchUp(int64_t now_us);
  MicroModemOutput TakeOutput();

  MicroModemUnit unit_;
  MicroModemAir air_;
  MicroModemCycle cycle_;
  MicroModemReceiver receiver_;
  MicroModemHost host_;
};

}  // namespace shoal
