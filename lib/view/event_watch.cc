#include "lib/view/event_watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/mission/mission.h"
#include "lib/vehicle/contact.h"
#include "lib/view/view_limits.h"

namespace shoal {

namespace {

constexpr size_t kMaxReason = 200;
/// An encounter is over where they are this many times as far apart as a collision is.
constexpr double kParted = 2;

}  // namespace

std::vector<WatchedVehicle> WatchedVehiclesOf(const Mission& mission) {
  std::vector<WatchedVehicle> vehicles;
  for (const Vehicle& vehicle : mission.vehicles) {
    vehicles.push_back({.name = vehicle.name, .length_m = vehicle.length_m});
  }
  return vehicles;
}

std::string_view EventKindText(EventKind kind) {
  constexpr std::array<std::string_view, 6> kTexts = {
      "collision", "all_stop", "cleared", "first_contact", "lost_contact", "contact_again"};
  return kTexts.at(static_cast<size_t>(kind));
}

EventWatch::EventWatch(std::vector<WatchedVehicle> vehicles)
    : vehicles_(std::move(vehicles)),
      positions_m_(vehicles_.size(), Eigen::Vector3d::Zero()),
      is_stopped_(vehicles_.size()) {
  for (const WatchedVehicle& vehicle : vehicles_) names_.push_back(vehicle.name);
}

void EventWatch::OnNav(size_t vehicle, int64_t utime, double x_m, double y_m, double z_m) {
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
  if (seen_.size() >= vehicles_.size()) CompareAll();
}

void EventWatch::OnHelm(size_t vehicle, int64_t utime, std::string_view state,
                        std::string_view all_stop) {
  if (vehicle >= vehicles_.size()) return;
  const bool is_stopped = state == "ALL-STOP";
  if (is_stopped == is_stopped_[vehicle]) return;
  is_stopped_[vehicle] = is_stopped;
  const std::string& name = vehicles_[vehicle].name;
  if (is_stopped) {
    AddEvent(utime, EventKind::kAllStop, {name},
             fmt::format("{}: all-stop, {}", name, all_stop.substr(0, kMaxReason)));
  } else {
    AddEvent(utime, EventKind::kCleared, {name}, fmt::format("{}: all-stop is over", name));
  }
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

bool EventWatch::HaveParted(uint32_t first, uint32_t second) const {
  return (positions_m_[first] - positions_m_[second]).norm() >
         kParted * NearestAllowed_m(first, second);
}

double EventWatch::NearestAllowed_m(size_t first, size_t second) const {
  return (vehicles_[first].length_m + vehicles_[second].length_m) / 2;
}

void EventWatch::CompareAll() {
  std::sort(seen_.begin(), seen_.end());
  seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
  const auto is_seen = [&](uint32_t vehicle) {
    return std::binary_search(seen_.begin(), seen_.end(), vehicle);
  };
  std::erase_if(touching_, [&](const auto& pair) {
    return is_seen(pair.first) && is_seen(pair.second) && HaveParted(pair.first, pair.second);
  });
  double longest_m = 0;
  for (const uint32_t vehicle : seen_) {
    longest_m = std::max(longest_m, vehicles_[vehicle].length_m);
  }
  for (size_t i = 0; i < seen_.size(); ++i) {
    const Eigen::Vector3d& a_m = positions_m_[seen_[i]];
    for (size_t j = i + 1; j < seen_.size(); ++j) {
      const Eigen::Vector3d& b_m = positions_m_[seen_[j]];
      if (std::abs(a_m.x() - b_m.x()) >= longest_m) continue;
      const WatchedVehicle& a = vehicles_[seen_[i]];
      const WatchedVehicle& b = vehicles_[seen_[j]];
      if (!InContact(a_m, a.length_m, b_m, b.length_m)) continue;
      const std::pair pair(seen_[i], seen_[j]);
      if (std::find(touching_.begin(), touching_.end(), pair) != touching_.end()) continue;
      touching_.push_back(pair);
      AddEvent(nav_utime_, EventKind::kCollision, {a.name, b.name},
               fmt::format("{} and {}: {:.1f} m, less than {:.1f} m", a.name, b.name,
                           (a_m - b_m).norm(), NearestAllowed_m(seen_[i], seen_[j])));
    }
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
                           static_cast<double>(silence_us_) / 1e6));
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
