#include "lib/sea/ocean/perlin_noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace shoal {

namespace {

constexpr double kMaxCoordinate = 1e9;

/// A coordinate's lattice cell and the place in it.
struct Lattice {
  uint32_t cell = 0;  ///< Modulo 256.
  double offset = 0;  ///< [0, 1).
};

Lattice Split(double coordinate) {
  // In this order min() turns NaN into the limit.
  const double bounded = std::max(-kMaxCoordinate, std::min(kMaxCoordinate, coordinate));
  const double cell = std::floor(bounded);
  return {.cell = static_cast<uint32_t>(static_cast<int64_t>(cell) & 255),
          .offset = bounded - cell};
}

double Fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double Interpolate(double a, double b, double weight) { return a + weight * (b - a); }

}  // namespace

PerlinPermutation DrawPermutation(const StreamKey& key) {
  PerlinPermutation permutation;
  std::iota(permutation.begin(), permutation.end(), uint8_t{0});
  Stream stream(key);
  for (size_t i = permutation.size() - 1; i > 0; --i) {
    std::swap(permutation[i], permutation[stream.UniformInt(i + 1)]);
  }
  return permutation;
}

double PerlinNoise(const PerlinPermutation& permutation, double x, double y) {
  const Lattice along_x = Split(x);
  const Lattice along_y = Split(y);
  // The gradient at a corner times the way from that corner: +y, -y, +x or -x.
  const auto corner = [&](uint32_t right, uint32_t up) {
    const uint32_t column = permutation[(along_x.cell + right) & 255];
    const uint32_t hash = permutation[(column + along_y.cell + up) & 255];
    const double way = hash & 2 ? along_x.offset - right : along_y.offset - up;
    return hash & 1 ? -way : way;
  };
  const double right = Fade(along_x.offset);
  return Interpolate(Interpolate(corner(0, 0), corner(1, 0), right),
                     Interpolate(corner(0, 1), corner(1, 1), right), Fade(along_y.offset));
}

double FractalNoise(const PerlinPermutation& permutation, const Octaves& octaves, double x,
                    double y) {
  double sum = 0;
  double amplitude = 1;
  double frequency = 1;
  for (int octave = 0; octave < octaves.count; ++octave) {
    sum += amplitude * PerlinNoise(permutation, x * frequency, y * frequency);
    amplitude *= octaves.persistence;
    frequency *= 2;
  }
  return sum;
}

}  // namespace shoal
