// A trailer that shows whether a message was damaged, and which were lost.
//
//   message          n bytes, as it is without a frame
//   sequence         uint16: one more for each frame that the sender makes; 0 follows 65535
//   checksum         uint32: CRC-32 of IEEE 802.3 over all bytes before it
//
// Numbers are little-endian. muNet has no frames, so they are off unless a mission turns them on;
// standing behind the message, it leaves the message readable to receivers that do not know it. Six
// bytes are 48 ms at 1000 bit/s.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace shoal {

inline constexpr size_t kFrameBytes = 6;  ///< What a frame adds to a message.

[[nodiscard]] std::vector<uint8_t> EncodeFrame(std::span<const uint8_t> message, uint16_t sequence);

struct OpenedFrame {
  std::span<const uint8_t> message = {};  ///< Part of the bytes that were given.
  uint16_t sequence = 0;
};

/// Returns the message of a frame whose checksum is right.
[[nodiscard]] std::optional<OpenedFrame> OpenFrame(std::span<const uint8_t> bytes);

/// What the sequence numbers of one sender show.
struct FrameCount {
  std::optional<uint16_t> last_sequence = {};  ///< Nothing before the first frame.
  int64_t received = 0;
  int64_t lost = 0;       ///< Numbers that were left out.
  int64_t repeated = 0;   ///< Frames with the number of the one before.
  int64_t restarted = 0;  ///< Lower numbers than before: the sender was restarted.

  bool operator==(const FrameCount&) const = default;
};

/// Counts a frame. Frames of one sender arrive in the order in which it sent them, so a lower
/// number means that the sender has restarted.
void CountFrame(uint16_t sequence, FrameCount* count);

/// By the sender's id.
using FrameCounts = std::map<uint32_t, FrameCount>;

}  // namespace shoal
