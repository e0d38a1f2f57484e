// Missions and messages for tests of views.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/time/time_units.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"
#include "lib/mission/model/mission.h"
#include "lib/run/broker/broker_rules.h"
#include "lib/tools/view/view_source.h"

namespace shoal {

/// Returns a mission of 600 s with these vehicles, 3 m long each.
inline Mission MissionOf(const std::vector<std::string>& names) {
  Mission mission;
  mission.name = "test";
  mission.duration_s = 600;
  for (const std::string& name : names) {
    Vehicle vehicle;
    vehicle.name = name;
    mission.vehicles.push_back(vehicle);
  }
  return mission;
}

inline nav_t NavAt(int64_t utime, double x_m, double y_m) {
  nav_t nav{};
  nav.utime = utime;
  nav.x_m = x_m;
  nav.y_m = y_m;
  nav.altitude_m = -1;
  return nav;
}

inline node_report_t ReportOf(std::string_view name, int64_t utime, double x_m, double y_m) {
  node_report_t report{};
  report.utime = utime;
  report.name = name;
  report.x_m = x_m;
  report.y_m = y_m;
  report.length_m = 3;
  report.mode = "DRIVE survey";
  return report;
}

/// Returns a fate of a report, as the broker fills one in.
inline fate_t FateOf(std::string_view source, std::string_view destination,
                     std::string_view cause) {
  fate_t fate{};
  fate.kind = "report";
  fate.source = source;
  fate.destination = destination;
  fate.count = 1;
  fate.cause = cause;
  fate.range_m = fate.limit_m = fate.age_s = fate.age_limit_s = fate.wait_s = fate.loss_pct = -1;
  fate.length_bytes = fate.length_limit_bytes = -1;
  return fate;
}

/// Returns what COMMS_MEDIA has of this fate.
inline fate_medium_t MediumOf(const fate_t& fate, std::string_view medium) {
  fate_medium_t of_medium{};
  of_medium.kind = fate.kind;
  of_medium.source = fate.source;
  of_medium.destination = fate.destination;
  of_medium.number = fate.number;
  of_medium.cause = fate.cause;
  of_medium.medium = medium;
  of_medium.origin = fate.source;
  of_medium.depth_m = of_medium.depth_limit_m = of_medium.range_m = of_medium.limit_m = -1;
  of_medium.horizon_m = of_medium.path_loss_db = of_medium.path_loss_limit_db = -1;
  of_medium.loss_probability = of_medium.delay_s = -1;
  return of_medium;
}

inline comms_media_t MediaOf(int64_t utime, const std::vector<fate_medium_t>& media) {
  comms_media_t message;
  message.utime = utime;
  message.num_media = static_cast<int32_t>(media.size());
  message.media = media;
  return message;
}

/// Returns an acoustic path without losses or errors.
inline acoustic_path_t CalmPath(int64_t sent_utime) {
  acoustic_path_t path{};
  path.sent_utime = sent_utime;
  path.air_s = 0.4;
  path.travel_s = 0.05;
  path.snr_db = -999;
  path.own_packet = -1;
  return path;
}

inline fate_t Through(fate_t fate, const acoustic_path_t& path) {
  fate.num_paths = 1;
  fate.path = {path};
  return fate;
}

inline comms_fates_t FatesOf(int64_t utime, std::vector<fate_t> fates) {
  comms_fates_t message;
  message.utime = utime;
  message.num_fates = static_cast<int32_t>(fates.size());
  message.fates = std::move(fates);
  return message;
}

inline comms_pulse_t PulseOf(std::string_view label, std::string_view ptype, double duration_s) {
  comms_pulse_t pulse{};
  pulse.sx_m = 1;
  pulse.sy_m = -3;
  pulse.tx_m = 80;
  pulse.ty_m = 20;
  pulse.beam_width_m = 10;
  pulse.duration_s = duration_s;
  pulse.fill = 0.35;
  pulse.label = label;
  pulse.ptype = ptype;
  pulse.fill_color = "orange";
  return pulse;
}

inline comms_pulses_t PulsesOf(int64_t utime, std::vector<comms_pulse_t> pulses) {
  comms_pulses_t message;
  message.utime = utime;
  message.num_pulses = static_cast<int32_t>(pulses.size());
  message.pulses = std::move(pulses);
  return message;
}

/// Returns rules as a broker publishes them.
inline BrokerRules RulesWith(int64_t utime, double comms_range_m, double stale_time_s) {
  BrokerRules rules{.utime = utime};
  rules.rules.comms_range_m = comms_range_m;
  rules.rules.critical_range_m = 30;
  rules.rules.stale_time_s = stale_time_s;
  return rules;
}

/// Returns the query that `ask` changes the default into.
template <class F>
FateQuery Asked(F ask) {
  FateQuery query;
  ask(query);
  return query;
}

}  // namespace shoal
