// How one vessel would go by another, holding a course and a speed: which side, which end.
//
// Own ship "passes" where it makes way along the contact's heading toward being abeam of it, and
// "crosses" where it makes way toward the contact's bow-stern line. Which end it crosses and which
// side it passes on follow from the side to which the bearing of the contact drifts.
#pragma once

#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

/// Less is none, in m/s and deg/s: a vessel on the contact's own course would otherwise cross its
/// line, or not, by the rounding of a sine.
inline constexpr double kNoDrift = 1e-6;

struct Passing {
  bool passes = false;
  bool passes_port = false;  ///< Would pass on the contact's port side, else on its starboard side.
  bool crosses = false;
  bool crosses_bow = false;       ///< Crosses ahead of the contact.
  bool crosses_stern = false;     ///< Crosses astern of it; both where the bearing stands.
  double bearing_rate_degps = 0;  ///< Of the contact, seen from own ship; positive: to the right.
};

/// Where own ship is, seen from the contact.
struct Aspect {
  bool fore = false;  ///< Forward of the contact's beam.
  bool port = false;  ///< On the contact's port side.
};

/// `alpha_deg`: contact angle, [0, 360).
[[nodiscard]] Aspect AspectOf(double alpha_deg);

/// Returns on which side own ship passes a contact whose bearing drifts at `bearing_rate_degps`.
[[nodiscard]] bool PassesPort(const Aspect& aspect, double bearing_rate_degps);

/// Returns whether own ship, if it crosses at all, crosses the contact's bow (stern).
[[nodiscard]] bool IsBowSide(const Aspect& aspect, double bearing_rate_degps);
[[nodiscard]] bool IsSternSide(const Aspect& aspect, double bearing_rate_degps);

/// `own` holds its heading and speed, and so does `contact`.
[[nodiscard]] Passing PassingOf(const VesselMotion& own, const VesselMotion& contact);

/// Returns how far ahead of the contact, in m, own ship crosses the contact's bow-stern line, both
/// holding course and speed; negative: astern of it. Infinite where it does not come closer to the
/// line.
[[nodiscard]] double CrossingDistance(const VesselMotion& own, const VesselMotion& contact);

}  // namespace shoal
