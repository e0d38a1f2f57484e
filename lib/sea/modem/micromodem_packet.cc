#include "lib/sea/modem/micromodem_packet.h"

#include <algorithm>

#include "lib/base/codec/crc32.h"
#include "lib/base/codec/little_endian.h"

namespace shoal {
namespace {

constexpr uint8_t kMark = 0x4D;
constexpr size_t kFixedBytes = 7;  // Before the frames' lengths.
constexpr uint8_t kAckBit = 0x80;
constexpr uint16_t kFrameAckBit = 0x8000;
constexpr uint16_t kFrameLengthBits = 0x01FF;

uint16_t HeaderChecksum(std::span<const uint8_t> bytes) {
  return static_cast<uint16_t>(Crc32(bytes) & 0xFFFF);
}

int MaxValue(MicroModemKind kind) {
  switch (kind) {
    case MicroModemKind::kMini:
      return kMaxMiniPacket;
    case MicroModemKind::kAck:
      return (1 << kMaxMicroModemFrames) - 1;
    default:
      return 0;
  }
}

/// Returns how many frames a packet may have, and how long one may be.
MicroModemRate LimitsOf(const MicroModemPacket& packet) {
  if (packet.kind == MicroModemKind::kFlexible) {
    return {.max_frames = 1, .max_frame_bytes = kMaxFlexibleBytes};
  }
  return kMicroModemRates[static_cast<size_t>(packet.rate)];
}

bool IsPossible(const MicroModemPacket& packet) {
  const auto kind = static_cast<int>(packet.kind);
  if (kind < 1 || kind > static_cast<int>(MicroModemKind::kFlexible)) return false;
  if (packet.rate < 0 || packet.rate >= static_cast<int>(kMicroModemRates.size())) return false;
  if (packet.source < 0 || packet.source > kMaxMicroModemAddress) return false;
  if (packet.destination < 0 || packet.destination > kMaxMicroModemAddress) return false;
  if (packet.value < 0 || packet.value > MaxValue(packet.kind)) return false;
  const bool has_frames = packet.kind == MicroModemKind::kData ||
                          packet.kind == MicroModemKind::kCycle ||
                          packet.kind == MicroModemKind::kFlexible;
  const int max_frames = has_frames ? LimitsOf(packet).max_frames : 0;
  return packet.num_frames >= (has_frames ? 1 : 0) && packet.num_frames <= max_frames;
}

/// Takes a frame of that length off the front of `bytes`, which may hold fewer.
MicroModemFrame TakeFrame(uint16_t entry, std::span<const uint8_t>* bytes) {
  MicroModemFrame frame{.wants_ack = (entry & kFrameAckBit) != 0, .is_damaged = true};
  const size_t length = entry & kFrameLengthBits;
  if (bytes->size() < length + sizeof(uint32_t)) {
    *bytes = {};
    return frame;
  }
  const auto data = bytes->first(length);
  LittleEndianReader trailer(bytes->subspan(length));
  if (trailer.Take<uint32_t>() == Crc32(data)) {
    frame.is_damaged = false;
    frame.bytes.assign(data.begin(), data.end());
  }
  *bytes = bytes->subspan(length + sizeof(uint32_t));
  return frame;
}

}  // namespace

std::vector<uint8_t> EncodeMicroModemPacket(const MicroModemPacket& packet) {
  SHOAL_CHECK(IsPossible(packet), "modems send what modems understand");
  std::vector<uint8_t> bytes;
  bytes.push_back(kMark);
  bytes.push_back(static_cast<uint8_t>(static_cast<int>(packet.kind) << 4 | packet.rate));
  bytes.push_back(static_cast<uint8_t>(packet.source));
  bytes.push_back(static_cast<uint8_t>(packet.destination));
  bytes.push_back(static_cast<uint8_t>((packet.wants_ack ? kAckBit : 0) | packet.num_frames));
  AppendLittleEndian(static_cast<uint16_t>(packet.value), &bytes);
  for (const MicroModemFrame& frame : packet.frames) {
    SHOAL_CHECK(frame.bytes.size() <= static_cast<size_t>(kMaxMicroModemFrameBytes), "fits");
    const auto entry =
        static_cast<uint16_t>(frame.bytes.size() | (frame.wants_ack ? kFrameAckBit : 0U));
    AppendLittleEndian(entry, &bytes);
  }
  AppendLittleEndian(HeaderChecksum(bytes), &bytes);
  for (const MicroModemFrame& frame : packet.frames) {
    bytes.insert(bytes.end(), frame.bytes.begin(), frame.bytes.end());
    AppendLittleEndian(Crc32(frame.bytes), &bytes);
  }
  return bytes;
}

MicroModemVerdict DecodeMicroModemPacket(std::span<const uint8_t> bytes, MicroModemPacket* packet) {
  if (bytes.empty() || bytes[0] != kMark) return MicroModemVerdict::kForeign;
  if (bytes.size() < kFixedBytes) return MicroModemVerdict::kDamagedHeader;
  LittleEndianReader reader(bytes.subspan(1));
  const auto kind_and_rate = reader.Take<uint8_t>();
  MicroModemPacket read;
  read.kind = static_cast<MicroModemKind>(kind_and_rate >> 4);
  read.rate = kind_and_rate & 0xF;
  read.source = reader.Take<uint8_t>();
  read.destination = reader.Take<uint8_t>();
  const auto ack_and_frames = reader.Take<uint8_t>();
  read.wants_ack = (ack_and_frames & kAckBit) != 0;
  read.num_frames = ack_and_frames & ~kAckBit;
  read.value = reader.Take<uint16_t>();
  if (!IsPossible(read)) return MicroModemVerdict::kDamagedHeader;

  const bool is_data = read.kind == MicroModemKind::kData || read.kind == MicroModemKind::kFlexible;
  const size_t num_entries = is_data ? static_cast<size_t>(read.num_frames) : 0;
  const size_t header_bytes = kFixedBytes + 2 * num_entries;
  if (bytes.size() < header_bytes + 2) return MicroModemVerdict::kDamagedHeader;
  std::vector<uint16_t> entries;
  for (size_t i = 0; i < num_entries; ++i) entries.push_back(reader.Take<uint16_t>());
  if (reader.Take<uint16_t>() != HeaderChecksum(bytes.first(header_bytes))) {
    return MicroModemVerdict::kDamagedHeader;
  }
  const int max_bytes = LimitsOf(read).max_frame_bytes;
  std::span<const uint8_t> rest = bytes.subspan(header_bytes + 2);
  for (const uint16_t entry : entries) {
    if ((entry & kFrameLengthBits) > max_bytes) return MicroModemVerdict::kDamagedHeader;
    read.frames.push_back(TakeFrame(entry, &rest));
  }
  *packet = std::move(read);
  return MicroModemVerdict::kUnderstood;
}

}  // namespace shoal
