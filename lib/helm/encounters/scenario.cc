#include "lib/helm/encounters/scenario.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"

namespace shoal {

namespace {

constexpr double kSixNauticalMiles_m = 6 * 1852;

/// A vessel that is at `meeting_m` after `meeting_s`, and goes on as long again.
ScenarioVessel VesselThrough(std::string name, const Eigen::Vector2d& meeting_m, double course_deg,
                             double speed_mps, double meeting_s) {
  const Eigen::Vector2d way_m = UnitVector(DegToRad(course_deg)) * (speed_mps * meeting_s);
  return {.name = std::move(name),
          .start = {.position_m = meeting_m - way_m,
                    .heading_deg = Wrap360(course_deg),
                    .speed_mps = speed_mps},
          .goal_m = meeting_m + way_m};
}

std::string TwoDigits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

// --- Imazu ---

/// Slow targets go 8.4 knots where own ship goes 12, and start 4.2 NM away instead of 6.
constexpr double kSlowShare = 0.7;

struct ImazuTarget {
  double course_deg;  ///< Own ship's is 0.
  bool is_slow = false;
};

constexpr size_t kMaxImazuTargets = 3;
struct ImazuRow {
  std::array<ImazuTarget, kMaxImazuTargets> targets;
  size_t num_targets;
};

// Where the sources differ, docs/vehicles/encounters.md states what was taken and why (cases 2, 8,
// 12).
constexpr std::array<ImazuRow, kNumImazuCases> kImazu = {{
    {{{{180}}}, 1},
    {{{{-90}}}, 1},
    {{{{0, true}}}, 1},
    {{{{45}}}, 1},
    {{{{180}, {-90}}}, 2},
    {{{{-10}, {-45}}}, 2},
    {{{{0, true}, {-45}}}, 2},
    {{{{180}, {90}}}, 2},
    {{{{-30}, {-90}}}, 2},
    {{{{-90}, {15}}}, 2},
    {{{{90}, {-30}}}, 2},
    {{{{180}, {-45}, {-10}}}, 3},
    {{{{180}, {10}, {45}}}, 3},
    {{{{-10}, {-45}, {-90}}}, 3},
    {{{{0, true}, {-45}, {-90}}}, 3},
    {{{{45, true}, {90}, {-90}}}, 3},
    {{{{0, true}, {10}, {-45}}}, 3},
    {{{{-135}, {-15}, {-30}}}, 3},
    {{{{15}, {-15}, {-135}}}, 3},
    {{{{0, true}, {-15}, {-90}}}, 3},
    {{{{-15}, {15}, {-90}}}, 3},
    {{{{0, true}, {-45}, {-90}}}, 3},
}};

// --- Encounters with a single target ---

/// How the target's course follows from `angle_deg`.
enum class Shape {
  kEqualSpeeds,  ///< The target bears `angle_deg` from own ship, both equally fast.
  kOvertaking,   ///< Own ship bears `angle_deg` from the target, which goes half as fast.
  kOvertaken,    ///< The target bears `angle_deg` from own ship, which goes half as fast.
  kClear,        ///< Opposite courses, the target abeam at `angle_deg` (+-90), far enough away.
};

struct SingleRow {
  std::string_view name;
  Shape shape;
  double angle_deg;
  EncounterRole role;
  std::string_view description;
};

constexpr double kHalf = 0.5;

constexpr std::array kSingle = {
    SingleRow{"head_on", Shape::kEqualSpeeds, 0, EncounterRole::kHeadOn, "dead ahead"},
    SingleRow{"head_on_port_10", Shape::kEqualSpeeds, -10, EncounterRole::kHeadOn,
              "10 degrees to port: head-on up to 12"},
    SingleRow{"head_on_starboard_10", Shape::kEqualSpeeds, 10, EncounterRole::kHeadOn,
              "10 degrees to starboard: head-on up to 12"},
    SingleRow{"crossing_port_14", Shape::kEqualSpeeds, -14, EncounterRole::kStandOn,
              "14 degrees to port: crossing from 12 on"},
    SingleRow{"crossing_starboard_14", Shape::kEqualSpeeds, 14, EncounterRole::kGiveWay,
              "14 degrees to starboard: crossing from 12 on"},
    SingleRow{"crossing_port_45", Shape::kEqualSpeeds, -45, EncounterRole::kStandOn,
              "from port at right angles"},
    SingleRow{"crossing_starboard_45", Shape::kEqualSpeeds, 45, EncounterRole::kGiveWay,
              "from starboard at right angles"},
    SingleRow{"crossing_port_75", Shape::kEqualSpeeds, -75, EncounterRole::kStandOn,
              "converging from port"},
    SingleRow{"crossing_starboard_75", Shape::kEqualSpeeds, 75, EncounterRole::kGiveWay,
              "converging from starboard"},
    SingleRow{"overtaking", Shape::kOvertaking, 180, EncounterRole::kOvertaking,
              "from dead astern of the target"},
    SingleRow{"overtaking_port_117", Shape::kOvertaking, -117.5, EncounterRole::kOvertaking,
              "own ship 117.5 degrees on the target's port side: overtaking from 112.5 on"},
    SingleRow{"overtaking_starboard_117", Shape::kOvertaking, 117.5, EncounterRole::kOvertaking,
              "own ship 117.5 degrees on the target's starboard side: overtaking from 112.5 on"},
    SingleRow{"faster_port_107", Shape::kOvertaking, -107.5, EncounterRole::kGiveWay,
              "own ship 107.5 degrees on the target's port side: crossing up to 112.5"},
    SingleRow{"faster_starboard_107", Shape::kOvertaking, 107.5, EncounterRole::kStandOn,
              "own ship 107.5 degrees on the target's starboard side: crossing up to 112.5"},
    SingleRow{"overtaken", Shape::kOvertaken, 180, EncounterRole::kOvertaken,
              "the target comes from dead astern"},
    SingleRow{"overtaken_port_117", Shape::kOvertaken, -117.5, EncounterRole::kOvertaken,
              "the target 117.5 degrees on the port side: it overtakes from 112.5 on"},
    SingleRow{"overtaken_starboard_117", Shape::kOvertaken, 117.5, EncounterRole::kOvertaken,
              "the target 117.5 degrees on the starboard side: it overtakes from 112.5 on"},
    SingleRow{"slower_port_107", Shape::kOvertaken, -107.5, EncounterRole::kStandOn,
              "the target 107.5 degrees on the port side: crossing up to 112.5"},
    SingleRow{"slower_starboard_107", Shape::kOvertaken, 107.5, EncounterRole::kGiveWay,
              "the target 107.5 degrees on the starboard side: crossing up to 112.5"},
    SingleRow{"clear_port", Shape::kClear, -90, EncounterRole::kNone,
              "opposite courses, clear to port: no risk of collision"},
    SingleRow{"clear_starboard", Shape::kClear, 90, EncounterRole::kNone,
              "opposite courses, clear to starboard: no risk of collision"},
};

constexpr auto kSingleNames = [] {
  std::array<std::string_view, kSingle.size()> names;
  for (size_t i = 0; i < names.size(); ++i) names.at(i) = kSingle.at(i).name;
  return names;
}();

/// Bearing of the faster vessel (course 0, speed 1) from a slower one (speed `kHalf`) that it is
/// about to meet, relative to the slower one's course.
double AspectAtCourse(double course_deg) {
  const Eigen::Vector2d offset = UnitVector(DegToRad(course_deg)) * kHalf - Eigen::Vector2d(0, 1);
  return Wrap180(RadToDeg(HeadingOf(offset)) - course_deg);
}

/// Returns the slower one's course at which the faster one bears `aspect_deg` from it.
double CourseOfAspect(double aspect_deg) {
  double low_deg = 0;     // There it is 180,
  double high_deg = 180;  // and 0 here.
  const double wanted_deg = std::abs(aspect_deg);
  if (wanted_deg >= 180) return 0;
  for (int i = 0; i < 60; ++i) {
    const double middle_deg = (low_deg + high_deg) / 2;
    (std::abs(AspectAtCourse(middle_deg)) > wanted_deg ? low_deg : high_deg) = middle_deg;
  }
  return aspect_deg < 0 ? -low_deg : low_deg;
}

/// At the scale of surface craft 100 m, two and a half times risk_m of EncounterOptions.
double ClearRange_m(double range_m) { return range_m / 3.6; }

}  // namespace

double MeetingRange_m(const ScenarioScale& scale) { return kSixNauticalMiles_m * scale.length; }

EncounterScenario ImazuCase(int number, const ScenarioScale& scale) {
  SHOAL_CHECK(number >= 1 && number <= kNumImazuCases, "Imazu's cases are 1 to 22");
  const ImazuRow& row = kImazu.at(static_cast<size_t>(number - 1));
  EncounterScenario scenario;
  scenario.name = "imazu_" + TwoDigits(number);
  scenario.description = "Imazu's case " + std::to_string(number) + " of 22";
  scenario.meeting_s = MeetingRange_m(scale) / scale.speed_mps;
  const Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  scenario.vessels.push_back(
      VesselThrough("own", origin_m, 0, scale.speed_mps, scenario.meeting_s));
  for (size_t i = 0; i < row.num_targets; ++i) {
    const ImazuTarget& target = row.targets.at(i);
    scenario.vessels.push_back(
        VesselThrough("target_" + std::to_string(i + 1), origin_m, target.course_deg,
                      scale.speed_mps * (target.is_slow ? kSlowShare : 1), scenario.meeting_s));
  }
  return scenario;
}

EncounterScenario OvertakingCase(int number, const ScenarioScale& scale) {
  SHOAL_CHECK(number >= 1 && number <= kNumOvertakingCases, "cases of overtaking are 1 to 22");
  // Of the slower one's line to port of own ship's, of MeetingRange_m().
  constexpr std::array kOffsets = {-10, -6, -4, -2, -1, 0, 1, 2, 4, 6, 10};
  constexpr double kOffsetUnit = 1.0 / 360;
  constexpr double kEast_deg = 90;
  const size_t place = static_cast<size_t>(number - 1) % kOffsets.size();
  const double share = static_cast<size_t>(number) <= kOffsets.size() ? 1.0 / 3 : 2.0 / 3;
  const double range_m = MeetingRange_m(scale);
  EncounterScenario scenario;
  scenario.name = "overtaking_" + TwoDigits(number);
  scenario.description = "Overtaking from dead astern, case " + std::to_string(number) + " of 22";
  scenario.meeting_s = range_m / scale.speed_mps;
  scenario.role = EncounterRole::kOvertaking;
  const Eigen::Vector2d offset_m(0, kOffsets.at(place) * kOffsetUnit * range_m);
  scenario.vessels = {
      VesselThrough("own", Eigen::Vector2d::Zero(), kEast_deg, scale.speed_mps, scenario.meeting_s),
      VesselThrough("target_1", offset_m, kEast_deg, scale.speed_mps * share, scenario.meeting_s)};
  return scenario;
}

std::span<const std::string_view> SingleTargetNames() { return kSingleNames; }

std::optional<EncounterScenario> SingleTarget(std::string_view name, const ScenarioScale& scale) {
  const auto row = std::find_if(kSingle.begin(), kSingle.end(),
                                [&](const SingleRow& each) { return each.name == name; });
  if (row == kSingle.end()) return std::nullopt;
  EncounterScenario scenario;
  scenario.name = row->name;
  scenario.description = std::string("One target, ") + std::string(row->description);
  const double range_m = MeetingRange_m(scale);
  scenario.meeting_s = range_m / scale.speed_mps;
  scenario.role = row->role;

  double own_speed_mps = scale.speed_mps;
  double target_speed_mps = scale.speed_mps;
  double target_course_deg = 0;
  Eigen::Vector2d target_meeting_m = Eigen::Vector2d::Zero();
  switch (row->shape) {
    case Shape::kEqualSpeeds:
      target_course_deg = 180 + 2 * row->angle_deg;
      break;
    case Shape::kOvertaking:
      target_speed_mps *= kHalf;
      target_course_deg = CourseOfAspect(row->angle_deg);
      break;
    case Shape::kOvertaken:
      own_speed_mps *= kHalf;
      target_course_deg = -CourseOfAspect(row->angle_deg);
      break;
    case Shape::kClear:
      target_course_deg = 180;
      target_meeting_m = {std::copysign(ClearRange_m(range_m), row->angle_deg), 0};
      break;
  }
  scenario.vessels = {
      VesselThrough("own", Eigen::Vector2d::Zero(), 0, own_speed_mps, scenario.meeting_s),
      VesselThrough("target_1", target_meeting_m, target_course_deg, target_speed_mps,
                    scenario.meeting_s)};
  return scenario;
}

EncounterScenario RandomEncounter(uint64_t seed, int num_vessels, const ScenarioScale& scale) {
  SHOAL_CHECK(num_vessels >= 2 && num_vessels <= kMaxRandomVessels,
              "random encounters have 2 to 8 vessels");
  const double range_m = MeetingRange_m(scale);
  EncounterScenario scenario;
  scenario.name = "random_" + std::to_string(num_vessels) + "_" + std::to_string(seed);
  scenario.description = "Random encounter of " + std::to_string(num_vessels) + " vessels, seed " +
                         std::to_string(seed);
  scenario.meeting_s = range_m / scale.speed_mps;
  Stream stream(seed, "encounter", num_vessels);
  for (int i = 0; i < num_vessels; ++i) {
    constexpr int kMaxDraws = 10'000;
    for (int draw = 0; draw < kMaxDraws; ++draw) {
      const double course_deg = 360 * stream.Uniform();
      const double speed_mps = scale.speed_mps * (0.5 + 0.5 * stream.Uniform());
      // Uniform over the disc.
      const double away_m = i < 2 ? 0 : range_m / 6 * std::sqrt(stream.Uniform());
      const Eigen::Vector2d meeting_m = UnitVector(2 * kPi * stream.Uniform()) * away_m;
      const double late = i < 2 ? 0 : 0.2 * stream.Uniform() - 0.1;
      ScenarioVessel vessel = VesselThrough("vessel_" + std::to_string(i + 1), meeting_m,
                                            course_deg, speed_mps, scenario.meeting_s);
      vessel.start.position_m -=
          UnitVector(DegToRad(course_deg)) * (speed_mps * scenario.meeting_s * late);
      const bool is_apart =
          std::all_of(scenario.vessels.begin(), scenario.vessels.end(), [&](const auto& other) {
            return (other.start.position_m - vessel.start.position_m).norm() >= range_m / 4 &&
                   (other.goal_m - vessel.goal_m).norm() >= range_m / 10;
          });
      if (!is_apart && draw + 1 < kMaxDraws) continue;
      scenario.vessels.push_back(std::move(vessel));
      break;
    }
  }
  return scenario;
}

}  // namespace shoal
