// Random domains, contacts and objectives for the tests of decisions.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"
#include "lib/helm/decision/cpa_function.h"
#include "lib/helm/decision/decide.h"
#include "lib/helm/decision/shapes.h"

namespace shoal {

/// A stream named by one number that rapidcheck draws: a table of hundreds of numbers need not be
/// drawn, and shrunk, one by one.
inline Stream AnyStream() { return {*rc::gen::arbitrary<uint64_t>(), "test of decisions"}; }

inline double Between(Stream& stream, double low, double high) {
  return low + (high - low) * stream.Uniform();
}

/// Returns an integer of low..high.
inline int IntBetween(Stream& stream, int low, int high) {
  return low + static_cast<int>(stream.UniformInt(static_cast<uint64_t>(high - low + 1)));
}

/// Few speeds, so that brute force is fast.
inline Domain SmallDomain(Stream& stream) {
  const int count = IntBetween(stream, 1, 9);
  return {.speed_mps = {.first = 0, .step = Between(stream, 0.1, 0.6), .count = count}};
}

inline GridBox DrawBox(Stream& stream, const Domain& domain) {
  GridBox box;
  box.first_course = IntBetween(stream, 0, 359);
  box.last_course =
      std::min(359, box.first_course + IntBetween(stream, 0, IntBetween(stream, 0, 359)));
  box.first_speed = IntBetween(stream, 0, domain.speed_mps.count - 1);
  box.last_speed = IntBetween(stream, box.first_speed, domain.speed_mps.count - 1);
  return box;
}

struct TestContact {
  Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();
  double horizon_s = 120;
};

inline TestContact DrawContact(Stream& stream) {
  TestContact contact;
  contact.offset_m = Between(stream, 0, 150) * UnitVector(Between(stream, 0, 2 * kPi));
  contact.velocity_mps = Between(stream, 0, 4) * UnitVector(Between(stream, 0, 2 * kPi));
  if (stream.Uniform() < 0.1) contact.offset_m.setZero();
  if (stream.Uniform() < 0.1) contact.velocity_mps.setZero();
  if (stream.Uniform() < 0.3) contact.horizon_s = Between(stream, 0, 60);
  return contact;
}

inline CpaGrid CpaOf(const TestContact& contact, const Domain& domain) {
  return {contact.offset_m, contact.velocity_mps, contact.horizon_s, domain};
}

inline CpaUtility DrawUtility(Stream& stream) {
  const double lo_m = Between(stream, 1, 20);
  return {.lo_m = lo_m, .hi_m = lo_m + Between(stream, 0, 60), .at_lo = Between(stream, 0, 50)};
}

inline Objective KeepClear(const TestContact& contact, const CpaUtility& utility,
                           const Domain& domain) {
  return NormaliseTo100({.coupled = std::make_shared<CpaFunction>(CpaOf(contact, domain), utility)},
                        domain);
}

/// Toward a bearing at a speed, as a waypoint is steered for.
inline Objective GoToward(double bearing_deg, double speed_mps, const Domain& domain) {
  return Couple(PeakOverCourse(bearing_deg, 0, 180),
                PeakOverAxis(domain.speed_mps, speed_mps, speed_mps / 2, 1.6, 20), 50, 50);
}

/// Any values, with bounds that are wider than needed by up to `slack`.
class TableFunction final : public CourseSpeedFunction {
 public:
  TableFunction(std::vector<double> values, int num_speeds, double slack)
      : values_(std::move(values)), num_speeds_(num_speeds), slack_(slack) {}

  double At(int course, int speed) const override {
    return values_.at(static_cast<size_t>(course * num_speeds_ + speed));
  }
  Range Bound(const GridBox& box) const override {
    Range range{.min = At(box.first_course, box.first_speed),
                .max = At(box.first_course, box.first_speed)};
    for (int course = box.first_course; course <= box.last_course; ++course) {
      for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
        range.min = std::min(range.min, At(course, speed));
        range.max = std::max(range.max, At(course, speed));
      }
    }
    const double slack = slack_ * ((box.first_course + box.last_speed) % 3);
    return {.min = range.min - slack, .max = range.max + slack};
  }

 private:
  std::vector<double> values_;
  int num_speeds_;
  double slack_;
};

}  // namespace shoal
