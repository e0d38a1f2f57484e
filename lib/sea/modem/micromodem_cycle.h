// The data cycle of a Micro-Modem that sends, after CCCYC:
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

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

#include "lib/sea/modem/micromodem_air.h"
#include "lib/sea/modem/micromodem_packet.h"
#include "lib/sea/modem/micromodem_unit.h"

namespace shoal {

class MicroModemCycle {
 public:
  MicroModemCycle(MicroModemUnit& unit, MicroModemAir& air) : unit_(unit), air_(air) {}

  bool is_under_way() const { return cycle_.has_value(); }
  bool is_asking() const { return cycle_ && cycle_->state == State::kAsking; }
  /// The packet that is being filled. @pre is_under_way()
  const MicroModemPacket& packet() const { return cycle_->packet; }

  /// Starts a cycle with `num_wanted` frames. @pre packet.kind is kData, and it has no frames yet
  void Start(const MicroModemPacket& packet, int num_wanted);
  /// Ends the cycle with an error. @pre is_under_way()
  void Abandon(std::string_view reason);
  /// CCMSC: nothing is left of the cycle, but what is on the air ends with its CATXF.
  void Reboot();

  /// Drops frames that were given before a cycle and are older than DTO.
  void DropOldFrames();
  /// False where too many frames were given before a cycle.
  bool HasRoomForEarlyFrame() const;
  /// Takes a frame of the host: of the packet that asks for one, else of a cycle that is to come.
  /// An empty one ends the packet.
  void Give(int destination, MicroModemFrame frame);

  /// A packet of the cycle has been sent.
  void OnTransmissionEnded();
  /// Does what is due.
  void OnTime();
  std::optional<int64_t> NextEvent_us() const;

 private:
  enum class State : uint8_t { kAnnouncing, kPausing, kAsking, kSending };

  struct Cycle {
    State state = State::kAsking;
    MicroModemPacket packet;  ///< kData; grows by the host's frames.
    int num_wanted = 0;
    int64_t until_us = 0;  ///< kPausing, kAsking.
  };
  /// A frame that the host gave before it was asked.
  struct EarlyFrame {
    int destination = 0;
    MicroModemFrame frame;
    int64_t given_us = 0;
  };

  void AskForFrame();
  void SendData();
  void End(MicroModemError code, std::string_view module, std::string_view reason);
  void TimeOutRequest();

  MicroModemUnit& unit_;
  MicroModemAir& air_;
  std::optional<Cycle> cycle_;
  std::deque<EarlyFrame> early_;
};

}  // namespace shoal
