// Sees the sea floor, other vehicles and obstacles ahead: a fan of beams, fixed to the hull.
//
//   ForwardLookingSonar sonar(params);
//   std::vector<SonarBeam> beams(sonar.beam_count());
//   sonar.Ping(pose, {.floor = floor, .vehicles = others, .walls_m = polygons}, number, beams);
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/convex_polygon.h"
#include "lib/sea/ocean/sea_floor.h"
#include "lib/vehicle/sensors/measurement_noise.h"

namespace shoal {

/// The defaults are MuNet's, after a BlueView ProViewer 450-15. An even number of beams has none in
/// the middle.
struct SonarParams {
  int azimuth_beams = 11;   ///< 1 .. kMaxSonarBeams; one: straight ahead.
  int elevation_beams = 5;  ///< 1 .. kMaxSonarBeams; one: at the tilt.
  double max_range_m = 135;
  int range_steps = 27;               ///< 1 .. kMaxRangeSteps: the floor is seen in such steps.
  double tilt_rad = DegToRad(2.5);    ///< Of the fan's middle, below the hull's axis.
  double width_rad = DegToRad(50);    ///< From the outermost beam on one side to the other.
  double height_rad = DegToRad(15);   ///< From the highest to the lowest.
  double rate_hz = 10;                ///< How often whoever owns the sonar should ping.
  MeasurementNoise range_noise = {};  ///< Metres; of what is seen.
};

inline constexpr int kMaxSonarBeams = 256;
inline constexpr int kMaxRangeSteps = 10'000;

/// Returns whether these are valid: finite numbers, counts as stated there, 0 < max_range
/// <= 1e5, angles within +-pi, width and height >= 0, 0 < rate, sigma >= 0.
[[nodiscard]] bool IsSonar(const SonarParams& params);

struct SonarPose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  double phi_rad = 0;
  double theta_rad = 0;
  double psi_rad = 0;
};

/// Another vehicle, as the sonar sees it: a sphere.
struct SonarTarget {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double radius_m = 1.6;  ///< >= 0; MuNet: the vehicle's length.
};

/// What there is to be seen. Spans and floor must outlive the call.
struct SonarScene {
  const SeaFloor& floor;
  std::span<const SonarTarget> vehicles = {};  ///< Without the one that carries the sonar.
  std::span<const Polygon> walls_m =
      {};  ///< Of obstacles that reach from the surface to the floor.
};

struct SonarBeam {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< Unit vector, world axes.
  double range_m = 0;  ///< To the nearest of what it sees; max_range_m where it sees nothing.
  bool is_echo = false;
};

class ForwardLookingSonar {
 public:
  /// @pre IsSonar(params)
  explicit ForwardLookingSonar(const SonarParams& params);

  size_t beam_count() const { return beams_.size(); }
  const SonarParams& params() const { return params_; }

  /// Fills `beams`, sorted by azimuth from -psi to +psi and then by elevation from above to below.
  /// The floor is seen at the first range step that lies on or below it, so its range is a multiple
  /// of max_range / range_steps, at most one step too far. A target is seen where the beam enters
  /// its sphere; from inside, by every beam, at range 0. MuNet's geometry (golden
  /// forward_looking_sonar.json). A wall is seen where the beam meets it; from inside at range 0.
  /// @pre finite pose and scene, convex walls, beams.size() == beam_count()
  void Ping(const SonarPose& pose, const SonarScene& scene, int64_t number,
            std::span<SonarBeam> beams) const;

 private:
  SonarParams params_;
  std::vector<Eigen::Vector3d> beams_;  ///< Unit vectors, body axes.
};

}  // namespace shoal
