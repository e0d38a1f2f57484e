// What a [[vehicle]] measures with: [vehicle.sensors] and [vehicle.sonar].
#include "lib/mission/file/describe.h"
#include "lib/vehicle/sensors/forward_looking_sonar.h"

namespace shoal {
namespace {

void Describe(Fields& fields, SensorOptions& sensors) {
  sensors.is_fitted = true;
  fields.Number("position_noise_m", sensors.position_noise_m, Between(0, 10'000));
  fields.Number("depth_noise_m", sensors.depth_noise_m, Between(0, 1000));
  fields.Number("attitude_noise_deg", sensors.attitude_noise_deg, Between(0, 90));
  fields.Number("rate_noise_degps", sensors.rate_noise_degps, Between(0, 90));
  fields.Number("speed_noise_mps", sensors.speed_noise_mps, Between(0, kFastest_mps));
  fields.Number("altitude_noise_m", sensors.altitude_noise_m, Between(0, 1000));
  fields.Number("altimeter_range_m", sensors.altimeter_range_m, Above(0, 20'000));
}

void Describe(Fields& fields, SonarOptions& sonar) {
  sonar.is_fitted = true;
  fields.SmallInteger("azimuth_beams", sonar.azimuth_beams, 1, kMaxSonarBeams);
  fields.SmallInteger("elevation_beams", sonar.elevation_beams, 1, kMaxSonarBeams);
  fields.Number("max_range_m", sonar.max_range_m, Above(0, 10'000));
  fields.SmallInteger("range_steps", sonar.range_steps, 1, 1000);
  fields.Number("tilt_deg", sonar.tilt_deg, Between(-90, 90));
  fields.Number("width_deg", sonar.width_deg, Between(0, 180));
  fields.Number("height_deg", sonar.height_deg, Between(0, 180));
  fields.Number("rate_hz", sonar.rate_hz, Above(0, 1000));
  fields.Number("noise_m", sonar.noise_m, Between(0, 1000));
}

}  // namespace

void DescribeInstruments(Fields& fields, Vehicle& vehicle) {
  if (fields.Has("sensors", vehicle.sensors.is_fitted)) {
    fields.Below("sensors", [&](Fields& table) { Describe(table, vehicle.sensors); });
  }
  if (fields.Has("sonar", vehicle.sonar.is_fitted)) {
    fields.Below("sonar", [&](Fields& table) { Describe(table, vehicle.sonar); });
  }
}

}  // namespace shoal
