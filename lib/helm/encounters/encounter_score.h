// How well a vessel kept to the collision regulations in an encounter: a rubric after Woerner
// (2016, 2019): safety by range and pose at the closest approach, and rules 8 and 13 to 17 by what
// the vessel did. The formulas are shoal's own; docs/vehicles/encounters.md has all of them with
// their reasons.
#pragma once

#include <optional>
#include <string_view>

#include "lib/helm/encounters/encounter.h"

namespace shoal {

/// What the rubric counts, each 0 to 1, 1 best.
struct ScoreParts {
  double range = 0;     ///< By the distance at the closest approach.
  double pose = 1;      ///< Not ahead of the other at the closest approach; 1 of a stand-on vessel.
  double apparent = 0;  ///< Size of its action: 30 degrees, or half the speed, is full.
  double early = 0;     ///< Full where it began in the first half of the time that was left.
  double starboard = 0;     ///< First alteration of course to starboard.
  double port_to_port = 0;  ///< The other on the port side at the closest approach.
  double behind = 1;        ///< Did not cross ahead of the other, or far from it.
  double held_course = 1;   ///< Up to 3 degrees is full, 30 nothing.
  double held_speed = 1;    ///< Up to 5 % is full, 50 % nothing.
  double last_resort = 1;   ///< What it did in extremis, if it came to that.
};

/// One vessel's score in one encounter, 0 to 100. A rule that its role does not know is absent.
struct EncounterScore {
  ScoreParts parts = {};
  double safety = 0;
  std::optional<double> rule_8 = {};
  std::optional<double> rule_13 = {};
  std::optional<double> rule_14 = {};
  std::optional<double> rule_15 = {};
  std::optional<double> rule_16 = {};
  std::optional<double> rule_17 = {};
  double overall = 0;  ///< Weighted by role; 0 where the vessels touched.
};

/// @pre side is 0 or 1
[[nodiscard]] EncounterScore ScoreOf(const Encounter& encounter, size_t side,
                                     const EncounterOptions& options);

/// How a vessel passed the other: "ahead", "astern", "port to port", "starboard to starboard",
/// "on its port side" or "on its starboard side" (of the other), or "not yet".
/// @pre side is 0 or 1
[[nodiscard]] std::string_view PassedHow(const Encounter& encounter, size_t side);

}  // namespace shoal
