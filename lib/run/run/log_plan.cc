#include "lib/run/run/log_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <set>
#include <system_error>

#include "lib/base/arithmetic/elementary.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_format.h"
#include "lib/bus/record/log_writer.h"
#include "lib/mission/model/remus100_model.h"

namespace shoal {

namespace {

// Sizes of encoded messages, as the logs of missions/ have them.
constexpr double kNav_bytes = 168;
constexpr double kActuators_bytes = 48;
constexpr double kDesired_bytes = 40;
constexpr double kHelmState_bytes = 119;
constexpr double kGuidance_bytes = 280;
constexpr double kHelmDecision_bytes = 366;
constexpr double kNavigation_bytes = 230;
constexpr double kSonarBeam_bytes = 24;
constexpr double kReport_bytes = 182;
constexpr double kFate_bytes = 16;
constexpr double kPulse_bytes = 20;
constexpr double kSwarm_bytes = 60;
constexpr double kSwarmContact_bytes = 120;

/// The share of reports over a medium that arrives: a shared acoustic network loses most of them if
/// several are sent in a second.
constexpr double kShareOverMedia = 0.1;

bool IsRun(Provider provider) { return provider != Provider::kNone; }

/// Sums up the events of the channels that a log takes.
class Sum {
 public:
  explicit Sum(const ChannelChoice& choice) : choice_(choice) {}

  void Add(const std::string& channel, double num_events, double data_bytes) {
    if (!choice_.Takes(channel)) return;
    bytes_ += num_events * (static_cast<double>(kLogHeaderSize + channel.size()) + data_bytes);
  }
  double bytes() const { return bytes_; }

 private:
  const ChannelChoice& choice_;
  double bytes_ = 0;
};

/// Which vehicles can receive reports of which, where they start.
class StartRanges {
 public:
  explicit StartRanges(const Mission& mission) : mission_(mission) {}

  bool Reaches(const Vehicle& from, const Vehicle& to) const {
    const RoutingRules& rules = mission_.comms;
    const double range_m = Hypot(from.start.x_m - to.start.x_m, from.start.y_m - to.start.y_m);
    if (rules.groups && from.group != to.group) return false;
    if (rules.comms_range_m < 0 || range_m < rules.critical_range_m) return true;
    return range_m < rules.comms_range_m * from.link_factors.stealth * to.link_factors.earange;
  }

 private:
  const Mission& mission_;
};

void AddOwnChannels(const Mission& mission, const Vehicle& vehicle, Sum* sum) {
  const double num_steps = static_cast<double>(mission.LastStep() + 1);
  const double steps_per_s = 1e6 / static_cast<double>(mission.tick_us);
  const auto num_at = [&](double rate_hz) {
    return std::max(mission.duration_s, 1.0) * std::min(rate_hz, steps_per_s);
  };
  const std::string& name = vehicle.name;
  if (IsRun(vehicle.sim)) {
    sum->Add(channels::Nav(name).name, num_steps, kNav_bytes);
    if (vehicle.sensors.is_fitted) {
      sum->Add(channels::MeasuredNav(name).name, num_steps, kNav_bytes);
    }
    if (vehicle.navigation.is_fitted) {
      sum->Add(channels::EstimatedNav(name).name, num_steps, kNav_bytes);
      sum->Add(channels::Navigation(name).name,
               num_at(1 / std::max(vehicle.navigation.report_every_s, 1e-3)), kNavigation_bytes);
    }
    if (vehicle.sonar.is_fitted) {
      sum->Add(channels::Sonar(name).name, num_at(vehicle.sonar.rate_hz),
               vehicle.sonar.azimuth_beams * vehicle.sonar.elevation_beams * kSonarBeam_bytes);
    }
  }
  if (IsRun(vehicle.helm)) {
    sum->Add(channels::Actuators(name).name, num_steps, kActuators_bytes);
    sum->Add(channels::Desired(name).name, num_steps, kDesired_bytes);
    sum->Add(channels::HelmState(name).name,
             num_at(1 / std::max(vehicle.helm_options.state_interval_s, 1e-3)), kHelmState_bytes);
    if (std::holds_alternative<Remus100Options>(vehicle.model)) {
      sum->Add(channels::Guidance(name).name, num_at(1), kGuidance_bytes);
    }
    if (!vehicle.behaviors.empty()) {
      sum->Add(channels::HelmDecision(name).name, num_at(1), kHelmDecision_bytes);
    }
  }
  if (const SwarmOptions* swarm = mission.SwarmOf(vehicle);
      swarm != nullptr && IsRun(vehicle.acomms)) {
    sum->Add(channels::Swarm(name).name, num_at(2),
             kSwarm_bytes + kSwarmContact_bytes * static_cast<double>(swarm->followers.size()));
  }
}

void AddReports(const Mission& mission, Sum* sum) {
  const StartRanges ranges(mission);
  const bool has_pulses = mission.comms.pulse_duration_s > 0 && mission.comms.view_node_rpt_pulses;
  const double steps_per_s = 1e6 / static_cast<double>(mission.tick_us);
  double num_fates = 0;
  double num_delivered = 0;
  for (const Vehicle& to : mission.vehicles) {
    if (!mission.IsReported(to)) continue;
    double num_received = 0;
    for (const Vehicle& from : mission.vehicles) {
      if (&from == &to || !mission.IsReported(from)) continue;
      const double num_reports =
          mission.duration_s * std::min(from.reporter_options.rate_hz, steps_per_s);
      const bool arrives = ranges.Reaches(from, to);
      if (arrives) {
        num_received +=
            num_reports * (GoesOverMedia(mission.comms, Kind::kReport) ? kShareOverMedia : 1);
      }
      if (arrives ||
          static_cast<int64_t>(mission.vehicles.size()) <= mission.comms.each_fate_up_to) {
        num_fates += num_reports;
      }
    }
    num_delivered += num_received;
    sum->Add(channels::NodeReport(to.name).name, num_received, kReport_bytes);
    sum->Add(channels::NodeReportLocal().name,
             mission.duration_s * std::min(to.reporter_options.rate_hz, steps_per_s),
             kReport_bytes);
  }
  // The items of a step share a message, whose head is small beside them.
  const auto add_lists = [&](const std::string& channel, double num_items, double item_bytes) {
    if (num_items > 0) sum->Add(channel, 1, num_items * item_bytes);
  };
  add_lists(channels::CommsFates().name, num_fates, kFate_bytes);
  if (has_pulses) add_lists(channels::ViewCommsPulse().name, num_delivered, kPulse_bytes);
}

/// Returns the names of all channels that shoal's own participants have in this mission.
std::set<std::string> ChannelsOf(const Mission& mission) {
  std::set<std::string> names;
  for (const ChannelRow& row : ChannelTable()) {
    if (!row.logged) continue;
    if (row.home != ChannelHome::kVehicle) {
      names.emplace(row.topic);
      continue;
    }
    for (const Vehicle& vehicle : mission.vehicles) {
      names.insert(
          channels::Nav(vehicle.name).name.replace(0, topics::kNav.size(), std::string(row.topic)));
    }
  }
  return names;
}

void WarnOfUnknown(const Mission& mission, const ChannelChoice& choice, LogPlan* plan) {
  if (choice.TakesAll()) return;
  const std::set<std::string> names = ChannelsOf(mission);
  const auto warn = [&](const std::string& option, const std::vector<std::string>& globs) {
    for (const std::string& glob : globs) {
      if (std::ranges::any_of(names,
                              [&](const std::string& name) { return Matches(glob, name); })) {
        continue;
      }
      plan->warnings.push_back(fmt::format(
          "{} '{}' matches none of shoal's channels in this mission, such as {}; only a channel of "
          "your own program can have such a name (`shoal channels` lists shoal's)",
          option, glob,
          mission.vehicles.empty() ? std::string(topics::kCommsFates)
                                   : channels::Nav(mission.vehicles.front().name).name));
    }
  };
  warn("--channels", choice.only);
  warn("--without", choice.without);
}

/// Returns the nearest folder above a path that exists.
std::filesystem::path FolderOf(const std::string& path) {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::absolute(path, error).lexically_normal();
  while (!std::filesystem::is_directory(folder, error) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  return folder;
}

}  // namespace

double EstimateLog_bytes(const Mission& mission, const ChannelChoice& choice) {
  Sum sum(choice);
  for (const Vehicle& vehicle : mission.vehicles) AddOwnChannels(mission, vehicle, &sum);
  if (IsRun(mission.broker)) AddReports(mission, &sum);
  return sum.bytes();
}

std::string BytesText(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", std::max(bytes / 1e3, 1.0));
  if (bytes < 1e9) return fmt::format("{:.0f} MB", bytes / 1e6);
  return fmt::format("{:.1f} GB", bytes / 1e9);
}

LogPlan PlanLog(const Mission& mission, const ChannelChoice& choice, const std::string& path,
                std::optional<bool> compress) {
  LogPlan plan;
  plan.bytes = EstimateLog_bytes(mission, choice);
  plan.is_compressed = path.ends_with(".lcm") ? false
                       : path.ends_with(kCompressedSuffix)
                           ? true
                           : compress.value_or(plan.bytes > kPlainLog_bytes);
  plan.file_bytes = plan.bytes * (plan.is_compressed ? kCompressedShare : 1);
  std::error_code error;
  const std::filesystem::path folder = FolderOf(path);
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if (!error && plan.file_bytes > static_cast<double>(space.available)) {
    plan.warnings.push_back(fmt::format(
        "the log may have {}, and the disk of {} has {} left: free some, record on another disk{}, "
        "or leave channels out (--without)",
        BytesText(plan.file_bytes), folder.string(),
        BytesText(static_cast<double>(space.available)),
        plan.is_compressed ? "" : ", compress it (.zst, --compress)"));
  }
  WarnOfUnknown(mission, choice, &plan);
  return plan;
}

}  // namespace shoal
