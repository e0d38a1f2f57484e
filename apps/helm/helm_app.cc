#include "apps/helm/helm_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/bus/bus/waypoint_arrival.h"
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

int64_t Microseconds(double seconds) { return std::llround(seconds * 1e6); }

bool IsPlace(double x_m, double y_m) {
  return std::abs(x_m) <= kMaxCoordinate_m && std::abs(y_m) <= kMaxCoordinate_m;
}

/// The words of HELM_STATE, not copied: most steps have nothing new to publish.
struct StateWords {
  std::string_view state;
  std::string_view all_stop;
  std::string_view task;
  std::string_view task_kind;
};

StateWords WordsOf(const HelmStates& states) {
  const Task* task = states.task();
  return {.state = Name(states.mode()),
          .all_stop = states.all_stop(),
          .task = task == nullptr ? std::string_view() : std::string_view(task->name),
          .task_kind = task == nullptr ? std::string_view() : KindOf(*task)};
}

/// Where it steers for, as HELM_STATE has it.
struct StateNumbers {
  int waypoint_index = -1;
  int laps_done = 0;
  Eigen::Vector3d waypoint_m = Eigen::Vector3d::Zero();
  double distance_m = 0;
  double cross_track_error_m = 0;
};

StateNumbers NumbersOf(const Guidance& guidance) {
  return {
      .waypoint_index = guidance.waypoint_index,
      .laps_done = guidance.laps_done,
      .waypoint_m = {guidance.waypoint_m.x(), guidance.waypoint_m.y(), guidance.z_m.value_or(0)},
      .distance_m = guidance.distance_m,
      .cross_track_error_m = guidance.cross_track_error_m};
}

StateNumbers NumbersOf(const helm_state_t& state) {
  return {.waypoint_index = state.waypoint_index,
          .laps_done = state.laps_done,
          .waypoint_m = {state.waypoint_x_m, state.waypoint_y_m, state.waypoint_z_m},
          .distance_m = state.distance_m,
          .cross_track_error_m = state.cross_track_error_m};
}

/// True where the next HELM_STATE differs from `last` in more than follows from NAV.
bool HasNews(const StateWords& words, const StateNumbers& numbers, const helm_state_t& last) {
  return words.state != last.state || words.task != last.task ||
         words.task_kind != last.task_kind || words.all_stop != last.all_stop ||
         numbers.waypoint_index != last.waypoint_index || numbers.laps_done != last.laps_done ||
         numbers.waypoint_m.x() != last.waypoint_x_m ||
         numbers.waypoint_m.y() != last.waypoint_y_m || numbers.waypoint_m.z() != last.waypoint_z_m;
}

/// Variables of behaviors that NAVIGATION sets: half of the long axis of the ellipse that holds the
/// position with 95 %, and the number of fixes, whenever there was another (periodic_surface).
constexpr char kUncertaintyVariable[] = "NAV_UNCERTAINTY_M";
constexpr char kFixVariable[] = "GPS_UPDATE_RECEIVED";

constexpr size_t kMaxContactsShown = 10;

std::string TasksText(const Vehicle& vehicle) {
  std::string text;
  for (const Task& task : vehicle.tasks) text += fmt::format(" {} ({})", task.name, KindOf(task));
  return text.empty() ? " none" : text;
}

std::string CommandsText(const std::array<int64_t, kNumOrderKinds>& num_executed) {
  std::string text;
  for (size_t i = 0; i < num_executed.size(); ++i) {
    if (num_executed[i] == 0) continue;
    text += fmt::format(" {} {}", Name(static_cast<OrderKind>(i)), num_executed[i]);
  }
  return text.empty() ? " none" : text;
}

}  // namespace

HelmApp::HelmApp(const Mission& mission, const Vehicle& vehicle, Bus& bus)
    : bus_(bus),
      pilot_(MakePilot(mission, vehicle)),
      nav_timeout_us_(Microseconds(vehicle.helm_options.nav_timeout_s)),
      state_interval_us_(Microseconds(vehicle.helm_options.state_interval_s)),
      desired_channel_(channels::Desired(vehicle.name)),
      actuators_channel_(channels::Actuators(vehicle.name)),
      state_channel_(channels::HelmState(vehicle.name)),
      guidance_channel_(channels::Guidance(vehicle.name)),
      states_(vehicle),
      swarm_(mission, vehicle),
      vehicle_(vehicle),
      lost_nav_warning_(fmt::format("no NAV for {:.1f} s", vehicle.helm_options.nav_timeout_s)) {
  state_.vehicle = vehicle.name;
  if (!vehicle.behaviors.empty()) {
    arbiter_ = std::make_unique<Arbiter>(mission, vehicle);
    if (vehicle.helm_options.deploy_at_start) arbiter_->TakeOver({.kind = OrderKind::kDeploy});
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
      if (arbiter_) arbiter_->OnSwarm(swarm, utime_.value_or(0));
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
      if (arbiter_ && had_nav_) arbiter_->OnSonar(ping, nav_, utime_.value_or(0));
    });
  }
}

void HelmApp::OnNav(const nav_t& nav) {
  ++num_navs_;
  const bool is_finite = std::isfinite(nav.heading_deg) && std::isfinite(nav.speed_mps) &&
                         std::isfinite(nav.yaw_rate_degps) && std::isfinite(nav.pitch_deg) &&
                         std::isfinite(nav.pitch_rate_degps) && !std::isnan(nav.altitude_m);
  if (!IsPlace(nav.x_m, nav.y_m) || !IsPlace(nav.z_m, 0) || !is_finite) {
    ++num_bad_navs_;
    log_.Warn(kBadNav);
    return;
  }
  nav_ = nav;
  nav_is_fresh_ = true;
}

void HelmApp::OnNavigation(const navigation_t& navigation) {
  if (arbiter_) {
    arbiter_->Set({.variable = kUncertaintyVariable, .value = navigation.ellipse_major_m},
                  "navigation");
  }
  if (arbiter_ && navigation.num_gps > num_gps_) {
    arbiter_->Set({.variable = kFixVariable, .value = static_cast<double>(navigation.num_gps)},
                  "navigation");
  }
  num_gps_ = navigation.num_gps;
}

void HelmApp::OnCommand(const helm_command_t& command) {
  Execute(ReadOrder(command.command, command.argument, command.values), "");
}

void HelmApp::OnNodeMessage(const node_message_t& message) {
  if (message.var_name != kCommandVariable) {  // For the behaviors, or another program.
    if (!arbiter_) return;
    VariablePost setting{.variable = message.var_name, .value = message.string_val};
    if (message.is_double != 0) setting.value = message.double_val;
    arbiter_->Set(setting, message.src_node);
    return;
  }
  const Result<HelmOrder> order = message.is_double != 0
                                      ? Result<HelmOrder>(Error{"a number is no order"})
                                      : ReadOrderText(message.string_val);
  Execute(order, message.src_node);
}

void HelmApp::Execute(const Result<HelmOrder>& order, std::string_view from) {
  const std::string sender = from.empty() ? "" : fmt::format(" of {}", Printable(from));
  const std::string refusal = order.ok() ? Execute(*order) : order.error();
  if (!refusal.empty()) {
    ++num_refused_;
    const std::string text = fmt::format("HELM_COMMAND{} refused: {}", sender, refusal);
    log_.Warn(text);
    log_.Event(utime_.value_or(0), text);
    return;
  }
  ++num_executed_.at(static_cast<size_t>(order->kind));
  log_.Event(utime_.value_or(0), fmt::format("command{}: {}{}{}", sender, Name(order->kind),
                                             order->task.empty() ? "" : " ", order->task));
}

std::string HelmApp::Execute(const HelmOrder& order) {
  if (order.kind == OrderKind::kSet) {
    if (!arbiter_) return "set: the vehicle has no behaviors, and so no variables";
    arbiter_->Set(order.setting, "command");
    return {};
  }
  std::string refusal = states_.Execute(arbiter_ ? arbiter_->Instead(order) : order);
  if (arbiter_ && refusal.empty()) arbiter_->TakeOver(order);
  return refusal;
}

void HelmApp::OnNodeReport(const node_report_t& report) {
  ++num_reports_;
  if (arbiter_) arbiter_->OnNodeReport(report, utime_.value_or(report.utime));
  if (!IsPlace(report.x_m, report.y_m)) {
    log_.Warn(kBadReport);
    return;
  }
  const Contact contact{.position_m = {report.x_m, report.y_m}, .reported_utime = report.utime};
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
  const double dt_s =
      utime_ ? std::clamp(static_cast<double>(utime - *utime_) / 1e6, 0.0, kMaxControlStep_s) : 0;
  utime_ = utime;
  if (utime < busy_until_utime_) return;  // What arrives is taken, as from a queue at the end.
  const bool nav_is_lost = WatchNav(utime);

  std::optional<Fix> fix;
  if (had_nav_ && !nav_is_lost) {
    fix = Fix{.position_m = {nav_.x_m, nav_.y_m},
              .heading_rad = WrapTwoPi(DegToRad(nav_.heading_deg)),
              .time_s = static_cast<double>(utime) / 1e6,
              .z_m = nav_.z_m,
              .velocity_mps =
                  nav_.speed_over_ground_mps * UnitVector(DegToRad(nav_.course_over_ground_deg)),
              .speed_mps = std::max(0.0, nav_.speed_mps),
              .num_gps_fixes = num_gps_,
              .surroundings = swarm_.Look(states_.task(), nav_)};
  }
  states_.Advance(fix, nav_is_lost);
  if (arbiter_) guidance_ = Guide(utime, fix);
  if (arbiter_ && IsPrevented(utime)) return;
  const std::optional<Guidance>& guidance = arbiter_ ? guidance_ : states_.guidance();
  if (guidance) {
    pilot_->Steer(*guidance, nav_, dt_s, &desired_, &actuators_);
  } else {
    pilot_->Rest(nav_, &desired_, &actuators_);
  }

  actuators_.utime = utime;
  desired_.utime = utime;
  if (had_nav_) Publish(bus_, desired_channel_, desired_);
  Publish(bus_, actuators_channel_, actuators_);
  PublishState(utime);
  PublishGuidance(utime, guidance);
  if (arbiter_) PublishDecision(utime);
}

bool HelmApp::IsPrevented(int64_t utime) {
  if (const double busy_s = arbiter_->TakeBusy(); busy_s > 0) {
    busy_until_utime_ = utime + Microseconds(busy_s);
  }
  return utime < busy_until_utime_ || !arbiter_->outcome().crash.empty();
}

std::string HelmApp::Crash() const {
  if (!arbiter_ || arbiter_->outcome().crash.empty()) return {};
  return fmt::format("the behavior {} crashes the helm", Printable(arbiter_->outcome().crash));
}

std::optional<Guidance> HelmApp::Guide(int64_t utime, const std::optional<Fix>& fix) {
  std::optional<Guidance> guidance =
      arbiter_->Advance({.utime = utime,
                         .drives = states_.mode() == HelmMode::kDrive,
                         .nav = fix ? &nav_ : nullptr,
                         .task = states_.task(),
                         .is_interruption = states_.is_interrupted(),
                         .alone = states_.guidance()});
  for (const HelmEvent& event : arbiter_->TakeEvents()) {
    log_.Event(utime, fmt::format("{}: {}", event.kind, Printable(event.text)));
  }
  for (const std::string& warning : arbiter_->TakeWarnings()) log_.Warn(Printable(warning));
  if (arbiter_->TakePark()) {
    [[maybe_unused]] const std::string refusal = states_.Execute({.kind = OrderKind::kPark});
    guidance.reset();
  }
  return guidance;
}

void HelmApp::PublishDecision(int64_t utime) {
  if (const std::optional<helm_decision_t> decision = arbiter_->TakeDecision()) {
    Publish(bus_, channels::HelmDecision(vehicle_.name), *decision);
  }
  for (const VariablePost& post : arbiter_->TakeMessages()) {
    node_message_t message{};
    message.utime = utime;
    message.src_node = vehicle_.name;
    message.src_app = "helm";
    constexpr std::string_view kGroup = "group:";
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
    Publish(bus_, channels::NodeMessageLocal(), message);
  }
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

void HelmApp::PublishState(int64_t utime) {
  StateWords words = WordsOf(states_);
  if (arbiter_ && states_.mode() == HelmMode::kDrive) {
    words.all_stop = arbiter_->all_stop();
    const HelmAim* leading = arbiter_->Leading();
    if (leading != nullptr && states_.task() == nullptr) {
      words.task = leading->name;
      words.task_kind = leading->kind;
    }
  }
  const std::optional<Guidance>& guidance = arbiter_ ? guidance_ : states_.guidance();
  StateNumbers numbers;
  if (guidance) {
    numbers = NumbersOf(*guidance);
  } else if (!words.task.empty() && words.task == state_.task) {
    numbers = NumbersOf(state_);
  }
  if (state_utime_ && !HasNews(words, numbers, state_) &&
      utime - *state_utime_ < state_interval_us_) {
    return;
  }
  if (words.state != state_.state || words.task != state_.task ||
      words.all_stop != state_.all_stop) {
    log_.Event(utime, fmt::format("{} {} ({})", words.state, words.task, words.all_stop));
  }
  const helm_state_t before = state_;
  state_utime_ = utime;
  state_.utime = utime;
  state_.state = words.state;
  state_.all_stop = words.all_stop;
  state_.task = words.task;
  state_.task_kind = words.task_kind;
  state_.waypoint_index = numbers.waypoint_index;
  state_.laps_done = numbers.laps_done;
  state_.waypoint_x_m = numbers.waypoint_m.x();
  state_.waypoint_y_m = numbers.waypoint_m.y();
  state_.waypoint_z_m = numbers.waypoint_m.z();
  state_.distance_m = numbers.distance_m;
  state_.cross_track_error_m = numbers.cross_track_error_m;
  Publish(bus_, state_channel_, state_);
  if (const std::string arrival = ArrivalText(before, state_); !arrival.empty()) {
    const double miss_m = (Eigen::Vector2d(before.waypoint_x_m, before.waypoint_y_m) -
                           Eigen::Vector2d(nav_.x_m, nav_.y_m))
                              .norm();
    log_.Event(utime, fmt::format("{}, {:.1f} m from it", arrival, miss_m));
  }
}

void HelmApp::PublishGuidance(int64_t utime, const std::optional<Guidance>& guidance) {
  const std::optional<double> pitch_rad = pilot_->desired_pitch_rad();
  if (!pitch_rad || !guidance) return;
  const bool is_news = !how_utime_ || how_.task != state_.task ||
                       how_.waypoint_index != guidance->waypoint_index ||
                       how_.layers.size() != guidance->layers.size();
  if (!is_news && utime - *how_utime_ < state_interval_us_) return;
  how_utime_ = utime;
  how_.utime = utime;
  how_.vehicle = vehicle_.name;
  how_.task = state_.task;
  how_.task_kind = state_.task_kind;
  how_.waypoint_index = guidance->waypoint_index;
  how_.heading_deg = desired_.heading_deg;
  how_.speed_mps = desired_.speed_mps;
  how_.depth_m = desired_.depth_m;
  how_.pitch_deg = RadToDeg(*pitch_rad);
  how_.crab_deg = RadToDeg(guidance->crab_rad);
  how_.cross_track_error_m = guidance->cross_track_error_m;
  how_.u_max_mps = guidance->u_max_mps;
  how_.layers.clear();
  for (const LayerShare& share : guidance->layers) {
    guidance_layer_t layer{};
    layer.name = share.name;
    layer.east_mps = share.velocity_mps.x();
    layer.north_mps = share.velocity_mps.y();
    layer.descent_mps = share.velocity_mps.z();
    layer.speed_mps = share.velocity_mps.norm();
    layer.weight = share.weight;
    how_.layers.push_back(layer);
  }
  how_.num_layers = static_cast<int32_t>(how_.layers.size());
  Publish(bus_, guidance_channel_, how_);
}

StatusPage HelmApp::Status() const {
  StatusPage page;
  page.text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({})\n"
      "    Tasks:{}\n"
      "    Return point: x {:.1f} m, y {:.1f} m\n"
      "    NAV time-out: {:.1f} s, deploy at start: {}\n"
      "    {}\n",
      vehicle_.name, FactsOfModel(vehicle_.model).name, TasksText(vehicle_),
      vehicle_.return_task.point_m.x(), vehicle_.return_task.point_m.y(),
      vehicle_.helm_options.nav_timeout_s, vehicle_.helm_options.deploy_at_start ? "yes" : "no",
      pilot_->GainsText());
  page.text += fmt::format(
      "State: {} (all-stop: {})\n"
      "    Task: {} ({}), waypoint {}, laps done {}\n"
      "    Steers for: x {:.1f} m, y {:.1f} m, distance {:.1f} m, cross-track error {:.1f} m\n"
      "               Desired   Actual\n"
      "    Heading: {:9.1f}{:9.1f} deg\n"
      "    Speed:   {:9.2f}{:9.2f} m/s\n"
      "    Depth:   {:9.1f}{:9.1f} m\n"
      "    Position: x {:.2f} m, y {:.2f} m\n"
      "    Thrust {:.1f} % ({:.0f} rpm), rudder {:.1f} deg, stern plane {:.1f} deg\n",
      Name(states_.mode()), states_.all_stop(), state_.task.empty() ? "none" : state_.task,
      state_.task_kind, state_.waypoint_index, state_.laps_done, state_.waypoint_x_m,
      state_.waypoint_y_m, state_.distance_m, state_.cross_track_error_m, desired_.heading_deg,
      nav_.heading_deg, desired_.speed_mps, nav_.speed_mps, desired_.depth_m, nav_.z_m, nav_.x_m,
      nav_.y_m, actuators_.thrust_pct, actuators_.propeller_rpm, actuators_.rudder_deg,
      actuators_.stern_plane_deg);
  page.text += GuidanceText();
  page.text += fmt::format(
      "Received:\n"
      "    NAV: {} ({} refused)\n"
      "    Commands:{} ({} refused)\n"
      "    NODE_REPORT: {}\n"
      "    Undecodable: {}\n"
      "{}",
      num_navs_, num_bad_navs_, CommandsText(num_executed_), num_refused_, num_reports_,
      bus_.counters().undecodable, ContactsText());
  if (arbiter_) page.text += arbiter_->Text();
  log_.AppendTo(&page);
  return page;
}

std::string HelmApp::GuidanceText() const {
  if (!how_utime_) return {};
  std::string text = fmt::format(
      "Guidance: pitch {:.1f} deg desired, {:.1f} actual; crab angle by ALOS {:.1f} deg\n",
      how_.pitch_deg, nav_.pitch_deg, how_.crab_deg);
  for (const guidance_layer_t& layer : how_.layers) {
    text += fmt::format("    {:<18} asks for {:.2f} m/s, weight {:.3f}\n", layer.name,
                        layer.speed_mps, layer.weight);
  }
  return text;
}

std::string HelmApp::ContactsText() const {
  const Eigen::Vector2d own_position_m(nav_.x_m, nav_.y_m);
  std::vector<std::tuple<double, std::string, double>> rows;  // Range, name, age.
  for (const auto& [name, contact] : contacts_) {
    const double age_s =
        (static_cast<double>(utime_.value_or(0)) - static_cast<double>(contact.reported_utime)) /
        1e6;
    rows.emplace_back((contact.position_m - own_position_m).norm(), Printable(name), age_s);
  }
  std::sort(rows.begin(), rows.end());
  std::string text = fmt::format("Contacts: {}\n", rows.size());
  for (size_t i = 0; i < std::min(rows.size(), kMaxContactsShown); ++i) {
    const auto& [range_m, name, age_s] = rows[i];
    text += fmt::format("    {:<16} range {:8.1f} m, age {:6.1f} s\n", name, range_m, age_s);
  }
  return text;
}

}  // namespace shoal
