#include "lib/helm/decision/speed_along.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kRounding_mps = 1e-9;

struct WayOfCourse {
  double x = 0;
  double y = 0;
};
using WaysOfCourses = std::array<WayOfCourse, Domain::kNumCourses>;

WaysOfCourses MakeWaysOfCourses() {
  WaysOfCourses ways;
  for (int i = 0; i < Domain::kNumCourses; ++i) {
    const Eigen::Vector2d way = UnitVector(DegToRad(i));
    ways[static_cast<size_t>(i)] = {.x = way.x(), .y = way.y()};
  }
  return ways;
}

const WaysOfCourses kWays = MakeWaysOfCourses();

}  // namespace

SpeedAlong::SpeedAlong(double toward_deg, const Domain& domain)
    : toward_deg_(Wrap360(toward_deg)),
      away_deg_(Wrap360(toward_deg + 180)),
      first_mps_(domain.speed_mps.first),
      step_mps_(domain.speed_mps.step) {
  const Eigen::Vector2d toward = UnitVector(DegToRad(toward_deg));
  x_ = toward.x();
  y_ = toward.y();
}

double SpeedAlong::Cosine(int course) const {
  const WayOfCourse& way = kWays[static_cast<size_t>(course)];
  return way.x * x_ + way.y * y_;
}

CourseSpeedFunction::Range SpeedAlong::Bound(const GridBox& box) const {
  const double first = Cosine(box.first_course);
  const double last = Cosine(box.last_course);
  const auto holds = [&](double course_deg) {
    return course_deg > box.first_course && course_deg < box.last_course;
  };
  const double most = holds(toward_deg_) ? 1 : std::max(first, last);
  const double least = holds(away_deg_) ? -1 : std::min(first, last);
  const double slow_mps = SpeedAt(box.first_speed);
  const double fast_mps = SpeedAt(box.last_speed);
  return {.min = std::min(least * slow_mps, least * fast_mps) - kRounding_mps,
          .max = std::max(most * slow_mps, most * fast_mps) + kRounding_mps};
}

}  // namespace shoal
