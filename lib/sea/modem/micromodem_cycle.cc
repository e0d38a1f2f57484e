#include "lib/sea/modem/micromodem_cycle.h"

#include <string>
#include <utility>

#include "lib/base/time/time_units.h"
#include "lib/base/time/utc_time.h"

namespace shoal {

namespace {

/// From the end of a cycle packet to the request for data.
constexpr int64_t kPause_us = 100'000;
constexpr size_t kMaxEarlyFrames = 8;

}  // namespace

void MicroModemCycle::Start(const MicroModemPacket& packet, int num_wanted) {
  cycle_ = Cycle{.packet = packet, .num_wanted = num_wanted};
  if (packet.rate != 0) {
    AskForFrame();
    return;
  }
  cycle_->state = State::kAnnouncing;
  MicroModemPacket announcement = packet;
  announcement.kind = MicroModemKind::kCycle;
  announcement.num_frames = num_wanted;
  air_.Send(announcement, 0, true);
}

void MicroModemCycle::Abandon(std::string_view reason) {
  End(MicroModemError::kAbandoned, "CYCLE", reason);
}

void MicroModemCycle::Reboot() {
  const bool is_leaving = cycle_ && air_.is_sending_cycle() && cycle_->state == State::kSending;
  if (cycle_ && !is_leaving) Abandon("given up for CCMSC");
  cycle_.reset();  // CATXF reports what is leaving.
  early_.clear();
}

void MicroModemCycle::DropOldFrames() {
  std::erase_if(early_, [this](const EarlyFrame& early) {
    return unit_.now_us - early.given_us > unit_.settings.dto * kSecond_us;
  });
}

bool MicroModemCycle::HasRoomForEarlyFrame() const { return early_.size() < kMaxEarlyFrames; }

void MicroModemCycle::Give(int destination, MicroModemFrame frame) {
  const bool is_empty = frame.bytes.empty();
  if (is_asking() && is_empty) {
    SendData();
  } else if (is_asking()) {
    cycle_->packet.frames.push_back(std::move(frame));
    AskForFrame();
  } else if (!is_empty) {
    early_.push_back(
        {.destination = destination, .frame = std::move(frame), .given_us = unit_.now_us});
  }
}

void MicroModemCycle::OnTransmissionEnded() {
  if (!cycle_) return;
  if (cycle_->state == State::kAnnouncing) {
    cycle_->state = State::kPausing;
    cycle_->until_us = unit_.now_us + kPause_us;
  } else {
    cycle_.reset();
  }
}

void MicroModemCycle::OnTime() {
  if (!cycle_ || cycle_->until_us > unit_.now_us) return;
  if (cycle_->state == State::kPausing) {
    AskForFrame();
  } else if (cycle_->state == State::kAsking) {
    TimeOutRequest();
  }
}

std::optional<int64_t> MicroModemCycle::NextEvent_us() const {
  if (!cycle_ || (cycle_->state != State::kPausing && cycle_->state != State::kAsking)) {
    return std::nullopt;
  }
  return cycle_->until_us;
}

/// Uses what the host gave before it was asked, and asks for the rest.
void MicroModemCycle::AskForFrame() {
  MicroModemPacket& packet = cycle_->packet;
  const int max_bytes = kMicroModemRates[static_cast<size_t>(packet.rate)].max_frame_bytes;
  while (std::ssize(packet.frames) < cycle_->num_wanted && !early_.empty()) {
    EarlyFrame early = std::move(early_.front());
    early_.pop_front();
    if (early.destination != packet.destination || std::ssize(early.frame.bytes) > max_bytes) {
      unit_.WriteError("NMEA", MicroModemError::kBadField,
                       "data given before CCCYC does not fit it");
    } else {
      packet.frames.push_back(std::move(early.frame));
    }
  }
  if (std::ssize(packet.frames) == cycle_->num_wanted) {
    SendData();
    return;
  }
  cycle_->state = State::kAsking;
  cycle_->until_us = unit_.now_us + unit_.settings.dto * kSecond_us;
  unit_.Write("CADRQ," + ClockText(unit_.Utc_us()) + "," + std::to_string(packet.source) + "," +
              std::to_string(packet.destination) + "," + (packet.wants_ack ? "1," : "0,") +
              std::to_string(max_bytes) + "," + std::to_string(packet.frames.size() + 1));
}

void MicroModemCycle::SendData() {
  MicroModemPacket& packet = cycle_->packet;
  if (packet.frames.empty()) {
    End(MicroModemError::kNoData, "CYCLE", "no data and nothing sent");
    return;
  }
  cycle_->state = State::kSending;
  packet.num_frames = static_cast<int>(packet.frames.size());
  size_t num_bytes = 0;
  for (const MicroModemFrame& frame : packet.frames) num_bytes += frame.bytes.size();
  air_.Send(packet, static_cast<int>(num_bytes), true);
}

void MicroModemCycle::End(MicroModemError code, std::string_view module, std::string_view reason) {
  cycle_.reset();
  unit_.WriteError(module, code, reason);
}

void MicroModemCycle::TimeOutRequest() {
  const std::string reason =
      "no data for frame " + std::to_string(cycle_->packet.frames.size() + 1);
  if (cycle_->packet.frames.empty()) {
    End(MicroModemError::kNoData, "DATA_TIMEOUT", reason);
    return;
  }
  unit_.WriteError("DATA_TIMEOUT", MicroModemError::kNoData, reason);
  SendData();
}

}  // namespace shoal
