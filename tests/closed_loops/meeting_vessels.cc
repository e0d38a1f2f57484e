#include "tests/closed_loops/meeting_vessels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <utility>

#include "lib/base/check/bounds.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/modes/value_text.h"
#include "tests/closed_loops/kinematic_vessel.h"

namespace shoal {

namespace {

using Json = nlohmann::json;

constexpr int kStepsPerDecision = 5;
constexpr int kStepsPerReport = 10;
constexpr int kStepsPerRow = 20;

double NumberOf(const Json& block, const std::string& key, double otherwise) {
  if (!block.contains(key)) return otherwise;
  return std::strtod(block.at(key).get<std::string>().c_str(), nullptr);
}

std::vector<Eigen::Vector2d> PointsOf(const std::string& text) {
  std::vector<Eigen::Vector2d> points;
  std::istringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ':');) {
    const size_t comma = pair.find(',');
    points.emplace_back(std::strtod(pair.substr(0, comma).c_str(), nullptr),
                        std::strtod(pair.substr(comma + 1).c_str(), nullptr));
  }
  return points;
}

/// What avoidance of both kinds has in common.
template <class Options>
Options AvoidanceOf(const Json& block) {
  Options options;
  options.pwt_outer_dist = NumberOf(block, "pwt_outer_dist", options.pwt_outer_dist);
  options.pwt_inner_dist = NumberOf(block, "pwt_inner_dist", options.pwt_inner_dist);
  options.completed_dist = NumberOf(block, "completed_dist", options.completed_dist);
  options.min_util_cpa_dist = NumberOf(block, "min_util_cpa_dist", options.min_util_cpa_dist);
  options.max_util_cpa_dist = NumberOf(block, "max_util_cpa_dist", options.max_util_cpa_dist);
  options.pwt_grade = block.at("pwt_grade").get<std::string>();
  options.steady = false;
  return options;
}

BehaviorOptions BehaviorOf(const Json& block, const MeetingOptions& meeting) {
  BehaviorOptions options = {.name = block.at("name").get<std::string>(),
                             .pwt = NumberOf(block, "pwt", 100),
                             .condition = {block.at("condition").get<std::string>()}};
  if (block.contains("templating")) options.templating = Templating::kSpawn;
  const auto type = block.at("type").get<std::string>();
  if (type == "Waypoint") {
    options.what = WaypointOptions{.points = PointsOf(block.at("points").get<std::string>()),
                                   .speed = NumberOf(block, "speed", 0),
                                   .capture_radius = NumberOf(block, "capture_radius", 3),
                                   .slip_radius = NumberOf(block, "slip_radius", 15),
                                   .lead = NumberOf(block, "lead", -1),
                                   .lead_damper = NumberOf(block, "lead_damper", -1),
                                   .return_angle = 90,
                                   .lead_to_start = block.contains("lead_to_start")};
  } else if (type == "AvoidCollision") {
    options.what = AvoidanceOf<AvoidCollisionOptions>(block);
  } else if (type == "AvdColregsV22") {
    auto colregs = AvoidanceOf<ColregsOptions>(block);
    colregs.min_dwell = meeting.min_dwell_s;
    options.what = colregs;
  } else {
    SHOAL_CHECK(type == "Trail", "the scenario has behaviors that this program knows");
    TrailOptions trail = {.trail_range = NumberOf(block, "trail_range", 50),
                          .trail_angle = NumberOf(block, "trail_angle", 180),
                          .radius = NumberOf(block, "radius", 5),
                          .nm_radius = NumberOf(block, "nm_radius", 20)};
    trail.contact.contact = block.at("contact").get<std::string>();
    options.what = trail;
  }
  return options;
}

HelmSetup SetupOf(const std::string& name, const Json& vehicle, const MeetingOptions& options) {
  HelmSetup setup = {.vehicle = name};
  for (const auto& [variable, value] : vehicle.at("initialize").items()) {
    setup.variables[variable] = value.get<std::string>();
  }
  for (const Json& block : vehicle.at("behaviors")) {
    setup.behaviors.push_back(BehaviorOf(block, options));
  }
  return setup;
}

struct Vessel {
  std::string name;
  VesselMotion motion = {};
  KinematicCommand command = {};
  ContactLedger ledger;
  BehaviorSet helm;
  std::map<std::string, std::string> last_roles = {};
  std::map<std::string, VariableValue> last_posts = {};
};

void NoteRole(double time_s, const Vessel& vessel, const std::string& contact,
              const std::string& role, Meeting* meeting, std::string* last) {
  if (role == *last) return;
  const std::pair<std::string, std::string> pair(vessel.name, contact);
  const std::string mode = role.substr(0, role.find(':'));
  std::string& roles = meeting->roles[pair];
  if (mode != last->substr(0, last->find(':'))) {
    roles += (roles.empty() ? "" : " ") + mode;
    meeting->events.emplace_back(time_s, vessel.name + ": role " + contact + " " + mode);
  }
  *last = role;
  ++meeting->num_role_changes[pair];
}

HelmOutcome Decide(double time_s, Vessel* vessel, Meeting* meeting) {
  const Contacts& contacts = vessel->ledger.At(time_s, vessel->motion.position_m);
  const HelmOutcome outcome = vessel->helm.Iterate({.time_s = time_s,
                                                    .drives = true,
                                                    .own = OwnMotion{.motion = vessel->motion},
                                                    .contacts = &contacts});
  if (outcome.has_decision) {
    vessel->command = {.heading_deg = outcome.commands.course_deg.value_or(0),
                       .speed_mps = outcome.commands.speed_mps.value_or(0)};
  } else if (!outcome.keeps_last) {
    vessel->command = {.heading_deg = vessel->motion.heading_deg, .speed_mps = 0};
  }
  for (const HelmAim& aim : outcome.aims) {
    if (!aim.role) continue;
    NoteRole(time_s, *vessel, aim.role->contact, aim.role->role, meeting,
             &vessel->last_roles[aim.role->contact]);
  }
  for (const VariablePost& post : outcome.posts) {
    if (post.variable != "REGION" && post.variable != "WPT_INDEX") continue;
    VariableValue& last = vessel->last_posts[post.variable];
    if (std::exchange(last, post.value) == post.value) continue;
    meeting->events.emplace_back(time_s,
                                 vessel->name + ": " + post.variable + " " + TextOf(post.value));
  }
  for (const HelmEvent& event : outcome.events) {
    meeting->events.emplace_back(time_s, vessel->name + ": " + event.kind + " " + event.text);
  }
  return outcome;
}

/// "*": every vessel.
bool Matches(const Json& pattern, const std::string& name) {
  return pattern == "*" || pattern == name;
}

bool IsLost(const Json& lost, double time_s, const std::string& source,
            const std::string& receiver) {
  return std::any_of(lost.begin(), lost.end(), [&](const Json& each) {
    return Matches(each.at("source"), source) && Matches(each.at("receiver"), receiver) &&
           time_s >= each.at("from_s").get<double>() && time_s < each.at("to_s").get<double>();
  });
}

void ExchangeReports(const Json& lost, double time_s, std::vector<Vessel>* vessels) {
  for (const Vessel& source : *vessels) {
    for (Vessel& receiver : *vessels) {
      if (source.name == receiver.name || IsLost(lost, time_s, source.name, receiver.name)) {
        continue;
      }
      (void)receiver.ledger.Take(
          {.name = source.name, .motion = source.motion, .made_s = time_s, .received_s = time_s},
          receiver.motion.position_m);
    }
  }
}

void NoteDistances(const std::vector<Vessel>& vessels, Meeting* meeting) {
  for (size_t i = 0; i < vessels.size(); ++i) {
    for (size_t j = i + 1; j < vessels.size(); ++j) {
      const double distance_m =
          (vessels[i].motion.position_m - vessels[j].motion.position_m).norm();
      const std::pair<std::string, std::string> pair(vessels[i].name, vessels[j].name);
      const auto known = meeting->closest_m.emplace(pair, distance_m).first;
      known->second = std::min(known->second, distance_m);
    }
  }
}

std::vector<Vessel> VesselsOf(const Json& scenario, const MeetingOptions& options) {
  std::vector<Vessel> vessels;
  for (const auto& [name, vehicle] : scenario.at("vehicles").items()) {
    const Json& start = vehicle.at("start");
    const VesselMotion motion = {
        .position_m = {start.at("x_m").get<double>(), start.at("y_m").get<double>()},
        .heading_deg = start.at("heading_deg").get<double>(),
        .speed_mps = start.at("speed_mps").get<double>()};
    vessels.push_back({.name = name,
                       .motion = motion,
                       .command = {.heading_deg = motion.heading_deg, .speed_mps = 0},
                       .ledger = ContactLedger(name, options.contacts),
                       .helm = BehaviorSet(SetupOf(name, vehicle, options))});
  }
  return vessels;
}

/// Between two full seconds of a track, as if the vessel had turned evenly.
VesselMotion MotionAt(const std::vector<const GoldenRow*>& rows, double time_s) {
  const auto second = std::min(static_cast<size_t>(time_s), rows.size() - 1);
  const GoldenRow& from = *rows[second];
  const GoldenRow& to = *rows[std::min(second + 1, rows.size() - 1)];
  const double part = time_s - static_cast<double>(second);
  const auto between = [&](const char* title) {
    return Number(from, title) + part * (Number(to, title) - Number(from, title));
  };
  const double turn_deg = Wrap180(Number(to, "heading") - Number(from, "heading"));
  return {.position_m = {between("x"), between("y")},
          .heading_deg = Wrap360(Number(from, "heading") + part * turn_deg),
          .speed_mps = between("speed")};
}

}  // namespace

JudgedMeeting JudgeAlong(const nlohmann::json& scenario, const std::vector<GoldenRow>& track,
                         const MeetingOptions& options) {
  std::map<std::string, std::vector<const GoldenRow*>> rows;
  for (const GoldenRow& row : track) rows[row.at("vehicle")].push_back(&row);
  std::vector<Vessel> vessels = VesselsOf(scenario, options);
  JudgedMeeting judged;
  constexpr int kDecisionsPerSecond = 4;
  const size_t num_rows = rows.begin()->second.size();
  for (size_t i = 0; i + 1 < kDecisionsPerSecond * num_rows; ++i) {
    const double time_s = static_cast<double>(i) / kDecisionsPerSecond;
    for (Vessel& vessel : vessels) vessel.motion = MotionAt(rows.at(vessel.name), time_s);
    if (i % 2 == 0) ExchangeReports(scenario.at("lost_reports"), time_s, &vessels);
    for (Vessel& vessel : vessels) {
      const HelmOutcome outcome = Decide(time_s, &vessel, &judged.meeting);
      if (i % kDecisionsPerSecond != 0 || !outcome.has_decision) continue;
      const GoldenRow& row = *rows.at(vessel.name)[i / kDecisionsPerSecond];
      const HelmPoint theirs = {.course_deg = Number(row, "desired_heading"),
                                .speed_mps = Number(row, "desired_speed")};
      judged.decisions.push_back({.time_s = time_s,
                                  .vessel = vessel.name,
                                  .theirs = theirs,
                                  .ours = outcome.commands,
                                  .roles = vessel.last_roles,
                                  .utility = vessel.helm.UtilityAt(outcome.commands),
                                  .utility_theirs = vessel.helm.UtilityAt(theirs)});
    }
  }
  return judged;
}

Meeting RunMeeting(const nlohmann::json& scenario, const MeetingOptions& options) {
  std::vector<Vessel> vessels = VesselsOf(scenario, options);
  Meeting meeting;
  const auto last =
      static_cast<int>(std::lround(scenario.at("duration_s").get<double>() / kVesselStep_s));
  for (int step = 0; step <= last; ++step) {
    const double time_s = step * kVesselStep_s;
    if (step % kStepsPerReport == 0) ExchangeReports(scenario.at("lost_reports"), time_s, &vessels);
    for (Vessel& vessel : vessels) {
      if (step % kStepsPerDecision == 0) (void)Decide(time_s, &vessel, &meeting);
      if (step % kStepsPerRow == 0) {
        meeting.tracks[vessel.name].push_back({.time_s = time_s, .motion = vessel.motion});
      }
    }
    NoteDistances(vessels, &meeting);
    for (Vessel& vessel : vessels) vessel.motion = Step(vessel.motion, vessel.command);
  }
  return meeting;
}

}  // namespace shoal
