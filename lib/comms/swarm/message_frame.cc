#include "lib/comms/swarm/message_frame.h"

#include "lib/base/codec/crc32.h"
#include "lib/base/codec/little_endian.h"

namespace shoal {

std::vector<uint8_t> EncodeFrame(std::span<const uint8_t> message, uint16_t sequence) {
  std::vector<uint8_t> bytes;
  bytes.reserve(message.size() + kFrameBytes);
  bytes.assign(message.begin(), message.end());
  AppendLittleEndian(sequence, &bytes);
  AppendLittleEndian(Crc32(bytes), &bytes);
  return bytes;
}

std::optional<OpenedFrame> OpenFrame(std::span<const uint8_t> bytes) {
  if (bytes.size() < kFrameBytes) return std::nullopt;
  LittleEndianReader trailer(bytes.last(kFrameBytes));
  const auto sequence = trailer.Take<uint16_t>();
  const auto checksum = trailer.Take<uint32_t>();
  if (Crc32(bytes.first(bytes.size() - sizeof checksum)) != checksum) return std::nullopt;
  return OpenedFrame{.message = bytes.first(bytes.size() - kFrameBytes), .sequence = sequence};
}

void CountFrame(uint16_t sequence, FrameCount* count) {
  constexpr uint16_t kHalfTurn = 0x8000;
  ++count->received;
  if (count->last_sequence) {
    const auto ahead = static_cast<uint16_t>(sequence - *count->last_sequence);
    if (ahead == 0) {
      ++count->repeated;
    } else if (ahead < kHalfTurn) {
      count->lost += ahead - 1;
    } else {
      ++count->restarted;
    }
  }
  count->last_sequence = sequence;
}

}  // namespace shoal
