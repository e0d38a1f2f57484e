// Finds where vehicles run aground, each time once.
//
//   GroundingWatch watch(2);
//   if (watch.Look(0, floor_m - depth_m - draught_m)) ...   // vehicle 0 has just run aground
#pragma once

#include <cstddef>
#include <vector>

namespace shoal {

class GroundingWatch {
 public:
  /// A vehicle is afloat again with more than this under its keel.
  static constexpr double kFreed_m = 0.5;

  /// Vehicles are numbers below `num_vehicles`.
  explicit GroundingWatch(size_t num_vehicles) : is_aground_(num_vehicles) {}

  /// Takes the water between a vehicle's keel and the floor, metres; 0 or less: it is aground.
  /// Returns true where it was not before.
  bool Look(size_t vehicle, double clearance_m);

 private:
  std::vector<bool> is_aground_;
};

}  // namespace shoal
