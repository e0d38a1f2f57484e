// On which side of 0 the numbers of a map stand: whether they can be what they are taken for. A map
// of depths that is read as elevations is land everywhere.
#pragma once

#include <cstddef>

namespace shoal {

struct FloorSigns {
  size_t num_negative = 0;
  size_t num_zero = 0;
  size_t num_positive = 0;

  /// Counts a number as it stands in the file. @pre it is not NaN
  void Count(double number) {
    ++(number < 0 ? num_negative : number > 0 ? num_positive : num_zero);
  }
  size_t num() const { return num_negative + num_zero + num_positive; }
  /// Returns how many points lie below the surface, where the numbers are depths or elevations.
  size_t NumBelow(bool are_depths) const { return are_depths ? num_positive : num_negative; }
  /// Less than one point in a hundred does. A map of the sea that has so little of it is mostly one
  /// whose signs are the other way round, with a few wrong points.
  bool IsHardlyBelow(bool are_depths) const { return NumBelow(are_depths) * 100 < num(); }
};

}  // namespace shoal
