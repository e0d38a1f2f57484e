// The tables [[vehicle]] and [template.NAME].
#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/mission/file/describe.h"
#include "lib/mission/model/providers.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr size_t kMaxTasks = 1000;
constexpr size_t kMaxBehaviors = 1000;
constexpr size_t kMaxExtraFields = 100;
constexpr std::array<std::pair<std::string_view, Ending>, 5> kEndings = {{
    {"hold", Ending::kHold},
    {"surface", Ending::kSurface},
    {"go_on", Ending::kGoOn},
    {"loiter", Ending::kLoiter},
    {"end_mission", Ending::kEndMission},
}};
constexpr int kLargestAddress = std::numeric_limits<int>::max();

void Describe(Fields& fields, StartPose& start) {
  fields.Number("x_m", start.x_m, Between(-kFarthest_m, kFarthest_m));
  fields.Number("y_m", start.y_m, Between(-kFarthest_m, kFarthest_m));
  fields.Number("heading_deg", start.heading_deg, Between(-360, 360));
  fields.Number("speed_mps", start.speed_mps, Between(0, kFastest_mps));
  fields.Number("depth_m", start.depth_m, Between(0, 20'000));
}

void Describe(Fields& fields, HelmOptions& options) {
  constexpr size_t kMaxKept = 2;
  fields.Number("nav_timeout_s", options.nav_timeout_s, Above(0, 3600));
  fields.Flag("deploy_at_start", options.deploy_at_start);
  fields.Texts("deploy_keeps", options.deploy_keeps, kMaxKept);
  for (const std::string& name : options.deploy_keeps) {
    if (name == "RETURN" || name == "STATION_KEEP") continue;
    fields.Refuse("deploy_keeps",
                  "deploy sets DEPLOY, RETURN and STATION_KEEP: RETURN and "
                  "STATION_KEEP can be kept");
  }
  fields.Number("state_interval_s", options.state_interval_s, Above(0, 3600));
  fields.Number("decide_every_s", options.decide_every_s, Between(0.01, 60));
  fields.Flag("goals_mandatory", options.goals_mandatory);
  if (fields.Has("end_of_tasks", options.end_of_tasks.has_value())) {
    Ending ending = options.end_of_tasks.value_or(Ending::kHold);
    fields.Choice("end_of_tasks", ending, kEndings);
    options.end_of_tasks = ending;
  }
  fields.Number("hold_radius_m", options.hold_radius_m, Above(0, 10'000));
  fields.Number("loiter_radius_m", options.loiter_radius_m, Above(0, 10'000));
}

void Describe(Fields& fields, ReporterOptions& options) {
  const NumberLimits seconds = Between(0, 100'000);
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
  fields.TextMap("extra", options.extra, kMaxExtraFields);
}

void Describe(Fields& fields, MessageOptions& options) {
  fields.Number("ack_timeout_s", options.ack_timeout_s, Above(0, 100'000));
  fields.Integer("max_repeats", options.max_repeats, 0, 1000);
  fields.Number("ack_jitter_s", options.ack_jitter_s, Between(0, 1000));
  fields.Number("repeat_jitter_s", options.repeat_jitter_s, Between(0, 1000));
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
  if (vehicle.tasks.size() > kMaxTasks) {
    fields.Refuse("task", "more than " + std::to_string(kMaxTasks) + " tasks");
  }
}

/// The behaviors beside the tasks, and what they depend on.
void DescribeBehaviors(Fields& fields, Vehicle& vehicle) {
  fields.List("behavior", vehicle.behaviors,
              [](Fields& table, BehaviorOptions& options) { Describe(table, options); });
  if (vehicle.behaviors.size() > kMaxBehaviors) {
    fields.Refuse("behavior", "more than " + std::to_string(kMaxBehaviors) + " behaviors");
  }
  fields.List("mode", vehicle.modes,
              [](Fields& table, ModeOptions& mode) { Describe(table, mode); });
  if (vehicle.modes.size() > kMaxBehaviors) {
    fields.Refuse("mode", "more than " + std::to_string(kMaxBehaviors) + " modes");
  }
  if (fields.Has("variables", !vehicle.variables.empty())) {
    DescribeVariables(fields, vehicle.variables);
  }
  if (fields.Has("domain", vehicle.domain != Domain())) {
    fields.Below("domain", [&](Fields& table) { Describe(table, vehicle.domain); });
  }
}

/// What provides the vehicle's parts; `outside = true` stands for "none" of each, and what is
/// passive has no helm.
void DescribeProviders(Fields& fields, bool is_passive, Vehicle& vehicle) {
  fields.Flag("outside", vehicle.is_outside);
  if (is_passive) vehicle.helm = Provider::kNone;
  const std::pair<std::string_view, Provider*> parts[] = {{"vehicle_sim", &vehicle.sim},
                                                          {"helm", &vehicle.helm},
                                                          {"node_reporter", &vehicle.reporter},
                                                          {"acomms", &vehicle.acomms}};
  for (const auto& [key, provider] : parts) {
    if (!vehicle.is_outside) {
      fields.Choice(key, *provider, kProviders);
      continue;
    }
    *provider = Provider::kNone;
    if (fields.Has(key, false)) {
      fields.Refuse(key,
                    "outside = true means that shoal provides no part of this vehicle: leave " +
                        std::string(key) + " out");
    }
  }
}

/// True for the name of a model without actuators.
bool IsPassive(std::string_view model_name) {
  const std::vector<AnyModel> models = EachModel();
  return std::ranges::any_of(models, [&](const AnyModel& model) {
    return FactsOfModel(model).name == model_name && !FactsOfModel(model).passive.empty();
  });
}

/// Refuses what only a vehicle with a helm can have.
void RefuseHelmOfPassive(Fields& fields, const Vehicle& vehicle) {
  const ModelFacts facts = FactsOfModel(vehicle.model);
  const std::string why = "a vehicle of model \"" + std::string(facts.name) + "\" is " +
                          std::string(facts.passive) + " and has no helm: leave it out";
  if (vehicle.helm != Provider::kNone) fields.Refuse("helm", why);
  if (!vehicle.tasks.empty()) fields.Refuse("task", why);
  if (!vehicle.behaviors.empty()) fields.Refuse("behavior", why);
}

/// Returns the name of the vehicle's model.
std::string DescribeModelName(Fields& fields, const Vehicle& vehicle) {
  std::vector<std::string_view> names;
  for (const AnyModel& model : EachModel()) names.push_back(FactsOfModel(model).name);
  std::string name(FactsOfModel(vehicle.model).name);
  fields.Word("model", name, names);
  return name;
}

/// The table of every model, so that a template can have them for vehicles of several models; the
/// vehicle keeps that of `chosen`.
void DescribeModels(Fields& fields, std::string_view chosen, Vehicle& vehicle) {
  for (AnyModel& model : EachModel()) {
    const std::string_view name = FactsOfModel(model).name;
    if (FactsOfModel(vehicle.model).name == name) model = vehicle.model;
    fields.Below(name, [&](Fields& table) {
      std::visit([&](auto& parameters) { Describe(table, parameters); }, model);
    });
    if (chosen == name) vehicle.model = model;
  }
}

}  // namespace

void Describe(Fields& fields, Vehicle& vehicle) {
  fields.Text("name", vehicle.name, {.max_length = 1000});
  fields.Skip("template");  // Laid under the vehicle already (expand.h).
  const std::string model_name = DescribeModelName(fields, vehicle);
  const bool is_passive = IsPassive(model_name);
  if (fields.reading() && is_passive && vehicle.type == Vehicle().type) vehicle.type = model_name;
  fields.Text("type", vehicle.type, {.min_length = 1});
  fields.Text("group", vehicle.group, {});
  fields.Text("color", vehicle.color, {.min_length = 1});
  fields.Number("length_m", vehicle.length_m, Above(0, 500));
  fields.Number("draught_m", vehicle.draught_m, Above(0, 100));
  fields.Number("stealth", vehicle.link_factors.stealth, Between(0, 1));
  fields.Number("earange", vehicle.link_factors.earange, Between(1, 10));
  if (fields.Has("acoustic_address", vehicle.acoustic_address > 0)) {
    fields.SmallInteger("acoustic_address", vehicle.acoustic_address, 1, kLargestAddress);
  }
  fields.Flag("acoustic_leader", vehicle.acoustic_leader);
  fields.Number("modem_depth_m", vehicle.modem_depth_m, Between(0, 1000));
  Describe(fields, vehicle.media);
  fields.Inline("start", [&](Fields& table) { Describe(table, vehicle.start); });
  DescribeProviders(fields, is_passive, vehicle);
  DescribeModels(fields, model_name, vehicle);
  DescribeInstruments(fields, vehicle);
  DescribeNavigation(fields, vehicle);
  fields.Below("helm_options", [&](Fields& table) { Describe(table, vehicle.helm_options); });
  fields.Below("autopilot", [&](Fields& table) { DescribeAutopilot(table, vehicle); });
  fields.Below("reporter", [&](Fields& table) { Describe(table, vehicle.reporter_options); });
  if (fields.Has("recovery", vehicle.recovery != RecoveryPlan())) {
    fields.Below("recovery", [&](Fields& table) { Describe(table, vehicle.recovery); });
  }
  fields.Below("messages", [&](Fields& table) { Describe(table, vehicle.message_options); });
  if (fields.reading()) vehicle.return_task.point_m = {vehicle.start.x_m, vehicle.start.y_m};
  fields.Below("return",
               [&](Fields& table) { Describe(table, vehicle.return_task, vehicle.start); });
  DescribeTasks(fields, vehicle);
  DescribeBehaviors(fields, vehicle);
  if (is_passive && fields.reading()) RefuseHelmOfPassive(fields, vehicle);
}

}  // namespace shoal
