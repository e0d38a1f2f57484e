// The closest point of approach (CPA) to a contact for each course and speed, and how good it is.
//
//   const Objective keep_clear = NormaliseTo100(
//       {.coupled = std::make_shared<CpaFunction>(CpaGrid(contact_m - own_m, velocity_mps, 120,
//                                                         domain),
//                                                 CpaUtility{.lo_m = 10, .hi_m = 75})},
//       domain);
//
// CpaGrid and its bounds serve any function that grows with CPA, in whole or in regions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "lib/helm/decision/objective.h"

namespace shoal {

/// How good a CPA is.
struct CpaUtility {
  double lo_m = 10;   ///< Below: 0. > 0.
  double hi_m = 75;   ///< Above: 100. >= lo_m.
  double at_lo = 25;  ///< At lo_m, from where it grows linearly; 0 to 100.
};

/// Returns 0 below lo_m, 100 above hi_m, between them a line from at_lo to 100. Never decreases
/// with the distance.
[[nodiscard]] double UtilityOfCpa(double cpa_m, const CpaUtility& utility);

/// Returns the widest range of utilities of CPAs within `cpa_m`.
[[nodiscard]] CourseSpeedFunction::Range UtilityOfCpa(const CourseSpeedFunction::Range& cpa_m,
                                                      const CpaUtility& utility);

/// CPA for each course and speed of a domain, while the contact keeps its velocity.
///
/// With q the contact's place and w its velocity, both relative to own ship, CPA(w) is the least
/// |q + w t| of 0 <= t <= horizon. The bounds rest on two facts:
///
///  1. CPA is quasi-convex in w: it is at most d where w lies in (D - q) / t for some t, with D the
///     disc of radius d. The union of the convex set S = D - q, scaled by all s = 1/t >= 1/horizon,
///     is convex: the mean of a in s1 S and b in s2 S lies in (s1 + s2)/2 S. So the greatest CPA of
///     a convex polygon of velocities is that of one of its corners.
///  2. Without horizon, CPA depends only on the direction of w, and grows with its angle to -q. So
///     the least CPA of a polygon that lies on one side of the line along q is that of one of its
///     corners; a horizon can only raise it.
///
/// The polygon around a box of the grid: its inner and outer corners, and the point where the
/// tangents of the outer arc meet.
class CpaGrid {
 public:
  /// `offset_m` is the contact's position minus own.
  /// @pre all finite, horizon_s >= 0
  CpaGrid(const Eigen::Vector2d& offset_m, const Eigen::Vector2d& contact_velocity_mps,
          double horizon_s, const Domain& domain);

  /// Returns the CPA in metres; never more than range_m().
  [[nodiscard]] double At(int course, int speed) const;

  /// Returns a range that holds At() of every point of the box, rounding included.
  [[nodiscard]] CourseSpeedFunction::Range Bound(const GridBox& box) const;

  double range_m() const { return range_m_; }

 private:
  double SpeedAt(int speed) const { return first_mps_ + step_mps_ * speed; }
  /// Returns the unit vector, x East, y North.
  const Eigen::Vector2d& DirectionOf(int half_deg) const {
    return (*directions_)[static_cast<size_t>(half_deg)];
  }

  double offset_x_m_;
  double offset_y_m_;
  double contact_x_mps_;
  double contact_y_mps_;
  double horizon_s_;
  double first_mps_;
  double step_mps_;
  double range2_m2_;
  double range_m_;
  const std::array<Eigen::Vector2d, 720>* directions_;  ///< Of each half degree.
};

/// The utility of the CPA.
class CpaFunction final : public CourseSpeedFunction {
 public:
  CpaFunction(const CpaGrid& cpa, const CpaUtility& utility) : cpa_(cpa), utility_(utility) {}

  double At(int course, int speed) const override;
  Range Bound(const GridBox& box) const override;

 private:
  CpaGrid cpa_;
  CpaUtility utility_;
};

}  // namespace shoal
