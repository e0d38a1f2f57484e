// The best point of a grid of courses and speeds, exact, without a look at every point: branch and
// bound. Part of Decide and NormaliseTo100; no other library needs it.
#pragma once

#include <algorithm>
#include <compare>
#include <limits>
#include <utility>
#include <vector>

#include "lib/helm/decision/objective.h"

namespace shoal {

struct GridPoint {
  int course = 0;
  int speed = 0;

  auto operator<=>(const GridPoint&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

/// Returns the point of `whole` with the greatest value, and that value. Of points with equal
/// values it is the one with the lowest course, then with the lowest speed. `problem` gives
///
///   Number                   of values and bounds,
///   Bounds                   what it keeps about a box for the boxes inside,
///   kAnyOfEquals             true: any point with the greatest value will do,
///   first_guesses()          points of `whole`, at least one; good ones save work,
///   Value(point)             a number,
///   Upper(box, outer, worth, bounds)  a number that no Value in the box exceeds; `outer` are the
///                            bounds of a box around it. Fills in `bounds`, unless it returns less
///                            than `worth`,
///   Worthwhile(point, bounds, worth)  false: Value(point) is less than `worth` for sure, by the
///                            bounds of a box around it.
///
/// Sectors of the circle wait in a heap, the one with the greatest upper bound first. It is halved,
/// and both halves bounded; a small one is evaluated point by point. Boxes that cannot hold a
/// better point than the best one so far are dropped.
///
/// Why the result is exact. Call p better than q where its value is greater, or equal and its
/// (course, speed) comes first; this is a total order. Let b be the best of all points. At each
/// time either b was evaluated, or one waiting box holds it: halving keeps every point, and a box
/// that holds b is dropped only for a best point so far, r, with Upper < Value(r), which Value(b)
/// <= Upper contradicts, or with Upper == Value(r) and r not after the first point of the box: then
/// Value(b) <= Value(r) and r is not after b, so r is b. The search ends with no box waiting, so b
/// was evaluated, and nothing replaces it. The order in which boxes are visited has no effect.
template <class Problem>
std::pair<GridPoint, typename Problem::Number> BestPoint(Problem* problem, const GridBox& whole) {
  using Number = typename Problem::Number;
  struct Waiting {
    Number upper;
    GridBox box;
    typename Problem::Bounds bounds;
  };
  constexpr int kWidestSector = 45;
  constexpr int kFewPoints = 9;
  constexpr double kRadPerCourse = 0.0175;

  GridPoint best = {};
  Number best_value = std::numeric_limits<Number>::lowest();
  const auto look_at = [&](const GridPoint& point) {
    const Number value = problem->Value(point);
    if (value > best_value || (!Problem::kAnyOfEquals && value == best_value && point < best)) {
      best = point;
      best_value = value;
    }
  };
  const auto may_hold_a_better_one = [&](Number upper, const GridBox& box) {
    return upper > best_value ||
           (!Problem::kAnyOfEquals && upper == best_value &&
            GridPoint{.course = box.first_course, .speed = box.first_speed} < best);
  };

  // Of equal bounds first the box with the lowest course: that settles ties early.
  const auto later = [](const Waiting& a, const Waiting& b) {
    if (a.upper != b.upper) return a.upper < b.upper;
    return std::pair(a.box.first_course, a.box.first_speed) >
           std::pair(b.box.first_course, b.box.first_speed);
  };
  std::vector<Waiting> waiting;
  waiting.reserve(128);
  const auto consider = [&](const GridBox& box, const Waiting& outer) {
    Waiting inner = {.upper = {}, .box = box, .bounds = outer.bounds};
    inner.upper =
        std::min(outer.upper, problem->Upper(box, outer.bounds, best_value, &inner.bounds));
    if (!may_hold_a_better_one(inner.upper, box)) return;
    waiting.push_back(inner);
    std::push_heap(waiting.begin(), waiting.end(), later);
  };

  for (const GridPoint& guess : problem->first_guesses()) look_at(guess);
  Waiting all = {.upper = {}, .box = whole, .bounds = {}};
  all.upper = problem->Upper(whole, {}, best_value, &all.bounds);
  if (!may_hold_a_better_one(all.upper, whole)) return {best, best_value};
  for (int first = whole.first_course; first <= whole.last_course; first += kWidestSector) {
    GridBox sector = whole;
    sector.first_course = first;
    sector.last_course = std::min(first + kWidestSector - 1, whole.last_course);
    consider(sector, all);
  }
  while (!waiting.empty()) {
    std::pop_heap(waiting.begin(), waiting.end(), later);
    const Waiting next = waiting.back();
    const GridBox& box = next.box;
    waiting.pop_back();
    if (next.upper < best_value) break;
    if (!may_hold_a_better_one(next.upper, box)) continue;

    const int num_courses = box.last_course - box.first_course + 1;
    const int num_speeds = box.last_speed - box.first_speed + 1;
    if (num_courses * num_speeds <= kFewPoints) {
      for (int course = box.first_course; course <= box.last_course; ++course) {
        for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
          const GridPoint point = {.course = course, .speed = speed};
          if (problem->Worthwhile(point, next.bounds, best_value)) look_at(point);
        }
      }
      continue;
    }
    look_at({.course = (box.first_course + box.last_course) / 2,
             .speed = (box.first_speed + box.last_speed) / 2});
    // The longer side in the plane of velocities: an arc at the greatest speed, or a radius.
    const bool halve_courses =
        num_speeds == 1 ||
        (num_courses > 1 &&
         kRadPerCourse * (num_courses - 1) * (box.last_speed + 1) > num_speeds - 1);
    GridBox front = box;
    GridBox back = box;
    if (halve_courses) {
      front.last_course = (box.first_course + box.last_course) / 2;
      back.first_course = front.last_course + 1;
    } else {
      front.last_speed = (box.first_speed + box.last_speed) / 2;
      back.first_speed = front.last_speed + 1;
    }
    consider(front, next);
    consider(back, next);
  }
  return {best, best_value};
}

}  // namespace shoal
