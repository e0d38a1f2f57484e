#include "lib/run/verdict/arrival_watch.h"

#include <fmt/format.h>

#include <cmath>

namespace shoal {

void ArrivalWatch::Look(const Eigen::Vector2d& position_m, double time_s) {
  const bool is_first = std::isinf(distance_m_);
  distance_m_ = (position_m - goal_.point_m).norm();
  if (is_first) was_there_first_ = distance_m_ <= goal_.within_m;
  if (distance_m_ < closest_m_) {
    closest_m_ = distance_m_;
    closest_s_ = time_s;
  }
  if (distance_m_ > goal_.within_m) {
    there_since_s_.reset();
    return;
  }
  if (!first_there_s_) first_there_s_ = time_s;
  if (!there_since_s_) there_since_s_ = time_s;
}

Outcome ArrivalWatch::Find() const {
  if (std::isinf(closest_m_))
    return {.passed = false, .strain = closest_m_, .numbers = "never seen"};

  const std::optional<double>& arrival_s = goal_.stays ? there_since_s_ : first_there_s_;
  if (arrival_s) {
    const double late_s = *arrival_s - goal_.by_s;
    std::string numbers = fmt::format("there {} {:.1f} s{}", goal_.stays ? "from" : "at",
                                      *arrival_s, goal_.stays ? " on" : "");
    if (late_s > 0) numbers += fmt::format(", {} s late", FormatExcess(late_s));
    return {.passed = late_s <= 0, .strain = *arrival_s, .numbers = numbers, .value = arrival_s};
  }
  const double excess_m = (goal_.stays ? distance_m_ : closest_m_) - goal_.within_m;
  return {.passed = false,
          .strain = excess_m,
          .numbers = goal_.stays
                         ? fmt::format("{:.1f} m away at the end, {} m too far (closest: "
                                       "{:.1f} m at {:.1f} s)",
                                       distance_m_, FormatExcess(excess_m), closest_m_, closest_s_)
                         : fmt::format("closest: {:.1f} m at {:.1f} s, {} m too far", closest_m_,
                                       closest_s_, FormatExcess(excess_m))};
}

}  // namespace shoal
