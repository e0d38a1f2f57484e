#include "lib/vehicle/navigation/beacons.h"

#include <cmath>
#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

BeaconReceiver::BeaconReceiver(const AcousticRanging& ranging, const OwnClock& clock,
                               std::vector<Beacon> beacons, const StreamKey& key)
    : ranging_(ranging), clock_(clock), beacons_(std::move(beacons)), last_pings_(beacons_.size()) {
  SHOAL_CHECK(ranging.sound_speed_mps > 0, "sound_speed_mps > 0");
  for (const Beacon& beacon : beacons_) {
    SHOAL_CHECK(beacon.interval_s > 0, "interval_s > 0");
    keys_.push_back(key.With(beacon.name));
  }
}

std::vector<BeaconReading> BeaconReceiver::Read(const Eigen::Vector3d& position_m,
                                                double heading_rad, double time_s) {
  std::vector<BeaconReading> readings;
  for (size_t i = 0; i < beacons_.size(); ++i) {
    const Beacon& beacon = beacons_[i];
    if (beacon.kind == BeaconKind::kPackets) continue;
    const double range_m = (beacon.position_m - position_m).norm();
    const double travel_s = range_m / ranging_.sound_speed_mps;
    const double delay_s =
        beacon.kind == BeaconKind::kOneWay ? travel_s : 2 * travel_s + beacon.turnaround_s;
    // The last ping whose sound is here by now.
    const auto number = static_cast<int64_t>(
        std::floor((time_s - delay_s - beacon.offset_s) / beacon.interval_s + 1e-9));
    const bool is_new = last_pings_[i] && number > *last_pings_[i] && number >= 0;
    if (!last_pings_[i] || number > *last_pings_[i]) last_pings_[i] = number;
    if (!is_new || range_m > ranging_.max_range_m) continue;
    Stream draws(keys_[i].With(number));
    if (draws.Uniform() < ranging_.dropout) continue;
    readings.push_back(Measure(i, position_m, heading_rad, time_s, &draws));
  }
  return readings;
}

BeaconReading BeaconReceiver::ReadPacket(size_t beacon, int64_t number,
                                         const Eigen::Vector3d& position_m, double heading_rad,
                                         double time_s) const {
  // Whether it is received is the network's business.
  Stream draws(keys_.at(beacon).With(number));
  return Measure(beacon, position_m, heading_rad, time_s, &draws);
}

BeaconReading BeaconReceiver::Measure(size_t number, const Eigen::Vector3d& position_m,
                                      double heading_rad, double time_s, Stream* draws) const {
  const Beacon& beacon = beacons_[number];
  const UsblReading truth = TrueUsbl(position_m, heading_rad, beacon.position_m);
  BeaconReading reading;
  reading.beacon = number;
  reading.kind = beacon.kind;
  reading.range_m = beacon.kind == BeaconKind::kTwoWay
                        ? TwoWayRange(truth.range_m, ranging_.sound_speed_mps, beacon.turnaround_s,
                                      clock_, ranging_.errors, draws)
                        : OneWayRange(truth.range_m, ranging_.sound_speed_mps, clock_, time_s,
                                      ranging_.errors, draws);
  if (ranging_.usbl) {
    reading.direction = WithNoise(truth, *ranging_.usbl, draws);
    reading.direction->range_m = reading.range_m;
  }
  return reading;
}

}  // namespace shoal
