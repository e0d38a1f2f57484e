// The tables [[vehicle]] and [template.NAME].
#include <array>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "lib/mission/describe.h"
#include "lib/mission/providers.h"
#include "lib/mission/suggest.h"

namespace shoal {
namespace {

constexpr size_t kMostTasks = 1000;
constexpr size_t kMostThrustPoints = 100;
constexpr size_t kMostExtraFields = 100;
constexpr int kLargestAddress = std::numeric_limits<int>::max();

void Describe(Fields& fields, StartPose& start) {
  fields.Number("x_m", start.x_m, Between(-kFarthest_m, kFarthest_m));
  fields.Number("y_m", start.y_m, Between(-kFarthest_m, kFarthest_m));
  fields.Number("heading_deg", start.heading_deg, Between(-360, 360));
  fields.Number("speed_mps", start.speed_mps, Between(0, kFastest_mps));
  fields.Number("depth_m", start.depth_m, Between(0, 20'000));
}

/// Returns what is wrong with a thrust map, empty where nothing is.
std::string ThrustMapProblem(const std::vector<ThrustPoint>& map) {
  if (map.empty() || map.back().thrust_pct <= 0 || map.back().speed_mps <= 0) {
    return "thrust_map must end with a point of positive thrust and speed, like [[100, 5]]";
  }
  for (size_t i = 0; i < map.size(); ++i) {
    const auto& [thrust_pct, speed_mps] = map[i];
    if (thrust_pct * speed_mps < 0 || (thrust_pct == 0 && speed_mps != 0)) {
      return "thrust_map must give speed ahead for positive thrust, astern for negative, 0 for 0";
    }
    if (i == 0) continue;
    if (thrust_pct <= map[i - 1].thrust_pct || speed_mps < map[i - 1].speed_mps) {
      return "thrust_map must rise: thrust from point to point, and speed must not fall";
    }
  }
  return "";
}

void DescribeThrustMap(Fields& fields, std::vector<ThrustPoint>& map) {
  std::vector<Eigen::Vector2d> pairs;
  for (const ThrustPoint& point : map) pairs.emplace_back(point.thrust_pct, point.speed_mps);
  fields.Pairs("thrust_map", pairs, Between(-100, 100), kMostThrustPoints);
  map.clear();
  for (const Eigen::Vector2d& pair : pairs) map.push_back({pair.x(), pair.y()});
  const std::string problem = ThrustMapProblem(map);
  if (!problem.empty()) fields.Refuse("thrust_map", problem);
}

void Describe(Fields& fields, SurfaceCraftParams& params) {
  DescribeThrustMap(fields, params.thrust_map);
  fields.Number("reverse_ratio", params.reverse_ratio, Between(0, 1));
  fields.Number("max_acceleration_mps2", params.max_acceleration_mps2, Above(0, 100));
  fields.Number("max_deceleration_mps2", params.max_deceleration_mps2, Above(0, 100));
  fields.Number("max_rudder_deg", params.max_rudder_deg, Above(0, 180));
  fields.Number("max_rudder_rate_degps", params.max_rudder_rate_degps, Above(0, 100'000));
  fields.Number("turn_rate_degps", params.turn_rate_degps, Above(0, 360));
  fields.Number("full_turn_speed_mps", params.full_turn_speed_mps, Above(0, kFastest_mps));
  fields.Number("turn_speed_loss", params.turn_speed_loss, Between(0, 0.99));
}

void Describe(Fields& fields, HelmOptions& options) {
  fields.Number("nav_timeout_s", options.nav_timeout_s, Above(0, 3600));
  fields.Flag("deploy_at_start", options.deploy_at_start);
  fields.Number("state_interval_s", options.state_interval_s, Above(0, 3600));
}

void Describe(Fields& fields, AutopilotOptions& options) {
  const Range gain = Between(0, 1000);
  fields.Number("heading_kp", options.heading_kp, gain);
  fields.Number("heading_ki", options.heading_ki, gain);
  fields.Number("heading_kd", options.heading_kd, gain);
  fields.Number("heading_integral_limit_deg", options.heading_integral_limit_deg, Between(0, 180));
  fields.Number("speed_kp", options.speed_kp, gain);
  fields.Number("speed_ki", options.speed_ki, gain);
  fields.Number("speed_integral_limit_pct", options.speed_integral_limit_pct, Between(0, 100));
}

void Describe(Fields& fields, ReporterOptions& options) {
  const Range seconds = Between(0, 100'000);
  fields.Number("rate_hz", options.rate_hz, Above(0, 1000));
  fields.Number("nav_grace_period_s", options.nav_grace_period_s, seconds);
  fields.Number("nohelm_threshold_s", options.nohelm_threshold_s, seconds);
  fields.Number("blackout_interval_s", options.blackout_interval_s, seconds);
  fields.Number("blackout_variance_s", options.blackout_variance_s, seconds);
  if (options.blackout_variance_s > options.blackout_interval_s) {
    fields.Refuse("blackout_variance_s",
                  "blackout_variance_s must not be greater than blackout_interval_s");
  }
  fields.Flag("extrapolate", options.extrapolate);
  fields.Number("extrap_position_thresh_m", options.extrap_position_thresh_m, Between(0, 10'000));
  fields.Number("extrap_heading_thresh_deg", options.extrap_heading_thresh_deg, Between(0, 360));
  fields.Number("extrap_max_gap_s", options.extrap_max_gap_s, seconds);
  fields.TextMap("extra", options.extra, kMostExtraFields);
}

void Describe(Fields& fields, MessageOptions& options) {
  fields.Number("ack_timeout_s", options.ack_timeout_s, Above(0, 100'000));
  fields.Integer("max_repeats", options.max_repeats, 0, 1000);
}

/// [[vehicle.task]]: names are unique within the vehicle, since commands and expectations use them.
void DescribeTasks(Fields& fields, Vehicle& vehicle) {
  std::set<std::string> names;
  fields.List("task", vehicle.tasks, [&](Fields& table, Task& task) {
    Describe(table, task, vehicle.start);
    if (!task.name.empty() && !names.insert(task.name).second) {
      table.Refuse("name", "a task " + Quoted(task.name) +
                               " of this vehicle exists already; give each a name of its own");
    }
  });
  if (vehicle.tasks.size() > kMostTasks) {
    fields.Refuse("task", "more than " + std::to_string(kMostTasks) + " tasks");
  }
}

}  // namespace

void Describe(Fields& fields, Vehicle& vehicle) {
  constexpr std::array<std::string_view, 2> kModels = {"surface_craft", "remus100"};
  fields.Text("name", vehicle.name, {.max_length = 1000});
  if (fields.Has("template", false)) {
    fields.Refuse("template", "only a [[vehicle]] or a [[fleet]] of the file can have a template");
  }
  fields.Text("type", vehicle.type, {.min_length = 1});
  fields.Word("model", vehicle.model, kModels);
  fields.Text("group", vehicle.group, {});
  fields.Text("color", vehicle.color, {.min_length = 1});
  fields.Number("length_m", vehicle.length_m, Above(0, 500));
  fields.Number("stealth", vehicle.link_factors.stealth, Between(0, 1));
  fields.Number("earange", vehicle.link_factors.earange, Between(1, 10));
  if (fields.Has("acoustic_address", vehicle.acoustic_address > 0)) {
    fields.SmallInteger("acoustic_address", vehicle.acoustic_address, 1, kLargestAddress);
  }
  fields.Flag("acoustic_leader", vehicle.acoustic_leader);
  fields.Inline("start", [&](Fields& table) { Describe(table, vehicle.start); });
  fields.Choice("vehicle_sim", vehicle.sim, kProviders);
  fields.Choice("helm", vehicle.helm, kProviders);
  fields.Choice("node_reporter", vehicle.reporter, kProviders);
  fields.Choice("acomms", vehicle.acomms, kProviders);
  fields.Below("surface_craft", [&](Fields& table) { Describe(table, vehicle.surface_craft); });
  fields.Below("remus100", [&](Fields& table) { Describe(table, vehicle.remus100); });
  DescribeInstruments(fields, vehicle);
  fields.Below("helm_options", [&](Fields& table) { Describe(table, vehicle.helm_options); });
  fields.Below("autopilot", [&](Fields& table) { Describe(table, vehicle.autopilot); });
  fields.Below("reporter", [&](Fields& table) { Describe(table, vehicle.reporter_options); });
  if (fields.Has("recovery", vehicle.recovery != RecoveryPlan())) {
    fields.Below("recovery", [&](Fields& table) { Describe(table, vehicle.recovery); });
  }
  fields.Below("messages", [&](Fields& table) { Describe(table, vehicle.message_options); });
  if (fields.reading()) vehicle.return_task.point_m = {vehicle.start.x_m, vehicle.start.y_m};
  fields.Below("return",
               [&](Fields& table) { Describe(table, vehicle.return_task, vehicle.start); });
  DescribeTasks(fields, vehicle);
}

}  // namespace shoal
