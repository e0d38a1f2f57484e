#include "apps/helm/helm_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/run/run/own_nav.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

constexpr char kBadNav[] = "NAV with invalid values: ignored";
/// The variable of node messages that are orders.
constexpr std::string_view kCommandVariable = topics::kHelmCommand;
constexpr char kBadReport[] = "NODE_REPORT with an invalid position: ignored";
constexpr char kManyContacts[] = "more than 1000 contacts: new ones are ignored";
constexpr size_t kMaxContacts = 1000;
/// After a longer gap between steps the autopilots' integrals would jump.
constexpr double kMaxControlStep_s = 1;

bool IsPlace(double x_m, double y_m) {
  return std::abs(x_m) <= kMaxCoordinate_m && std::abs(y_m) <= kMaxCoordinate_m;
}

node_message_t MessageOf(const VariablePost& post, const std::string& vehicle, int64_t utime) {
  constexpr std::string_view kGroup = "group:";
  node_message_t message{};
  message.utime = utime;
  message.src_node = vehicle;
  message.src_app = "helm";
  if (post.destination.starts_with(kGroup)) {
    message.dest_group = post.destination.substr(kGroup.size());
  } else {
    message.dest_node = post.destination;
  }
  message.var_name = post.variable;
  if (const double* number = std::get_if<double>(&post.value)) {
    message.is_double = 1;
    message.double_val = *number;
  } else {
    message.string_val = std::get<std::string>(post.value);
  }
  return message;
}

}  // namespace

HelmApp::HelmApp(const Mission& mission, const Vehicle& vehicle, Bus& bus)
    : bus_(bus),
      pilot_(MakePilot(mission, vehicle)),
      nav_timeout_us_(Microseconds(vehicle.helm_options.nav_timeout_s)),
      desired_channel_(channels::Desired(vehicle.name)),
      actuators_channel_(channels::Actuators(vehicle.name)),
      decision_channel_(channels::HelmDecision(vehicle.name)),
      states_(vehicle),
      arbiter_(mission, vehicle),
      reports_(vehicle, bus),
      swarm_(mission, vehicle),
      vehicle_(vehicle),
      lost_nav_warning_(fmt::format("no NAV for {:.1f} s", vehicle.helm_options.nav_timeout_s)) {
  if (vehicle.helm_options.deploy_at_start) {
    [[maybe_unused]] const std::string refusal = Execute({.kind = OrderKind::kDeploy});
  }
  Subscribe(bus, OwnNav(vehicle), [this](const nav_t& nav) { OnNav(nav); });
  Subscribe(bus, channels::HelmCommand(vehicle.name),
            [this](const helm_command_t& command) { OnCommand(command); });
  Subscribe(bus, channels::NodeReport(vehicle.name),
            [this](const node_report_t& report) { OnNodeReport(report); });
  Subscribe(bus, channels::NodeMessage(vehicle.name),
            [this](const node_message_t& message) { OnNodeMessage(message); });
  for (size_t i = 0; i < swarm_.names().size(); ++i) {
    SubscribeAs<NavNeighbour>(bus, channels::Nav(swarm_.names()[i]),
                              [this, i](const NavNeighbour& nav) { swarm_.OnNav(i, nav); });
  }
  if (mission.SwarmOf(vehicle) != nullptr) {
    Subscribe(bus, channels::Swarm(vehicle.name), [this](const swarm_t& swarm) {
      swarm_.OnSwarm(swarm);
      arbiter_.inputs().OnSwarm(swarm, utime_.value_or(0));
    });
  }
  if (vehicle.navigation.is_fitted) {
    Subscribe(bus, channels::Navigation(vehicle.name),
              [this](const navigation_t& navigation) { OnNavigation(navigation); });
  }
  if (vehicle.sonar.is_fitted) {
    Subscribe(bus, channels::Sonar(vehicle.name), [this](const sonar_t& ping) {
      swarm_.OnSonar(ping);
      pilot_->OnSonar(ping);
      if (had_nav_) arbiter_.inputs().OnSonar(ping, nav_, utime_.value_or(0));
    });
  }
}

void HelmApp::OnNav(const nav_t& nav) {
  ++counters_.num_navs;
  const bool is_finite = std::isfinite(nav.heading_deg) && std::isfinite(nav.speed_mps) &&
                         std::isfinite(nav.yaw_rate_degps) && std::isfinite(nav.pitch_deg) &&
                         std::isfinite(nav.pitch_rate_degps) && !std::isnan(nav.altitude_m);
  if (!IsPlace(nav.x_m, nav.y_m) || !IsPlace(nav.z_m, 0) || !is_finite) {
    ++counters_.num_bad_navs;
    log_.Warn(kBadNav);
    return;
  }
  nav_ = nav;
  nav_is_fresh_ = true;
}

void HelmApp::OnNavigation(const navigation_t& navigation) {
  arbiter_.inputs().OnNavigation(navigation);
  num_gps_ = navigation.num_gps;
}

void HelmApp::OnCommand(const helm_command_t& command) {
  Execute(ReadOrder(command.command, command.argument, command.values), "");
}

void HelmApp::OnNodeMessage(const node_message_t& message) {
  if (message.var_name != kCommandVariable) {  // For the behaviors, or another program.
    arbiter_.inputs().OnNodeMessage(message);
    return;
  }
  const Result<HelmOrder> order = message.is_double != 0
                                      ? Result<HelmOrder>(Error{"a number is not an order"})
                                      : ReadOrderText(message.string_val);
  Execute(order, message.src_node);
}

void HelmApp::Execute(const Result<HelmOrder>& order, std::string_view from) {
  const std::string sender = from.empty() ? "" : fmt::format(" of {}", Printable(from));
  const std::string refusal = order.ok() ? Execute(*order) : order.error();
  if (!refusal.empty()) {
    ++counters_.num_refused;
    const std::string text = fmt::format("HELM_COMMAND{} refused: {}", sender, refusal);
    log_.Warn(text);
    log_.Event(utime_.value_or(0), text);
    return;
  }
  ++counters_.num_executed.at(static_cast<size_t>(order->kind));
  log_.Event(utime_.value_or(0), fmt::format("command{}: {}{}{}", sender, Name(order->kind),
                                             order->task.empty() ? "" : " ", order->task));
}

std::string HelmApp::Execute(const HelmOrder& order) {
  if (order.kind == OrderKind::kSet) return arbiter_.Set(order.setting);
  std::string refusal = states_.Execute(arbiter_.ReplacementFor(order));
  if (refusal.empty()) arbiter_.TakeOver(order);
  return refusal;
}

void HelmApp::OnNodeReport(const node_report_t& report) {
  ++counters_.num_reports;
  arbiter_.inputs().OnNodeReport(report, utime_.value_or(report.utime));
  if (!IsPlace(report.x_m, report.y_m)) {
    log_.Warn(kBadReport);
    return;
  }
  const ReportedVehicle contact{.position_m = {report.x_m, report.y_m},
                                .reported_utime = report.utime};
  const auto found = contacts_.find(report.name);
  if (found != contacts_.end()) {
    found->second = contact;
  } else if (contacts_.size() < kMaxContacts) {
    contacts_.emplace(report.name, contact);
  } else {
    log_.Warn(kManyContacts);
  }
}

void HelmApp::Tick(int64_t utime) {
  const double dt_s = utime_ ? std::clamp(Seconds(utime - *utime_), 0.0, kMaxControlStep_s) : 0;
  utime_ = utime;
  if (utime < busy_until_utime_) return;  // What arrives is taken, as from a queue at the end.

  // What was received.
  const bool nav_is_lost = WatchNav(utime);
  const std::optional<Fix> fix = FixAt(utime, nav_is_lost);
  // What the tasks want, and what is decided of that and of what the behaviors want.
  states_.Advance(fix, nav_is_lost);
  const Arbiter::Step step = arbiter_.Advance({.utime = utime,
                                               .drives = states_.mode() == HelmMode::kDrive,
                                               .nav = fix ? &nav_ : nullptr,
                                               .list = states_.aim()});
  NoteDecision(utime, step);
  if (utime < busy_until_utime_ || !arbiter_.crash().empty()) return;
  // How it is steered, and what is published.
  if (step.guidance != nullptr) {
    pilot_->Steer(*step.guidance, nav_, dt_s, &desired_, &actuators_);
  } else {
    pilot_->Rest(nav_, &desired_, &actuators_);
  }
  PublishStep(utime, step.guidance);
}

std::optional<Fix> HelmApp::FixAt(int64_t utime, bool nav_is_lost) {
  if (!had_nav_ || nav_is_lost) return std::nullopt;
  return Fix{.position_m = {nav_.x_m, nav_.y_m},
             .heading_rad = WrapTwoPi(DegToRad(nav_.heading_deg)),
             .time_s = Seconds(utime),
             .z_m = nav_.z_m,
             .velocity_mps =
                 nav_.speed_over_ground_mps * UnitVector(DegToRad(nav_.course_over_ground_deg)),
             .speed_mps = std::max(0.0, nav_.speed_mps),
             .num_gps_fixes = num_gps_,
             .surroundings = swarm_.Look(states_.task(), nav_)};
}

void HelmApp::NoteDecision(int64_t utime, const Arbiter::Step& step) {
  if (arbiter_.has_notes()) {
    for (const HelmEvent& event : arbiter_.TakeEvents()) {
      log_.Event(utime, fmt::format("{}: {}", event.kind, Printable(event.text)));
    }
    for (const std::string& warning : arbiter_.TakeWarnings()) log_.Warn(Printable(warning));
  }
  if (step.parks) {
    [[maybe_unused]] const std::string refusal = states_.Execute({.kind = OrderKind::kPark});
  }
  if (step.busy_s > 0) busy_until_utime_ = utime + Microseconds(step.busy_s);
}

void HelmApp::PublishStep(int64_t utime, const Guidance* guidance) {
  actuators_.utime = utime;
  desired_.utime = utime;
  if (had_nav_) Publish(bus_, desired_channel_, desired_);
  Publish(bus_, actuators_channel_, actuators_);
  reports_.PublishState(utime, WordsOf(states_, arbiter_), guidance, nav_, &log_);
  const std::optional<double> pitch_rad = pilot_->desired_pitch_rad();
  if (pitch_rad && guidance != nullptr) {
    reports_.PublishGuidance(utime, *guidance, *pitch_rad, desired_);
  }
  if (arbiter_.has_output()) PublishDecision(utime);
}

void HelmApp::PublishDecision(int64_t utime) {
  if (const std::optional<helm_decision_t> decision = arbiter_.TakeDecision()) {
    Publish(bus_, decision_channel_, *decision);
  }
  for (const VariablePost& post : arbiter_.TakeMessages()) {
    Publish(bus_, channels::NodeMessageLocal(), MessageOf(post, vehicle_.name, utime));
  }
}

std::string HelmApp::Crash() const {
  if (arbiter_.crash().empty()) return {};
  return fmt::format("the behavior {} crashes the helm", Printable(arbiter_.crash()));
}

// Returns true where the last NAV, or the first step, was too long ago.
bool HelmApp::WatchNav(int64_t utime) {
  if (nav_is_fresh_ || !nav_utime_) nav_utime_ = utime;
  had_nav_ = had_nav_ || nav_is_fresh_;
  nav_is_fresh_ = false;
  const bool is_lost = utime - *nav_utime_ > nav_timeout_us_;
  if (is_lost && !nav_was_lost_) log_.Warn(lost_nav_warning_);
  if (!is_lost && nav_was_lost_) log_.Retract(lost_nav_warning_);
  nav_was_lost_ = is_lost;
  return is_lost;
}

StatusPage HelmApp::Status() const {
  StatusPage page;
  HelmCounters counters = counters_;
  counters.num_undecodable = bus_.counters().undecodable;
  page.text = HelmPageText({.vehicle = vehicle_,
                            .gains = pilot_->GainsText(),
                            .states = states_,
                            .state = reports_.state(),
                            .guidance = reports_.guidance(),
                            .nav = nav_,
                            .desired = desired_,
                            .actuators = actuators_,
                            .counters = counters,
                            .contacts = contacts_,
                            .utime = utime_.value_or(0)});
  page.text += arbiter_.Text();
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
