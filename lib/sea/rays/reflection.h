// What a boundary returns of a ray: magnitude and phase by the grazing angle.
//
//   const Reflector sand = HalfSpaceOf("sand");
//   const Reflection reflection = Reflect(sand, grazing_rad, {.speed_mps = 1500, .hz = 25'000});
//
// Phases belong to the time factor exp(+i omega t): a vacuum adds pi, a total reflection between 0
// (at the critical angle) and pi (at grazing incidence).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

/// The water at the place of a reflection.
struct Incidence {
  double speed_mps = 1500;
  double hz = 25'000;
  double density = 1;  ///< Relative to fresh water, as all densities here.
};

struct Reflection {
  double magnitude = 1;  ///< [0, 1]; of a table what the table has.
  double phase_rad = 0;
};

/// The sea surface without waves: magnitude 1, phase pi.
struct Vacuum {
  bool operator==(const Vacuum&) const = default;
};

/// Magnitude 1, phase 0.
struct RigidWall {
  bool operator==(const RigidWall&) const = default;
};

/// A fluid without end: Rayleigh's reflection coefficient. Shear waves are left out, so that rock
/// reflects more than in nature where it is steep.
struct HalfSpace {
  double speed_mps = 1650;
  double density = 1.9;                        ///< > 0.
  double attenuation_db_per_wavelength = 0.8;  ///< Of sound in the bottom; >= 0.

  bool operator==(const HalfSpace&) const = default;
};

/// The bottom types that mission files name.
inline constexpr std::array<std::pair<std::string_view, HalfSpace>, 5> kBottomTypes = {{
    {"sand", {1650, 1.9, 0.8}},
    {"silt", {1575, 1.7, 1.0}},
    {"mud", {1480, 1.4, 0.3}},
    {"gravel", {1800, 2.0, 0.6}},
    {"rock", {2800, 2.4, 0.2}},
}};

/// Magnitude and phase by grazing angle, linear in between. Outside its angles nothing is
/// reflected, as Bellhop has it.
struct ReflectionTable {
  struct Row {
    double grazing_deg = 0;  ///< Grows from row to row.
    double magnitude = 1;
    double phase_deg = 180;

    bool operator==(const Row&) const = default;
  };
  std::vector<Row> rows = {};

  bool operator==(const ReflectionTable&) const = default;
};

/// The surface with waves that the wind raises: phase pi, and in dB the loss
///   1.26e-3 v^1.57 f^0.85 / sin(grazing),  v in m/s, f in kHz,
/// below 6 m/s that of 6 m/s times exp(1.2 (v - 6)), and nowhere more than kMaxSurfaceLoss_db. It
/// is the absorption by bubbles in APL-UW High-Frequency Ocean Environmental Acoustic Models
/// Handbook, TR 9407 (1994), part II, fitted for 10 to 100 kHz. Energy that waves scatter out of
/// the specular direction still arrives within a modem's time spread, and is not taken away.
struct WindySurface {
  double wind_mps = 5;  ///< At 10 m height; >= 0.

  bool operator==(const WindySurface&) const = default;
};
inline constexpr double kMaxSurfaceLoss_db = 15;

using Reflector = std::variant<Vacuum, RigidWall, HalfSpace, ReflectionTable, WindySurface>;

/// Returns what a boundary returns of a ray that meets it at this grazing angle, in [0, pi/2].
[[nodiscard]] Reflection Reflect(const Reflector& boundary, double grazing_rad,
                                 const Incidence& water);

/// Returns the bottom type with this name, or nothing.
[[nodiscard]] std::optional<HalfSpace> FindBottomType(std::string_view name);

/// Returns "" or what is wrong with a table: angles in [0, 90] must grow, magnitudes be in [0, 1].
[[nodiscard]] std::string ProblemOf(const ReflectionTable& table);

}  // namespace shoal
