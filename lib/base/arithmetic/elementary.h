// The elementary functions: sin, exp, pow and their kin, with the same bits on every processor.
//
//   const double distance_m = Hypot(east_m, north_m);
//   const auto [sine, cosine] = SinCos(heading_rad);
//
// libm chooses among several implementations by what the processor can do, and its releases differ;
// a log would depend on both. These are musl's (vendor/README.md): additions, multiplications,
// divisions and roots, which IEEE 754 rounds in one way only. Domains, poles, infinities and signed
// zeros are those of the C standard. Errors are below 1 unit in the last place (Atan2 1.3, Erfc 2.1
// on the arguments of elementary_test.cc). Sign and payload of a NaN are the processor's.
//
// What IEEE 754 rounds exactly stays in std: sqrt, abs, floor, round, fmod, remainder, ldexp.
// tests/libm_imports finds a program of shoal that takes any other from libm.
#pragma once

namespace shoal {

namespace musl {

extern "C" {
[[gnu::const]] double shoal_sin(double x);
[[gnu::const]] double shoal_cos(double x);
void shoal_sincos(double x, double* sine, double* cosine);
[[gnu::const]] double shoal_tan(double x);
[[gnu::const]] double shoal_asin(double x);
[[gnu::const]] double shoal_acos(double x);
[[gnu::const]] double shoal_atan(double x);
[[gnu::const]] double shoal_atan2(double y, double x);
[[gnu::const]] double shoal_exp(double x);
[[gnu::const]] double shoal_expm1(double x);
[[gnu::const]] double shoal_log(double x);
[[gnu::const]] double shoal_log1p(double x);
[[gnu::const]] double shoal_log10(double x);
[[gnu::const]] double shoal_log2(double x);
[[gnu::const]] double shoal_pow(double base, double exponent);
[[gnu::const]] double shoal_hypot(double x, double y);
[[gnu::const]] double shoal_erfc(double x);
double shoal_lgamma_r(double x, int* sign);
}

}  // namespace musl

struct SineAndCosine {
  double sine = 0;
  double cosine = 0;
};

/// Angles are radians.
[[nodiscard]] inline double Sin(double x) { return musl::shoal_sin(x); }
[[nodiscard]] inline double Cos(double x) { return musl::shoal_cos(x); }
/// Returns the bits of Sin and Cos, for little more than one of them.
[[nodiscard]] inline SineAndCosine SinCos(double x) {
  SineAndCosine both;
  musl::shoal_sincos(x, &both.sine, &both.cosine);
  return both;
}
[[nodiscard]] inline double Tan(double x) { return musl::shoal_tan(x); }
[[nodiscard]] inline double Asin(double x) { return musl::shoal_asin(x); }
[[nodiscard]] inline double Acos(double x) { return musl::shoal_acos(x); }
[[nodiscard]] inline double Atan(double x) { return musl::shoal_atan(x); }
[[nodiscard]] inline double Atan2(double y, double x) { return musl::shoal_atan2(y, x); }

[[nodiscard]] inline double Exp(double x) { return musl::shoal_exp(x); }
[[nodiscard]] inline double Expm1(double x) { return musl::shoal_expm1(x); }
[[nodiscard]] inline double Log(double x) { return musl::shoal_log(x); }
[[nodiscard]] inline double Log1p(double x) { return musl::shoal_log1p(x); }
[[nodiscard]] inline double Log10(double x) { return musl::shoal_log10(x); }
[[nodiscard]] inline double Log2(double x) { return musl::shoal_log2(x); }
/// A square is x * x: cheaper, and rounded once.
[[nodiscard]] inline double Pow(double base, double exponent) {
  return musl::shoal_pow(base, exponent);
}

/// Returns the root of x^2 + y^2, without overflow on the way.
[[nodiscard]] inline double Hypot(double x, double y) { return musl::shoal_hypot(x, y); }

[[nodiscard]] inline double Erfc(double x) { return musl::shoal_erfc(x); }
/// Returns ln |Gamma(x)|. (std::lgamma writes a global variable.)
[[nodiscard]] inline double LogGamma(double x) {
  int sign = 0;
  return musl::shoal_lgamma_r(x, &sign);
}

}  // namespace shoal
