#include "lib/vehicle/navigation/beacons.h"

#include <cmath>
#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

BeaconReceiver::BeaconReceiver(const AcousticRanging& ranging, const OwnClock& clock,
                               std::vector<Beacon> beacons, const StreamKey& key,
                               TravelTimes travel_times)
    : ranging_(ranging),
      clock_(clock),
      beacons_(std::move(beacons)),
      travel_times_(std::move(travel_times)),
      last_pings_(beacons_.size()) {
  SHOAL_CHECK(ranging.sound_speed_mps > 0, "sound_speed_mps > 0");
  for (const Beacon& beacon : beacons_) {
    SHOAL_CHECK(beacon.interval_s > 0, "interval_s > 0");
    keys_.push_back(key.With(beacon.name));
  }
}

std::optional<double> BeaconReceiver::RangeTo(const Beacon& beacon,
                                              const Eigen::Vector3d& position_m) const {
  if (!travel_times_) return (beacon.position_m - position_m).norm();
  const std::optional<double> travel_s = travel_times_(beacon.position_m, position_m);
  if (!travel_s) return std::nullopt;
  return *travel_s * ranging_.sound_speed_mps;
}

std::vector<BeaconReading> BeaconReceiver::Read(const Eigen::Vector3d& position_m,
                                                double heading_rad, double time_s) {
  std::vector<BeaconReading> readings;
  for (size_t i = 0; i < beacons_.size(); ++i) {
    const Beacon& beacon = beacons_[i];
    if (beacon.kind == BeaconKind::kPackets) continue;
    const std::optional<double> way_m = RangeTo(beacon, position_m);
    const double range_m = way_m.value_or((beacon.position_m - position_m).norm());
    const double travel_s = range_m / ranging_.sound_speed_mps;
    const double delay_s =
        beacon.kind == BeaconKind::kOneWay ? travel_s : 2 * travel_s + beacon.turnaround_s;
    // The last ping whose sound is here by now.
    const auto number = static_cast<int64_t>(
        std::floor((time_s - delay_s - beacon.offset_s) / beacon.interval_s + 1e-9));
    const bool is_new = last_pings_[i] && number > *last_pings_[i] && number >= 0;
    if (!last_pings_[i] || number > *last_pings_[i]) last_pings_[i] = number;
    if (!is_new || !way_m || range_m > ranging_.max_range_m) continue;
    Stream draws(keys_[i].With(number));
    if (draws.Uniform() < ranging_.dropout) continue;
    readings.push_back(Measure(i, range_m, position_m, heading_rad, time_s, &draws));
  }
  return readings;
}

BeaconReading BeaconReceiver::ReadPacket(size_t beacon, int64_t number,
                                         const Eigen::Vector3d& position_m, double heading_rad,
                                         double time_s) const {
  // Whether it is received is the network's business.
  Stream draws(keys_.at(beacon).With(number));
  const double range_m = RangeTo(beacons_.at(beacon), position_m)
                             .value_or((beacons_.at(beacon).position_m - position_m).norm());
  return Measure(beacon, range_m, position_m, heading_rad, time_s, &draws);
}

BeaconReading BeaconReceiver::Measure(size_t number, double range_m,
                                      const Eigen::Vector3d& position_m, double heading_rad,
                                      double time_s, Stream* draws) const {
  const Beacon& beacon = beacons_[number];
  const UsblReading truth = TrueUsbl(position_m, heading_rad, beacon.position_m);
  BeaconReading reading;
  reading.beacon = number;
  reading.kind = beacon.kind;
  reading.range_m =
      beacon.kind == BeaconKind::kTwoWay
          ? TwoWayRange(range_m, ranging_.sound_speed_mps, beacon.turnaround_s, clock_,
                        ranging_.errors, draws)
          : OneWayRange(range_m, ranging_.sound_speed_mps, clock_, time_s, ranging_.errors, draws);
  if (ranging_.usbl) {
    reading.direction = WithNoise(truth, *ranging_.usbl, draws);
    reading.direction->range_m = reading.range_m;
  }
  return reading;
}

}  // namespace shoal
