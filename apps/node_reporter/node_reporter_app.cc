#include "apps/node_reporter/node_reporter_app.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "apps/node_reporter/dead_reckoning.h"
#include "lib/base/time/seconds.h"
#include "lib/run/run/own_nav.h"

namespace shoal {

namespace {

/// NAV comes in every step; after this many seconds without it a position is dead reckoned.
constexpr double kNavTimeout_s = 2;
/// Fields of a report about the ellipse that holds the vehicle's position, with 95 %: half of its
/// long and short axis in metres, and the heading of the long one in degrees.
constexpr std::string_view kMajorKey = "NAV_MAJOR_M";
constexpr std::string_view kMinorKey = "NAV_MINOR_M";
constexpr std::string_view kDirectionKey = "NAV_MAJOR_DEG";
constexpr std::string_view kNavWarning = "no NAV, hence no reports";
constexpr std::string_view kBadNavWarning = "NAV dropped: it holds an impossible number";

bool AllReportedNumbersAreFinite(const nav_t& nav) {
  for (const double number :
       {nav.x_m, nav.y_m, nav.z_m, nav.altitude_m, nav.lat_deg, nav.lon_deg, nav.speed_mps,
        nav.heading_deg, nav.speed_over_ground_mps, nav.course_over_ground_deg}) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

}  // namespace

NodeReporterApp::NodeReporterApp(const Mission& mission, const Vehicle& vehicle, Bus& bus)
    : bus_(bus),
      start_utime_(mission.start_utime),
      now_utime_(mission.start_utime),
      nav_grace_period_s_(vehicle.reporter_options.nav_grace_period_s),
      schedule_(vehicle.reporter_options.rate_hz, mission.start_utime, mission.tick_us),
      mediator_(vehicle.name, vehicle.message_options, mission.seed, bus, &log_),
      name_(vehicle.name),
      options_(vehicle.reporter_options),
      blackout_stream_(StreamKey(mission.seed, "blackout").With(vehicle.name)),
      silent_until_utime_(mission.start_utime) {
  report_.name = vehicle.name;
  report_.type = vehicle.type;
  report_.group = vehicle.group;
  report_.color = vehicle.color;
  report_.length_m = vehicle.length_m;
  for (const auto& [key, value] : options_.extra) {
    report_.extra.push_back({.key = key, .value = value});
  }
  report_.num_extra = static_cast<int32_t>(report_.extra.size());

  const double tick_hz = 1e6 / static_cast<double>(mission.tick_us);
  if (options_.rate_hz > tick_hz) {
    log_.WarnConfig(
        fmt::format("rate_hz = {:g} is above the mission's {:g} steps per second; "
                    "reports go out in every step",
                    options_.rate_hz, tick_hz));
  } else if (!(options_.rate_hz > 0)) {
    log_.WarnConfig(fmt::format("rate_hz = {:g}: no reports", options_.rate_hz));
  }

  Subscribe(bus, OwnNav(vehicle), [this](const nav_t& nav) { TakeNav(nav); });
  if (vehicle.navigation.is_fitted) {
    Subscribe(bus, channels::Navigation(vehicle.name),
              [this](const navigation_t& navigation) { TakeUncertainty(navigation); });
  }
  Subscribe(bus, channels::HelmState(vehicle.name), [this](const helm_state_t& state) {
    helm_ = state;
    helm_is_new_ = true;
  });
}

void NodeReporterApp::TakeUncertainty(const navigation_t& navigation) {
  report_.extra.resize(options_.extra.size());
  for (const auto& [key, value] : {std::pair(kMajorKey, navigation.ellipse_major_m),
                                   std::pair(kMinorKey, navigation.ellipse_minor_m),
                                   std::pair(kDirectionKey, navigation.ellipse_heading_deg)}) {
    report_.extra.push_back({.key = std::string(key), .value = fmt::format("{:.1f}", value)});
  }
  report_.num_extra = static_cast<int32_t>(report_.extra.size());
}

void NodeReporterApp::TakeNav(const nav_t& nav) {
  if (!AllReportedNumbersAreFinite(nav)) {
    ++num_bad_nav_;
    log_.Warn(kBadNavWarning);
    return;
  }
  nav_ = nav;
  nav_is_new_ = true;
}

void NodeReporterApp::Tick(int64_t utime) {
  now_utime_ = utime;
  if (nav_is_new_) nav_utime_ = utime;
  if (helm_is_new_) helm_utime_ = utime;
  nav_is_new_ = helm_is_new_ = false;
  mediator_.Tick(utime);
  Report(utime);
}

void NodeReporterApp::Report(int64_t utime) {
  const bool has_nav = HasFreshNav(utime);
  if (!schedule_.IsDue(utime)) return;
  if (!has_nav) {
    ++num_without_nav_;
    return;
  }
  if (utime < silent_until_utime_) {
    ++num_blacked_out_;
    return;
  }
  FillReport(utime);
  if (options_.extrapolate && IsForetold()) {
    ++num_predicted_;
    return;
  }
  report_.index = num_sent_++;
  Publish(bus_, channel_, report_);
  if (options_.extrapolate) last_sent_ = report_;
  if (options_.blackout_interval_s > 0) StartBlackout(utime);
}

/// Returns whether there is NAV to report from; warns and takes the warning back.
bool NodeReporterApp::HasFreshNav(int64_t utime) {
  const bool fresh = nav_utime_ && SecondsBetween(*nav_utime_, utime) <= kNavTimeout_s;
  const bool warn = !fresh && SecondsBetween(start_utime_, utime) >= nav_grace_period_s_;
  if (warn && !warned_of_nav_) {
    log_.Warn(kNavWarning);
    log_.Event(utime, kNavWarning);
  } else if (!warn && warned_of_nav_) {
    log_.Retract(kNavWarning);
    log_.Event(utime, "NAV is back");
  }
  warned_of_nav_ = warn;
  return fresh;
}

/// Returns the time of the NAV that is reported. A program of the user's that leaves it out, or has
/// a clock of its own, is taken at the step in which its NAV came.
int64_t NodeReporterApp::NavUtime(int64_t utime) const {
  const bool is_plausible =
      nav_.utime <= utime && SecondsBetween(nav_.utime, utime) <= kNavTimeout_s;
  return is_plausible ? nav_.utime : nav_utime_.value_or(utime);
}

void NodeReporterApp::FillReport(int64_t utime) {
  report_.utime = NavUtime(utime);
  report_.x_m = nav_.x_m;
  report_.y_m = nav_.y_m;
  report_.depth_m = nav_.z_m;
  report_.altitude_m = nav_.altitude_m;
  report_.lat_deg = nav_.lat_deg;
  report_.lon_deg = nav_.lon_deg;
  report_.speed_mps = nav_.speed_mps;
  report_.heading_deg = nav_.heading_deg;
  report_.speed_over_ground_mps = nav_.speed_over_ground_mps;
  report_.course_over_ground_deg = nav_.course_over_ground_deg;
  report_.mode = Mode(utime);
  report_.all_stop = helm_utime_ ? helm_.all_stop : "clear";
}

std::string NodeReporterApp::Mode(int64_t utime) const {
  if (!helm_utime_) return "NOHELM-EVER";
  const double silence_s = SecondsBetween(*helm_utime_, utime);
  if (silence_s > options_.nohelm_threshold_s) return fmt::format("NOHELM-{:.0f}", silence_s);
  return helm_.task.empty() ? helm_.state : helm_.state + ":" + helm_.task;
}

bool NodeReporterApp::IsForetold() const {
  return last_sent_ && Predicts(*last_sent_, report_,
                                {.position_m = options_.extrap_position_thresh_m,
                                 .heading_deg = options_.extrap_heading_thresh_deg,
                                 .max_gap_s = options_.extrap_max_gap_s});
}

/// The next report waits for the interval and a random addition of up to the variance, either way.
void NodeReporterApp::StartBlackout(int64_t utime) {
  const double uniform = Stream(blackout_stream_.With(report_.index)).Uniform();
  const double gap_s =
      options_.blackout_interval_s + (2 * uniform - 1) * options_.blackout_variance_s;
  silent_until_utime_ = utime + Microseconds(gap_s);
}

StatusPage NodeReporterApp::Status() const {
  const auto age = [this](const std::optional<int64_t>& heard_utime) {
    return heard_utime ? fmt::format("{:.1f} s ago", SecondsBetween(*heard_utime, now_utime_))
                       : std::string("never");
  };
  StatusPage page;
  page.text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({}, group {}, {}, {:g} m)\n"
      "    Rate: {:g} Hz\n"
      "    Blackout: {:g} s +- {:g} s\n"
      "    Extrapolation: {}\n"
      "\nNAV: {}\n"
      "Helm: {} ({})\n"
      "\nReports sent: {}\n"
      "    Skipped without NAV: {}\n"
      "    Skipped in blackout: {}\n"
      "    Skipped as predicted: {}\n"
      "    NAV with impossible numbers: {}\n"
      "\nMessages to be acknowledged: {}\n"
      "    Acknowledged: {}\n"
      "    Waiting: {}\n"
      "    Given up: {}\n"
      "    Refused: {}\n"
      "    Repeats: {}\n"
      "Acks of others' messages: {}\n"
      "    Left out: {}\n"
      "Acks that nothing waits for: {}\n"
      "\nUndecodable messages: {}\n",
      name_, report_.type, report_.group.empty() ? "(none)" : report_.group, report_.color,
      report_.length_m, options_.rate_hz, options_.blackout_interval_s,
      options_.blackout_variance_s,
      options_.extrapolate
          ? fmt::format("within {:g} m and {:g} deg, at most {:g} s",
                        options_.extrap_position_thresh_m, options_.extrap_heading_thresh_deg,
                        options_.extrap_max_gap_s)
          : std::string("off"),
      age(nav_utime_), age(helm_utime_), Mode(now_utime_), num_sent_, num_without_nav_,
      num_blacked_out_, num_predicted_, num_bad_nav_, mediator_.counters().given,
      mediator_.counters().acknowledged, mediator_.num_waiting(), mediator_.counters().given_up,
      mediator_.counters().refused, mediator_.counters().repeats, mediator_.counters().acks_sent,
      mediator_.counters().acks_unsent, mediator_.counters().acks_unexpected,
      bus_.counters().undecodable);
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
