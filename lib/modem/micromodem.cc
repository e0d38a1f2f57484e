#include "lib/modem/micromodem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/check/check.h"
#include "lib/check/time_units.h"
#include "lib/modem/utc_time.h"

namespace shoal {
namespace {

/// From the end of a cycle packet to the request for data.
constexpr int64_t kPause_us = 100'000;
constexpr int64_t kMaxAir_us = 3600 * kSecond_us;
constexpr int64_t kYear2200_us = 7'258'118'400 * kSecond_us;

int64_t Air_us(size_t num_bytes, double bps) {
  if (!(bps > 0)) return 1;
  const double air_us = std::ceil(8e6 * static_cast<double>(num_bytes) / bps);
  return static_cast<int64_t>(std::clamp(air_us, 1.0, static_cast<double>(kMaxAir_us)));
}

/// Returns how many bytes take as long at `water_bps` as `num_bytes` at `bps`; never fewer.
size_t FilledUp(size_t num_bytes, double bps, double water_bps, size_t max_bytes) {
  max_bytes = std::min<size_t>(max_bytes, 65'535);
  const double filled = std::floor(static_cast<double>(num_bytes) * water_bps / bps);
  if (!(filled > static_cast<double>(num_bytes)) || num_bytes >= max_bytes) return num_bytes;
  return static_cast<size_t>(std::min(filled, static_cast<double>(max_bytes)));
}

}  // namespace

MicroModem::MicroModem(const MicroModemOptions& options) : options_(options) {
  SHOAL_CHECK(options.address >= 0 && options.address <= kMaxMicroModemAddress,
              "the caller has checked the address");
  settings_.src = options.address;
  SetClock(options.utc_at_zero_us, 0);
}

void MicroModem::SetClock(int64_t utc_us, int64_t now_us) {
  clock_offset_us_ = std::clamp<int64_t>(utc_us, 0, kYear2200_us) - now_us;
}

int64_t MicroModem::Utc_us(int64_t time_us) const { return clock_offset_us_ + time_us; }

std::optional<int64_t> MicroModem::NextEvent_us() const {
  std::optional<int64_t> next_us;
  const auto consider = [&next_us](int64_t time_us) {
    next_us = std::min(next_us.value_or(time_us), time_us);
  };
  if (on_air_) consider(on_air_->end_us);
  if (cycle_ && (cycle_->state == CycleState::kPausing || cycle_->state == CycleState::kAsking)) {
    consider(cycle_->until_us);
  }
  if (awaited_) consider(awaited_->until_us);
  if (boot_us_) consider(*boot_us_);
  if (transponders_us_) consider(*transponders_us_);
  return next_us;
}

MicroModemOutput MicroModem::Advance(int64_t now_us) {
  CatchUp(now_us);
  return Finish();
}

void MicroModem::CatchUp(int64_t now_us) {
  for (auto next_us = NextEvent_us(); next_us && *next_us <= now_us; next_us = NextEvent_us()) {
    now_us_ = std::max(now_us_, *next_us);
    DoWhatIsDue();
  }
  now_us_ = std::max(now_us_, now_us);
}

void MicroModem::DoWhatIsDue() {
  if (on_air_ && on_air_->end_us <= now_us_) EndTransmission();
  if (boot_us_ && *boot_us_ <= now_us_) {
    boot_us_.reset();
    SayRevision();
  }
  if (transponders_us_ && *transponders_us_ <= now_us_) {
    transponders_us_.reset();
    SayTransponderTimes();
  }
  if (awaited_ && awaited_->until_us <= now_us_) TimeOutAwaitedData();
  if (!cycle_ || cycle_->until_us > now_us_) return;
  if (cycle_->state == CycleState::kPausing) {
    AskForFrame();
  } else if (cycle_->state == CycleState::kAsking) {
    TimeOutRequest();
  }
}

/// A packet starts at the caller's time, never at that of an event which has passed since his last
/// call: the water counts from when it is given the bytes.
MicroModemOutput MicroModem::Finish() {
  if (!on_air_ && !waiting_.empty()) StartTransmission();
  return std::exchange(output_, {});
}

void MicroModem::Send(const MicroModemPacket& packet, std::optional<int> told_bytes,
                      bool is_of_cycle) {
  waiting_.push_back({.bytes = EncodeMicroModemPacket(packet),
                      .rate = packet.rate,
                      .told_bytes = told_bytes,
                      .is_of_cycle = is_of_cycle});
}

void MicroModem::StartTransmission() {
  Outgoing next = std::move(waiting_.front());
  waiting_.pop_front();
  const int bps = kMicroModemRates[static_cast<size_t>(next.rate)].bps;
  const int64_t by_rate_us = Air_us(next.bytes.size(), bps);
  next.bytes.resize(
      FilledUp(next.bytes.size(), bps, options_.water_bps, options_.max_packet_bytes));
  const int64_t air_us = std::max(by_rate_us, Air_us(next.bytes.size(), options_.water_bps));
  on_air_ = OnAir{
      .end_us = now_us_ + air_us, .told_bytes = next.told_bytes, .is_of_cycle = next.is_of_cycle};
  if (next.told_bytes && settings_.txp == 1) Say("CATXP," + std::to_string(*next.told_bytes));
  output_.to_water.push_back({.bytes = std::move(next.bytes), .air_us = air_us});
  ++counts_.sent;
}

void MicroModem::EndTransmission() {
  const OnAir ended = *on_air_;
  on_air_.reset();
  if (ended.told_bytes && settings_.txf == 1) Say("CATXF," + std::to_string(*ended.told_bytes));
  if (!ended.is_of_cycle || !cycle_) return;
  if (cycle_->state == CycleState::kAnnouncing) {
    cycle_->state = CycleState::kPausing;
    cycle_->until_us = now_us_ + kPause_us;
  } else {
    cycle_.reset();
  }
}

void MicroModem::StartCycle(const MicroModemPacket& packet, int num_wanted) {
  cycle_ = Cycle{.packet = packet, .num_wanted = num_wanted};
  if (packet.rate != 0) {
    AskForFrame();
    return;
  }
  cycle_->state = CycleState::kAnnouncing;
  MicroModemPacket announcement = packet;
  announcement.kind = MicroModemKind::kCycle;
  announcement.num_frames = num_wanted;
  Send(announcement, 0, true);
}

/// Uses what the host gave before it was asked, and asks for the rest.
void MicroModem::AskForFrame() {
  MicroModemPacket& packet = cycle_->packet;
  const int max_bytes = kMicroModemRates[static_cast<size_t>(packet.rate)].max_frame_bytes;
  while (std::ssize(packet.frames) < cycle_->num_wanted && !early_.empty()) {
    EarlyFrame early = std::move(early_.front());
    early_.pop_front();
    if (early.destination != packet.destination || std::ssize(early.frame.bytes) > max_bytes) {
      SayError("NMEA", ErrorCode::kBadField, "data given before CCCYC does not fit it");
    } else {
      packet.frames.push_back(std::move(early.frame));
    }
  }
  if (std::ssize(packet.frames) == cycle_->num_wanted) {
    SendData();
    return;
  }
  cycle_->state = CycleState::kAsking;
  cycle_->until_us = now_us_ + settings_.dto * kSecond_us;
  Say("CADRQ," + ClockText(Utc_us()) + "," + std::to_string(packet.source) + "," +
      std::to_string(packet.destination) + "," + (packet.wants_ack ? "1," : "0,") +
      std::to_string(max_bytes) + "," + std::to_string(packet.frames.size() + 1));
}

void MicroModem::SendData() {
  MicroModemPacket& packet = cycle_->packet;
  if (packet.frames.empty()) {
    EndCycle(ErrorCode::kNoData, "CYCLE", "no data and nothing sent");
    return;
  }
  cycle_->state = CycleState::kSending;
  packet.num_frames = static_cast<int>(packet.frames.size());
  size_t num_bytes = 0;
  for (const MicroModemFrame& frame : packet.frames) num_bytes += frame.bytes.size();
  Send(packet, static_cast<int>(num_bytes), true);
}

void MicroModem::EndCycle(ErrorCode code, std::string_view module, std::string_view reason) {
  cycle_.reset();
  SayError(module, code, reason);
}

void MicroModem::TimeOutRequest() {
  const std::string reason =
      "no data for frame " + std::to_string(cycle_->packet.frames.size() + 1);
  if (cycle_->packet.frames.empty()) {
    EndCycle(ErrorCode::kNoData, "DATA_TIMEOUT", reason);
    return;
  }
  SayError("DATA_TIMEOUT", ErrorCode::kNoData, reason);
  SendData();
}

void MicroModem::TimeOutAwaitedData() {
  const AwaitedData awaited = *awaited_;
  awaited_.reset();
  Say("CAMSG,PACKET_TIMEOUT," + std::to_string(settings_.pto));
  SayStatistics({.mode = CstMode::kTimeout,
                 .arrived_utc_us = Utc_us(),
                 .source = awaited.source,
                 .destination = awaited.destination,
                 .type = CstPacketType::kFsk,
                 .num_frames = awaited.num_frames,
                 .num_bad_frames = awaited.num_frames});
}

void MicroModem::Say(std::string_view body) { output_.to_host += NmeaSentence(body); }

void MicroModem::SayError(std::string_view module, ErrorCode code, std::string_view reason) {
  Say("CAERR," + ClockText(Utc_us()) + "," + std::string(module) + "," +
      std::to_string(static_cast<int>(code)) + "," + std::string(reason));
}

void MicroModem::SayRevision() {
  constexpr std::string_view kFirmware = "0.94.0.00";  // Of a Micro-Modem 1.
  if (settings_.rev == 0) return;
  for (const char* part : {"INIT", "AUV"}) {
    Say("CAREV," + ClockText(Utc_us()) + "," + part + "," + std::string(kFirmware));
  }
}

void MicroModem::SayStatistics(const ReceptionStatistics& statistics) {
  if (settings_.cst == 1) Say(CstText(statistics));
}

}  // namespace shoal
