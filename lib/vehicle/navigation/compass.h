// A magnetic compass: the heading, its errors, and the deviation that the ship's own iron causes.
#pragma once

#include <cstdint>

#include "lib/base/random/stream.h"

namespace shoal {

/// Coefficients of a compass-adjuster, radians. Deviation is positive where the compass points east
/// of magnetic north: magnetic heading = compass heading + deviation (Bowditch, American Practical
/// Navigator, 2019, chapter 6).
struct DeviationCoefficients {
  double a = 0;  ///< The same on all headings.
  double b = 0;  ///< Times the sine of the heading.
  double c = 0;  ///< Times its cosine.
  double d = 0;  ///< Times the sine of twice the heading.
  double e = 0;  ///< Times the cosine of twice the heading.

  bool operator==(const DeviationCoefficients&) const = default;
};

/// Largest sum |B| + |C| + 2 |D| + 2 |E|, radians: beyond it one heading could have two readings.
inline constexpr double kMaxDeviation = 0.5;

struct Compass {
  double bias_rad = 0;                   ///< Added to every reading, clockwise.
  double bias_sigma_rad = 0;             ///< Spread of biases, and what a filter assumes; >= 0.
  double noise_rad = 0;                  ///< Standard deviation; >= 0.
  DeviationCoefficients deviation = {};  ///< What no table corrects; within kMaxDeviation.
  double rate_hz = 5;                    ///< Readings per second; > 0.
};

/// Returns the deviation of a compass that shows `compass_heading_rad`.
[[nodiscard]] double DeviationAt(const DeviationCoefficients& deviation,
                                 double compass_heading_rad);

/// Returns the root of the mean square of the deviation over all headings.
[[nodiscard]] double DeviationRms(const DeviationCoefficients& deviation);

/// Returns the reading on a true heading, [0, 2 pi). Variation counts as corrected.
/// @pre the deviation is within kMaxDeviation
[[nodiscard]] double ReadCompass(const Compass& compass, double heading_rad, Stream* draws);

}  // namespace shoal
