#include "lib/vehicle/navigation/instruments.h"

#include <cmath>
#include <string_view>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"

namespace shoal {

InstrumentOptions Drawn(const InstrumentOptions& options, const StreamKey& key) {
  const auto draw = [&](std::string_view purpose, double sigma, double* value) {
    if (sigma > 0) *value += sigma * Stream(key.With(purpose)).Normal();
  };
  InstrumentOptions drawn = options;
  draw("compass bias", options.compass.bias_sigma_rad, &drawn.compass.bias_rad);
  draw("gyro bias", options.gyro.bias_sigma_radps, &drawn.gyro.bias_radps);
  if (drawn.dvl) draw("dvl scale", options.dvl->scale_sigma, &drawn.dvl->scale_error);
  draw("depth bias", options.depth.bias_sigma_m, &drawn.depth.bias_m);
  draw("clock phase", options.clock.phase_sigma_s, &drawn.clock.phase_s);
  draw("clock drift", options.clock.drift_sigma_ppm, &drawn.clock.drift_ppm);
  return drawn;
}

bool Instruments::Schedule::IsDue(double rate_hz, int64_t utime) {
  const auto period =
      static_cast<int64_t>(std::floor(static_cast<double>(utime) * rate_hz / 1e6 + 1e-9));
  return std::exchange(last_period, period) != period;
}

Instruments::Instruments(const InstrumentOptions& drawn, std::vector<Beacon> beacons,
                         const StreamKey& key, TravelTimes travel_times)
    : options_(drawn),
      compass_key_(key.With("compass")),
      dvl_key_(key.With("dvl")),
      log_key_(key.With("log")),
      depth_key_(key.With("depth")),
      gyro_(drawn.gyro, key.With("gyro")) {
  if (drawn.gps) gps_.emplace(*drawn.gps, key.With("gps"));
  if (drawn.ranging && !beacons.empty()) {
    beacons_.emplace(*drawn.ranging, drawn.clock, std::move(beacons), key.With("beacon"),
                     std::move(travel_times));
  }
}

Readings Instruments::Read(const TrueMotion& truth, int64_t utime, int64_t start_utime,
                           std::span<const ReceivedPacket> packets) {
  Readings readings;
  if (last_utime_) {
    SHOAL_CHECK(utime > *last_utime_, "times increase");
    readings.yaw_rate_radps = gyro_.Read(WrapPi(truth.heading_rad - last_heading_rad_),
                                         Seconds(utime - *last_utime_), utime);
  }
  last_utime_ = utime;
  last_heading_rad_ = truth.heading_rad;
  Stream depth_draws(depth_key_.With(utime));
  readings.depth_m = ReadDepth(options_.depth, truth.position_m.z(), &depth_draws);
  if (compass_due_.IsDue(options_.compass.rate_hz, utime)) {
    Stream draws(compass_key_.With(utime));
    readings.heading_rad = ReadCompass(options_.compass, truth.heading_rad, &draws);
  }
  if (options_.dvl) {
    readings.has_dvl_lock = HasBottomLock(*options_.dvl, truth.altitude_m);
    if (dvl_due_.IsDue(options_.dvl->rate_hz, utime)) {
      Stream draws(dvl_key_.With(utime));
      readings.over_ground_mps =
          ReadDvl(*options_.dvl, truth.over_ground_mps, truth.altitude_m, &draws);
    }
  }
  if (options_.log && log_due_.IsDue(options_.log->rate_hz, utime)) {
    Stream draws(log_key_.With(utime));
    readings.forward_mps = ReadSpeedLog(*options_.log, truth.in_water_mps.x(), &draws);
  }
  if (gps_) {
    gps_->Watch(truth.position_m.z(), utime);
    readings.has_gps_fix = gps_->has_fix();
    if (gps_due_.IsDue(options_.gps->rate_hz, utime)) {
      readings.position_m = gps_->Read(truth.position_m.head<2>(), utime);
    }
  }
  if (beacons_) {
    const double time_s = Seconds(utime - start_utime);
    readings.beacons = beacons_->Read(truth.position_m, truth.heading_rad, time_s);
    for (const ReceivedPacket& packet : packets) {
      readings.beacons.push_back(beacons_->ReadPacket(packet.beacon, packet.number,
                                                      truth.position_m, truth.heading_rad, time_s));
    }
  }
  return readings;
}

}  // namespace shoal
