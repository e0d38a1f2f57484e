// Included before each source of GeographicLib: makes it call the elementary functions of shoal. The
// headers of the standard library come first, since the names below are macros; a macro with
// arguments leaves `using std::sinh;` alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

extern "C" {
double shoal_sin(double x);
double shoal_cos(double x);
double shoal_atan(double x);
double shoal_atan2(double y, double x);
double shoal_exp(double x);
double shoal_expm1(double x);
double shoal_log(double x);
double shoal_log1p(double x);
double shoal_hypot(double x, double y);
double shoal_cbrt(double x);
double shoal_sinh(double x);
double shoal_cosh(double x);
double shoal_tanh(double x);
double shoal_asinh(double x);
double shoal_atanh(double x);
}

/// std::abs of a complex number is hypot of libm.
inline double ShoalAbs(const std::complex<double>& z) { return shoal_hypot(z.real(), z.imag()); }

#define abs(z) ShoalAbs(z)
#define sin(x) shoal_sin(x)
#define cos(x) shoal_cos(x)
#define atan(x) shoal_atan(x)
#define atan2(y, x) shoal_atan2(y, x)
#define exp(x) shoal_exp(x)
#define expm1(x) shoal_expm1(x)
#define log(x) shoal_log(x)
#define log1p(x) shoal_log1p(x)
#define hypot(x, y) shoal_hypot(x, y)
#define cbrt(x) shoal_cbrt(x)
#define sinh(x) shoal_sinh(x)
#define cosh(x) shoal_cosh(x)
#define tanh(x) shoal_tanh(x)
#define asinh(x) shoal_asinh(x)
#define atanh(x) shoal_atanh(x)
