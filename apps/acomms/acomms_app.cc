#include "apps/acomms/acomms_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "apps/acomms/swarm_bytes.h"
#include "apps/acomms/swarm_setup.h"
#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/message_frame.h"
#include "lib/mission/model/swarm_plan.h"
#include "lib/run/run/own_nav.h"

namespace shoal {

namespace {

constexpr char kNoNav[] = "no NAV: slots pass unused";
constexpr char kBadNav[] = "NAV with values outside the encodable range: ignored";

std::string_view Name(SwarmScheme scheme) {
  switch (scheme) {
    case SwarmScheme::kFdmaLf:
      return "fdma_lf";
    case SwarmScheme::kTdma:
      return "tdma";
    case SwarmScheme::kTdmaLf:
      break;
  }
  return "tdma_lf";
}

std::string PlanText(const SlotPlan& plan) {
  const std::string episode =
      fmt::format("{}, episode {:g} s", Name(plan.scheme), Seconds(plan.episode_us));
  if (plan.scheme == SwarmScheme::kTdmaLf) {
    return fmt::format("{}, request {:g} s, answer {:g} s", episode, Seconds(plan.broadcast_us),
                       Seconds(plan.response_us));
  }
  return fmt::format("{}, from member to member {:g} s", episode, Seconds(plan.offset_us));
}

/// How long a slot is kept at most: half of it, or a second.
int64_t LongestWait_us(const SlotPlan& plan, SwarmMessage message) {
  constexpr int64_t kSecond_us = 1'000'000;
  int64_t slot_us = plan.scheme == SwarmScheme::kTdma ? plan.offset_us : plan.episode_us;
  if (message == SwarmMessage::kBroadcastRequest) slot_us = plan.broadcast_us;
  if (message == SwarmMessage::kResponse) slot_us = plan.response_us;
  return std::max(plan.tick_us, std::min(kSecond_us, slot_us / 2));
}

/// When the broker has a report of each member, in mission time: before, it sends nothing of them.
int64_t FirstReports_us(const Mission& mission, const Vehicle& vehicle) {
  double first_s = 0;
  for (const Vehicle* member : SwarmMembers(mission, vehicle)) {
    if (member->reporter != Provider::kShoal) continue;
    first_s = std::max(first_s, 1 / member->reporter_options.rate_hz);
  }
  return Microseconds(first_s);
}

std::set<std::string, std::less<>> VehiclesOfOtherSwarms(const Mission& mission,
                                                         const Vehicle& vehicle) {
  std::set<std::string, std::less<>> names;
  for (const Vehicle& each : mission.vehicles) {
    const SwarmOptions* swarm = mission.SwarmOf(each);
    if (swarm != nullptr && swarm != mission.SwarmOf(vehicle)) names.insert(each.name);
  }
  return names;
}

std::string ContactText(const swarm_contact_t& contact, int64_t utime) {
  std::string text =
      fmt::format("    {:<16} {:<8}", contact.name, contact.is_target ? "leader" : "follower");
  if (!contact.is_heard) return text + " nothing received yet\n";
  if (!contact.is_known) {
    return text + " cannot be used" + (contact.is_silent ? ", silent\n" : "\n");
  }
  text += fmt::format("{:9.1f} s {:9.1f} {:9.1f} {:8.1f}", Seconds(utime - contact.report_utime),
                      contact.x_m, contact.y_m, contact.z_m);
  if (contact.is_silent) text += "  silent";
  for (const std::string& recovered : contact.recovered) text += "  " + recovered;
  return text + "\n";
}

}  // namespace

AcommsApp::AcommsApp(const Mission& mission, const Vehicle& vehicle, Bus& bus)
    : name_(vehicle.name),
      leader_(OwnSwarm(mission, vehicle).leader),
      swarm_name_(OwnSwarm(mission, vehicle).name),
      others_(VehiclesOfOtherSwarms(mission, vehicle)),
      plan_(PlanSwarm(mission, OwnSwarm(mission, vehicle)).plan),
      start_utime_(mission.start_utime),
      bus_(bus),
      swarm_channel_(channels::Swarm(vehicle.name)),
      record_channel_(channels::Acomms(vehicle.name)),
      receiver_(MakeSwarmReceiver(mission, vehicle)),
      schedule_(MakeSwarmSchedule(mission, vehicle)),
      writer_(mission, vehicle),
      record_(vehicle.name, writer_),
      propeller_(vehicle.model),
      first_reports_us_(FirstReports_us(mission, vehicle)) {
  helm_.waypoint_index = -1;
  Subscribe(bus, OwnNav(vehicle), [this](const nav_t& nav) { OnNav(nav); });
  Subscribe(bus, channels::HelmState(vehicle.name),
            [this](const helm_state_t& helm) { helm_ = helm; });
  if (receiver_.state.is_leader && propeller_.is_needed()) {
    Subscribe(bus, channels::Actuators(vehicle.name),
              [this](const actuators_t& actuators) { propeller_.OnActuators(actuators); });
  }
  Subscribe(bus, channels::AcousticRx(vehicle.name),
            [this](const acoustic_rx_t& packet) { arrived_.push_back(packet); });
}

void AcommsApp::OnNav(const nav_t& nav) {
  if (!MotionOf(nav, receiver_.limits)) {
    log_.Warn(kBadNav);
    return;
  }
  nav_ = nav;
  nav_is_new_ = true;
}

void AcommsApp::ReceivePacket(const acoustic_rx_t& packet, int64_t utime) {
  const std::optional<ResponseRequest> request_before = receiver_.state.request;
  const SwarmReception reception = Receive(packet.payload, utime - start_utime_, &receiver_);
  writer_.Count(packet.source, reception);
  if (reception.reason == RejectReason::kOtherGroup && others_.contains(packet.source)) {
    ++num_of_others_;  // As it should be: no event.
    return;
  }
  for (const std::string& line : record_.Note(packet.source, reception, utime)) {
    log_.Event(utime, line);
  }
  if (reception.result == ReceptionResult::kRejected) return;
  const std::optional<ResponseRequest>& request = receiver_.state.request;
  if (request && request != request_before) schedule_.Take(*request);
}

void AcommsApp::Tick(int64_t utime) {
  utime_ = utime;
  const std::vector<acoustic_rx_t> arrived = std::exchange(arrived_, {});
  for (const acoustic_rx_t& packet : arrived) ReceivePacket(packet, utime);
  if (std::exchange(nav_is_new_, false)) nav_utime_ = utime;
  UseSlot(utime);
  if (!arrived.empty() || !swarm_utime_ || utime - *swarm_utime_ >= kSwarmInterval_us) {
    PublishSwarm(utime);
  }
  const auto change =
      record_.TakeChange(receiver_, num_without_nav_, schedule_.num_missed(), utime);
  if (change) Publish(bus_, record_channel_, *change);
}

void AcommsApp::UseSlot(int64_t utime) {
  if (const auto due = schedule_.Due(utime - start_utime_)) {
    if (kept_) LetPass();
    kept_ = *due;
  }
  if (!kept_) return;
  const bool has_nav = nav_utime_ && utime - *nav_utime_ <= kNavTimeout_us;
  const int64_t now_us = utime - start_utime_;
  const bool may_wait = now_us - kept_->slot_us < LongestWait_us(plan_, kept_->message);
  if (has_nav && may_wait && now_us < first_reports_us_) return;
  if (has_nav) {
    DueMessage due = *std::exchange(kept_, std::nullopt);
    // Followers that are asked late answer later by as much.
    due.response_start_us +=
        std::max<int64_t>(0, now_us - due.slot_us) / plan_.tick_us * plan_.tick_us;
    Send(due, utime);
    log_.Retract(kNoNav);
    return;
  }
  if (nav_utime_ || !may_wait) LetPass();
}

void AcommsApp::LetPass() {
  kept_.reset();
  ++num_without_nav_;
  log_.Warn(kNoNav);
}

void AcommsApp::Send(const DueMessage& due, int64_t utime) {
  const std::optional<Motion> own = MotionOf(nav_, receiver_.limits);
  SHOAL_CHECK(own.has_value(), "NAV was checked when it came");
  std::vector<uint8_t> bytes = SwarmBytes(
      due, {.own = *own,
            .next = NextOf(*own, helm_, propeller_.PlanOf(*own, utime), receiver_.limits),
            .now_us = utime - start_utime_,
            .state = receiver_.state});
  if (receiver_.has_frames) bytes = EncodeFrame(bytes, sequence_++);
  acoustic_tx_t packet{};
  packet.utime = utime;
  packet.source = name_;
  packet.num_bytes = static_cast<int32_t>(bytes.size());
  packet.payload = std::move(bytes);
  Publish(bus_, tx_channel_, packet);
  ++num_sent_;
  if (due.message != SwarmMessage::kBroadcastRequest) return;
  for (SwarmContact& member : receiver_.state.members) member.has_answered = false;
}

void AcommsApp::PublishSwarm(int64_t utime) {
  swarm_t swarm = writer_.Write(receiver_, utime);
  swarm.num_said = num_sent_;
  Publish(bus_, swarm_channel_, swarm);
  swarm_utime_ = utime;
}

std::string AcommsApp::SwarmText() const {
  if (swarm_name_.empty()) return "";
  return fmt::format(", swarm {} (group_id {})", swarm_name_,
                     static_cast<char>(receiver_.state.group_id));
}

StatusPage AcommsApp::Status() const {
  const int64_t utime = utime_.value_or(start_utime_);
  const swarm_t swarm = writer_.Write(receiver_, utime);
  StatusPage page;
  page.text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({}), leader {}{}\n"
      "    Slots: {}\n"
      "    Frames: {}\n"
      "Sent: {} messages; {} slots passed without NAV, {} requests unanswered\n"
      "Known:           role     age of report    x [m]     y [m]    z [m]\n",
      name_, receiver_.state.is_leader ? "leads" : "follows", leader_, SwarmText(), PlanText(plan_),
      receiver_.has_frames ? "on" : "off", num_sent_, num_without_nav_, schedule_.num_missed());
  for (const swarm_contact_t& contact : swarm.contacts) page.text += ContactText(contact, utime);
  page.text += "Received from:   received   clean  recovered  rejected\n";
  for (const swarm_source_t& source : swarm.sources) {
    page.text += fmt::format("    {:<16} {:>4} {:>7} {:>10} {:>9}\n", source.name, source.received,
                             source.clean, source.recovered, source.rejected);
  }
  if (!others_.empty()) {
    page.text += fmt::format("    messages of other swarms dropped: {}\n", num_of_others_);
  }
  for (const auto& [id, count] : receiver_.counts.frames) {
    page.text += fmt::format("    frames of {}: {} received, {} lost, {} repeated, {} restarts\n",
                             writer_.NameOfId(id), count.received, count.lost, count.repeated,
                             count.restarted);
  }
  for (const swarm_count_t& count : swarm.counts) {
    page.text += fmt::format("    {} {} times: {}{}{}\n", count.outcome, count.count, count.field,
                             count.field.empty() ? "" : " by ", count.by);
  }
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
