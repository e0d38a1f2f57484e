// How far a vessel has come on a list of points that it passes in order, round after round: tasks
// and behaviors count alike.
//
//   RouteRounds rounds(points_m.size());
//   if (reached) goes_on = rounds.Pass(num_laps);
//   to_m = points_m[rounds.index()];
#pragma once

#include <algorithm>
#include <cstddef>

namespace shoal {

class RouteRounds {
 public:
  /// Steers for the point `first`. @pre first < num_points
  explicit RouteRounds(size_t num_points = 1, size_t first = 0)
      : num_points_(num_points), index_(first) {}

  /// Returns the point that is steered for.
  size_t index() const { return index_; }
  /// Returns how many points were reached, in all rounds.
  int num_reached() const { return num_reached_; }
  /// Returns how often the last point of the list was reached.
  int num_rounds() const { return num_rounds_; }

  /// True where the last point of the list is steered for.
  bool IsLast() const { return index_ + 1 == num_points_; }
  /// True where that is the end of `most_rounds` rounds. 0: they never end.
  bool IsEnd(int most_rounds) const {
    return IsLast() && most_rounds > 0 && num_rounds_ + 1 >= most_rounds;
  }

  /// The point is reached: goes on with the next, after the last with the first. Stays at the end
  /// of `most_rounds` rounds and returns false; 0: they never end.
  bool Pass(int most_rounds = 0);

  /// Goes on with another list: what was reached stays counted, and the same point is steered for,
  /// or the last one where there are fewer. @pre num_points > 0
  void ChangeNumber(size_t num_points) {
    num_points_ = num_points;
    index_ = std::min(index_, num_points - 1);
  }

  /// Steers for another point. @pre index < num_points
  void GoTo(size_t index) { index_ = index; }

 private:
  size_t num_points_;
  size_t index_;
  int num_reached_ = 0;
  int num_rounds_ = 0;
};

}  // namespace shoal
