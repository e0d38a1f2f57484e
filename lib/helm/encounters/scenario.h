// Encounters by design: where each vessel starts, how fast and for which goal.
//
//   const EncounterScenario head_on = ImazuCase(1, {});
//
// x East, y North. All vessels go straight from start to goal and, unless one of them alters, meet
// at or near the origin at the same time. docs/vehicles/encounters.md states sources and choices.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

struct ScenarioVessel {
  std::string name;  ///< "own", then "target_1" ...; of random encounters "vessel_1" ...
  VesselMotion start = {};
  Eigen::Vector2d goal_m = Eigen::Vector2d::Zero();
};

struct EncounterScenario {
  std::string name;         ///< "imazu_01", "head_on", "random_4_17".
  std::string description;  ///< One line.
  std::vector<ScenarioVessel> vessels;
  double meeting_s = 0;  ///< When they would meet.
  /// Role of the first vessel toward the second at entry, of encounters of two; kNone: there must
  /// be no encounter.
  std::optional<EncounterRole> role;
};

/// Lengths of ships become lengths of the vessels of the mission: six nautical miles at scale
/// 0.0324 are 360 m, and 30 minutes at 12 knots become 120 s at 3 m/s.
struct ScenarioScale {
  double length = 0.0324;  ///< > 0.
  double speed_mps = 3;    ///< Of own ship; > 0.

  bool operator==(const ScenarioScale&) const = default;
};

/// Returns six nautical miles at that scale.
[[nodiscard]] double MeetingRange_m(const ScenarioScale& scale);

constexpr int kNumImazuCases = 22;

/// Returns case 1 to 22 of Imazu (1987), coordinates after Sawada, Sato and Majima (2021), Table 4.
/// @pre 1 <= number <= kNumImazuCases
[[nodiscard]] EncounterScenario ImazuCase(int number, const ScenarioScale& scale);

constexpr int kNumOvertakingCases = 22;

/// Returns a vessel that comes up from dead astern of a slower one, both on course 90: the slower
/// one goes a third (1 to 11) or two thirds (12 to 22) as fast, and its line is up to 10 m, at the
/// default scale, to the North or South of own ship's. @pre 1 <= number <= kNumOvertakingCases
[[nodiscard]] EncounterScenario OvertakingCase(int number, const ScenarioScale& scale);

/// Returns the names of the encounters with a single target, one on either side of each boundary of
/// the classification among them.
[[nodiscard]] std::span<const std::string_view> SingleTargetNames();

/// Returns nothing where there is no encounter of this name.
[[nodiscard]] std::optional<EncounterScenario> SingleTarget(std::string_view name,
                                                            const ScenarioScale& scale);

constexpr int kMaxRandomVessels = 8;

/// Draws an encounter of `num_vessels`: the first two meet at the origin at the same time; each
/// further one passes within a sixth of MeetingRange_m() of it, up to a tenth of the time earlier
/// or later. Speeds are 0.5 to 1 of the scale's. Starts are a quarter of MeetingRange_m() apart,
/// goals a tenth. Equal arguments, equal encounters. @pre 2 <= num_vessels <= kMaxRandomVessels
[[nodiscard]] EncounterScenario RandomEncounter(uint64_t seed, int num_vessels,
                                                const ScenarioScale& scale);

}  // namespace shoal
