// The building blocks of objective functions: one value for each course, speed or depth of the
// grid, 0 (worst) to 100 (best) unless stated.
//
//   const auto course = PeakOverCourse(bearing_deg, 0, 180);
//   const auto speed = PeakOverAxis(domain.speed_mps, 2, 1, 1.6, 20);
//   const Objective toward_the_point = Couple(course, speed, 50, 50);
//
// Formulas: docs/vehicles/decision.md. Angles in degrees, compass.
#pragma once

#include <vector>

#include "lib/helm/decision/objective.h"

namespace shoal {

/// Returns a peak: at distance d from the summit hi - delta d / peak up to d = peak, from there
/// falling linearly from hi - delta to lo over base, lo beyond. With peak = 0, delta does not
/// count. Where no grid point is above lo, the one nearest to the summit has hi, so that a narrow
/// peak between two grid points is not lost. Over course, d is counted around the circle; any
/// finite `summit_deg` is right.
/// @pre peak, base >= 0; 0 <= delta <= hi - lo
[[nodiscard]] std::vector<double> PeakOverCourse(double summit_deg, double peak_deg,
                                                 double base_deg, double delta = 0, double lo = 0,
                                                 double hi = 100);
/// The same over speed or depth. @pre axis.count > 0
[[nodiscard]] std::vector<double> PeakOverAxis(const Axis& axis, double summit, double peak,
                                               double base, double delta = 0, double lo = 0,
                                               double hi = 100);

/// Returns the polyline through (first, 0) (low, u_low) (med, 100) (high, u_high) (last, 0), first
/// and last those of the axis, the others rounded to its points. Of points that coincide, the one
/// nearest to med in this list counts.
/// @pre axis.count > 0, low <= med <= high
[[nodiscard]] std::vector<double> SpeedPolyline(const Axis& axis, double med, double low,
                                                double high, double u_low, double u_high);

/// Returns 100 at the summit, falling linearly to u_l at dl degrees to its left and to u_h at dh
/// degrees to its right, from there to 0 on the opposite course.
/// @pre 0 < dl, dh < 180
[[nodiscard]] std::vector<double> HeadingPolyline(double summit_deg, double dl, double dh,
                                                  double u_l, double u_h);

/// Returns 100 up to the summit, falling linearly to 0 over base. A summit below the axis counts as
/// its first value. @pre axis.count > 0, base >= 0
[[nodiscard]] std::vector<double> AtMost(const Axis& axis, double summit, double base);

/// Returns 100 from the summit up, rising linearly from 0 over base below it. A summit above the
/// axis counts as its last value. @pre axis.count > 0, base >= 0
[[nodiscard]] std::vector<double> AtLeast(const Axis& axis, double summit, double base);

/// Returns the sum at each point. @pre a and b are over the same axis
[[nodiscard]] std::vector<double> SumOf(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the function whose course part spans 0..course_share and whose speed part spans
/// 0..speed_share, normalised to 0..100. A part that is flat has no effect, unless both are flat.
/// @pre neither is empty; shares >= 0, not both 0
[[nodiscard]] Objective Couple(const std::vector<double>& course, const std::vector<double>& speed,
                               double course_share, double speed_share);

/// Returns the function shifted and scaled so that its least value over the grid is 0 and its
/// greatest 100, both exact. One that is flat to 1e-9 stays flat, at its value clipped to 0..100.
/// It still mentions the same variables.
[[nodiscard]] Objective NormaliseTo100(Objective objective, const Domain& domain);

}  // namespace shoal
