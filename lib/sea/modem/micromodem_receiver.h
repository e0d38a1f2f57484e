// The packets that arrive at a Micro-Modem: what its host gets of them, and what it answers.
#pragma once

#include <cstdint>
#include <optional>

#include "lib/sea/modem/micromodem_air.h"
#include "lib/sea/modem/micromodem_cst.h"
#include "lib/sea/modem/micromodem_packet.h"
#include "lib/sea/modem/micromodem_unit.h"

namespace shoal {

class MicroModemReceiver {
 public:
  MicroModemReceiver(MicroModemUnit& unit, MicroModemAir& air) : unit_(unit), air_(air) {}

  void Receive(const MicroModemArrival& arrival);
  /// CCMSC: data that a cycle packet has announced is not awaited any more.
  void Reboot() { awaited_.reset(); }

  /// Does what is due.
  void OnTime();
  std::optional<int64_t> NextEvent_us() const;

 private:
  /// Data at rate 0, announced by a cycle packet.
  struct AwaitedData {
    int source = 0;
    int destination = 0;
    int num_frames = 0;
    int64_t until_us = 0;
  };

  void Take(const MicroModemPacket& packet, const MicroModemArrival& arrival);
  void TakeCycle(const MicroModemPacket& packet, ReceptionStatistics statistics);
  void TakeData(const MicroModemPacket& packet, ReceptionStatistics statistics);
  void TakeFlexible(const MicroModemPacket& packet, ReceptionStatistics statistics);
  void TakeAck(const MicroModemPacket& packet);
  void Answer(MicroModemKind kind, int destination, int value);

  MicroModemUnit& unit_;
  MicroModemAir& air_;
  std::optional<AwaitedData> awaited_;
};

}  // namespace shoal
