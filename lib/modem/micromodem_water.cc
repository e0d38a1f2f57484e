// What a Micro-Modem makes of what it hears.
#include <algorithm>

#include "lib/check/time_units.h"
#include "lib/modem/micromodem.h"
#include "lib/modem/sentence_text.h"

namespace shoal {
namespace {

constexpr int64_t kHour_us = 3600 * kSecond_us;

std::string Text(int number) { return std::to_string(number); }

/// Only these are for all where they say so: answers of all at once to one ping would collide.
bool MayBeForAll(MicroModemKind kind) {
  return kind == MicroModemKind::kCycle || kind == MicroModemKind::kData ||
         kind == MicroModemKind::kMini;
}

std::string CycleText(const MicroModemPacket& packet) {
  return "CACYC,0," + Text(packet.source) + "," + Text(packet.destination) + "," +
         Text(packet.rate) + (packet.wants_ack ? ",1," : ",0,") + Text(packet.num_frames);
}

}  // namespace

MicroModemOutput MicroModem::Hear(const MicroModemHeard& heard, int64_t now_us) {
  CatchUp(now_us);
  HearBytes(heard);
  return Finish();
}

void MicroModem::HearBytes(const MicroModemHeard& heard) {
  MicroModemPacket packet;
  switch (DecodeMicroModemPacket(heard.bytes, &packet)) {
    case MicroModemVerdict::kForeign:
      ++counts_.foreign;
      return;
    case MicroModemVerdict::kDamagedHeader:
      ++counts_.damaged_headers;
      return;
    case MicroModemVerdict::kUnderstood:
      break;
  }
  const bool is_for_all = packet.destination == kMicroModemBroadcast && MayBeForAll(packet.kind);
  if (packet.source == address()) {
    ++counts_.own;
  } else if (packet.destination != address() && !is_for_all) {
    ++counts_.overheard;
  } else {
    HearPacket(packet, heard);
  }
}

void MicroModem::HearPacket(const MicroModemPacket& packet, const MicroModemHeard& heard) {
  if (packet.kind == MicroModemKind::kData && packet.rate == 0 &&
      !(awaited_ && awaited_->source == packet.source)) {
    ++counts_.no_cycle;
    return;
  }
  ++counts_.understood;
  const int64_t start_us = std::clamp(heard.start_us, now_us_ - kHour_us, now_us_);
  const ReceptionStatistics statistics = {.arrived_utc_us = Utc_us(start_us),
                                          .source = packet.source,
                                          .destination = packet.destination,
                                          .snr_db = heard.snr_db};
  const std::string from_to = Text(packet.source) + "," + Text(packet.destination);
  switch (packet.kind) {
    case MicroModemKind::kCycle:
      return HearCycle(packet, statistics);
    case MicroModemKind::kData:
      return HearData(packet, statistics);
    case MicroModemKind::kAck:
      HearAck(packet);
      break;
    case MicroModemKind::kPing:
      Say("CAMPA," + from_to);
      AnswerModem(MicroModemKind::kPingReply, packet.source, 0);
      break;
    case MicroModemKind::kPingReply: {
      const int64_t travel_us = std::clamp<int64_t>(heard.travel_us, 0, kHour_us);
      Say("CAMPR," + from_to + "," + FixedText(static_cast<double>(travel_us) / 1e6, 4));
      break;
    }
    case MicroModemKind::kMini: {
      const std::array<uint8_t, 2> value = {static_cast<uint8_t>(packet.value >> 8),
                                            static_cast<uint8_t>(packet.value & 0xFF)};
      Say("CAMUA," + from_to + "," + HexText(value));
      break;
    }
  }
  SayStatistics(statistics);
}

void MicroModem::HearCycle(const MicroModemPacket& packet, ReceptionStatistics statistics) {
  if (settings_.rxp == 1) Say("CARXP,0");
  Say(CycleText(packet));
  statistics.type = CstPacketType::kFsk;
  SayStatistics(statistics);
  if (packet.rate != 0) return;
  awaited_ = AwaitedData{.source = packet.source,
                         .destination = packet.destination,
                         .num_frames = packet.num_frames,
                         .until_us = now_us_ + settings_.pto * kSecond_us};
}

void MicroModem::HearData(const MicroModemPacket& packet, ReceptionStatistics statistics) {
  const bool is_fsk = packet.rate == 0;
  if (is_fsk) awaited_.reset();
  if (settings_.rxp == 1) Say(is_fsk ? "CARXP,0" : "CARXP,1");
  if (!is_fsk) Say(CycleText(packet));
  int acknowledged = 0;
  for (int i = 0; i < packet.num_frames; ++i) {
    const MicroModemFrame& frame = packet.frames[static_cast<size_t>(i)];
    if (frame.is_damaged) {
      Say("CAMSG,BAD_CRC," + Text(i + 1));
      ++statistics.num_bad_frames;
      continue;
    }
    Say("CARXD," + Text(packet.source) + "," + Text(packet.destination) +
        (frame.wants_ack ? ",1," : ",0,") + Text(i + 1) + "," + HexText(frame.bytes));
    if (frame.wants_ack) acknowledged |= 1 << i;
  }
  counts_.damaged_frames += statistics.num_bad_frames;
  statistics.mode = statistics.num_bad_frames > 0 ? CstMode::kBadCrc : CstMode::kGood;
  statistics.rate = packet.rate;
  statistics.type = is_fsk ? CstPacketType::kFsk : CstPacketType::kPsk;
  statistics.num_frames = packet.num_frames;
  SayStatistics(statistics);
  if (acknowledged != 0 && packet.destination != kMicroModemBroadcast) {
    AnswerModem(MicroModemKind::kAck, packet.source, acknowledged);
  }
}

void MicroModem::HearAck(const MicroModemPacket& packet) {
  for (int i = 0; i < kMaxMicroModemFrames; ++i) {
    if ((packet.value >> i & 1) == 0) continue;
    Say("CAACK," + Text(packet.source) + "," + Text(packet.destination) + "," + Text(i + 1) + ",1");
  }
}

void MicroModem::AnswerModem(MicroModemKind kind, int destination, int value) {
  if (!HasRoom()) {
    ++counts_.answers_dropped;
    return;
  }
  Send({.kind = kind, .source = address(), .destination = destination, .value = value}, {}, false);
}

}  // namespace shoal
