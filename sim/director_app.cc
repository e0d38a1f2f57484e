#include "sim/director_app.h"

#include <fmt/format.h>

#include <string_view>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/control_message.h"
#include "lib/comms/routing/control.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/model/event_text.h"
#include "lib/run/verdict/mission_verdict.h"
#include "lib/run/verdict/summary.h"

namespace shoal {

namespace {
constexpr std::string_view kTooManyControls =
    "UNC_* of one more vehicle not kept: a broker that starts again will not get it";

/// False for what only an unregistered participant sends: no mission has as many messages.
bool CanBeCount(int64_t count) { return count >= 0 && count <= 1'000'000'000'000; }

}  // namespace

DirectorApp::DirectorApp(const Mission& mission, Bus& bus, Fates fates)
    : mission_(mission), bus_(bus), judge_(mission), is_done_(mission.vehicles.size()) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const std::string& name = mission.vehicles[i].name;
    Subscribe(bus, channels::Nav(name), [this, i](const nav_t& nav) {
      if (judge_.TakeNav(i, {nav.x_m, nav.y_m, nav.z_m}, nav.altitude_m) &&
          judge_.TakeMotion(i, nav.heading_deg, nav.speed_mps)) {
        return;
      }
      log_.Warn(fmt::format("NAV of {} dropped: it holds an impossible number",
                            mission_.vehicles[i].name));
    });
    if (mission.vehicles[i].navigation.is_fitted) {
      Subscribe(bus, channels::EstimatedNav(name), [this, i](const nav_t& nav) {
        judge_.TakeEstimate(i, {nav.x_m, nav.y_m});
      });
    }
    Subscribe(bus, channels::HelmState(name), [this, i](const helm_state_t& helm) {
      HelmFacts facts = {.state = helm.state, .task = helm.task, .laps_done = helm.laps_done};
      if (helm.waypoint_index >= 0) facts.cross_track_error_m = helm.cross_track_error_m;
      is_done_[i] = helm.state == "DRIVE" && helm.task == kEndOfTasks;
      judge_.TakeHelm(i, facts, last_utime_.value_or(mission_.start_utime));
    });
    if (mission.SwarmOf(mission.vehicles[i]) == nullptr) continue;
    Subscribe(bus, channels::Swarm(name), [this, i](const swarm_t& swarm) { TakeSwarm(i, swarm); });
  }
  // A vehicle that is simulated elsewhere has no NAV: its own reports are all there is.
  Subscribe(bus, channels::NodeReportFromOutside(), [this](const node_report_t& report) {
    for (size_t i = 0; i < mission_.vehicles.size(); ++i) {
      const Vehicle& vehicle = mission_.vehicles[i];
      if (vehicle.sim != Provider::kNone || vehicle.name != report.name) continue;
      judge_.TakeNav(i, {report.x_m, report.y_m, report.depth_m}, report.altitude_m);
      judge_.TakeMotion(i, report.heading_deg, report.speed_mps);
    }
  });
  if (fates == Fates::kFromBus) {
    bus.SubscribeBytes(channels::CommsFates().name,
                       [this](const Message& message) { TakeFates(message); });
  }
  if (mission.acoustics.is_used) {
    const auto sent = [this](const std::string& source) {
      judge_.tally().acoustic().AddSent(VehicleKey(source));
    };
    Subscribe(bus, channels::AcousticTx(),
              [sent](const acoustic_tx_t& packet) { sent(packet.source); });
    Subscribe(bus, channels::AcousticTxOn(),
              [sent](const acoustic_tx_on_t& packet) { sent(packet.source); });
    Subscribe(bus, channels::ModemTx(), [sent](const modem_tx_t& packet) { sent(packet.source); });
  }
  for (const ControlRow& row : ControlTable()) {
    Subscribe(bus, channels::Control(row), [this, &row](const unc_control_t& control) {
      if (!controls_.Keep(row, control)) log_.Warn(kTooManyControls);
    });
  }
  Subscribe(bus, channels::UncControlsReq(),
            [this](const unc_controls_req_t&) { controls_wanted_ = true; });
}

/// What another swarm sends is dropped by its group_id: that is not a failure between two vehicles.
void DirectorApp::TakeSwarm(size_t vehicle, const swarm_t& swarm) {
  const SwarmOptions* own = mission_.SwarmOf(mission_.vehicles[vehicle]);
  for (const swarm_source_t& source : swarm.sources) {
    const Vehicle* sender = mission_.FindVehicle(source.name);
    if (sender == nullptr || mission_.SwarmOf(*sender) != own || !CanBeCount(source.clean) ||
        !CanBeCount(source.recovered) || !CanBeCount(source.rejected)) {
      continue;
    }
    judge_.TakeSwarm(
        vehicle, sender->name,
        {.clean = source.clean, .recovered = source.recovered, .rejected = source.rejected});
  }
}

void DirectorApp::Tick(int64_t utime) {
  EndLastStep();
  last_utime_ = utime;
  AnswerControlsRequest(utime);
  LookForTheEnd(utime);
  const double now_s = Seconds(utime - mission_.start_utime);
  for (; next_event_ < mission_.events.size(); ++next_event_) {
    const Event& event = mission_.events[next_event_];
    if (now_s < event.at_s) break;
    const bool is_published =
        std::visit([&](const auto& what) { return PublishEvent(utime, what); }, event.what);
    if (is_published) log_.Event(utime, EventText(event));
  }
}

void DirectorApp::End() { EndLastStep(); }

void DirectorApp::LookForTheEnd(int64_t utime) {
  size_t num_waited_for = 0;
  size_t num_done = 0;
  for (size_t i = 0; i < mission_.vehicles.size(); ++i) {
    if (mission_.vehicles[i].helm_options.end_of_tasks != Ending::kEndMission) continue;
    ++num_waited_for;
    if (is_done_[i]) ++num_done;
  }
  if (ends_mission_ || num_waited_for == 0 || num_done < num_waited_for) return;
  ends_mission_ = true;
  log_.Event(utime, fmt::format("the mission ends: the tasks of {} are done",
                                num_done == 1 ? "its vehicle" : "its vehicles"));
}

void DirectorApp::EndLastStep() {
  if (last_utime_) judge_.EndStep(*last_utime_);
}

void DirectorApp::TakeFates(const Message& message) {
  if (message.publisher.empty()) {
    log_.Warn(
        "COMMS_FATES of an unregistered participant dropped: only a broker of the mission decides");
    return;
  }
  if (!Decode(message.data, &fates_message_)) {
    bus_.CountUndecodable(message.channel);
    return;
  }
  judge_.tally().Take(fates_message_.fates);
}

bool DirectorApp::PublishEvent(int64_t utime, const CommandEvent& event) {
  helm_command_t command;
  command.utime = utime;
  command.command = event.command;
  command.argument = event.argument;
  command.num_values = static_cast<int32_t>(event.values.size());
  command.values = event.values;
  for (const Vehicle* vehicle : mission_.VehiclesNamed(event.vehicle)) {
    Publish(bus_, channels::HelmCommand(vehicle->name), command);
  }
  return true;
}

bool DirectorApp::PublishEvent(int64_t utime, const SimCommandEvent& event) {
  sim_command_t command;
  command.utime = utime;
  command.command = event.command;
  command.num_values = static_cast<int32_t>(event.values.size());
  command.values = event.values;
  for (const Vehicle* vehicle : mission_.VehiclesNamed(event.vehicle)) {
    Publish(bus_, channels::SimCommand(vehicle->name), command);
  }
  return true;
}

bool DirectorApp::PublishEvent(int64_t utime, const RuleEvent& event) {
  unc_control_t control;
  control.utime = utime;
  control.vehicle = event.vehicle;
  SetValue(event.value, &control);
  const ControlRow* row = FindControl(event.rule);
  if (row == nullptr) {
    log_.Warn(fmt::format("event dropped: there is no rule '{}'", event.rule));
    return false;
  }
  Publish(bus_, channels::Control(*row), control);  // Received, and kept, in the next step.
  return true;
}

bool DirectorApp::PublishEvent(int64_t utime, const MessageEvent& event) {
  node_message_t message;
  message.utime = utime;
  message.src_node = event.src_node;
  message.src_app = "shoal";
  message.dest_node = event.dest_node;
  message.dest_group = event.dest_group;
  message.var_name = event.var_name;
  message.string_val = event.string_val;
  message.double_val = event.double_val.value_or(0);
  message.is_double = event.double_val ? 1 : 0;
  message.ack_requested = event.ack ? 1 : 0;
  // Its node_reporter gives an acknowledged message its ack_id, and repeats it.
  Publish(bus_,
          event.ack ? channels::MediatedMessage(event.src_node) : channels::NodeMessageLocal(),
          message);
  return true;
}

void DirectorApp::AnswerControlsRequest(int64_t utime) {
  if (!controls_wanted_) return;
  controls_wanted_ = false;
  unc_controls_t answer = controls_.All();
  answer.utime = utime;
  log_.Event(utime, fmt::format("UNC_CONTROLS: {} published on request", answer.num_controls));
  Publish(bus_, channels::UncControls(), answer);
}

int64_t DirectorApp::num_delivered() const {
  return fates(Kind::kReport).Count(FateCounts::kAll, FateCounts::kAll, "delivered");
}

int64_t DirectorApp::num_blocked() const {
  return fates(Kind::kReport).CountOffered(FateCounts::kAll, FateCounts::kAll) - num_delivered();
}

std::string DirectorApp::Summary(bool complete) const {
  return Summarize(mission_, judge_, complete);
}

std::string DirectorApp::VerdictText(double end_s, bool complete) const {
  return TextOf(VerdictOf(mission_, judge_, end_s, complete));
}

bool DirectorApp::Passed() const { return judge_.Passed(); }

StatusPage DirectorApp::Status() const {
  StatusPage page;
  page.text = fmt::format("Mission: {} ({})\nSeed: {}\nEvents published: {} of {}\n\n{}",
                          mission_.name, mission_.file, mission_.seed, next_event_,
                          mission_.events.size(), Summary(false));
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
