#include "lib/sea/modem/micromodem_receiver.h"

#include <algorithm>
#include <array>
#include <string>

#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/sea/modem/sentence_text.h"

namespace shoal {
namespace {

constexpr int64_t kHour_us = 3600 * kSecond_us;

std::string Text(int number) { return std::to_string(number); }

/// Only these may be addressed to all: the answers of all modems to one ping would collide.
bool MayBeForAll(MicroModemKind kind) {
  return kind == MicroModemKind::kCycle || kind == MicroModemKind::kData ||
         kind == MicroModemKind::kMini || kind == MicroModemKind::kFlexible;
}

std::string CycleText(const MicroModemPacket& packet) {
  return "CACYC,0," + Text(packet.source) + "," + Text(packet.destination) + "," +
         Text(packet.rate) + (packet.wants_ack ? ",1," : ",0,") + Text(packet.num_frames);
}

}  // namespace

void MicroModemReceiver::Receive(const MicroModemArrival& arrival) {
  MicroModemPacket packet;
  switch (DecodeMicroModemPacket(arrival.bytes, &packet)) {
    case MicroModemVerdict::kForeign:
      ++unit_.counts.foreign;
      return;
    case MicroModemVerdict::kDamagedHeader:
      ++unit_.counts.damaged_headers;
      return;
    case MicroModemVerdict::kUnderstood:
      break;
  }
  const bool is_for_all = packet.destination == kMicroModemBroadcast && MayBeForAll(packet.kind);
  if (packet.source == unit_.address()) {
    ++unit_.counts.own;
  } else if (packet.destination != unit_.address() && !is_for_all) {
    ++unit_.counts.overheard;
  } else {
    Take(packet, arrival);
  }
}

void MicroModemReceiver::Take(const MicroModemPacket& packet, const MicroModemArrival& arrival) {
  if (packet.kind == MicroModemKind::kData && packet.rate == 0 &&
      !(awaited_ && awaited_->source == packet.source)) {
    ++unit_.counts.no_cycle;
    return;
  }
  ++unit_.counts.understood;
  const int64_t start_us = std::clamp(arrival.start_us, unit_.now_us - kHour_us, unit_.now_us);
  const ReceptionStatistics statistics = {.arrived_utc_us = unit_.Utc_us(start_us),
                                          .source = packet.source,
                                          .destination = packet.destination,
                                          .snr_db = arrival.snr_db};
  const std::string from_to = Text(packet.source) + "," + Text(packet.destination);
  switch (packet.kind) {
    case MicroModemKind::kCycle:
      return TakeCycle(packet, statistics);
    case MicroModemKind::kData:
      return TakeData(packet, statistics);
    case MicroModemKind::kFlexible:
      return TakeFlexible(packet, statistics);
    case MicroModemKind::kAck:
      TakeAck(packet);
      break;
    case MicroModemKind::kPing:
      unit_.Write("CAMPA," + from_to);
      Answer(MicroModemKind::kPingReply, packet.source, 0);
      break;
    case MicroModemKind::kPingReply: {
      const int64_t travel_us = std::clamp<int64_t>(arrival.travel_us, 0, kHour_us);
      unit_.Write("CAMPR," + from_to + "," + FixedText(Seconds(travel_us), 4));
      break;
    }
    case MicroModemKind::kMini: {
      const std::array<uint8_t, 2> value = {static_cast<uint8_t>(packet.value >> 8),
                                            static_cast<uint8_t>(packet.value & 0xFF)};
      unit_.Write("CAMUA," + from_to + "," + HexText(value));
      break;
    }
  }
  unit_.WriteStatistics(statistics);
}

void MicroModemReceiver::TakeCycle(const MicroModemPacket& packet, ReceptionStatistics statistics) {
  if (unit_.settings.rxp == 1) unit_.Write("CARXP,0");
  unit_.Write(CycleText(packet));
  statistics.type = CstPacketType::kFsk;
  unit_.WriteStatistics(statistics);
  if (packet.rate != 0) return;
  awaited_ = AwaitedData{.source = packet.source,
                         .destination = packet.destination,
                         .num_frames = packet.num_frames,
                         .until_us = unit_.now_us + unit_.settings.pto * kSecond_us};
}

void MicroModemReceiver::TakeData(const MicroModemPacket& packet, ReceptionStatistics statistics) {
  const bool is_fsk = packet.rate == 0;
  if (is_fsk) awaited_.reset();
  if (unit_.settings.rxp == 1) unit_.Write(is_fsk ? "CARXP,0" : "CARXP,1");
  if (!is_fsk) unit_.Write(CycleText(packet));
  int acknowledged = 0;
  for (int i = 0; i < packet.num_frames; ++i) {
    const MicroModemFrame& frame = packet.frames[static_cast<size_t>(i)];
    if (frame.is_damaged) {
      unit_.Write("CAMSG,BAD_CRC," + Text(i + 1));
      ++statistics.num_bad_frames;
      continue;
    }
    unit_.Write("CARXD," + Text(packet.source) + "," + Text(packet.destination) +
                (frame.wants_ack ? ",1," : ",0,") + Text(i + 1) + "," + HexText(frame.bytes));
    if (frame.wants_ack) acknowledged |= 1 << i;
  }
  unit_.counts.damaged_frames += statistics.num_bad_frames;
  statistics.mode = statistics.num_bad_frames > 0 ? CstMode::kBadCrc : CstMode::kGood;
  statistics.rate = packet.rate;
  statistics.type = is_fsk ? CstPacketType::kFsk : CstPacketType::kPsk;
  statistics.num_frames = packet.num_frames;
  unit_.WriteStatistics(statistics);
  if (acknowledged != 0 && packet.destination != kMicroModemBroadcast) {
    Answer(MicroModemKind::kAck, packet.source, acknowledged);
  }
}

/// A modem of any version receives it: what cannot send CCTDP gets CARDP all the same.
void MicroModemReceiver::TakeFlexible(const MicroModemPacket& packet,
                                      ReceptionStatistics statistics) {
  const MicroModemFrame& frame = packet.frames.front();
  unit_.Write("CARDP," + Text(packet.source) + "," + Text(packet.destination) + "," +
              Text(packet.rate) + (packet.wants_ack ? ",1,0,," : ",0,0,,") +
              (frame.is_damaged
                   ? "0;0;"
                   : "1;" + std::to_string(frame.bytes.size()) + ";" + HexText(frame.bytes)));
  statistics.num_frames = 1;
  statistics.num_bad_frames = frame.is_damaged ? 1 : 0;
  unit_.counts.damaged_frames += statistics.num_bad_frames;
  statistics.mode = frame.is_damaged ? CstMode::kBadCrc : CstMode::kGood;
  statistics.rate = packet.rate;
  statistics.type = CstPacketType::kFlexible;
  unit_.WriteStatistics(statistics);
  const bool acknowledges = !frame.is_damaged && frame.wants_ack;
  if (acknowledges && packet.destination != kMicroModemBroadcast) {
    Answer(MicroModemKind::kAck, packet.source, 1);
  }
}

void MicroModemReceiver::TakeAck(const MicroModemPacket& packet) {
  for (int i = 0; i < kMaxMicroModemFrames; ++i) {
    if ((packet.value >> i & 1) == 0) continue;
    unit_.Write("CAACK," + Text(packet.source) + "," + Text(packet.destination) + "," +
                Text(i + 1) + ",1");
  }
}

void MicroModemReceiver::Answer(MicroModemKind kind, int destination, int value) {
  if (!air_.HasRoom()) {
    ++unit_.counts.answers_dropped;
    return;
  }
  air_.Send({.kind = kind, .source = unit_.address(), .destination = destination, .value = value},
            {}, false);
}

void MicroModemReceiver::OnTime() {
  if (!awaited_ || awaited_->until_us > unit_.now_us) return;
  const AwaitedData awaited = *awaited_;
  awaited_.reset();
  unit_.Write("CAMSG,PACKET_TIMEOUT," + std::to_string(unit_.settings.pto));
  unit_.WriteStatistics({.mode = CstMode::kTimeout,
                         .arrived_utc_us = unit_.Utc_us(),
                         .source = awaited.source,
                         .destination = awaited.destination,
                         .type = CstPacketType::kFsk,
                         .num_frames = awaited.num_frames,
                         .num_bad_frames = awaited.num_frames});
}

std::optional<int64_t> MicroModemReceiver::NextEvent_us() const {
  if (!awaited_) return std::nullopt;
  return awaited_->until_us;
}

}  // namespace shoal
