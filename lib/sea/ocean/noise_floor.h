// A synthetic sea floor drawn from a seed: hills and hollows of Perlin noise on a square map.
#pragma once

#include <Eigen/Core>

#include "lib/base/random/stream.h"
#include "lib/sea/ocean/perlin_noise.h"

namespace shoal {

/// How noise n, 0 to 1, becomes a share of the floor's range.
enum class FloorStyle {
  kFlat,     ///< 0.
  kLinear,   ///< n.
  kSigmoid,  ///< 1 / (1 + e^(-10 (n - 1/2))): plateaus with steep slopes between them.
  kShelf,    ///< 2 n^3 below n = 1/2, from there on 1/2 + 2 (n - 1/2)^3: a cliff of 1/4 between.
};

/// Returns that share. MuNet's formulas (golden floor_perlin.json). @pre 0 <= noise <= 1
[[nodiscard]] double FloorShare(FloorStyle style, double noise);

struct NoiseFloorOptions {
  FloorStyle style = FloorStyle::kLinear;
  double z_m = 125;      ///< Least depth.
  double range_m = 10;   ///< How much deeper it gets.
  double size_m = 1000;  ///< The map's side.
  double scale_m = 300;  ///< Wavelength of the first octave; MuNet: 0.3 size.
  Octaves octaves = {};
  Eigen::Vector2d south_west_m = {-500, -500};      ///< The map's corner; x East, y North.
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< Metres deeper per metre East and North,
                                                    ///< counted from the middle of the map.
};

inline constexpr double kMaxFloorDepth_m = 20'000;
inline constexpr double kMaxFloorSize_m = 1e6;
inline constexpr double kMaxFloorSlope = 10;

/// Returns whether a floor can be made of these: finite numbers, depths from 0 to kMaxFloorDepth_m,
/// 1 m <= size <= kMaxFloorSize_m, 1 m <= scale, octaves as stated there, slopes within
/// +-kMaxFloorSlope.
[[nodiscard]] bool IsNoiseFloor(const NoiseFloorOptions& options);

/// What takes raw noise to 0 .. 1.
struct NoiseBounds {
  double min = 0;
  double span = 1;  ///< > 0.
};

/// Small, and copied at no cost: it holds no map, a depth is computed where it is asked for.
class NoiseFloor {
 public:
  /// Draws the noise from `key` and looks through the map for its bounds: on points 1 m apart, at
  /// most 1000 x 1000 of them, so that the depth reaches from z to z + range. Noise between these
  /// points that exceeds the bounds is clipped. @pre IsNoiseFloor(options)
  NoiseFloor(const NoiseFloorOptions& options, const StreamKey& key);
  /// The same with given noise. @pre IsNoiseFloor(options)
  NoiseFloor(const NoiseFloorOptions& options, const PerlinPermutation& permutation);
  /// The same with given bounds. @pre IsNoiseFloor(options)
  NoiseFloor(const NoiseFloorOptions& options, const PerlinPermutation& permutation,
             const NoiseBounds& bounds);

  /// Returns the depth of the floor, >= 0. Off the map it is that of the nearest point of the map's
  /// edge. A NaN coordinate counts as the western or southern edge.
  [[nodiscard]] double DepthAt(const Eigen::Vector2d& position_m) const;

  /// Returns a depth, >= 0, that the floor is nowhere above: the least one that z and the slope
  /// allow.
  [[nodiscard]] double ShallowestDepth() const;

  const NoiseBounds& bounds() const { return bounds_; }

 private:
  NoiseBounds FindBounds() const;
  double RawNoise(double east_m, double north_m) const;

  NoiseFloorOptions options_;
  PerlinPermutation permutation_;
  NoiseBounds bounds_;
};

}  // namespace shoal
