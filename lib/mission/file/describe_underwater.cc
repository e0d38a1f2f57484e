// The tasks of underwater vehicles: path_follow, target_track and surface.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/file/describe_layers.h"
#include "lib/mission/file/task_fields.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr size_t kMaxGroupMembers = 1000;
constexpr double kDeepest_m = 20'000;

constexpr std::array<std::pair<std::string_view, SwitchRule>, 4> kSwitchRules = {{
    {"circle_or_passed_line", SwitchRule::kCircleOrPassedLine},
    {"circle", SwitchRule::kCircle},
    {"passed_line", SwitchRule::kPassedLine},
    {"along_track", SwitchRule::kAlongTrack},
}};

constexpr std::array<std::pair<std::string_view, PathTaskEnd>, 6> kPathEnds = {{
    {"done", PathTaskEnd::kDone},
    {"go_on", PathTaskEnd::kGoOn},
    {"hold", PathTaskEnd::kHold},
    {"return_to_first", PathTaskEnd::kReturnToFirst},
    {"surface", PathTaskEnd::kSurface},
    {"loiter", PathTaskEnd::kLoiter},
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

constexpr std::array<std::pair<std::string_view, TargetEndRule>, 4> kTargetEnds = {{
    {"surface", TargetEndRule::kSurface},
    {"hold", TargetEndRule::kHold},
    {"go_on", TargetEndRule::kGoOn},
    {"done", TargetEndRule::kDone},
}};

}  // namespace

void Describe(Fields& fields, PathFollowTask& task, const StartPose& start) {
  DescribePath(fields, task, start);
  fields.Number("speed_mps", task.speed_mps, Above(0, kFastest_mps));
  fields.Number("propeller_rpm", task.propeller_rpm, Between(0, 10'000));
  fields.Choice("waypoint_switch", task.waypoint_switch.rule, kSwitchRules);
  fields.Number("acceptance_radius_m", task.waypoint_switch.acceptance_radius_m,
                Between(0, 10'000));
  fields.Number("passed_line_within_m", task.waypoint_switch.passed_line_within_m, Between(0, 1e6));
  fields.Choice("end", task.end, kPathEnds);
  fields.Number("lookahead_m", task.lookahead_m, Above(0, 10'000));
  fields.Number("crab_gain", task.crab_gain, Between(0, 1));
  fields.Flag("guard_crab", task.guard_crab);
  fields.Flag("turn_crab", task.turn_crab);
  fields.Number("hold_radius_m", task.hold_radius_m, Above(0, 10'000));
  if (task.hold_radius_m < task.waypoint_switch.acceptance_radius_m) {
    fields.Refuse("hold_radius_m", "hold_radius_m must not be less than acceptance_radius_m");
  }
  fields.Number("loiter_radius_m", task.loiter_radius_m, Above(0, 10'000));
  DescribeLayers(fields, LayersOfPath(), task.cascade);
  if (task.cascade.layers.empty()) {
    for (const std::string_view key :
         {"alpha", "r_safe_m", "r_avoid_m", "r_pass_m", "r_sonar_m", "r_sonar_pass_m",
          "sonar_memory_s", "group", "swarm", "u_max_mps"}) {
      fields.NoKey(key, "it is for layers: write layers = [\"survival\"] as well");
    }
    return;
  }
  if (fields.Has("group", !task.group.empty())) {
    fields.Texts("group", task.group, kMaxGroupMembers);
  }
  fields.Choice("swarm", task.swarm, kSwarmKnowledge);
  fields.Number("u_max_mps", task.u_max_mps, Above(0, kFastest_mps));
  if (task.u_max_mps < task.speed_mps) {
    fields.Refuse("u_max_mps",
                  fmt::format("u_max_mps = {:g}, which the layers share, must not be less than "
                              "speed_mps = {:g}",
                              task.u_max_mps, task.speed_mps));
  }
}

void Describe(Fields& fields, SurfaceTask& task, const StartPose&) {
  fields.Number("speed_mps", task.speed_mps, Above(0, kFastest_mps));
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
    fields.Texts("group", task.group, kMaxGroupMembers);
  }
  fields.Choice("swarm", task.swarm, kSwarmKnowledge);
  fields.Choice("on_silence", task.on_silence, kSilenceRules);
  fields.Number("smoothing_mps", task.smoothing_mps, Between(0, kFastest_mps));
  fields.Choice("on_target_end", task.on_target_end, kTargetEnds);
  fields.Number("hold_radius_m", task.hold_radius_m, Above(0, 10'000));
  fields.Flag("compensate_current", task.compensate_current);
  fields.Flag("speed_along_bow", task.speed_along_bow);
  static_assert(kLaws.size() == std::variant_size_v<decltype(track.law)>, "each law has a word");
  std::string law(kLaws.at(track.law.index()));
  fields.Word("law", law, kLaws);
  if (fields.reading() && law == "constant_bearing") track.law = ConstantBearingLaw{};
  if (auto* bearing = std::get_if<ConstantBearingLaw>(&track.law)) {
    fields.Number("lookahead_m", bearing->lookahead_m, Above(0, 10'000));
    fields.Number("r_safe_m", bearing->r_safe_m, Between(0, 1e5));
  } else {
    DescribeLayers(fields, LayersOfTracking(), std::get<VelocityCascade>(track.law));
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
