#include "lib/tools/view/event_watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/check/enum_table.h"
#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/bus/waypoint_arrival.h"
#include "lib/mission/model/event_text.h"
#include "lib/mission/model/mission.h"
#include "lib/run/verdict/mission_verdict.h"
#include "lib/tools/view/fate_text.h"
#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

constexpr size_t kMaxReason = 200;
/// What a helm states of an all-stop that came without a reason.
constexpr std::string_view kByCommand = "all_stop command";
constexpr std::string_view kStopped = "ALL-STOP";
constexpr std::string_view kDrives = "DRIVE";
constexpr std::string_view kParked = "PARK";

std::vector<double> LengthsOf(const std::vector<WatchedVehicle>& vehicles) {
  std::vector<double> lengths_m;
  lengths_m.reserve(vehicles.size());
  for (const WatchedVehicle& vehicle : vehicles) lengths_m.push_back(vehicle.length_m);
  return lengths_m;
}

}  // namespace

std::vector<WatchedVehicle> WatchedVehiclesOf(const Mission& mission) {
  std::vector<WatchedVehicle> vehicles;
  for (const Vehicle& vehicle : mission.vehicles) {
    vehicles.push_back({.name = vehicle.name,
                        .length_m = vehicle.length_m,
                        .plan = PlanWatch(vehicle.behaviors, vehicle.tasks)});
    if (FactsOfModel(vehicle.model).passive.empty()) vehicles.back().draught_m = DraughtOf(vehicle);
  }
  return vehicles;
}

std::vector<ViewEvent> PlannedEventsOf(const Mission& mission) {
  std::vector<ViewEvent> planned;
  for (const Event& event : mission.events) {
    const std::string vehicle = VehicleOf(event);
    std::vector<std::string> vehicles;
    if (mission.FindVehicle(vehicle) != nullptr) vehicles.push_back(vehicle);
    planned.push_back({.utime = mission.start_utime + Microseconds(event.at_s),
                       .kind = EventKind::kMission,
                       .vehicles = std::move(vehicles),
                       .text = EventText(event)});
  }
  return planned;
}

std::vector<ViewEvent> EventsOf(const MissionVerdict& verdict, int64_t start_utime) {
  constexpr size_t kMaxVerdicts = 500;
  constexpr double kLongest_s = 1e9;
  std::vector<ViewEvent> events;
  for (const VerdictLine& line : verdict.lines) {
    if (events.size() == kMaxVerdicts) break;
    events.push_back(
        {.utime =
             start_utime + static_cast<int64_t>(std::clamp(verdict.end_s, 0.0, kLongest_s) * 1e6),
         .kind = line.passed ? EventKind::kMet : EventKind::kMissed,
         .vehicles = {},
         .text = fmt::format("{}: {}: {}", line.passed ? "met" : "missed",
                             line.text.substr(0, kMaxReason), line.numbers.substr(0, kMaxReason))});
  }
  return events;
}

std::string_view EventKindText(EventKind kind) {
  constexpr EnumTable<EventKind, std::string_view> kTexts = {
      "collision",    "aground",       "all_stop",     "cleared",  "first_contact",
      "lost_contact", "contact_again", "waypoint",     "deployed", "parked",
      "task",         "message",       "message_lost", "surfaced", "fix",
      "role",         "replanned",     "mission",      "met",      "missed"};
  return kTexts[kind];
}

EventWatch::EventWatch(std::vector<WatchedVehicle> vehicles, std::vector<ViewEvent> planned)
    : vehicles_(std::move(vehicles)),
      positions_m_(vehicles_.size(), Eigen::Vector3d::Zero()),
      collisions_(LengthsOf(vehicles_)),
      groundings_(vehicles_.size()),
      helms_(vehicles_.size()),
      is_deep_(vehicles_.size()),
      has_fix_(vehicles_.size()),
      parts_(vehicles_.size()),
      planned_(std::move(planned)) {
  for (const WatchedVehicle& vehicle : vehicles_) names_.push_back(vehicle.name);
}

void EventWatch::OnNav(size_t vehicle, int64_t utime, double x_m, double y_m, double z_m,
                       double altitude_m) {
  if (vehicle >= vehicles_.size()) return;
  utime = PlausibleUtime(utime);
  if (utime != nav_utime_) {
    if (utime < nav_utime_ && nav_utime_ - utime < kOvertaking_us) return;
    CompareAll();
    nav_utime_ = utime;
  }
  if (!std::isfinite(x_m) || !std::isfinite(y_m) || !std::isfinite(z_m)) return;
  positions_m_[vehicle] = {x_m, y_m, z_m};
  seen_.push_back(static_cast<uint32_t>(vehicle));
  const std::optional<double> draught_m = vehicles_[vehicle].draught_m;
  if (draught_m && altitude_m >= 0 && groundings_.Look(vehicle, altitude_m - *draught_m)) {
    const std::string& name = vehicles_[vehicle].name;
    AddEvent(utime, EventKind::kAground, {name}, fmt::format("{}: aground", name));
  }
  WatchSurface(vehicle, utime, z_m);
  if (seen_.size() >= vehicles_.size()) CompareAll();
}

void EventWatch::WatchSurface(size_t vehicle, int64_t utime, double z_m) {
  constexpr double kDeep_m = 2;
  constexpr double kAtSurface_m = 0.5;
  if (vehicles_[vehicle].draught_m != 0.0) return;
  if (z_m > kDeep_m) {
    is_deep_[vehicle] = true;
  } else if (z_m < kAtSurface_m && is_deep_[vehicle]) {
    is_deep_[vehicle] = false;
    const std::string& name = vehicles_[vehicle].name;
    AddOneOfMany(utime, EventKind::kSurfaced, {name}, fmt::format("{}: at the surface", name));
  }
}

void EventWatch::OnHelm(size_t vehicle, const helm_state_t& helm) {
  if (vehicle >= vehicles_.size()) return;
  WatchStop(vehicle, helm);
  WatchArrival(vehicle, helm);
  WatchTask(vehicle, helm);
  helms_[vehicle] = helm;
}

void EventWatch::WatchStop(size_t vehicle, const helm_state_t& helm) {
  const bool is_stopped = helm.state == kStopped;
  if (is_stopped == (helms_[vehicle].state == kStopped)) return;
  const std::string& name = vehicles_[vehicle].name;
  if (is_stopped) {
    AddEvent(helm.utime, EventKind::kAllStop, {name},
             fmt::format("{}: {}", name,
                         helm.all_stop == kByCommand ? std::string("by command")
                                                     : helm.all_stop.substr(0, kMaxReason)));
  } else {
    AddEvent(helm.utime, EventKind::kCleared, {name}, fmt::format("{}: all-stop is over", name));
  }
}

void EventWatch::WatchArrival(size_t vehicle, const helm_state_t& helm) {
  const std::string arrival = ArrivalText(helms_[vehicle], helm);
  if (arrival.empty()) return;
  if (num_arrivals_ == kMaxArrivals) {
    ++num_left_out_;
    return;
  }
  ++num_arrivals_;
  const std::string& name = vehicles_[vehicle].name;
  AddEvent(helm.utime, EventKind::kWaypoint, {name},
           fmt::format("{}: {}", name, arrival.substr(0, kMaxReason)));
}

void EventWatch::WatchTask(size_t vehicle, const helm_state_t& helm) {
  const helm_state_t& before = helms_[vehicle];
  const std::string& name = vehicles_[vehicle].name;
  const bool drives = helm.state == kDrives;
  if (drives && before.state != kDrives && before.state != kStopped) {
    AddOneOfMany(helm.utime, EventKind::kDeployed, {name}, fmt::format("{}: deployed", name));
  }
  if (helm.state == kParked && before.state == kDrives) {
    AddOneOfMany(helm.utime, EventKind::kParked, {name}, fmt::format("{}: parked", name));
  }
  if (!drives || helm.task.empty() || helm.task == before.task) return;
  AddOneOfMany(helm.utime, EventKind::kTask, {name},
               fmt::format("{}: task {}", name, helm.task.substr(0, kMaxReason)));
}

void EventWatch::OnDecision(size_t vehicle, const helm_decision_t& decision) {
  if (vehicle >= vehicles_.size()) return;
  /// A part that is not named for so long has ended; when it comes again it is another encounter.
  constexpr int64_t kForgotten_us = 30 * kSecond_us;
  const int64_t utime = PlausibleUtime(decision.utime);
  std::vector<Part>& parts = parts_[vehicle];
  std::erase_if(parts, [&](const Part& part) { return utime - part.utime > kForgotten_us; });
  for (const std::string& event : decision.events) {
    const Eigen::Vector2d position_m = positions_m_[vehicle].head<2>();
    if (auto plan = vehicles_[vehicle].plan.OnEvent(event, position_m)) {
      AddPlan(vehicle, utime, event, std::move(*plan));
    }
  }
  const std::string& name = vehicles_[vehicle].name;
  for (const helm_aim_t& aim : decision.aims) {
    if (aim.contact.empty() || aim.role.empty()) continue;
    auto part = std::find_if(parts.begin(), parts.end(),
                             [&](const Part& each) { return each.contact == aim.contact; });
    if (part == parts.end()) {
      if (parts.size() == kMaxParts) continue;
      parts.push_back({.contact = aim.contact});
      part = parts.end() - 1;
    }
    part->utime = utime;
    if (part->role == aim.role) continue;
    part->role = aim.role;
    std::string text = fmt::format("{}: {} toward {}", name, aim.role, aim.contact);
    if (!aim.rule.empty()) text += fmt::format(" (rule {})", aim.rule);
    if (aim.range_m >= 0) text += fmt::format(", {:.1f} m", aim.range_m);
    AddOneOfMany(utime, EventKind::kRole, {name, aim.contact}, text.substr(0, 2 * kMaxReason));
  }
}

void EventWatch::OnNavigation(size_t vehicle, const navigation_t& navigation) {
  if (vehicle >= vehicles_.size()) return;
  const bool has_fix = navigation.has_gps_fix != 0;
  if (has_fix_[vehicle] == false && has_fix) {
    const std::string& name = vehicles_[vehicle].name;
    AddOneOfMany(navigation.utime, EventKind::kFix, {name}, fmt::format("{}: GPS fix", name));
  }
  has_fix_[vehicle] = has_fix;
}

void EventWatch::OnMessage(int32_t from, int32_t to, const FateView& fate) {
  const CauseOutcome outcome = RowOf(fate.facts.cause).outcome;
  if (fate.facts.kind != Kind::kMessage || outcome == CauseOutcome::kPending) return;
  const bool is_received = IsReceived(fate.facts.cause);
  AddOneOfMany(fate.facts.utime, is_received ? EventKind::kMessage : EventKind::kMessageLost,
               {NameOf(from), NameOf(to)},
               fmt::format("message {} of {}", fate.facts.number, FateText(fate)));
}

void EventWatch::TakePlanned(int64_t utime) {
  for (; next_planned_ < planned_.size() && planned_[next_planned_].utime <= utime;
       ++next_planned_) {
    const ViewEvent& event = planned_[next_planned_];
    AddEvent(event.utime, event.kind, event.vehicles, event.text.substr(0, kMaxReason));
  }
}

void EventWatch::AddOneOfMany(int64_t utime, EventKind kind, std::vector<std::string> vehicles,
                              std::string text) {
  size_t& count = num_of_kind_.at(static_cast<size_t>(kind));
  if (count == kMaxOfKind) {
    ++num_left_out_;
    return;
  }
  ++count;
  AddEvent(utime, kind, std::move(vehicles), std::move(text));
}

void EventWatch::SetStaleTime(double stale_time_s) {
  constexpr double kLongest_s = 1e9;
  const double silence_s = std::clamp(2 * stale_time_s, kLeastSilence_s, kLongest_s);
  silence_us_ =
      static_cast<int64_t>((std::isfinite(silence_s) ? silence_s : kLeastSilence_s) * 1e6);
  next_loss_utime_ = -kFarthest_us;
}

void EventWatch::SetName(int32_t number, std::string_view name) {
  if (number < 0 || static_cast<size_t>(number) >= kMaxNames) return;
  const auto place = static_cast<size_t>(number);
  if (names_.size() <= place) names_.resize(place + 1);
  names_[place] = name;
}

void EventWatch::CompareAll() {
  std::sort(seen_.begin(), seen_.end());
  seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
  for (const Collision& collision : collisions_.Look(seen_, positions_m_)) {
    const std::string& first = vehicles_[collision.first].name;
    const std::string& second = vehicles_[collision.second].name;
    AddEvent(nav_utime_, EventKind::kCollision, {first, second},
             fmt::format("{} and {}: {:.1f} m, less than {:.1f} m", first, second,
                         collision.range_m, collision.allowed_m));
  }
  seen_.clear();
}

void EventWatch::OnDelivery(int32_t from, int32_t to, int64_t utime) {
  const auto [a, b] = std::minmax(from, to);
  if (a < 0 || a == b || static_cast<size_t>(b) >= kMaxNames) return;
  const auto later = static_cast<size_t>(b);
  const size_t place = later * (later - 1) / 2 + static_cast<size_t>(a);
  if (pairs_.size() <= place) pairs_.resize(later * (later + 1) / 2);
  Pair& pair = pairs_[place];
  pair.received_utime = utime;
  if (pair.contact == Contact::kNow) return;
  const bool is_first = pair.contact == Contact::kNone;
  pair.contact = Contact::kNow;
  next_loss_utime_ = std::min(next_loss_utime_, utime + silence_us_);
  const std::string first = NameOf(a);
  const std::string second = NameOf(b);
  AddEvent(
      utime, is_first ? EventKind::kFirstContact : EventKind::kContactAgain, {first, second},
      fmt::format("{} and {}: {}", first, second, is_first ? "first contact" : "contact again"));
}

void EventWatch::FindLosses(int64_t utime) {
  next_loss_utime_ = 2 * kFarthest_us;
  size_t place = 0;
  for (int32_t b = 1; place < pairs_.size(); ++b) {
    for (int32_t a = 0; a < b; ++a, ++place) {
      Pair& pair = pairs_[place];
      if (pair.contact != Contact::kNow) continue;
      const int64_t lost_utime = pair.received_utime + silence_us_;
      if (utime < lost_utime) {
        next_loss_utime_ = std::min(next_loss_utime_, lost_utime);
        continue;
      }
      pair.contact = Contact::kLost;
      const std::string first = NameOf(a);
      const std::string second = NameOf(b);
      AddEvent(lost_utime, EventKind::kLostContact, {first, second},
               fmt::format("{} and {}: nothing received for {:.1f} s", first, second,
                           Seconds(silence_us_)));
    }
  }
}

void EventWatch::OnCommand(size_t vehicle, const helm_command_t& command, int64_t utime) {
  if (vehicle >= vehicles_.size() || command.command != "move") return;
  if (auto plan = vehicles_[vehicle].plan.OnMove(command.argument, command.values)) {
    AddPlan(vehicle, utime, "move: " + command.argument, std::move(*plan));
  }
}

void EventWatch::AddPlan(size_t vehicle, int64_t utime, const std::string& what, std::string plan) {
  const std::string& name = vehicles_[vehicle].name;
  const size_t before = events_.size();
  AddOneOfMany(utime, EventKind::kReplanned, {name},
               fmt::format("{}: {}", name, what.substr(0, kMaxReason)));
  if (events_.size() > before) events_.back().plan = std::move(plan);
}

void EventWatch::AddEvent(int64_t utime, EventKind kind, std::vector<std::string> vehicles,
                          std::string text) {
  if (events_.size() == kMaxEvents) {
    ++num_left_out_;
    return;
  }
  events_.push_back({.utime = PlausibleUtime(utime),
                     .kind = kind,
                     .vehicles = std::move(vehicles),
                     .text = std::move(text)});
}

std::string EventWatch::NameOf(int32_t number) const {
  const auto place = static_cast<size_t>(number);
  return place < names_.size() ? names_[place] : std::string();
}

}  // namespace shoal
