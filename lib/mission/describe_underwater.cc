// The tasks of underwater vehicles: path_follow and target_track.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "lib/geometry/angles.h"
#include "lib/mission/describe.h"
#include "lib/mission/suggest.h"

namespace shoal {
namespace {

constexpr size_t kMostPathPoints = 10'000;
constexpr size_t kMostGroupMembers = 1000;
constexpr double kDeepest_m = 20'000;

constexpr std::array<std::pair<std::string_view, SwitchRule>, 4> kSwitchRules = {{
    {"circle_or_passed_line", SwitchRule::kCircleOrPassedLine},
    {"circle", SwitchRule::kCircle},
    {"passed_line", SwitchRule::kPassedLine},
    {"along_track", SwitchRule::kAlongTrack},
}};

constexpr std::array<std::pair<std::string_view, PathTaskEnd>, 5> kPathEnds = {{
    {"done", PathTaskEnd::kDone},
    {"go_on", PathTaskEnd::kGoOn},
    {"hold", PathTaskEnd::kHold},
    {"return_to_first", PathTaskEnd::kReturnToFirst},
    {"surface", PathTaskEnd::kSurface},
}};

constexpr std::array<std::pair<std::string_view, SwarmKnowledge>, 2> kSwarmKnowledge = {{
    {"direct", SwarmKnowledge::kDirect},
    {"acoustic", SwarmKnowledge::kAcoustic},
}};

constexpr std::array<std::pair<std::string_view, SilenceRule>, 3> kSilenceRules = {{
    {"predict", SilenceRule::kPredict},
    {"station_keep", SilenceRule::kStationKeep},
    {"surface", SilenceRule::kSurface},
}};

/// The layers of a cascade by their names in mission files.
constexpr std::array<std::string_view, 5> kLayers = {"survival", "sonar", "survival_and_sonar",
                                                     "formation", "feed_forward"};

/// Distances that the layers of a task share.
struct Radii {
  double r_safe_m = SurvivalGroupLayer().r_safe_m;
  double r_avoid_m = SurvivalGroupLayer().r_avoid_m;
  double r_sonar_m = SurvivalSonarLayer().r_avoid_m;
  double r_inner_m = FormationLayer().r_inner_m;
  double r_follow_m = FormationLayer().r_follow_m;
};

VelocityLayer MakeLayer(std::string_view name, const Radii& radii) {
  const SurvivalGroupLayer group = {.r_safe_m = radii.r_safe_m, .r_avoid_m = radii.r_avoid_m};
  const SurvivalSonarLayer sonar = {.r_avoid_m = radii.r_sonar_m};
  if (name == "survival") return group;
  if (name == "sonar") return sonar;
  if (name == "survival_and_sonar") return SurvivalLayer{.group = group, .sonar = sonar};
  if (name == "feed_forward") return FeedForwardLayer{};
  return FormationLayer{
      .r_safe_m = radii.r_safe_m, .r_inner_m = radii.r_inner_m, .r_follow_m = radii.r_follow_m};
}

std::string NameOf(const VelocityLayer& layer) {
  if (std::holds_alternative<FeedForwardLayer>(layer)) return "feed_forward";
  if (std::holds_alternative<FormationLayer>(layer)) return "formation";
  if (std::holds_alternative<SurvivalLayer>(layer)) return "survival_and_sonar";
  return std::holds_alternative<SurvivalSonarLayer>(layer) ? "sonar" : "survival";
}

/// Takes the radii out of a cascade, where it has them.
void ReadRadii(const VelocityLayer& layer, Radii* radii) {
  const auto read_group = [&](const SurvivalGroupLayer& group) {
    radii->r_safe_m = group.r_safe_m;
    radii->r_avoid_m = group.r_avoid_m;
  };
  if (const auto* formation = std::get_if<FormationLayer>(&layer)) {
    radii->r_safe_m = formation->r_safe_m;
    radii->r_inner_m = formation->r_inner_m;
    radii->r_follow_m = formation->r_follow_m;
  } else if (const auto* group = std::get_if<SurvivalGroupLayer>(&layer)) {
    read_group(*group);
  } else if (const auto* sonar = std::get_if<SurvivalSonarLayer>(&layer)) {
    radii->r_sonar_m = sonar->r_avoid_m;
  } else if (const auto* both = std::get_if<SurvivalLayer>(&layer)) {
    read_group(both->group);
    radii->r_sonar_m = both->sonar.r_avoid_m;
  }
}

void DescribeRadii(Fields& fields, Radii& radii) {
  const NumberLimits distance = Above(0, 1e5);
  fields.Number("r_safe_m", radii.r_safe_m, distance);
  fields.Number("r_avoid_m", radii.r_avoid_m, distance);
  fields.Number("r_sonar_m", radii.r_sonar_m, distance);
  fields.Number("r_inner_m", radii.r_inner_m, distance);
  fields.Number("r_follow_m", radii.r_follow_m, distance);
  const auto in_order = [&](std::string_view key, double low_m, double high_m,
                            std::string_view low_key) {
    if (low_m < high_m) return;
    fields.Refuse(
        key, fmt::format("{} = {:g} must be more than {} = {:g}", key, high_m, low_key, low_m));
  };
  in_order("r_avoid_m", radii.r_safe_m, radii.r_avoid_m, "r_safe_m");
  in_order("r_inner_m", radii.r_safe_m, radii.r_inner_m, "r_safe_m");
  in_order("r_follow_m", radii.r_inner_m, radii.r_follow_m, "r_inner_m");
}

void DescribeCascade(Fields& fields, TargetTrackTask& task) {
  auto& cascade = std::get<VelocityCascade>(task.track.law);
  Radii radii;
  std::vector<std::string> names;
  for (const VelocityLayer& layer : cascade.layers) {
    ReadRadii(layer, &radii);
    names.push_back(NameOf(layer));
  }
  fields.Texts("layers", names, kLayers.size());
  DescribeRadii(fields, radii);
  if (!fields.reading()) return;
  cascade.layers.clear();
  for (const std::string& name : names) {
    if (std::find(kLayers.begin(), kLayers.end(), name) == kLayers.end()) {
      fields.Refuse("layers", "unknown layer " + Quoted(name) + DidYouMean(name, kLayers) +
                                  "; there are: " + Joined(kLayers));
      continue;
    }
    cascade.layers.push_back(MakeLayer(name, radii));
  }
  if (names.empty()) fields.Refuse("layers", "a cascade needs a layer: " + Joined(kLayers));
}

}  // namespace

void Describe(Fields& fields, PathFollowTask& task, const StartPose& start) {
  fields.Require("points", "points = [[0, 0, 10], [100, 0, 20]]");
  fields.Triples("points", task.points_m, Between(-kFarthest_m, kFarthest_m), kMostPathPoints);
  if (task.points_m.empty() && fields.Has("points", true)) {
    fields.Refuse("points", "points must hold at least one point, like [[100, 0, 20]]");
    task.points_m.emplace_back(Eigen::Vector3d::Zero());
  }
  constexpr std::array<std::string_view, 2> kFrames = {"mission", "start"};
  std::string frame = "mission";
  fields.Word("points_frame", frame, kFrames);
  for (Eigen::Vector3d& point_m : task.points_m) {
    if (frame == "start") point_m += Eigen::Vector3d(start.x_m, start.y_m, 0);
    if (point_m.z() < 0 || point_m.z() > kDeepest_m ||
        point_m.head<2>().cwiseAbs().maxCoeff() > kFarthest_m) {
      fields.Refuse("points",
                    "points are [x, y, depth], with x and y within 1000 km of the origin "
                    "and depths from 0 to 20000 m");
      point_m.setZero();
    }
  }
  fields.Number("speed_mps", task.speed_mps, Above(0, kFastest_mps));
  fields.Number("propeller_rpm", task.propeller_rpm, Between(0, 10'000));
  fields.Choice("waypoint_switch", task.waypoint_switch.rule, kSwitchRules);
  fields.Number("acceptance_radius_m", task.waypoint_switch.acceptance_radius_m,
                Between(0, 10'000));
  fields.Choice("end", task.end, kPathEnds);
  fields.Number("lookahead_m", task.lookahead_m, Above(0, 10'000));
  fields.Number("crab_gain", task.crab_gain, Between(0, 1));
  fields.Flag("guard_crab", task.guard_crab);
  fields.Flag("turn_crab", task.turn_crab);
  fields.Number("hold_radius_m", task.hold_radius_m, Above(0, 10'000));
  if (task.hold_radius_m < task.waypoint_switch.acceptance_radius_m) {
    fields.Refuse("hold_radius_m", "hold_radius_m must not be less than acceptance_radius_m");
  }
}

void Describe(Fields& fields, SurfaceForFixTask& task, const StartPose&) {
  fields.SmallInteger("fixes", task.fixes, 1, 1'000'000);
  fields.Number("limit_s", task.limit_s, Above(0, kLongest_s));
  fields.Number("speed_mps", task.speed_mps, Above(0, kFastest_mps));
  fields.Number("radius_m", task.radius_m, Above(0, 10'000));
}

void Describe(Fields& fields, TargetTrackTask& task, const StartPose&) {
  constexpr std::array<std::string_view, 2> kLaws = {"cascade", "constant_bearing"};
  TargetTrackParams& track = task.track;
  fields.Require("target", "target = \"alpha\"");
  fields.Text("target", task.target, {.min_length = 1});
  if (fields.Has("group", !task.group.empty())) {
    fields.Texts("group", task.group, kMostGroupMembers);
  }
  fields.Choice("swarm", task.swarm, kSwarmKnowledge);
  fields.Choice("on_silence", task.on_silence, kSilenceRules);
  fields.Flag("compensate_current", task.compensate_current);
  std::string law(kLaws.at(track.law.index()));
  fields.Word("law", law, kLaws);
  if (fields.reading() && law == "constant_bearing") track.law = ConstantBearingLaw{};
  if (auto* bearing = std::get_if<ConstantBearingLaw>(&track.law)) {
    fields.Number("lookahead_m", bearing->lookahead_m, Above(0, 10'000));
    fields.Number("r_safe_m", bearing->r_safe_m, Between(0, 1e5));
  } else {
    DescribeCascade(fields, task);
  }
  fields.Number("u_max_mps", track.u_max_mps, Above(0, kFastest_mps));
  fields.Number("z_max_m", track.depth.z_max_m, Above(0, kDeepest_m));
  fields.Number("z_min_m", track.depth.z_min_m, Between(0, kDeepest_m));
  if (track.depth.z_min_m >= track.depth.z_max_m) {
    fields.Refuse("z_min_m", fmt::format("z_min_m = {:g} must be less than z_max_m = {:g}",
                                         track.depth.z_min_m, track.depth.z_max_m));
  }
  fields.Number("z_safe_m", track.depth.z_safe_m, Above(0, kDeepest_m));
  fields.Number("climb_mps", track.depth.climb_mps, Between(0, kFastest_mps));
  double max_pitch_deg = RadToDeg(track.max_pitch_rad);
  fields.Number("max_pitch_deg", max_pitch_deg, Above(0, 90));
  if (fields.reading()) track.max_pitch_rad = DegToRad(max_pitch_deg);
}

}  // namespace shoal
