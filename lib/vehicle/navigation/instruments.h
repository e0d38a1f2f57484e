// Everything that a vehicle navigates with, read together once per step.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/vehicle/navigation/beacons.h"
#include "lib/vehicle/navigation/compass.h"
#include "lib/vehicle/navigation/gps.h"
#include "lib/vehicle/navigation/gyro.h"
#include "lib/vehicle/navigation/ranging.h"
#include "lib/vehicle/navigation/velocity_sensors.h"

namespace shoal {

struct InstrumentOptions {
  Compass compass;
  Gyro gyro;
  std::optional<Dvl> dvl;
  std::optional<SpeedLog> log;
  DepthSensor depth;
  std::optional<Gps> gps;
  OwnClock clock;
  std::optional<AcousticRanging> ranging;
};

/// Returns `options` with what spreads from vehicle to vehicle (biases, scale error, clock) drawn
/// once, each from a stream of its own.
[[nodiscard]] InstrumentOptions Drawn(const InstrumentOptions& options, const StreamKey& key);

/// The truth about a vehicle that its instruments see. Velocities are in the horizontal plane,
/// forward and starboard: pitch and roll count as known.
struct TrueMotion {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  double heading_rad = 0;                                ///< Clockwise from North.
  Eigen::Vector2d over_ground_mps = Eigen::Vector2d::Zero();
  Eigen::Vector2d in_water_mps = Eigen::Vector2d::Zero();  ///< Relative to the water.
  std::optional<double> altitude_m;                        ///< Absent: not known.
};

/// A packet that the acoustic network has delivered since the last step.
struct ReceivedPacket {
  size_t beacon = 0;  ///< Which beacon sent it; of the kind kPackets.
  int64_t number = 0;
};

/// Readings of one step. What is absent was not due, out of reach or lost.
struct Readings {
  double yaw_rate_radps = 0;  ///< Mean since the last step, clockwise.
  double depth_m = 0;
  std::optional<double> heading_rad;
  std::optional<Eigen::Vector2d> over_ground_mps;  ///< Forward, starboard.
  std::optional<double> forward_mps;               ///< Relative to the water.
  std::optional<Eigen::Vector2d> position_m;       ///< By GPS.
  std::vector<BeaconReading> beacons;
  bool has_dvl_lock = false;
  bool has_gps_fix = false;
};

class Instruments {
 public:
  /// Draws depend on `key`, the instrument and the time, so that one instrument's options do not
  /// change what others read.
  /// `travel_times`: of the sound of beacons; without it sound goes straight (BeaconReceiver).
  Instruments(const InstrumentOptions& drawn, std::vector<Beacon> beacons, const StreamKey& key,
              TravelTimes travel_times = {});

  /// Returns what is read at `utime`; `start_utime` is the mission's. The first call sets the
  /// schedule; from then on each call is one step. @pre times increase
  [[nodiscard]] Readings Read(const TrueMotion& truth, int64_t utime, int64_t start_utime,
                              std::span<const ReceivedPacket> packets = {});

  const InstrumentOptions& options() const { return options_; }
  const GyroUnit& gyro() const { return gyro_; }

 private:
  /// One instrument's schedule: due once in each period since the mission's clock began.
  struct Schedule {
    std::optional<int64_t> last_period;
    bool IsDue(double rate_hz, int64_t utime);
  };

  InstrumentOptions options_;
  StreamKey compass_key_;
  StreamKey dvl_key_;
  StreamKey log_key_;
  StreamKey depth_key_;
  GyroUnit gyro_;
  std::optional<GpsUnit> gps_;
  std::optional<BeaconReceiver> beacons_;
  Schedule compass_due_;
  Schedule dvl_due_;
  Schedule log_due_;
  Schedule gps_due_;
  std::optional<int64_t> last_utime_;
  double last_heading_rad_ = 0;
};

}  // namespace shoal
