#include "apps/helm/sonar_echoes.h"

#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/attitude.h"

namespace shoal {

std::vector<SonarEcho> EchoesOf(const sonar_t& ping, const nav_t& own) {
  std::vector<SonarEcho> echoes;
  const double age_s = (static_cast<double>(own.utime) - static_cast<double>(ping.utime)) / 1e6;
  if (std::abs(age_s) > kSonarMemory_s || !std::isfinite(own.roll_deg)) return echoes;
  const Eigen::Matrix3d rotation = BodyToWorld(-DegToRad(own.roll_deg), DegToRad(own.pitch_deg),
                                               PsiFromHeading(DegToRad(own.heading_deg)));
  for (const sonar_beam_t& beam : ping.beams) {
    const auto azimuth = SinCos(-DegToRad(beam.azimuth_deg));
    const auto elevation = SinCos(DegToRad(beam.elevation_deg));
    const Eigen::Vector3d in_body(azimuth.cosine * elevation.cosine,
                                  azimuth.sine * elevation.cosine, -elevation.sine);
    const bool is_echo = beam.range_m >= 0 && std::isfinite(beam.range_m);
    if (!is_echo || !in_body.allFinite()) continue;
    echoes.push_back({.direction = rotation * in_body, .range_m = beam.range_m});
  }
  return echoes;
}

}  // namespace shoal
