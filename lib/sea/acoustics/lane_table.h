// The lanes of the acoustic network: one for each receiver and channel on which something arrives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "lib/sea/acoustics/air_lane.h"
#include "lib/sea/acoustics/places.h"

namespace shoal {

class LaneTable {
 public:
  /// Returns the index of the lane of a receiver and channel. A lane without packets may be closed
  /// in the next call, where there are many more lanes than `num_in_transit`.
  int32_t FindOrOpen(int32_t receiver, int32_t channel, size_t num_in_transit);

  AirLane& operator[](int32_t lane) { return lanes_[lane]; }
  const AirLane& operator[](int32_t lane) const { return lanes_[lane]; }

  size_t num_places() const { return lanes_.num_places(); }

 private:
  void CloseIdle();

  Places<AirLane> lanes_;
  std::unordered_map<uint64_t, int32_t> lane_of_;  ///< By receiver and channel; idle ones too.
};

}  // namespace shoal
