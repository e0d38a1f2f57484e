// Which of the collision regulations governs an encounter with one contact, with memory: a role
// that has been taken is kept until the rule ends it.
//
//                        first entry of this list that holds, checked in this order
//   none, cpa ──────────────────────────────────────────────────────────────────────────┐
//     ▲                                                                                 │
//     │   overtaking (13)    D < outer, closing, own ship abaft the contact's beam and  │
//     │                      gaining on it                                              │
//     │   head-on (14)       D < 2 outer, each sees the other within 12° of its bow,    │
//     │                      not (opening and D > min_cpa)                              │
//     │   overtaken (13/17)  D < outer, the contact abaft own beam and gaining,         │
//     │                      present CPA <= max_cpa                                     │
//     │   give-way (15/16)   D < outer, contact to starboard forward of the abaft       │
//     │                      sector, own ship to its port, not (opening and D > min_cpa)│
//     │   stand-on (15/17)   D < outer, the mirror of give-way, closing, the contact    │
//     │                      making way toward own bow-stern line                       │
//     │   cpa (8)            D <= outer, none of them: keeps clear without a role       │
//     │                                                                                 │
//     │ ends                                                                            ▼
//     └──────────────────────────────────────────────────────────────────────────── the role
//         every role         D >= outer (head-on: 2 outer)
//         overtaking         finally past and clear (13 d): own ship within 22.5° of the contact's
//                            bow, or the two open for min_dwell
//         overtaken          the mirror: the contact within 22.5° of own bow, or opening so long
//         head-on            opening and D > min_cpa; own ship abaft the contact's beam; both see
//                            each other to starboard, by 17° one of them or by 31.5° in all
//         give-way           opening and D > min_cpa; own ship on the contact's starboard side
//         stand-on           opening and D > min_cpa: crossing ahead alone does not end it
//
//   stand-on ── D <= max_cpa and present CPA <= min_cpa ──► in extremis (17 b): keeps clear as it
//   overtaken ── danger ──►   can, until the course and speed of the entry would do again, by half
//                          as much again as min_cpa; the role then ends when opening has lasted
//                          for min_dwell.
//   danger (any role, and cpa): close, closing, and CPA <= min_cpa (IsDanger). Lasts for min_dwell,
//                          and as long as in extremis does.
//
// D is the distance, CPA the closest distance if both hold course and speed. A role lasts at least
// min_dwell, out of range aside, and does not come back within min_dwell after it ended; another
// one may come at once. A vessel without way on (kNoWay_mps) has no bow to judge by: no role begins
// with one, it is kept clear of as "cpa".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

enum class ColregsMode {
  kNone,
  kCpa,
  kOvertaking,
  kHeadOn,
  kOvertaken,
  kGiveWay,
  kStandOn,
};

/// What own ship does in its role; of the vessel that stands on: what it takes the other to do.
enum class ColregsSubMode {
  kNone,
  kPort,       ///< Overtaking: passes on the contact's port side. Overtaken: is passed on own port.
  kStarboard,  ///< The same, on starboard.
  kStern,      ///< Crosses astern of the vessel that stands on.
  kBow,        ///< Crosses well ahead of it.
  kUnsureBow,  ///< Will cross ahead, not far.
  kUnsure,     ///< Will cross ahead, close.
  kNeither,    ///< Does not approach own bow-stern line any more.
  kInExtremis,  ///< The vessel that stands on acts.
};

/// Slower than this a vessel makes no way.
inline constexpr double kNoWay_mps = 0.1;

struct ColregsLimits {
  double outer_m = 100;        ///< No role from here on.
  double min_cpa_m = 10;       ///< Closer is a near collision.
  double max_cpa_m = 75;       ///< Farther is as good as clear.
  double give_way_bow_m = -1;  ///< Least distance to cross ahead; -1: (2 max_cpa + min_cpa) / 3;
                               ///< limited to min_cpa .. 2 max_cpa.
  double turn_radius_m = 0;    ///< Own.
  double min_dwell_s = 3;
  bool head_on_only = false;  ///< No role but head-on.
  /// False: no danger but in extremis, which a vessel that is overtaken is in by the distances of
  /// one that stands on, and until the two open; the side of overtaking may change; the course to
  /// hold is that of the entry.
  bool steady = true;
  ClassifyOptions sectors = {};
};

struct ColregsState {
  ColregsMode mode = ColregsMode::kNone;
  ColregsSubMode sub_mode = ColregsSubMode::kNone;
  double entered_s = 0;
  double sub_mode_since_s = 0;
  /// Own, at entry: what standing on holds. Where steady, a vessel that stands on and has turned by
  /// more than 20 degrees holds a course 20 degrees from its own: what it left is history.
  double entry_heading_deg = 0;
  double entry_speed_mps = 0;
  std::optional<double> opening_since_s = {};
  ColregsMode ended = ColregsMode::kNone;  ///< The role before this one ...
  double ended_s = 0;                      ///< ... and when it ended.
  std::optional<double> danger_s = {};     ///< When danger (IsDanger) was seen last; absent: over.

  bool in_extremis() const { return sub_mode == ColregsSubMode::kInExtremis; }
  /// Keeps course and speed: stand-on or overtaken, and not in extremis.
  bool stands_on() const {
    return (mode == ColregsMode::kStandOn || mode == ColregsMode::kOvertaken) && !in_extremis();
  }
  bool operator==(const ColregsState&) const = default;
};

/// Returns the state at `time_s`. @pre time_s never decreases
[[nodiscard]] ColregsState NextColregsState(const ColregsState& before, const VesselMotion& own,
                                            const VesselMotion& contact,
                                            const ColregsLimits& limits, double time_s);

[[nodiscard]] EncounterRole RoleOf(ColregsMode mode);

/// Returns "none", "cpa", or the name of the role.
[[nodiscard]] std::string_view Name(ColregsMode mode);
/// Returns "port", "unsure_bow", "in_extremis" ...; empty for kNone.
[[nodiscard]] std::string_view Name(ColregsSubMode sub_mode);

/// Returns mode and sub-mode, "give-way:stern", "head-on".
[[nodiscard]] std::string TextOf(const ColregsState& state);

/// Returns the number of the rule: "14", "17(b)" in extremis, "8" for cpa; empty: none.
[[nodiscard]] std::string_view RuleOf(const ColregsState& state);

}  // namespace shoal
