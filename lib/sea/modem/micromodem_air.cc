#include "lib/sea/modem/micromodem_air.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace shoal {

namespace {

constexpr int64_t kMaxAir_us = 3'600'000'000;

int64_t Air_us(size_t num_bytes, double bps) {
  const double air_us = std::ceil(8e6 * static_cast<double>(num_bytes) / bps);
  return static_cast<int64_t>(std::clamp(air_us, 1.0, static_cast<double>(kMaxAir_us)));
}

}  // namespace

void MicroModemAir::Send(const MicroModemPacket& packet, std::optional<int> shown_bytes,
                         bool is_of_cycle) {
  waiting_.push_back({.bytes = EncodeMicroModemPacket(packet),
                      .rate = packet.rate,
                      .shown_bytes = shown_bytes,
                      .is_of_cycle = is_of_cycle});
}

void MicroModemAir::StartNext() {
  if (on_air_ || waiting_.empty()) return;
  Outgoing next = std::move(waiting_.front());
  waiting_.pop_front();
  const int bps = kMicroModemRates[static_cast<size_t>(next.rate)].bps;
  const int64_t air_us = Air_us(next.bytes.size() + unit_.options.more_bytes, bps);
  on_air_ = OnAir{.end_us = unit_.now_us + air_us + kPacketGap_us,
                  .shown_bytes = next.shown_bytes,
                  .is_of_cycle = next.is_of_cycle};
  if (next.shown_bytes && unit_.settings.txp == 1) {
    unit_.Write("CATXP," + std::to_string(*next.shown_bytes));
  }
  unit_.output.to_water.push_back({.bytes = std::move(next.bytes), .bps = bps, .air_us = air_us});
  ++unit_.counts.sent;
}

bool MicroModemAir::EndWhatIsOver() {
  if (!on_air_ || on_air_->end_us > unit_.now_us) return false;
  const OnAir ended = *on_air_;
  on_air_.reset();
  if (ended.shown_bytes && unit_.settings.txf == 1) {
    unit_.Write("CATXF," + std::to_string(*ended.shown_bytes));
  }
  return ended.is_of_cycle;
}

void MicroModemAir::DropWaiting() {
  waiting_.clear();
  if (on_air_) on_air_->is_of_cycle = false;
}

std::optional<int64_t> MicroModemAir::NextEvent_us() const {
  if (!on_air_) return std::nullopt;
  return on_air_->end_us;
}

}  // namespace shoal
