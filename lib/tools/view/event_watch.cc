#include "lib/tools/view/event_watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/check/enum_table.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/waypoint_arrival.h"
#include "lib/mission/model/mission.h"
#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

constexpr size_t kMaxReason = 200;
/// What a helm states of an all-stop that came without a reason.
constexpr std::string_view kByCommand = "all_stop command";
constexpr std::string_view kStopped = "ALL-STOP";

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
    vehicles.push_back({.name = vehicle.name, .length_m = vehicle.length_m});
    if (FactsOfModel(vehicle.model).passive.empty()) vehicles.back().draught_m = DraughtOf(vehicle);
  }
  return vehicles;
}

std::string_view EventKindText(EventKind kind) {
  constexpr EnumTable<EventKind, std::string_view> kTexts = {
      "collision",     "aground",      "all_stop",      "cleared",
      "first_contact", "lost_contact", "contact_again", "waypoint"};
  return kTexts[kind];
}

EventWatch::EventWatch(std::vector<WatchedVehicle> vehicles)
    : vehicles_(std::move(vehicles)),
      positions_m_(vehicles_.size(), Eigen::Vector3d::Zero()),
      collisions_(LengthsOf(vehicles_)),
      groundings_(vehicles_.size()),
      helms_(vehicles_.size()) {
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
  if (seen_.size() >= vehicles_.size()) CompareAll();
}

void EventWatch::OnHelm(size_t vehicle, const helm_state_t& helm) {
  if (vehicle >= vehicles_.size()) return;
  WatchStop(vehicle, helm);
  WatchArrival(vehicle, helm);
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
