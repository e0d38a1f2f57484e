// Finds the vehicles that may be near, by the square of the plane that they are in.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace shoal {

class ReachGrid {
 public:
  /// Forgets all, and makes squares of this side. @pre side_m > 0
  void Reset(double side_m);

  /// Puts a vehicle, new or moved, where it is. @pre finite numbers
  void Put(int32_t index, const Eigen::Vector3d& position_m);
  void Remove(int32_t index);

  /// Appends every vehicle whose horizontal range to `center_m` is at most `reach_m`, and some
  /// others, in no particular order.
  void AppendNear(const Eigen::Vector3d& center_m, double reach_m,
                  std::vector<int32_t>* indices) const;

  double side_m() const { return side_m_; }

 private:
  /// A square by its column and row, or kNowhere.
  using Square = uint64_t;
  static constexpr Square kNowhere = ~uint64_t{0};

  int64_t Line(double coordinate_m) const;
  static Square At(int64_t column, int64_t row);

  double side_m_ = 1;
  std::unordered_map<Square, std::vector<int32_t>> squares_;
  std::vector<Square> places_;  ///< By index.
};

}  // namespace shoal
