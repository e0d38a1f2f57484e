// The cost of changing a decision while a contact is kept clear of.
//
// Two ways to keep clear are often nearly as good: to turn, or to slow down. What the goals want
// changes from moment to moment, with a track line above all, and so would the choice, by tens of
// degrees to and fro. So a behavior that keeps clear likes what was decided last, as long as that
// does keep clear: the side of passing, once chosen, holds until the contact is past.
#pragma once

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

/// Makes the last decision a part of the preference of a behavior that keeps clear:
///
///   (1 - s) f + s (kept course + kept speed) / 2,   s = 0.3
///
/// where what is kept is 100 at the last decision and falls, as the square of the difference, to 0
/// at 45 degrees and at 1 m/s: small changes are free, a jump costs all of it. The weight grows by
/// 1 / (1 - s), so that f counts as before. Without effect where nothing was decided, where the
/// last decision leads closer than three fifths of the way from min_cpa_m to max_cpa_m, and where
/// the two open.
/// @pre answer has a normalised objective
void PreferLastDecision(const BehaviorInputs& inputs, const VesselMotion& contact, double min_cpa_m,
                        double max_cpa_m, BehaviorAnswer& answer);

}  // namespace shoal
