#include "lib/sea/ocean/noise_floor.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/check/check.h"

namespace shoal {

namespace {

constexpr double kMaxPointsPerSide = 1000;
constexpr double kMaxFloorCorner_m = 1e9;

}  // namespace

double FloorShare(FloorStyle style, double noise) {
  switch (style) {
    case FloorStyle::kFlat:
      return 0;
    case FloorStyle::kLinear:
      return noise;
    case FloorStyle::kSigmoid:
      return 1 / (1 + Exp(-10 * (noise - 0.5)));
    case FloorStyle::kShelf: {
      const double above = noise - 0.5;
      return noise < 0.5 ? 2 * noise * noise * noise : 0.5 + 2 * above * above * above;
    }
  }
  SHOAL_CHECK(false, "the style is one of FloorStyle");
}

bool IsNoiseFloor(const NoiseFloorOptions& options) {
  return IsBetween(options.z_m, 0, kMaxFloorDepth_m) &&
         IsBetween(options.range_m, 0, kMaxFloorDepth_m) &&
         IsBetween(options.size_m, 1, kMaxFloorSize_m) &&
         IsBetween(options.scale_m, 1, kMaxFloorSize_m) &&
         IsBetween(options.octaves.count, 1, kMaxOctaves) &&
         IsBetween(options.octaves.persistence, 0, 1) &&
         IsBetween(options.south_west_m.x(), -kMaxFloorCorner_m, kMaxFloorCorner_m) &&
         IsBetween(options.south_west_m.y(), -kMaxFloorCorner_m, kMaxFloorCorner_m) &&
         IsBetween(options.slope.x(), -kMaxFloorSlope, kMaxFloorSlope) &&
         IsBetween(options.slope.y(), -kMaxFloorSlope, kMaxFloorSlope);
}

NoiseFloor::NoiseFloor(const NoiseFloorOptions& options, const StreamKey& key)
    : NoiseFloor(options, DrawPermutation(key)) {}

NoiseFloor::NoiseFloor(const NoiseFloorOptions& options, const PerlinPermutation& permutation)
    : NoiseFloor(options, permutation, NoiseBounds{}) {
  if (options_.style != FloorStyle::kFlat) bounds_ = FindBounds();
}

NoiseFloor::NoiseFloor(const NoiseFloorOptions& options, const PerlinPermutation& permutation,
                       const NoiseBounds& bounds)
    : options_(options), permutation_(permutation), bounds_(bounds) {
  SHOAL_CHECK(IsNoiseFloor(options), "IsNoiseFloor(options)");
  SHOAL_CHECK(bounds.span > 0, "bounds.span > 0");
}

double NoiseFloor::RawNoise(double east_m, double north_m) const {
  return FractalNoise(permutation_, options_.octaves, east_m / options_.scale_m,
                      north_m / options_.scale_m);
}

NoiseBounds NoiseFloor::FindBounds() const {
  const double step_m = std::max(1.0, options_.size_m / kMaxPointsPerSide);
  const int count = static_cast<int>(std::ceil(options_.size_m / step_m));
  double min = RawNoise(0, 0);
  double max = min;
  for (int column = 0; column < count; ++column) {
    for (int row = 0; row < count; ++row) {
      const double noise = RawNoise(column * step_m, row * step_m);
      min = std::min(min, noise);
      max = std::max(max, noise);
    }
  }
  // A map of one point has no span.
  return {.min = min, .span = max > min ? max - min : 1};
}

double NoiseFloor::DepthAt(const Eigen::Vector2d& position_m) const {
  // In this order max() turns NaN into the edge.
  const auto onto_map = [&](double offset_m) {
    return std::min(options_.size_m, std::max(0.0, offset_m));
  };
  const double east_m = onto_map(position_m.x() - options_.south_west_m.x());
  const double north_m = onto_map(position_m.y() - options_.south_west_m.y());
  double share = 0;
  if (options_.style != FloorStyle::kFlat) {
    const double noise = (RawNoise(east_m, north_m) - bounds_.min) / bounds_.span;
    share = FloorShare(options_.style, std::clamp(noise, 0.0, 1.0));
  }
  const double middle_m = options_.size_m / 2;
  const double deeper_m =
      options_.slope.x() * (east_m - middle_m) + options_.slope.y() * (north_m - middle_m);
  return std::max(0.0, options_.z_m + options_.range_m * share + deeper_m);
}

double NoiseFloor::ShallowestDepth() const {
  const double rise_m = options_.slope.lpNorm<1>() * options_.size_m / 2;
  return std::max(0.0, options_.z_m - rise_m);
}

}  // namespace shoal
