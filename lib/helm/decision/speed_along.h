// How fast each course and speed of a grid makes way in one direction, with bounds.
#pragma once

#include "lib/helm/decision/objective.h"

namespace shoal {

class SpeedAlong {
 public:
  SpeedAlong() = default;
  /// `toward_deg`: compass.
  SpeedAlong(double toward_deg, const Domain& domain);

  /// Returns the component, m/s, of the velocity along the direction.
  [[nodiscard]] double At(int course, int speed) const { return SpeedAt(speed) * Cosine(course); }
  /// Returns a range that holds At() of every point of the box, rounding included.
  [[nodiscard]] CourseSpeedFunction::Range Bound(const GridBox& box) const;

 private:
  double Cosine(int course) const;
  double SpeedAt(int speed) const { return first_mps_ + step_mps_ * speed; }

  double x_ = 0;
  double y_ = 1;
  double toward_deg_ = 0;
  double away_deg_ = 180;
  double first_mps_ = 0;
  double step_mps_ = 0;
};

}  // namespace shoal
