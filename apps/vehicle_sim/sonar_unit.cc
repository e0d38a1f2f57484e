#include "apps/vehicle_sim/sonar_unit.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

SonarParams ParamsOf(const SonarOptions& options, uint64_t seed, std::string_view vehicle) {
  const SonarParams params = {
      .azimuth_beams = options.azimuth_beams,
      .elevation_beams = options.elevation_beams,
      .max_range_m = options.max_range_m,
      .range_steps = options.range_steps,
      .tilt_rad = DegToRad(options.tilt_deg),
      .width_rad = DegToRad(options.width_deg),
      .height_rad = DegToRad(options.height_deg),
      .rate_hz = options.rate_hz,
      .range_noise = {.sigma = options.noise_m, .key = StreamKey(seed, "sonar").With(vehicle)}};
  SHOAL_CHECK(IsSonar(params), "the mission file was checked");
  return params;
}

SonarPose PoseOf(const nav_t& nav) {
  return {.position_m = {nav.x_m, nav.y_m, nav.z_m},
          .phi_rad = -DegToRad(nav.roll_deg),
          .theta_rad = DegToRad(nav.pitch_deg),
          .psi_rad = PsiFromHeading(DegToRad(nav.heading_deg))};
}

}  // namespace

SonarUnit::SonarUnit(const SonarOptions& options, uint64_t seed, std::string_view vehicle)
    : sonar_(ParamsOf(options, seed, vehicle)),
      level_(sonar_.beam_count()),
      beams_(sonar_.beam_count()) {
  const SeaFloor deep;
  sonar_.Ping({}, {.floor = deep}, 0, level_);
}

std::optional<sonar_t> SonarUnit::Ping(const nav_t& nav, const SonarScene& scene) {
  // Counted in periods since the mission's clock began, so that a restarted process keeps time.
  const auto period = static_cast<int64_t>(
      std::floor(static_cast<double>(nav.utime) * sonar_.params().rate_hz / 1e6 + 1e-9));
  if (last_ping_ == period) return std::nullopt;
  last_ping_ = period;
  sonar_.Ping(PoseOf(nav), scene, nav.utime, beams_);
  sonar_t ping{};
  ping.utime = nav.utime;
  ping.max_range_m = sonar_.params().max_range_m;
  // The guidance frame counts azimuths to port, and so does the fan; SONAR counts to starboard.
  const auto num_elevations = static_cast<size_t>(sonar_.params().elevation_beams);
  const size_t num_azimuths = beams_.size() / num_elevations;
  for (size_t k = 0; k < beams_.size(); ++k) {
    const size_t i = (num_azimuths - 1 - k / num_elevations) * num_elevations + k % num_elevations;
    const Eigen::Vector3d& ahead = level_[i].direction;
    sonar_beam_t beam{};
    beam.azimuth_deg = -RadToDeg(Atan2(ahead.y(), ahead.x()));
    beam.elevation_deg = RadToDeg(Asin(std::clamp(-ahead.z(), -1.0, 1.0)));
    beam.range_m = beams_[i].is_echo ? beams_[i].range_m : -1;
    ping.beams.push_back(beam);
  }
  ping.num_beams = static_cast<int32_t>(ping.beams.size());
  return ping;
}

}  // namespace shoal
