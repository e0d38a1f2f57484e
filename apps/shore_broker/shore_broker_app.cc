#include "apps/shore_broker/shore_broker_app.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/shore_broker/apply_control.h"
#include "apps/shore_broker/broker_page.h"
#include "apps/shore_broker/message_checks.h"
#include "lib/check/check.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

namespace {

/// A step for the question, one for the answer; the rest is for a launcher that is slow.
constexpr double kHold_s = 1;
/// `--warp max`, for those who watch: such missions run some 100 times as fast as real time.
constexpr double kMaxWarp = 100;
}  // namespace

ShoreBrokerApp::ShoreBrokerApp(BrokerSetup setup, Bus& bus)
    : setup_(std::move(setup)),
      bus_(bus),
      router_(setup_.rules, setup_.seed, setup_.vehicles),
      water_(setup_),
      fates_(bus),
      pulses_(bus),
      warp_(kMaxWarp) {
  for (const auto& [name, factors] : setup_.factors) router_.SetFactors(name, factors);

  const auto keep_report = [this](bool from_outside) {
    return [this, from_outside](const Message& message) {
      reports_.push_back({.raw = Keep(message, from_outside)});
    };
  };
  bus.SubscribeBytes(channels::NodeReportLocal().name, keep_report(false));
  bus.SubscribeBytes(channels::NodeReportFromOutside().name, keep_report(true));
  const auto keep = [this](std::vector<Waiting>* list, bool from_outside) {
    return [this, list, from_outside](const Message& message) {
      list->push_back(Keep(message, from_outside));
    };
  };
  bus.SubscribeBytes(channels::NodeMessageLocal().name, keep(&messages_, false));
  bus.SubscribeBytes(channels::NodeMessageFromOutside().name, keep(&messages_, true));
  bus.SubscribeBytes(channels::AckMessage().name, keep(&acks_, false));
  bus.SubscribeBytes(channels::AcousticTx().name, keep(&packets_, false));
  bus.SubscribeBytes(channels::HelmCommandAll().name, keep(&commands_, false));
  for (const ControlRow& row : ControlTable()) {
    Subscribe(bus, channels::Control(row), [this, &row](const unc_control_t& control) {
      controls_.push_back({.row = &row, .control = control});
    });
  }
  bus.SubscribeBytes(channels::UncControls().name,
                     [this](const Message& message) { KeepControls(message); });
}

void ShoreBrokerApp::OnWarp(double warp) { warp_ = warp > 0 ? warp : kMaxWarp; }

void ShoreBrokerApp::Tick(int64_t utime) {
  now_utime_ = utime;
  if (!began_) Begin(utime);
  HandOnCommands(utime);
  if (Holds(utime)) return;

  ApplyControls(utime);
  std::erase_if(reports_, [&](WaitingReport& report) { return !TakeIn(utime, &report); });
  for (const WaitingReport& report : reports_) RouteReport(utime, report);
  for (const Waiting& message : messages_) RouteMessage(utime, message);
  for (const Waiting& ack : acks_) RouteAck(utime, ack);
  for (const Waiting& packet : packets_) RoutePacket(utime, packet);
  water_.Deliver(utime, [&](const Arrival& arrival) { TakeArrival(utime, arrival); });
  SHOAL_CHECK(router_.NumInTransit() == water_.num_in_transit(), "everything has one fate");
  fates_.Flush(utime);
  pulses_.Flush(utime);
  Forget(utime);

  reports_.clear();
  messages_.clear();
  acks_.clear();
  packets_.clear();
  arena_.clear();
}

void ShoreBrokerApp::Begin(int64_t utime) {
  began_ = true;
  start_utime_ = utime;
  if (!water_.problem().empty()) {
    log_.Warn("no vehicle can send through the water; [acoustics] " + water_.problem());
  }
  rules_changed_ = true;
  holds_ = utime > setup_.start_utime;
  if (!holds_) return;
  unc_controls_req_t request;
  request.utime = utime;
  Publish(bus_, channels::UncControlsReq(), request);
  log_.Event(utime, "started in the midst of the mission: asks for the rules that were changed");
}

/// True while the rules are still asked for: until then what was heard waits.
bool ShoreBrokerApp::Holds(int64_t utime) {
  if (!holds_) return false;
  if (!kept_controls_ && SecondsBetween(start_utime_, utime) < kHold_s) return true;
  holds_ = false;
  if (!kept_controls_) {
    log_.Warn(
        "nobody told which rules were changed before this broker started: the mission file's "
        "hold");
    return false;
  }
  std::vector<WaitingControl> kept;
  for (const kept_control_t& each : kept_controls_->controls) {
    const ControlRow* row = FindControlOnChannel(each.channel);
    if (row != nullptr) kept.push_back({.row = row, .control = each.control});
  }
  controls_.insert(controls_.begin(), kept.begin(), kept.end());
  return false;
}

/// The launcher's answer. A stranger's would stand in its place.
void ShoreBrokerApp::KeepControls(const Message& message) {
  if (message.publisher.empty()) {
    log_.Warn("UNC_CONTROLS from outside the mission ignored: say the controls themselves, UNC_*");
    return;
  }
  unc_controls_t controls;
  if (Decode(message.data, &controls)) {
    kept_controls_ = std::move(controls);
  } else {
    bus_.CountUndecodable(message.channel);
  }
}

ShoreBrokerApp::Waiting ShoreBrokerApp::Keep(const Message& message, bool from_outside) {
  const Waiting waiting = {
      .begin = arena_.size(), .size = message.data.size(), .from_outside = from_outside};
  arena_.insert(arena_.end(), message.data.begin(), message.data.end());
  return waiting;
}

std::span<const uint8_t> ShoreBrokerApp::BytesOf(const Waiting& waiting) const {
  return std::span(arena_).subspan(waiting.begin, waiting.size);
}

void ShoreBrokerApp::ApplyControls(int64_t utime) {
  for (const WaitingControl& each : controls_) {
    if (ApplyControl(*each.row, each.control, utime, &router_, &log_)) rules_changed_ = true;
  }
  controls_.clear();
  if (!rules_changed_) return;
  rules_changed_ = false;
  comms_rules_t rules = RulesMessage(setup_, router_);
  rules.utime = utime;
  rules.is_start = began_to_work_ ? 0 : 1;
  began_to_work_ = true;
  Publish(bus_, channels::CommsRules(), rules);
}

void ShoreBrokerApp::HandOnCommands(int64_t utime) {
  for (const Waiting& waiting : commands_) {
    helm_command_t command;
    if (!DecodeWaiting(waiting, channels::HelmCommandAll(), &command)) continue;
    ++num_commands_handed_on_;
    log_.Event(utime, fmt::format("HELM_COMMAND handed on: {}", Printable(command.command)));
    for (const Contact* contact : router_.contacts()) {
      if (!contact->of_mission && !contact->known) continue;
      bus_.PublishBytes(channels::HelmCommand(contact->name).name, BytesOf(waiting));
    }
  }
  commands_.clear();
}

/// Returns false where the report goes no further.
bool ShoreBrokerApp::TakeIn(int64_t utime, WaitingReport* report) {
  if (!DecodeWaiting(report->raw,
                     report->raw.from_outside ? channels::NodeReportFromOutside()
                                              : channels::NodeReportLocal(),
                     &report_)) {
    return false;
  }
  const int num_known = router_.num_known();
  report->admission =
      AllNumbersAreFinite(report_)
          ? router_.Admit({.name = report_.name,
                           .group = report_.group,
                           .position_m = {report_.x_m, report_.y_m, report_.depth_m}},
                          utime)
          : router_.Refuse(report_.name);
  if (router_.num_known() > num_known) {
    log_.Event(utime, fmt::format("{} is known now", report_.name));
  }
  if (!report->admission.refused) {
    water_.Place(report_.name, report->admission.position_m);
    return true;
  }

  const Cause cause = *report->admission.refused;
  if (cause == Cause::kInvalid) {
    log_.Warn("invalid node report refused: illegal name or impossible number");
  } else if (cause == Cause::kTooManyVehicles) {
    log_.Warn("node report refused: too many vehicles that are not of the mission");
  }
  fates_.Add(
      utime,
      {.source = report->admission.source, .number = report->admission.number, .cause = cause},
      IsLegalVehicleName(report_.name) ? report_.name : "", "");
  return false;
}

/// NODE_REPORT_UNC, not more often than eyes can follow.
void ShoreBrokerApp::Share(int64_t utime, const WaitingReport& report) {
  const double interval_s = router_.rules().shared_node_reports_s;
  if (interval_s < 0) return;
  const auto place = static_cast<size_t>(report.admission.source);
  const std::string& name = router_.contact(report.admission.source).name;
  if (place >= shared_utimes_.size()) shared_utimes_.resize(place + 1, {"", kNever});
  auto& [whose, shared_utime] = shared_utimes_[place];
  const bool is_due = whose != name || shared_utime == kNever ||
                      SecondsBetween(shared_utime, utime) >= interval_s * warp_;
  if (!is_due) return;
  whose = name;
  shared_utime = utime;
  ++num_shared_;
  bus_.PublishBytes(channels::NodeReportUnc().name, BytesOf(report.raw));
}

void ShoreBrokerApp::Forget(int64_t utime) {
  std::vector<int32_t> forgotten;
  router_.ForgetSilent(utime, &forgotten);
  for (const int32_t index : forgotten) {
    log_.Event(utime, fmt::format("{} is forgotten", router_.contact(index).name));
  }
}

StatusPage ShoreBrokerApp::Status() const {
  StatusPage page;
  page.text = FormatBrokerPage(router_, water_,
                               {.start_utime = start_utime_,
                                .now_utime = now_utime_,
                                .num_commands_handed_on = num_commands_handed_on_,
                                .num_shared = num_shared_,
                                .num_undecodable = bus_.counters().undecodable});
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
