// The best point of a grid of courses and speeds, exact, without a look at every point: branch and
// bound. Part of Decide and NormaliseTo100; no other library needs it.
#pragma once

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "lib/decision/objective.h"

namespace shoal {

struct GridPoint {
  int course = 0;
  int speed = 0;

  auto operator<=>(const GridPoint&) const = default;
};

/// Returns the point of `whole` with the greatest value, of equal ones that of the lowest course,
/// of those the one with the lowest speed; and its value. `problem` gives
///
///   Value(course, speed)  a number,
///   Upper(box)            a number that no Value in the box exceeds,
///   first_guess()         any point of `whole`; a good one saves work.
///
/// Boxes wait in a heap, the one with the greatest upper bound first. A box is halved, and both
/// halves bounded; a small one is evaluated point by point. Boxes that cannot hold a better point
/// than the best one so far are dropped.
///
/// Why the result is exact. Call p better than q where its value is greater, or equal and its
/// (course, speed) comes first; this is a total order. Let b be the best of all points. At each
/// time either b was evaluated, or one waiting box holds it: halving keeps every point, and a box
/// that holds b is dropped only for a best point so far, r, with Upper < Value(r), which Value(b)
/// <= Upper contradicts, or with Upper == Value(r) and r not after the first point of the box: then
/// Value(b) <= Value(r) and r is not after b, so r is b. The search ends with no box waiting, so b
/// was evaluated, and nothing replaces it. The order in which boxes are visited has no effect.
template <class Problem>
auto BestPoint(const Problem& problem, const GridBox& whole) {
  using Number = decltype(problem.Value(0, 0));
  struct Waiting {
    Number upper;
    GridBox box;
  };
  constexpr int kFewPoints = 4;
  constexpr double kRadPerCourse = 0.0175;
  // Of equal bounds first the box with the lowest course: that settles ties early.
  const auto later = [](const Waiting& a, const Waiting& b) {
    return std::tuple(a.upper, -a.box.first_course, -a.box.first_speed) <
           std::tuple(b.upper, -b.box.first_course, -b.box.first_speed);
  };

  GridPoint best = problem.first_guess();
  Number best_value = problem.Value(best.course, best.speed);
  const auto may_hold_a_better_one = [&](Number upper, const GridBox& box) {
    return upper > best_value ||
           (upper == best_value &&
            GridPoint{.course = box.first_course, .speed = box.first_speed} < best);
  };
  std::vector<Waiting> waiting;
  waiting.reserve(512);
  waiting.push_back({.upper = problem.Upper(whole), .box = whole});
  while (!waiting.empty()) {
    std::pop_heap(waiting.begin(), waiting.end(), later);
    const auto [upper, box] = waiting.back();
    waiting.pop_back();
    if (upper < best_value) break;
    if (!may_hold_a_better_one(upper, box)) continue;

    const int num_courses = box.last_course - box.first_course + 1;
    const int num_speeds = box.last_speed - box.first_speed + 1;
    if (num_courses * num_speeds <= kFewPoints) {
      for (int course = box.first_course; course <= box.last_course; ++course) {
        for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
          const GridPoint point{.course = course, .speed = speed};
          const Number value = problem.Value(course, speed);
          if (value > best_value || (value == best_value && point < best)) {
            best = point;
            best_value = value;
          }
        }
      }
      continue;
    }
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
    for (const GridBox& half : {front, back}) {
      const Number half_upper = std::min(upper, problem.Upper(half));
      if (!may_hold_a_better_one(half_upper, half)) continue;
      waiting.push_back({.upper = half_upper, .box = half});
      std::push_heap(waiting.begin(), waiting.end(), later);
    }
  }
  return std::pair(best, best_value);
}

}  // namespace shoal
