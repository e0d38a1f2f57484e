#include "apps/shore_broker/shore_broker_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/shore_broker/broker_page.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

namespace {

std::vector<std::string> NamesOf(const std::vector<Vehicle>& vehicles) {
  std::vector<std::string> names;
  for (const Vehicle& vehicle : vehicles) names.push_back(vehicle.name);
  return names;
}

bool AllNumbersAreFinite(const node_report_t& report) {
  for (const double number :
       {report.x_m, report.y_m, report.depth_m, report.altitude_m, report.lat_deg, report.lon_deg,
        report.speed_mps, report.heading_deg, report.speed_over_ground_mps,
        report.course_over_ground_deg, report.length_m}) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

}  // namespace

ShoreBrokerApp::ShoreBrokerApp(const Mission& mission, Bus& bus)
    : bus_(bus), router_(mission.comms, NamesOf(mission.vehicles)), fates_(bus) {
  const auto keep_report = [this](bool from_outside) {
    return [this, from_outside](const Message& message) {
      reports_.push_back({.raw = Keep(message), .from_outside = from_outside});
    };
  };
  bus.SubscribeBytes(channels::NodeReportLocal().name, keep_report(false));
  bus.SubscribeBytes(channels::NodeReportFromOutside().name, keep_report(true));

  const auto keep_control = [this](double RoutingRules::*rule) {
    return [this, rule](const unc_control_t& control) {
      controls_.push_back({.rule = rule, .control = control});
    };
  };
  Subscribe(bus, channels::UncCommsRange(), keep_control(&RoutingRules::comms_range_m));
  Subscribe(bus, channels::UncStaleTime(), keep_control(&RoutingRules::stale_time_s));

  bus.SubscribeBytes(channels::HelmCommandAll().name,
                     [this](const Message& message) { commands_.push_back(Keep(message)); });
}

void ShoreBrokerApp::Tick(int64_t utime) {
  now_utime_ = utime;
  if (!started_) start_utime_ = utime;
  started_ = true;

  for (const WaitingControl& waiting : controls_) ApplyControl(utime, waiting);
  HandOnCommands(utime);
  std::erase_if(reports_, [&](WaitingReport& report) { return !TakeIn(utime, &report); });
  for (const WaitingReport& report : reports_) RouteOne(utime, report);
  fates_.Flush(utime);
  Forget(utime);

  controls_.clear();
  commands_.clear();
  reports_.clear();
  arena_.clear();
}

ShoreBrokerApp::Waiting ShoreBrokerApp::Keep(const Message& message) {
  const Waiting waiting = {.begin = arena_.size(), .size = message.data.size()};
  arena_.insert(arena_.end(), message.data.begin(), message.data.end());
  return waiting;
}

std::span<const uint8_t> ShoreBrokerApp::BytesOf(const Waiting& waiting) const {
  return std::span(arena_).subspan(waiting.begin, waiting.size);
}

void ShoreBrokerApp::ApplyControl(int64_t utime, const WaitingControl& waiting) {
  const bool is_range = waiting.rule == &RoutingRules::comms_range_m;
  const std::string_view channel = is_range ? "UNC_COMMS_RANGE" : "UNC_STALE_TIME";
  double& rule = router_.rules().*waiting.rule;
  const double value = waiting.control.value;
  if (!std::isfinite(value)) {
    log_.Warn(fmt::format("{} refused: {} is impossible; {:g} stays", channel, value, rule));
  } else if (!waiting.control.vehicle.empty()) {
    log_.Warn(fmt::format("{} refused: it holds for all, not for one vehicle; {:g} stays", channel,
                          rule));
  } else {
    log_.Event(utime, fmt::format("{}: {:g} (was {:g})", channel, value, rule));
    rule = value;
  }
}

void ShoreBrokerApp::HandOnCommands(int64_t utime) {
  for (const Waiting& waiting : commands_) {
    helm_command_t command;
    if (!Decode(BytesOf(waiting), &command)) {
      bus_.CountUndecodable(channels::HelmCommandAll().name);
      log_.Warn("HELM_COMMAND: undecodable bytes dropped");
      continue;
    }
    ++num_commands_handed_on_;
    log_.Event(utime, fmt::format("HELM_COMMAND handed on: {}", Printable(command.command)));
    for (const auto& [key, contact] : router_.contacts()) {
      if (!contact.of_mission && !contact.known) continue;
      bus_.PublishBytes(channels::HelmCommand(contact.name).name, BytesOf(waiting));
    }
  }
}

/// Returns false where the report goes no further.
bool ShoreBrokerApp::TakeIn(int64_t utime, WaitingReport* report) {
  if (!Decode(BytesOf(report->raw), &report_)) {
    const std::string channel = report->from_outside ? channels::NodeReportFromOutside().name
                                                     : channels::NodeReportLocal().name;
    bus_.CountUndecodable(channel);
    log_.Warn(channel + ": undecodable bytes dropped");
    return false;
  }
  const int num_known = router_.num_known();
  report->position_m = {report_.x_m, report_.y_m, report_.depth_m};
  report->admission =
      AllNumbersAreFinite(report_)
          ? router_.Admit(
                {.name = report_.name, .group = report_.group, .position_m = report->position_m},
                utime)
          : router_.Refuse(report_.name);
  if (router_.num_known() > num_known) {
    log_.Event(utime, fmt::format("{} is known now", report_.name));
  }
  if (!report->admission.refused) return true;

  const Cause cause = *report->admission.refused;
  log_.Warn(cause == Cause::kInvalid
                ? "invalid node report refused: illegal name or impossible number"
                : "node report refused: too many vehicles that are not of the mission");
  fates_.Add(
      utime,
      {.source = report->admission.source, .number = report->admission.number, .cause = cause},
      IsLegalVehicleName(report_.name) ? report_.name : "", "");
  return false;
}

void ShoreBrokerApp::RouteOne(int64_t utime, const WaitingReport& report) {
  decisions_.clear();
  router_.Route(report.admission, report.position_m, utime, &decisions_);
  const std::string& source = router_.contact(report.admission.source).name;
  for (const Decision& decision : decisions_) {
    fates_.Add(utime, decision, source, router_.contact(decision.destination).name);
    if (decision.cause == Cause::kDelivered) {
      bus_.PublishBytes(ReportChannel(decision.destination), BytesOf(report.raw));
    }
  }
}

void ShoreBrokerApp::Forget(int64_t utime) {
  std::vector<int32_t> forgotten;
  router_.ForgetSilent(utime, &forgotten);
  for (const int32_t index : forgotten) {
    log_.Event(utime, fmt::format("{} is forgotten", router_.contact(index).name));
  }
}

const std::string& ShoreBrokerApp::ReportChannel(int32_t index) {
  const auto place = static_cast<size_t>(index);
  if (place >= report_channels_.size()) report_channels_.resize(place + 1);
  ReceiverChannel& channel = report_channels_[place];
  const std::string& vehicle = router_.contact(index).name;
  if (channel.vehicle != vehicle) {
    channel = {.vehicle = vehicle, .name = channels::NodeReport(vehicle).name};
  }
  return channel.name;
}

StatusPage ShoreBrokerApp::Status() const {
  StatusPage page;
  page.text = FormatBrokerPage(router_, {.start_utime = start_utime_,
                                         .now_utime = now_utime_,
                                         .num_commands_handed_on = num_commands_handed_on_,
                                         .num_undecodable = bus_.counters().undecodable});
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
