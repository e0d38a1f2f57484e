// What a vehicle with [vehicle.navigation] knows of its motion: its instruments and its filter.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/geodesy/local_frame.h"
#include "lib/mission/model/mission.h"
#include "lib/vehicle/navigation/instruments.h"
#include "lib/vehicle/navigation/navigator.h"
#include "shoal/acoustic_rx_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/navigation_t.hpp"

namespace shoal {

class NavigationUnit {
 public:
  NavigationUnit(const Mission& mission, const Vehicle& vehicle);

  /// Starts again at a pose: instruments switched on, the filter at what it knows of a start.
  void Start(const StartPose& pose);
  /// Takes note of a packet: a range, where its sender is a beacon.
  void TakePacket(const acoustic_rx_t& packet);
  /// True where packets can be ranges.
  bool takes_packets() const { return takes_packets_; }

  /// Goes on to the next step and returns what is known at truth.utime. Roll, pitch and their
  /// rates, heave, descent and altitude are the truth.
  [[nodiscard]] nav_t Estimate(const nav_t& truth, const Eigen::Vector2d& current_mps,
                               const LocalFrame& frame);
  /// Returns the message of NAVIGATION where it is due; to be called after each Estimate.
  [[nodiscard]] std::optional<navigation_t> Report(int64_t utime);

  /// Returns lines of a status page, four blanks before each.
  [[nodiscard]] std::string StatusText() const;

 private:
  void Count();

  const InstrumentOptions assumed_;
  const InstrumentOptions drawn_;
  const StreamKey key_;
  const std::vector<BeaconOptions> beacon_options_;
  const std::vector<Beacon> beacons_;  ///< Where they are.
  const double report_every_s_;
  const int64_t start_utime_;
  bool takes_packets_ = false;
  TravelTimes travel_times_;
  Instruments instruments_;
  Navigator navigator_;
  std::vector<ReceivedPacket> packets_;  ///< Since the last step.
  std::optional<int64_t> utime_;         ///< Of the last step.
  std::optional<int64_t> last_report_;   ///< Counted in periods.
  navigation_t report_{};                ///< Counters, and ranges since the last message.
};

}  // namespace shoal
