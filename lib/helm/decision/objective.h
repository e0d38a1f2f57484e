// An objective function: how much one behavior likes each course, speed and depth.
//
//   value(course, speed, depth) =
//       offset + scale * (course[i] + speed[j] + depth[k] + coupled->At(i, j))
//
// A part that is empty counts as 0 everywhere. Depth never couples with the rest, so that the
// decision about it is separate, and exact.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lib/helm/decision/domain.h"

namespace shoal {

/// A part of the grid of courses and speeds, by indices, ends included. Never crosses North.
struct GridBox {
  int first_course = 0;
  int last_course = 0;
  int first_speed = 0;
  int last_speed = 0;

  bool operator==(const GridBox&) const = default;
};

/// A function that couples course and speed. Pure: the same indices always give the same value.
class CourseSpeedFunction {
 public:
  virtual ~CourseSpeedFunction() = default;

  /// Returns the value at a point of the grid; finite.
  virtual double At(int course, int speed) const = 0;

  /// A range that holds all values of a box; it may be wider than needed.
  struct Range {
    double min = 0;
    double max = 0;
  };
  virtual Range Bound(const GridBox& box) const = 0;
};

struct Objective {
  std::vector<double> course = {};  ///< Domain::kNumCourses values, or none.
  std::vector<double> speed = {};   ///< One per speed, or none.
  std::vector<double> depth = {};   ///< One per depth, or none.
  std::shared_ptr<const CourseSpeedFunction> coupled = nullptr;
  double offset = 0;
  double scale = 1;

  bool mentions_course() const { return !course.empty() || coupled != nullptr; }
  bool mentions_speed() const { return !speed.empty() || coupled != nullptr; }
  bool mentions_depth() const { return !depth.empty(); }
};

}  // namespace shoal
