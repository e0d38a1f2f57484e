// Publishes on VIEW_COMMS_PULSE what was delivered, for viewers.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

/// One delivery.
struct Pulse {
  std::string_view source;
  std::string_view destination;
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  double range_m = 0;
  bool of_message = false;
  std::string_view color;
};

class PulseWriter {
 public:
  /// Fits one datagram, as with fates.
  static constexpr int32_t kMaxPulsesPerMessage = 350;

  explicit PulseWriter(Bus& bus);

  /// Adds one pulse, unless its duration is 0 or its colour `off` or `invisible`; publishes when
  /// the message is full.
  void Add(int64_t utime, const Pulse& pulse, double duration_s);

  /// Publishes what was added since the last message, if anything.
  void Flush(int64_t utime);

 private:
  Bus& bus_;
  const Channel<comms_pulses_t> channel_ = channels::ViewCommsPulse();
  comms_pulses_t message_;  ///< Keeps its strings' memory: only the first num_pulses are meant.
};

/// Returns the colour of a vehicle's reports, by its index: the same for as long as it is there.
[[nodiscard]] std::string_view ReportColor(int32_t index);

}  // namespace shoal
