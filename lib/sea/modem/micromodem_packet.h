// What one Micro-Modem sends another: one packet is one acoustic transmission.
//
//   byte 0      0x4D
//   byte 1      kind in the high four bits, rate in the low four
//   byte 2      source
//   byte 3      destination; 0 is all
//   byte 4      bit 7: the cycle asks for acknowledgements; bits 0 to 3: number of frames
//   bytes 5, 6  kMini: the 13 bits; kAck: bit n-1 acknowledges frame n; else 0
//   2 per frame kData and kFlexible only. Bit 15: this frame asks for an acknowledgement; bits 0 to
//   8: its length 2 bytes     the low half of the CRC-32 of all bytes before then        kData and
//   kFlexible only: each frame's bytes, followed by their CRC-32
//
// Numbers are little-endian. Bytes behind the packet do not matter. Wrong bits among the frames
// damage single frames; wrong bits before them lose the packet. A packet without frames has 9
// bytes, 0.9 s at the 80 bit/s of rate 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/sea/modem/micromodem_rate.h"

namespace shoal {

enum class MicroModemKind : uint8_t {
  kCycle = 1,  ///< Rate 0 announces its data packet with this; other rates do without.
  kData = 2,
  kAck = 3,
  kPing = 4,
  kPingReply = 5,
  kMini = 6,
  kFlexible = 7,  ///< CCTDP of a Micro-Modem 2: one frame of at most kMaxFlexibleBytes.
};

struct MicroModemFrame {
  bool wants_ack = false;
  bool is_damaged = false;  ///< Received with a checksum that is wrong; `bytes` is empty then.
  std::vector<uint8_t> bytes = {};

  bool operator==(const MicroModemFrame&) const = default;
};

struct MicroModemPacket {
  MicroModemKind kind = MicroModemKind::kData;
  int source = 0;
  int destination = 0;
  int rate = 0;
  bool wants_ack = false;
  int num_frames = 0;                        ///< kCycle, kData, kFlexible.
  int value = 0;                             ///< kMini, kAck.
  std::vector<MicroModemFrame> frames = {};  ///< kData, kFlexible: num_frames of them.

  bool operator==(const MicroModemPacket&) const = default;
};

/// @pre What DecodeMicroModemPacket checks holds.
[[nodiscard]] std::vector<uint8_t> EncodeMicroModemPacket(const MicroModemPacket& packet);

enum class MicroModemVerdict : uint8_t {
  kUnderstood,     ///< Frames may be damaged all the same.
  kForeign,        ///< Not a Micro-Modem's.
  kDamagedHeader,  ///< A Micro-Modem's, by its first byte; the rest is wrong or cut off.
};

/// Reads a packet, whatever the bytes are. `packet` is set where they are understood; then
/// addresses, rate, number and length of frames and `value` are possible.
[[nodiscard]] MicroModemVerdict DecodeMicroModemPacket(std::span<const uint8_t> bytes,
                                                       MicroModemPacket* packet);

}  // namespace shoal
