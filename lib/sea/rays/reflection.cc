#include "lib/sea/rays/reflection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/text/numbers.h"

namespace shoal {

namespace {

/// 20 log10(e): decibels of one neper.
constexpr double kNeper_db = 8.685889638065035;

struct Complex {
  double re = 0;
  double im = 0;
};

Complex operator*(Complex a, Complex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// The root with a real part that is not negative.
Complex Root(Complex a) {
  const double size = Hypot(a.re, a.im);
  const double re = std::sqrt(std::max(0.0, (size + a.re) / 2));
  const double im = std::sqrt(std::max(0.0, (size - a.re) / 2));
  return {re, a.im < 0 ? -im : im};
}

Complex Inverse(Complex a) {
  const double square = a.re * a.re + a.im * a.im;
  return {a.re / square, -a.im / square};
}

/// R = (rho2 g1 - rho1 g2) / (rho2 g1 + rho1 g2) with g1 = i k1 sin(grazing) and
/// g2 = sqrt(kx^2 - k2^2); everything divided by k1.
Reflection ReflectAt(const HalfSpace& bottom, double grazing_rad, const Incidence& water) {
  const auto [sine, cosine] = SinCos(grazing_rad);
  // Attenuation in Np/m is dB per wavelength / 8.69 / wavelength; the imaginary part of the complex
  // speed a c^2 / omega then needs no frequency.
  const double ratio = bottom.attenuation_db_per_wavelength / kNeper_db / (2 * std::numbers::pi);
  const Complex speed = {bottom.speed_mps, bottom.speed_mps * ratio};
  const Complex index = Inverse({speed.re / water.speed_mps, speed.im / water.speed_mps});
  const Complex index_squared = index * index;
  const Complex below = Root({cosine * cosine - index_squared.re, -index_squared.im});
  const Complex above = {0, bottom.density * sine};
  const Complex scaled = {water.density * below.re, water.density * below.im};
  const Complex difference = {above.re - scaled.re, above.im - scaled.im};
  const Complex sum = {above.re + scaled.re, above.im + scaled.im};
  // A bottom with the speed of the water, at grazing incidence: no boundary.
  if (sum.re == 0 && sum.im == 0) return {0, 0};
  const Complex result = difference * Inverse(sum);
  return {std::min(1.0, Hypot(result.re, result.im)), Atan2(result.im, result.re)};
}

Reflection ReflectAt(const ReflectionTable& table, double grazing_rad, const Incidence& /*water*/) {
  const double grazing_deg = grazing_rad * 180 / std::numbers::pi;
  const std::vector<ReflectionTable::Row>& rows = table.rows;
  if (rows.empty() || grazing_deg < rows.front().grazing_deg ||
      grazing_deg > rows.back().grazing_deg) {
    return {0, 0};
  }
  const auto next =
      std::ranges::upper_bound(rows, grazing_deg, {}, &ReflectionTable::Row::grazing_deg);
  if (next == rows.end())
    return {rows.back().magnitude, rows.back().phase_deg * std::numbers::pi / 180};
  const ReflectionTable::Row& a = *std::prev(next);
  const double share = (grazing_deg - a.grazing_deg) / (next->grazing_deg - a.grazing_deg);
  return {a.magnitude + share * (next->magnitude - a.magnitude),
          (a.phase_deg + share * (next->phase_deg - a.phase_deg)) * std::numbers::pi / 180};
}

Reflection ReflectAt(const WindySurface& surface, double grazing_rad, const Incidence& water) {
  const double wind_mps = std::max(surface.wind_mps, 6.0);
  double loss_db = 1.26e-3 * Pow(wind_mps, 1.57) * Pow(water.hz / 1000, 0.85);
  if (surface.wind_mps < 6) loss_db *= Exp(1.2 * (surface.wind_mps - 6));
  // At wind 0 the exponential leaves 7e-4 of the loss at 6 m/s; a calm surface has none.
  if (surface.wind_mps <= 0) loss_db = 0;
  const double sine = Sin(grazing_rad);
  const double limit_db = kMaxSurfaceLoss_db * sine;
  loss_db = loss_db >= limit_db ? (loss_db > 0 ? kMaxSurfaceLoss_db : 0) : loss_db / sine;
  return {Pow(10, -loss_db / 20), std::numbers::pi};
}

Reflection ReflectAt(const Vacuum& /*surface*/, double /*grazing_rad*/,
                     const Incidence& /*water*/) {
  return {1, std::numbers::pi};
}

Reflection ReflectAt(const RigidWall& /*wall*/, double /*grazing_rad*/,
                     const Incidence& /*water*/) {
  return {1, 0};
}

}  // namespace

Reflection Reflect(const Reflector& boundary, double grazing_rad, const Incidence& water) {
  return std::visit([&](const auto& kind) { return ReflectAt(kind, grazing_rad, water); },
                    boundary);
}

std::optional<HalfSpace> FindBottomType(std::string_view name) {
  for (const auto& [type, half_space] : kBottomTypes) {
    if (type == name) return half_space;
  }
  return std::nullopt;
}

std::string ProblemOf(const ReflectionTable& table) {
  if (table.rows.empty()) return "a reflection table needs at least one row";
  for (size_t i = 0; i < table.rows.size(); ++i) {
    const ReflectionTable::Row& row = table.rows[i];
    const std::string place = "row " + std::to_string(i + 1) + " of the reflection table: ";
    if (!IsBetween(row.grazing_deg, 0, 90)) return place + "the angle must be between 0 and 90 deg";
    if (!IsBetween(row.magnitude, 0, 1)) return place + "the magnitude must be between 0 and 1";
    if (!IsBetween(row.phase_deg, -3600, 3600)) return place + "the phase must be in degrees";
    if (i > 0 && !(row.grazing_deg > table.rows[i - 1].grazing_deg)) {
      return place + "angles must grow from row to row";
    }
  }
  return "";
}

}  // namespace shoal
