#include "apps/helm/arbiter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/mission/file/behavior_update.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

constexpr int64_t kLongestSilence_us = 1'000'000;
constexpr size_t kMaxEvents = 100;

// Variables that stand for orders of the operator, by the custom of MOOS-IvP's missions.
constexpr char kDeploy[] = "DEPLOY";
constexpr char kReturn[] = "RETURN";
constexpr char kStationKeep[] = "STATION_KEEP";

HelmSetup SetupOf(const Vehicle& vehicle) {
  if (vehicle.behaviors.empty()) return {.vehicle = vehicle.name};  // The rest is for behaviors.
  HelmSetup setup{.vehicle = vehicle.name,
                  .behaviors = vehicle.behaviors,
                  .modes = vehicle.modes,
                  .variables = vehicle.variables,
                  .domain = vehicle.domain,
                  .goals_mandatory = vehicle.helm_options.goals_mandatory};
  setup.read_update = ReadBehaviorUpdate;
  return setup;
}

OwnMotion OwnMotionOf(const nav_t& nav) {
  return {.motion = {.position_m = {nav.x_m, nav.y_m},
                     .heading_deg = Wrap360(nav.heading_deg),
                     .speed_mps = std::max(0.0, nav.speed_mps)},
          .depth_m = nav.z_m,
          .altitude_m = nav.altitude_m};
}

double OrAny(const std::optional<double>& value) { return value.value_or(-1); }

/// Returns "active" of "active, 49 m to go": what follows changes all the time.
std::string_view RunStateOf(const helm_aim_t& aim) {
  return std::string_view(aim.state).substr(0, aim.state.find(','));
}

/// True where two decisions differ in more than the numbers behind them.
bool HasNews(const helm_decision_t& next, const helm_decision_t& last) {
  if (next.num_events > 0 || next.mode != last.mode || next.course_deg != last.course_deg ||
      next.speed_mps != last.speed_mps || next.depth_m != last.depth_m ||
      next.all_stop != last.all_stop || next.num_aims != last.num_aims) {
    return true;
  }
  for (size_t i = 0; i < next.aims.size(); ++i) {
    const helm_aim_t& a = next.aims[i];
    const helm_aim_t& b = last.aims[i];
    if (a.name != b.name || RunStateOf(a) != RunStateOf(b) || a.role != b.role ||
        a.contact != b.contact) {
      return true;
    }
  }
  return false;
}

helm_aim_t AimMessage(const HelmAim& aim) {
  helm_aim_t message{};
  message.name = aim.name;
  message.kind = aim.kind;
  message.state = aim.state;
  message.weight = aim.weight;
  message.best_course_deg = OrAny(aim.best.course_deg);
  message.best_speed_mps = OrAny(aim.best.speed_mps);
  message.best_depth_m = OrAny(aim.best.depth_m);
  message.value = aim.value;
  message.loss = aim.loss;
  message.range_m = message.cpa_m = message.age_s = -1;
  if (aim.role) {
    message.contact = aim.role->contact;
    message.role = aim.role->role;
    message.rule = aim.role->rule;
    message.range_m = aim.role->range_m;
    message.cpa_m = aim.role->cpa_m;
    message.age_s = aim.role->age_s;
  }
  return message;
}

}  // namespace

Arbiter::Arbiter(const Mission& mission, const Vehicle& vehicle)
    : inputs_(vehicle),
      vehicle_(vehicle.name),
      deploy_keeps_(vehicle.helm_options.deploy_keeps),
      interval_us_(Microseconds(vehicle.helm_options.decide_every_s)),
      behaviors_(SetupOf(vehicle)) {
  if (inputs_.is_used()) obstacles_ = mission.obstacles;
}

std::string Arbiter::Set(const VariablePost& setting) {
  if (!inputs_.is_used()) return "set: the vehicle has no behaviors, and so no variables";
  inputs_.Set(setting, "command");
  return {};
}

bool Arbiter::HasVariable(std::string_view name) const {
  return behaviors_.variables().Find(name) != nullptr;
}

bool Arbiter::IsKept(std::string_view name) const {
  return std::find(deploy_keeps_.begin(), deploy_keeps_.end(), name) != deploy_keeps_.end();
}

HelmOrder Arbiter::ReplacementFor(const HelmOrder& order) const {
  const bool by_variables = (order.kind == OrderKind::kReturn && HasVariable(kReturn)) ||
                            (order.kind == OrderKind::kStationKeep && HasVariable(kStationKeep));
  return by_variables ? HelmOrder{.kind = OrderKind::kDeploy} : order;
}

void Arbiter::TakeOver(const HelmOrder& order) {
  const auto set = [&](const char* name, bool value) {
    if (!HasVariable(name)) return;
    inputs_.Set({.variable = name, .value = std::string(value ? "true" : "false")}, "order");
  };
  behaviors_.Clear();
  switch (order.kind) {
    case OrderKind::kDeploy:
      set(kDeploy, true);
      if (!IsKept(kReturn)) set(kReturn, false);
      if (!IsKept(kStationKeep)) set(kStationKeep, false);
      break;
    case OrderKind::kReturn:
      set(kDeploy, true);
      set(kReturn, true);
      set(kStationKeep, false);
      break;
    case OrderKind::kStationKeep:
      set(kStationKeep, true);
      break;
    default:
      break;
  }
}

Arbiter::Step Arbiter::Advance(const Moment& moment) {
  if (!inputs_.is_used()) return {.guidance = moment.list.guidance};  // There is nothing to weigh.
  const bool drives = moment.drives && moment.nav != nullptr;
  const bool begins = drives && !drove_;
  drove_ = drives;
  Step step;
  if (begins || !next_utime_ || moment.utime >= *next_utime_) {
    Decide(moment);
    next_utime_ =
        next_utime_ && !begins ? *next_utime_ + interval_us_ : moment.utime + interval_us_;
    if (*next_utime_ <= moment.utime) next_utime_ = moment.utime + interval_us_;
    step.parks = outcome_.parks;
    step.busy_s = outcome_.busy_s;
  }
  if (drives && !step.parks) step.guidance = Weighed(moment);
  return step;
}

const Guidance* Arbiter::Weighed(const Moment& moment) {
  const Guidance* alone = moment.list.guidance;
  if ((outcome_.only_task || outcome_.is_task_point) && alone != nullptr) return alone;
  const bool is_decided = outcome_.has_decision || outcome_.keeps_last;
  if (!is_decided || !commands_.course_deg || !commands_.speed_mps) return nullptr;

  guidance_ = alone != nullptr ? *alone : Guidance();
  guidance_.heading_rad = WrapTwoPi(DegToRad(*commands_.course_deg));
  guidance_.speed_mps = *commands_.speed_mps;
  guidance_.propeller_rpm.reset();
  if (commands_.depth_m) {
    guidance_.z_m = *commands_.depth_m;
    guidance_.pitch_rad.reset();
  }
  if (const HelmAim* leading = Leading(); alone == nullptr && leading != nullptr) {
    if (leading->view.steers_for_m) {
      guidance_.waypoint_m = *leading->view.steers_for_m;
      guidance_.distance_m =
          (guidance_.waypoint_m - Eigen::Vector2d(moment.nav->x_m, moment.nav->y_m)).norm();
    }
  }
  return &guidance_;
}

void Arbiter::Decide(const Moment& moment) {
  const double time_s = Seconds(moment.utime);
  HelmInputs inputs{.time_s = time_s, .drives = moment.drives, .settings = inputs_.TakeSettings()};
  std::optional<Eigen::Vector2d> own_position_m;
  if (moment.nav != nullptr) {
    own_position_m = {moment.nav->x_m, moment.nav->y_m};
    inputs.own = OwnMotionOf(*moment.nav);
  }
  inputs.contacts = &inputs_.ContactsAt(time_s, own_position_m);
  inputs.obstacles = &obstacles_;
  inputs.goals_rest = moment.list.is_interruption;
  inputs.explains = false;  // Only what is published is explained.
  if (moment.list.task != nullptr && moment.list.guidance != nullptr) {
    const Task& task = *moment.list.task;
    const Guidance& alone = *moment.list.guidance;
    inputs.task = TaskAim{.name = task.name,
                          .kind = std::string(KindOf(task)),
                          .pwt = task.pwt,
                          .course_deg = Wrap360(RadToDeg(alone.heading_rad)),
                          .speed_mps = alone.speed_mps,
                          .depth_m = alone.z_m};
  }
  outcome_ = behaviors_.Iterate(inputs);
  if (outcome_.has_decision) commands_ = outcome_.commands;
  for (const VariablePost& post : outcome_.posts) {
    if (!post.destination.empty()) messages_.push_back(post);
  }
  for (HelmEvent& event : outcome_.events) {
    if (unpublished_events_.size() < kMaxEvents) {
      unpublished_events_.push_back(event.kind + ": " + event.text);
    }
    events_.push_back(std::move(event));
  }
  for (std::string& warning : outcome_.warnings) warnings_.push_back(std::move(warning));
  outcome_.events.clear();
  outcome_.warnings.clear();

  const bool is_silent = !moment.drives || moment.nav == nullptr || outcome_.only_task;
  if (is_silent && unpublished_events_.empty()) return;
  helm_decision_t next = Message(moment.utime);
  next.events = unpublished_events_;
  next.num_events = static_cast<int32_t>(next.events.size());
  if (!HasNews(next, published_) && moment.utime - published_.utime < kLongestSilence_us) return;
  behaviors_.Explain(&outcome_);
  for (size_t i = 0; i < outcome_.aims.size(); ++i) next.aims[i] = AimMessage(outcome_.aims[i]);
  unpublished_events_.clear();
  published_ = next;
  unpublished_ = std::move(next);
}

helm_decision_t Arbiter::Message(int64_t utime) const {
  helm_decision_t message{};
  message.utime = utime;
  message.vehicle = vehicle_;
  message.mode = outcome_.mode;
  message.course_deg = OrAny(outcome_.commands.course_deg);
  message.speed_mps = OrAny(outcome_.commands.speed_mps);
  message.depth_m = OrAny(outcome_.commands.depth_m);
  message.utility = outcome_.utility;
  message.all_stop = outcome_.all_stop;
  for (const HelmAim& aim : outcome_.aims) message.aims.push_back(AimMessage(aim));
  message.num_aims = static_cast<int32_t>(message.aims.size());
  return message;
}

std::optional<helm_decision_t> Arbiter::TakeDecision() {
  return std::exchange(unpublished_, std::nullopt);
}

std::vector<VariablePost> Arbiter::TakeMessages() { return std::exchange(messages_, {}); }

std::vector<HelmEvent> Arbiter::TakeEvents() { return std::exchange(events_, {}); }

std::vector<std::string> Arbiter::TakeWarnings() {
  std::vector<std::string> warnings = inputs_.TakeWarnings();
  for (std::string& warning : warnings_) warnings.push_back(std::move(warning));
  warnings_.clear();
  return warnings;
}

const HelmAim* Arbiter::Leading() const {
  const HelmAim* leading = nullptr;
  for (const HelmAim& aim : outcome_.aims) {
    if (aim.is_constraint || aim.weight <= 0) continue;
    if (leading == nullptr || aim.weight > leading->weight) leading = &aim;
  }
  return leading;
}

std::string Arbiter::Text() const {
  if (!inputs_.is_used()) return {};
  std::string text =
      fmt::format("Behaviors: {}{}\n", outcome_.all_stop,
                  outcome_.mode.empty() ? "" : fmt::format(", mode {}", outcome_.mode));
  HelmOutcome outcome = outcome_;
  if (!outcome.aims.empty()) behaviors_.Explain(&outcome);
  if (outcome_.has_decision) {
    text += fmt::format("    Decided: course {:.0f} deg, speed {:.2f} m/s",
                        OrAny(commands_.course_deg), OrAny(commands_.speed_mps));
    text += commands_.depth_m ? fmt::format(", depth {:.1f} m\n", *commands_.depth_m) : "\n";
  }
  text += fmt::format("    {:<20}{:>8}{:>8}{:>8}{:>8}{:>8}  {}\n", "", "weight", "course", "speed",
                      "value", "loss", "state");
  for (const HelmAim& aim : outcome.aims) {
    const auto number = [](const std::optional<double>& value, const char* format) {
      return value ? fmt::format(fmt::runtime(format), *value) : std::string("-");
    };
    text += fmt::format("    {:<20}{:>8.1f}{:>8}{:>8}{:>8.1f}{:>8.1f}  {}", Printable(aim.name),
                        aim.weight, number(aim.best.course_deg, "{:.0f}"),
                        number(aim.best.speed_mps, "{:.2f}"), aim.value, aim.loss / 100, aim.state);
    if (aim.role) {
      text += fmt::format("; {}{}, range {:.1f} m, CPA {:.1f} m, age {:.1f} s", aim.role->role,
                          aim.role->rule.empty() ? "" : fmt::format(" (rule {})", aim.role->rule),
                          aim.role->range_m, aim.role->cpa_m, aim.role->age_s);
    }
    text += '\n';
  }
  constexpr size_t kMaxVariablesShown = 30;
  size_t num_shown = 0;
  text += fmt::format("Variables: {}\n", behaviors_.variables().all().size());
  for (const auto& [name, entry] : behaviors_.variables().all()) {
    if (++num_shown > kMaxVariablesShown) break;
    const auto* words = std::get_if<std::string>(&entry.value);
    text += fmt::format(
        "    {} = {}\n", Printable(name),
        words != nullptr ? Printable(*words) : fmt::format("{:g}", std::get<double>(entry.value)));
  }
  return text;
}

}  // namespace shoal
