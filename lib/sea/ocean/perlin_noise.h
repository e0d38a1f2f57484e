// Smooth random landscapes: K. Perlin, "Improving noise", SIGGRAPH 2002, in the plane.
#pragma once

#include <array>
#include <cstdint>

#include "lib/base/random/stream.h"

namespace shoal {

/// A permutation of 0 .. 255.
using PerlinPermutation = std::array<uint8_t, 256>;

/// Returns a random permutation, all equally likely (Fisher, Yates).
[[nodiscard]] PerlinPermutation DrawPermutation(const StreamKey& key);

/// Returns noise in [-1, 1] at a point: zero where both coordinates are integers, twice
/// continuously differentiable, repeating every 256. Gradients are the four unit vectors along the
/// axes. Coordinates beyond +-1e9 count as that. NaN counts as 1e9.
[[nodiscard]] double PerlinNoise(const PerlinPermutation& permutation, double x, double y);

/// Octave i has 2^i times the frequency of the first, and persistence^i times its amplitude.
struct Octaves {
  int count = 3;             ///< 1 .. kMaxOctaves.
  double persistence = 0.5;  ///< [0, 1].
};
inline constexpr int kMaxOctaves = 16;

/// Returns the sum of the octaves at a point.
[[nodiscard]] double FractalNoise(const PerlinPermutation& permutation, const Octaves& octaves,
                                  double x, double y);

}  // namespace shoal
