// Beacons at known places, and what a vehicle measures of them: long baseline ranges, and
// directions where it carries an ultra-short baseline array.
//
// A one-way beacon sends at set times by the right time; a two-way beacon answers questions, which
// the vehicle asks at set times. A reading is there in the step in which the sound arrives, and is
// that of the vehicle's place at that moment. Packets that a network carries are ranges, too, where
// they come from a beacon of the kind kPackets.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/vehicle/navigation/ranging.h"

namespace shoal {

enum class BeaconKind {
  kOneWay,
  kTwoWay,
  kPackets,  ///< One-way by the packets that it sends anyway.
};

struct Beacon {
  std::string name;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  double position_sigma_m = 0;                           ///< How well x and y are known; >= 0.
  BeaconKind kind = BeaconKind::kTwoWay;
  double interval_s = 10;     ///< Between pings, or questions; > 0.
  double offset_s = 0;        ///< Of the first; >= 0.
  double turnaround_s = 0.1;  ///< Of a two-way beacon, from question to answer; >= 0.

  bool operator==(const Beacon&) const = default;
};

/// What a vehicle has to take ranges with.
struct AcousticRanging {
  double max_range_m = 2000;      ///< Beacons farther away are not received; > 0.
  double sound_speed_mps = 1500;  ///< Of the water, and of the vehicle's reckoning; > 0.
  double dropout = 0;             ///< Probability that a ping is not received; 0 .. 1.
  RangeErrors errors = {};
  std::optional<UsblErrors> usbl = {};  ///< Absent: it measures no directions.
};

struct BeaconReading {
  size_t beacon = 0;  ///< Which of them.
  BeaconKind kind = BeaconKind::kTwoWay;
  double range_m = 0;
  std::optional<UsblReading> direction;  ///< Its range is range_m.
};

/// Returns how long sound takes from one place to another, s, by its first arrival; nothing where
/// it does not come.
using TravelTimes = std::function<std::optional<double>(const Eigen::Vector3d& from_m,
                                                        const Eigen::Vector3d& to_m)>;

class BeaconReceiver {
 public:
  /// Draws depend on the name of a beacon and the number of its ping. Ranges are travel times
  /// multiplied with AcousticRanging::sound_speed_mps, as instruments have them; without
  /// `travel_times` sound goes straight at that speed, and ranges have no error by the sea.
  /// @pre as stated there
  BeaconReceiver(const AcousticRanging& ranging, const OwnClock& clock, std::vector<Beacon> beacons,
                 const StreamKey& key, TravelTimes travel_times = {});

  /// Returns what arrived since the last call; nothing at the first. Times are since the mission's
  /// start, and grow. The vehicle is at `position_m`, z down.
  [[nodiscard]] std::vector<BeaconReading> Read(const Eigen::Vector3d& position_m,
                                                double heading_rad, double time_s);

  /// Returns the range by packet `number` of a beacon of the kind kPackets, which is received now.
  [[nodiscard]] BeaconReading ReadPacket(size_t beacon, int64_t number,
                                         const Eigen::Vector3d& position_m, double heading_rad,
                                         double time_s) const;

 private:
  /// The way to a beacon as instruments measure it; nothing where no sound comes.
  std::optional<double> RangeTo(const Beacon& beacon, const Eigen::Vector3d& position_m) const;
  BeaconReading Measure(size_t number, double range_m, const Eigen::Vector3d& position_m,
                        double heading_rad, double time_s, Stream* draws) const;

  AcousticRanging ranging_;
  OwnClock clock_;
  std::vector<Beacon> beacons_;
  std::vector<StreamKey> keys_;
  TravelTimes travel_times_;
  std::vector<std::optional<int64_t>> last_pings_;  ///< Numbers, of each beacon.
};

}  // namespace shoal
