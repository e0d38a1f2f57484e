// Remembers where a sonar saw something, so that a vehicle keeps clear of what it has turned away
// from and does not see any more. For what stands still: whatever moves leaves a trail.
//
//   EchoMemory memory;
//   memory.Take(position_m, echoes, time_s);
//   std::span<const SonarEcho> all = memory.Recall(position_m, time_s, 20);
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "lib/vehicle/guidance/surroundings.h"

namespace shoal {

class EchoMemory {
 public:
  static constexpr double kCell_m = 2;  ///< Of echoes in one cube of this side, the last counts.
  static constexpr size_t kMaxEchoes = 2000;  ///< New places beyond are passed over.

  /// Takes the echoes of a ping that was sent at `position_m`. @pre finite
  void Take(const Eigen::Vector3d& position_m, std::span<const SonarEcho> echoes, double time_s);

  /// Returns the echoes of the last `for_s` as they lie now, in order of their cubes; forgets those
  /// that are older. Valid until the next call. @pre finite, for_s >= 0
  [[nodiscard]] std::span<const SonarEcho> Recall(const Eigen::Vector3d& position_m, double time_s,
                                                  double for_s);

 private:
  struct Place {
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    double time_s = 0;
  };

  std::map<std::array<int64_t, 3>, Place> places_;  ///< By cube.
  std::vector<SonarEcho> echoes_;
};

}  // namespace shoal
