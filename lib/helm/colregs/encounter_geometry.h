// The geometry of two vessels, and which of the collision regulations' situations it is.
//
//   beta   relative bearing of the contact from own ship: from own heading clockwise, [0, 360)
//   alpha  contact angle: relative bearing of own ship from the contact, [0, 360)
//
// Angles in degrees, compass; x East, y North.
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace shoal {

/// A vessel in straight motion.
struct VesselMotion {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double heading_deg = 0;
  double speed_mps = 0;  ///< >= 0.
};

/// Returns the velocity, x East, y North; a negative speed counts as 0.
[[nodiscard]] Eigen::Vector2d VelocityOf(const VesselMotion& vessel);

struct RelativeGeometry {
  double range_m = 0;
  double beta_deg = 0;
  double alpha_deg = 0;
  double range_rate_mps = 0;  ///< Negative: closing.
  double cpa_m = 0;           ///< Closest distance from now on, both holding course and speed.
  double time_to_cpa_s = 0;   ///< >= 0; 0 where they open, or move alike.
};

[[nodiscard]] RelativeGeometry GeometryOf(const VesselMotion& own, const VesselMotion& contact);

/// Returns the closest distance within `horizon_s` of two points in straight motion, `offset_m`
/// and `velocity_mps` those of one relative to the other (reference: CPA with clipped time).
[[nodiscard]] double ClosestApproach(const Eigen::Vector2d& offset_m,
                                     const Eigen::Vector2d& velocity_mps, double horizon_s);

/// Imminent danger, whatever the roles: the two close, going on takes them within `min_cpa_m` of
/// each other, and the contact is nearer than ten seconds, at least than 2 min_cpa_m, and at most
/// than max_cpa_m where that is more.
[[nodiscard]] bool IsDanger(const RelativeGeometry& geometry, double min_cpa_m, double max_cpa_m);

/// Own ship's part in an encounter.
enum class EncounterRole {
  kNone,        ///< No risk of collision, or too far.
  kOvertaking,  ///< Rule 13: own ship comes from abaft the contact's beam and keeps clear.
  kOvertaken,   ///< Rules 13 and 17: stands on.
  kHeadOn,      ///< Rule 14: both alter to starboard.
  kGiveWay,     ///< Rules 15 and 16: the contact is on own starboard side.
  kStandOn,     ///< Rules 15 and 17: own ship is on the contact's starboard side.
};

/// Returns "none", "overtaking", "overtaken", "head-on", "give-way" or "stand-on".
[[nodiscard]] std::string_view Name(EncounterRole role);

/// Returns the number of the rule that governs the role ("13", "14", "15/16", "17", ...); empty for
/// kNone.
[[nodiscard]] std::string_view RuleOf(EncounterRole role);

struct ClassifyOptions {
  double head_on_deg = 12;       ///< |beta| and |alpha| at most this: head-on (Woerner 2016: 13).
  double sidelight_deg = 112.5;  ///< End of the sidelights; beyond it is abaft the beam (rule 21).
};

/// Classifies by angles and motion alone, without memory: overtaking first (rule 13 prevails), then
/// head-on, then crossing. Vessels that open, or that would both stay farther than `risk_m` apart
/// holding course, have no role.
[[nodiscard]] EncounterRole Classify(const RelativeGeometry& geometry, double own_speed_mps,
                                     double contact_speed_mps, double risk_m,
                                     const ClassifyOptions& options = {});

}  // namespace shoal
