// Publishes on VIEW_COMMS_PULSE what was delivered, for viewers, as columns
// (lcmtypes/shoal_comms_pulse_columns_t.lcm).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

/// One delivery.
struct Pulse {
  std::string_view source;
  std::string_view destination;
  int32_t contact =
      -1;  ///< The broker's number of the destination, where it is at hand: for speed.
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  double range_m = 0;
  bool of_message = false;
  std::string_view color;
};

class PulseWriter {
 public:
  /// A message fits one datagram, even as the list that readers make of it: 115 bytes a pulse.
  static constexpr int32_t kMaxPulsesPerMessage = 350;

  explicit PulseWriter(Bus& bus);

  /// Adds one pulse, unless its duration is 0 or its colour `off` or `invisible`; publishes when
  /// the message is full.
  void Add(int64_t utime, const Pulse& pulse, double duration_s);

  /// Publishes what was added since the last message, if anything.
  void Flush(int64_t utime);

 private:
  bool IsEnd(size_t index, std::string_view vehicle, const Eigen::Vector3d& place_m) const;
  /// Returns which of the message's ends it is; adds it where it is not there.
  size_t EndOf(std::string_view vehicle, const Eigen::Vector3d& place_m);
  size_t DestinationOf(const Pulse& pulse);
  int16_t StyleOf(const Pulse& pulse, double duration_s);

  Bus& bus_;
  const Channel<comms_pulse_columns_t> channel_ = channels::ViewCommsPulseColumns();
  comms_pulse_columns_t message_;

  // Of message_.
  std::vector<std::string> names_;  ///< Of its ends, as they were given.
  /// A vehicle has several ends where it was met at several places.
  std::map<std::string, std::vector<size_t>, std::less<>> ends_of_name_;
  size_t source_ = 0;                   ///< The end that was the last source.
  size_t style_ = 0;                    ///< Likewise, of its styles.
  std::vector<size_t> end_of_contact_;  ///< The last that a contact had; it may be another's now.
};

/// Returns the colour of a vehicle's reports, by its index: the same for as long as it is there.
[[nodiscard]] std::string_view ReportColor(int32_t index);

}  // namespace shoal
