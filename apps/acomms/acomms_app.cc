#include "apps/acomms/acomms_app.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "apps/acomms/swarm_bytes.h"
#include "apps/acomms/swarm_setup.h"
#include "lib/check/check.h"
#include "lib/mission/swarm_plan.h"
#include "lib/run/own_nav.h"
#include "lib/swarm/message_frame.h"

namespace shoal {

namespace {

constexpr char kNoNav[] = "no NAV: slots pass unused";
constexpr char kBadNav[] = "NAV with values that messages cannot tell: ignored";

}  // namespace

AcommsApp::AcommsApp(const Mission& mission, const Vehicle& vehicle, Bus& bus)
    : name_(vehicle.name),
      leader_(mission.swarm.leader),
      plan_(PlanSwarm(mission).plan),
      start_utime_(mission.start_utime),
      bus_(bus),
      swarm_channel_(channels::Swarm(vehicle.name)),
      receiver_(MakeSwarmReceiver(mission, vehicle)),
      schedule_(MakeSwarmSchedule(mission, vehicle)),
      writer_(mission, vehicle) {
  helm_.waypoint_index = -1;
  Subscribe(bus, OwnNav(vehicle), [this](const nav_t& nav) { OnNav(nav); });
  Subscribe(bus, channels::HelmState(vehicle.name),
            [this](const helm_state_t& helm) { helm_ = helm; });
  Subscribe(bus, channels::AcousticRx(vehicle.name),
            [this](const acoustic_rx_t& packet) { arrived_.push_back(packet); });
}

void AcommsApp::OnNav(const nav_t& nav) {
  if (!MotionOf(nav)) {
    log_.Warn(kBadNav);
    return;
  }
  nav_ = nav;
  nav_is_new_ = true;
}

void AcommsApp::Hear(const acoustic_rx_t& packet, int64_t utime) {
  const std::optional<ResponseRequest> request_before = receiver_.state.request;
  const SwarmReception reception = Receive(packet.payload, utime - start_utime_, &receiver_);
  writer_.Count(packet.source, reception);
  if (reception.result == ReceptionResult::kRejected) return;
  const std::optional<ResponseRequest>& request = receiver_.state.request;
  if (request && request != request_before) schedule_.Take(*request);
}

void AcommsApp::Tick(int64_t utime) {
  utime_ = utime;
  const std::vector<acoustic_rx_t> arrived = std::exchange(arrived_, {});
  for (const acoustic_rx_t& packet : arrived) Hear(packet, utime);
  if (std::exchange(nav_is_new_, false)) nav_utime_ = utime;
  const bool has_nav = nav_utime_ && utime - *nav_utime_ <= kNavTimeout_us;
  if (const auto due = schedule_.Due(utime - start_utime_)) {
    if (has_nav) {
      Say(*due, utime);
      log_.Retract(kNoNav);
    } else {
      ++num_without_nav_;
      log_.Warn(kNoNav);
    }
  }
  if (!arrived.empty() || !swarm_utime_ || utime - *swarm_utime_ >= kSwarmInterval_us) {
    PublishSwarm(utime);
  }
}

void AcommsApp::Say(const DueMessage& due, int64_t utime) {
  const std::optional<Motion> own = MotionOf(nav_);
  SHOAL_CHECK(own.has_value(), "NAV was checked when it came");
  std::vector<uint8_t> bytes = SwarmBytes(due, {.own = *own,
                                                .next = NextOf(*own, helm_),
                                                .now_us = utime - start_utime_,
                                                .state = receiver_.state});
  if (receiver_.has_frames) bytes = EncodeFrame(bytes, sequence_++);
  acoustic_tx_t packet{};
  packet.utime = utime;
  packet.source = name_;
  packet.num_bytes = static_cast<int32_t>(bytes.size());
  packet.payload = std::move(bytes);
  Publish(bus_, tx_channel_, packet);
  ++num_said_;
  if (due.message != SwarmMessage::kBroadcastRequest) return;
  for (SwarmContact& member : receiver_.state.members) member.has_answered = false;
}

void AcommsApp::PublishSwarm(int64_t utime) {
  swarm_t swarm = writer_.Write(receiver_, utime);
  swarm.num_said = num_said_;
  Publish(bus_, swarm_channel_, swarm);
  swarm_utime_ = utime;
}

}  // namespace shoal
