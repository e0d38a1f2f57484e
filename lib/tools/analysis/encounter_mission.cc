#include "lib/tools/analysis/encounter_mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/helm/encounters/encounter.h"

namespace shoal {

namespace {

// Metres, at the scale of surface craft; other scales stretch them (docs/vehicles/encounters.md).
constexpr double kOuter_m = 150;  // Five times kUtil_m: an encounter is seen early enough.
constexpr double kInner_m = 75;
constexpr double kCompleted_m = 165;
constexpr double kLeastUtil_m = 10;
constexpr double kUtil_m = 30;
constexpr double kLength_m = 3;
constexpr double kArrival_m = 150;  // It may have kept clear by a detour, not run away.
constexpr double kClear_m = 60;     // Of encounters that must not be any.
constexpr double kLeastApproach_m = 5;
constexpr double kLeastApproachOfTwo_m = 10;
constexpr double kLeastScore = 30;
constexpr double kLeastScoreOfTwo = 60;
constexpr double kHorizon_s = 120;
/// A vessel that keeps clear takes longer than one that goes straight.
constexpr double kDurationFactor = 2.5;
/// Vessels steer for a point beyond their goal, this share of the way from the start farther, so
/// that none lies still before the mission ends.
constexpr double kBeyond = 0.4;
/// The speed up to which the surface craft's own thrust map reaches with room to spare.
constexpr double kDefaultTopSpeed_mps = 4;

/// At most three decimals, and none that are zero.
std::string Short(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Point(const Eigen::Vector2d& point_m) {
  return fmt::format("[{}, {}]", Short(point_m.x()), Short(point_m.y()));
}

Eigen::Vector2d FarGoal_m(const ScenarioVessel& vessel) {
  return vessel.goal_m + kBeyond * (vessel.goal_m - vessel.start.position_m);
}

class MissionText {
 public:
  MissionText(const EncounterScenario& scenario, const EncounterMissionOptions& options)
      : scenario_(scenario),
        options_(options),
        stretch_(options.scale.length / ScenarioScale().length),
        pace_(stretch_ * ScenarioScale().speed_mps / options.scale.speed_mps) {}

  std::string Write(const std::string& words) {
    text_ = fmt::format(
        "# {}{}.\n#\n# Made by `shoal encounters {}`; docs/vehicles/encounters.md.\n\n"
        "[mission]\nname = \"{}{}\"\ndescription = \"{}\"\nduration_s = {}\nseed = {}\n{}\n"
        "[comms]\ncomms_range = \"nolimit\"\nstale_time = \"nolimit\"\n\n",
        scenario_.description, options_.others_hold ? ", the others hold course" : "", words,
        scenario_.name, options_.others_hold ? "_hold" : "", scenario_.description, Duration_s(),
        options_.seed,
        options_.others_hold ? "collisions = \"allowed\"  # Of those that hold, with each other.\n"
                             : "");
    text_ +=
        fmt::format("[template.vessel]\nlength_m = {}\nhelm_options = {{deploy_at_start = true}}\n",
                    Short(std::min(500.0, kLength_m * stretch_)));
    if (options_.scale.speed_mps > kDefaultTopSpeed_mps) {
      text_ += fmt::format("surface_craft = {{thrust_map = [[100, {}]]}}\n",
                           Short(1.5 * options_.scale.speed_mps));
    }
    for (size_t i = 0; i < scenario_.vessels.size(); ++i) AddVessel(i);
    AddExpectations();
    return text_;
  }

 private:
  bool Holds(size_t vessel) const { return options_.others_hold && vessel > 0; }
  std::string Length(double length_m) const { return Short(length_m * stretch_); }
  std::string Duration_s() const { return Short(std::ceil(kDurationFactor * scenario_.meeting_s)); }

  void AddVessel(size_t number) {
    const ScenarioVessel& vessel = scenario_.vessels[number];
    text_ += fmt::format(
        "\n[[vehicle]]\nname = \"{}\"\ntemplate = \"vessel\"\n"
        "start = {{x_m = {}, y_m = {}, heading_deg = {}, speed_mps = {}}}\n",
        vessel.name, Short(vessel.start.position_m.x()), Short(vessel.start.position_m.y()),
        Short(vessel.start.heading_deg), Short(vessel.start.speed_mps));
    if (Holds(number)) {
      text_ +=
          fmt::format("\n[[vehicle.task]]\nkind = \"waypoints\"\npoints = [{}]\nspeed_mps = {}\n",
                      Point(FarGoal_m(vessel)), Short(vessel.start.speed_mps));
      return;
    }
    text_ +=
        fmt::format("domain = {{speed = [0, {}, 41]}}\n", Short(options_.scale.speed_mps * 4 / 3));
    text_ += fmt::format(
        "\n[[vehicle.behavior]]\nkind = \"waypoint\"\npwt = 100\npoints = [{}]\nspeed = {}\n",
        Point(FarGoal_m(vessel)), Short(vessel.start.speed_mps));
    if (options_.lead_m > 0) {
      text_ +=
          fmt::format("lead = {}\nlead_damper = 1\nlead_to_start = true\n", Short(options_.lead_m));
    }
    text_ += fmt::format(
        "\n[[vehicle.behavior]]\nkind = \"colregs\"\ntemplating = \"spawn\"\npwt = 200\n"
        "pwt_outer_dist = {}\npwt_inner_dist = {}\n"
        "completed_dist = {}\nmin_util_cpa_dist = {}\nmax_util_cpa_dist = {}\ntime_on_leg = {}\n",
        Length(kOuter_m), Length(kInner_m), Length(kCompleted_m), Length(kLeastUtil_m),
        Length(kUtil_m), Short(kHorizon_s * pace_));
  }

  /// Where an encounter begins and ends, and what its distances are worth, where not the defaults.
  void AddEncounterKeys(bool scores) {
    if (stretch_ == 1) return;
    const EncounterOptions encounter;
    text_ += fmt::format("entry_range_m = {}\nrisk_m = {}\nend_range_m = {}\n",
                         Length(encounter.entry_range_m), Length(encounter.risk_m),
                         Length(encounter.end_range_m));
    if (!scores) return;
    text_ += fmt::format("preferred_m = {}\nacceptable_m = {}\nnear_miss_m = {}\n",
                         Length(encounter.preferred_m), Length(encounter.acceptable_m),
                         Length(encounter.near_miss_m));
  }

  void AddExpectations() {
    const bool is_of_two = scenario_.vessels.size() == 2;
    const ScenarioVessel& own = scenario_.vessels.front();
    text_ += fmt::format(
        "\n[[expect]]\nkind = \"arrival\"\nvehicle = \"{}\"\npoint = {}\nwithin_m = {}\n", own.name,
        Point(own.goal_m), Length(kArrival_m));
    if (scenario_.role == EncounterRole::kNone) {
      text_ += fmt::format("\n[[expect]]\nkind = \"separation\"\nmin_m = {}\n", Length(kClear_m));
      return;
    }
    const bool both_act = is_of_two && !options_.others_hold;
    text_ += "\n[[expect]]\nkind = \"encounter_score\"\n";
    if (options_.others_hold || scenario_.role) {
      text_ += fmt::format("vehicle = \"{}\"\n", own.name);
    }
    if (scenario_.role) text_ += fmt::format("role = \"{}\"\n", Name(*scenario_.role));
    text_ += fmt::format("at_least = {}\n", Short(both_act ? kLeastScoreOfTwo : kLeastScore));
    AddEncounterKeys(true);
    text_ += "\n[[expect]]\nkind = \"closest_approach\"\n";
    if (options_.others_hold) text_ += fmt::format("vehicle = \"{}\"\n", own.name);
    text_ += fmt::format("at_least_m = {}\n",
                         Length(both_act ? kLeastApproachOfTwo_m : kLeastApproach_m));
    AddEncounterKeys(false);
  }

  const EncounterScenario& scenario_;
  const EncounterMissionOptions& options_;
  const double stretch_;  ///< Lengths relative to those of surface craft.
  const double pace_;     ///< Times likewise.
  std::string text_;
};

}  // namespace

std::string MissionTextOf(const EncounterScenario& scenario, const EncounterMissionOptions& options,
                          const std::string& words) {
  return MissionText(scenario, options).Write(words);
}

}  // namespace shoal
