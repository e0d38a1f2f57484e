// The transmissions of a Micro-Modem: one at a time, the others wait for their turn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "lib/sea/modem/micromodem_packet.h"
#include "lib/sea/modem/micromodem_unit.h"

namespace shoal {

/// Between two packets of one modem, so that they do not overlap at a receiver to which the
/// distance shrinks meanwhile: by up to 15 m.
inline constexpr int64_t kPacketGap_us = 10'000;

class MicroModemAir {
 public:
  static constexpr size_t kMaxWaiting = 8;

  explicit MicroModemAir(MicroModemUnit& unit) : unit_(unit) {}

  /// False where too many packets wait.
  bool HasRoom() const { return waiting_.size() < kMaxWaiting; }
  /// Sends a packet after those that wait. `shown_bytes` is what CATXP and CATXF show; absent:
  /// these sentences are not written.
  void Send(const MicroModemPacket& packet, std::optional<int> shown_bytes, bool is_of_cycle);
  /// Starts the next transmission where the last has ended. To be called in the step that takes the
  /// bytes: the network counts from there, and so does the end.
  void StartNext();
  /// Ends the transmission that is over. Returns true where it was one of the data cycle.
  bool EndWhatIsOver();
  /// Drops what waits; the transmission that is on the air does not belong to a cycle any more.
  void DropWaiting();

  bool is_busy() const { return on_air_.has_value(); }
  bool is_sending_cycle() const { return on_air_ && on_air_->is_of_cycle; }
  /// Returns when the transmission ends.
  std::optional<int64_t> NextEvent_us() const;

 private:
  struct Outgoing {
    std::vector<uint8_t> bytes;
    int rate = 0;
    std::optional<int> shown_bytes;
    bool is_of_cycle = false;
  };
  struct OnAir {
    int64_t end_us = 0;
    std::optional<int> shown_bytes;
    bool is_of_cycle = false;
  };

  MicroModemUnit& unit_;
  std::optional<OnAir> on_air_;
  std::deque<Outgoing> waiting_;
};

}  // namespace shoal
