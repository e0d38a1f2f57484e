#include "lib/tools/view/recorded_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/run/broker/broker_rules.h"
#include "lib/tools/view/fate_facts.h"
#include "shoal/nav_t.hpp"
#include "shoal/node_report_t.hpp"

namespace shoal {

namespace {

/// The number of messages that decide which clock stamped the log's events.
constexpr int kMaxVotes = 64;
constexpr int64_t kMaxEventsForVotes = 100'000;
constexpr int64_t kClocksApart_us = 3'600'000'000;
constexpr size_t kMaxText = 200;

/// True for messages that begin with the time of the step in which they were published.
bool BeginsWithStepTime(std::string_view channel) {
  constexpr std::array kOfVehicles = {topics::kNav, topics::kDesired, topics::kHelmState};
  constexpr std::array kOfShore = {topics::kCommsFates, topics::kCommsRules,
                                   topics::kViewCommsPulse};
  return std::find(kOfShore.begin(), kOfShore.end(), channel) != kOfShore.end() ||
         std::any_of(kOfVehicles.begin(), kOfVehicles.end(), [&](std::string_view topic) {
           return !VehicleOfChannel(channel, topic).empty();
         });
}

std::optional<int64_t> MessageUtime(const LogEvent& event) {
  constexpr size_t kFingerprint = 8;
  if (!BeginsWithStepTime(event.channel) || event.data.size() < 2 * kFingerprint)
    return std::nullopt;
  uint64_t utime = 0;
  for (const uint8_t byte : event.data.subspan(kFingerprint, 8)) utime = utime << 8 | byte;
  return static_cast<int64_t>(utime);
}

template <class T>
bool DecodeLogged(const LogEvent& event, T* message) {
  return Decode(Unseal(event.data).message, message);
}

double FiniteOr(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

/// Puts a mission together of what its messages hold.
class MissionFinder {
 public:
  void Take(const LogEvent& event) {
    if (event.channel == topics::kCommsRules) {
      TakeRules(event);
    } else if (event.channel == topics::kNodeReportLocal) {
      TakeReport(event);
    } else if (const auto vehicle = VehicleOfChannel(event.channel, topics::kNav);
               !vehicle.empty()) {
      TakeNav(vehicle, event);
    }
  }

  /// True where later messages add nothing.
  bool IsComplete() const { return has_rules_ && num_open_ == 0; }

  Mission mission;
  size_t num_left_out = 0;

 private:
  struct Found {
    size_t place = 0;
    bool has_report = false;
    bool has_nav = false;
  };

  /// Returns nullptr for names that no vehicle has, and beyond the first kMaxVehicles.
  Found* FindOrAdd(std::string_view name) {
    if (!IsLegalVehicleName(name)) return nullptr;
    const std::string key = VehicleKey(name);
    const auto known = found_.find(key);
    if (known != found_.end()) return &known->second;
    if (mission.vehicles.size() == LogSurvey::kMaxVehicles) {
      if (left_out_.size() < kMaxLeftOut && left_out_.insert(key).second) ++num_left_out;
      return nullptr;
    }
    mission.vehicles.emplace_back().name = name;
    ++num_open_;
    return &found_.emplace(key, Found{.place = mission.vehicles.size() - 1}).first->second;
  }

  void Complete(Found* found, bool Found::*part) {
    if (found->*part) return;
    found->*part = true;
    if (found->has_nav && found->has_report) --num_open_;
  }

  void TakeRules(const LogEvent& event) {
    if (has_rules_) return;
    const std::optional<BrokerRules> rules = ReadBrokerRules(Unseal(event.data).message);
    if (!rules) return;
    has_rules_ = true;
    mission.seed = static_cast<uint64_t>(rules->seed);
    if (rules->tick_us > 0 && rules->tick_us <= 3'600'000'000) mission.tick_us = rules->tick_us;
    if (std::abs(rules->origin.lat_deg) <= 90 && std::abs(rules->origin.lon_deg) <= 360) {
      mission.origin_lat_deg = rules->origin.lat_deg;
      mission.origin_lon_deg = rules->origin.lon_deg;
    }
    for (const AcousticNode& node : rules->vehicles) FindOrAdd(node.name);
  }

  void TakeReport(const LogEvent& event) {
    node_report_t report;
    if (!DecodeLogged(event, &report)) return;
    Found* found = FindOrAdd(report.name);
    if (found == nullptr || found->has_report) return;
    Vehicle& vehicle = mission.vehicles[found->place];
    vehicle.name = report.name;
    vehicle.type = report.type.substr(0, kMaxText);
    vehicle.color = report.color.substr(0, kMaxText);
    vehicle.group = report.group.substr(0, kMaxText);
    if (report.length_m > 0) vehicle.length_m = FiniteOr(report.length_m, vehicle.length_m);
    Complete(found, &Found::has_report);
  }

  void TakeNav(std::string_view vehicle_of_channel, const LogEvent& event) {
    // In a channel's name a vehicle is in upper case; most are called in lower case.
    Found* found = FindOrAdd(VehicleKey(vehicle_of_channel));
    if (found == nullptr || found->has_nav) return;
    nav_t nav{};
    if (!DecodeLogged(event, &nav)) return;
    Vehicle& vehicle = mission.vehicles[found->place];
    vehicle.start = {.x_m = FiniteOr(nav.x_m, 0),
                     .y_m = FiniteOr(nav.y_m, 0),
                     .heading_deg = FiniteOr(nav.heading_deg, 0),
                     .speed_mps = FiniteOr(nav.speed_mps, 0),
                     .depth_m = FiniteOr(nav.z_m, 0)};
    vehicle.return_task.point_m = {vehicle.start.x_m, vehicle.start.y_m};
    Complete(found, &Found::has_nav);
  }

  static constexpr size_t kMaxLeftOut = 100'000;

  bool has_rules_ = false;
  std::unordered_map<std::string, Found> found_;
  std::unordered_set<std::string> left_out_;
  size_t num_open_ = 0;  ///< Vehicles of which more can be learnt.
};

}  // namespace

std::optional<int64_t> MissionUtimeOf(const LogEvent& event, LogStamps stamps) {
  if (stamps == LogStamps::kMission) return event.utime;
  return MessageUtime(event);
}

LogSurvey SurveyLog(LogReader reader, bool vehicles) {
  LogSurvey survey;
  MissionFinder finder;
  std::optional<int64_t> first_message;
  int num_votes = 0;
  int num_wall = 0;
  for (int64_t i = 0; const auto event = reader.Next(); ++i) {
    if (!survey.has_events) survey.first_utime = PlausibleUtime(event->utime);
    survey.has_events = true;
    const auto message = MessageUtime(*event);
    if (message && num_votes < kMaxVotes) {
      if (!first_message) first_message = PlausibleUtime(*message);
      ++num_votes;
      const int64_t apart_us = PlausibleUtime(event->utime) - PlausibleUtime(*message);
      if (std::abs(apart_us) > kClocksApart_us) ++num_wall;
    }
    if (vehicles) finder.Take(*event);
    const bool has_voted = num_votes == kMaxVotes || i >= kMaxEventsForVotes;
    if (has_voted && (!vehicles || finder.IsComplete())) break;
  }
  if (num_wall > num_votes / 2) {
    survey.stamps = LogStamps::kWall;
    survey.first_utime = *first_message;
  }
  survey.mission = std::move(finder.mission);
  survey.mission.start_utime = survey.first_utime;
  survey.num_left_out = finder.num_left_out;
  return survey;
}

}  // namespace shoal
