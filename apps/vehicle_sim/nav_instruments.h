// What a vehicle measures of its own motion: the truth, and Gaussian noise on each number.
#pragma once

#include <cstdint>

#include "lib/base/geodesy/local_frame.h"
#include "lib/base/random/stream.h"
#include "lib/mission/model/mission.h"
#include "shoal/nav_t.hpp"

namespace shoal {

class NavInstruments {
 public:
  NavInstruments(const SensorOptions& options, uint64_t seed, std::string_view vehicle);

  /// Returns what is measured at truth.utime: the same, however often it is asked for. Latitude and
  /// longitude fit the measured x and y; speed and course over ground fit each other. A sea floor
  /// out of the altimeter's range is not known.
  [[nodiscard]] nav_t Measure(const nav_t& truth, const LocalFrame& frame) const;

 private:
  SensorOptions options_;
  StreamKey key_;
};

}  // namespace shoal
