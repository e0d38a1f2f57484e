#include "lib/sea/modem/micromodem_packet.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "lib/base/codec/crc32.h"

namespace shoal::micromodem_packet_test {

using Bytes = std::vector<uint8_t>;

MicroModemPacket AnyPacket() {
  MicroModemPacket packet;
  packet.kind = static_cast<MicroModemKind>(*rc::gen::inRange(1, 7));
  packet.source = *rc::gen::inRange(0, 128);
  packet.destination = *rc::gen::inRange(0, 128);
  packet.rate = *rc::gen::inRange(0, 6);
  packet.wants_ack = *rc::gen::arbitrary<bool>();
  const MicroModemRate& rate = kMicroModemRates[static_cast<size_t>(packet.rate)];
  if (packet.kind == MicroModemKind::kMini) packet.value = *rc::gen::inRange(0, 0x2000);
  if (packet.kind == MicroModemKind::kAck) packet.value = *rc::gen::inRange(0, 0x100);
  if (packet.kind == MicroModemKind::kCycle || packet.kind == MicroModemKind::kData) {
    packet.num_frames = *rc::gen::inRange(1, rate.max_frames + 1);
  }
  if (packet.kind != MicroModemKind::kData) return packet;
  for (int i = 0; i < packet.num_frames; ++i) {
    const auto length = static_cast<size_t>(*rc::gen::inRange(0, rate.max_frame_bytes + 1));
    packet.frames.push_back(
        {.wants_ack = *rc::gen::arbitrary<bool>(),
         .bytes = *rc::gen::container<Bytes>(length, rc::gen::arbitrary<uint8_t>())});
  }
  return packet;
}

size_t HeaderBytes(const MicroModemPacket& packet) { return 9 + 2 * packet.frames.size(); }

RC_GTEST_PROP(MicroModemPacketProperty, ComesBackAsItWasWhateverStandsBehindIt, ()) {
  const MicroModemPacket packet = AnyPacket();
  Bytes bytes = EncodeMicroModemPacket(packet);
  const auto more = *rc::gen::arbitrary<Bytes>();
  bytes.insert(bytes.end(), more.begin(), more.end());
  MicroModemPacket read;
  RC_ASSERT(DecodeMicroModemPacket(bytes, &read) == MicroModemVerdict::kUnderstood);
  RC_ASSERT(read == packet);
}

RC_GTEST_PROP(MicroModemPacketProperty, LosesOneFrameByAWrongBitAmongTheFrames, ()) {
  MicroModemPacket packet = AnyPacket();
  RC_PRE(!packet.frames.empty());
  Bytes bytes = EncodeMicroModemPacket(packet);
  const size_t header_bytes = HeaderBytes(packet);
  const size_t place = *rc::gen::inRange(header_bytes, bytes.size());
  bytes[place] ^= static_cast<uint8_t>(1 << *rc::gen::inRange(0, 8));
  MicroModemPacket read;
  RC_ASSERT(DecodeMicroModemPacket(bytes, &read) == MicroModemVerdict::kUnderstood);
  size_t begin = header_bytes;
  for (size_t i = 0; i < packet.frames.size(); ++i) {
    const size_t end = begin + packet.frames[i].bytes.size() + 4;
    const bool is_hit = place >= begin && place < end;
    RC_ASSERT(read.frames[i].is_damaged == is_hit);
    RC_ASSERT(is_hit || read.frames[i] == packet.frames[i]);
    begin = end;
  }
}

RC_GTEST_PROP(MicroModemPacketProperty, IsLostByAWrongBitBeforeTheFrames, ()) {
  const MicroModemPacket packet = AnyPacket();
  Bytes bytes = EncodeMicroModemPacket(packet);
  const size_t place = *rc::gen::inRange<size_t>(0, HeaderBytes(packet));
  bytes[place] ^= static_cast<uint8_t>(1 << *rc::gen::inRange(0, 8));
  MicroModemPacket read;
  const MicroModemVerdict verdict = DecodeMicroModemPacket(bytes, &read);
  RC_ASSERT(verdict != MicroModemVerdict::kUnderstood);
  RC_ASSERT((verdict == MicroModemVerdict::kForeign) == (place == 0));
}

RC_GTEST_PROP(MicroModemPacketProperty, LosesTheFramesThatAreCutOff, ()) {
  const MicroModemPacket packet = AnyPacket();
  const Bytes bytes = EncodeMicroModemPacket(packet);
  const size_t length = *rc::gen::inRange<size_t>(0, bytes.size());
  MicroModemPacket read;
  const auto verdict = DecodeMicroModemPacket(std::span<const uint8_t>(bytes).first(length), &read);
  RC_ASSERT((verdict == MicroModemVerdict::kUnderstood) == (length >= HeaderBytes(packet)));
  if (verdict == MicroModemVerdict::kUnderstood) RC_ASSERT(read.frames.back().is_damaged);
}

RC_GTEST_PROP(MicroModemPacketProperty, IsPossibleWhereItIsUnderstood, ()) {
  // Any bytes, with a header whose checksum is right.
  Bytes bytes = *rc::gen::container<Bytes>(40, rc::gen::arbitrary<uint8_t>());
  bytes[0] = 0x4D;
  bytes[1] = static_cast<uint8_t>(*rc::gen::inRange(0, 8) << 4 | (bytes[1] & 7));
  bytes[2] &= 0x7F;
  bytes[3] &= 0x7F;
  bytes[4] &= 0x8F;
  const bool is_data = bytes[1] >> 4 == 2;
  if (is_data) bytes[5] = bytes[6] = 0;
  const size_t length = 7 + (is_data ? 2 * (bytes[4] & 0x0FU) : 0U);
  const uint32_t checksum = Crc32(std::span<const uint8_t>(bytes).first(length));
  bytes[length] = static_cast<uint8_t>(checksum & 0xFF);
  bytes[length + 1] = static_cast<uint8_t>(checksum >> 8 & 0xFF);
  MicroModemPacket read;
  if (DecodeMicroModemPacket(bytes, &read) != MicroModemVerdict::kUnderstood) return;
  const MicroModemRate& rate = kMicroModemRates.at(static_cast<size_t>(read.rate));
  RC_ASSERT(read.num_frames <= rate.max_frames);
  RC_ASSERT(std::all_of(read.frames.begin(), read.frames.end(), [&](const auto& frame) {
    return std::ssize(frame.bytes) <= rate.max_frame_bytes;
  }));
  MicroModemPacket again = read;
  for (MicroModemFrame& frame : again.frames) frame.is_damaged = false;
  RC_ASSERT(!EncodeMicroModemPacket(again).empty());
}

TEST(MicroModemPacket, HasNoFrameLongerThanItsRateAllows) {
  for (const size_t length : {32U, 33U}) {
    Bytes bytes = EncodeMicroModemPacket({.kind = MicroModemKind::kData,
                                          .source = 1,
                                          .rate = 3,
                                          .num_frames = 1,
                                          .frames = {{.bytes = Bytes(length, 'a')}}});
    bytes[1] = 0x20;  // Rate 0.
    const uint32_t checksum = Crc32(std::span<const uint8_t>(bytes).first(9));
    bytes[9] = static_cast<uint8_t>(checksum & 0xFF);
    bytes[10] = static_cast<uint8_t>(checksum >> 8 & 0xFF);
    MicroModemPacket read;
    EXPECT_EQ(DecodeMicroModemPacket(bytes, &read) == MicroModemVerdict::kUnderstood, length == 32);
  }
}

TEST(MicroModemPacket, HasTheBytesThatItsHeaderTells) {
  const Bytes bytes = EncodeMicroModemPacket(
      {.kind = MicroModemKind::kData,
       .source = 3,
       .destination = 127,
       .rate = 5,
       .wants_ack = true,
       .num_frames = 2,
       .frames = {{.wants_ack = true, .bytes = {'a', 'b'}}, {.bytes = Bytes(256, 'c')}}});
  const Bytes header = {0x4D, 0x25, 3, 127, 0x82, 0, 0, 0x02, 0x80, 0x00, 0x01};
  ASSERT_EQ(bytes.size(), 13U + 2 + 4 + 256 + 4);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 11), header);
  EXPECT_EQ(bytes[11] | bytes[12] << 8, static_cast<int>(Crc32(header) & 0xFFFF));
  EXPECT_EQ(bytes[13], 'a');
  EXPECT_EQ(EncodeMicroModemPacket({.kind = MicroModemKind::kPing, .destination = 1}).size(), 9U);
}

}  // namespace shoal::micromodem_packet_test
