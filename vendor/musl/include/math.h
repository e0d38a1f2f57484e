/* What the files of musl include as <math.h>, and the names of their functions in shoal. Functions
 * that IEEE 754 rounds exactly (sqrt, floor, scalbn, fabs) stay those of the compiler and of libc. */
#ifndef SHOAL_VENDOR_MUSL_MATH_H
#define SHOAL_VENDOR_MUSL_MATH_H

#define sin shoal_sin
#define cos shoal_cos
#define sincos shoal_sincos
#define tan shoal_tan
#define asin shoal_asin
#define acos shoal_acos
#define atan shoal_atan
#define atan2 shoal_atan2
#define exp shoal_exp
#define expm1 shoal_expm1
#define log shoal_log
#define log1p shoal_log1p
#define log10 shoal_log10
#define log2 shoal_log2
#define pow shoal_pow
#define hypot shoal_hypot
#define cbrt shoal_cbrt
#define erf shoal_erf
#define erfc shoal_erfc
#define lgamma_r shoal_lgamma_r
#define sinh shoal_sinh
#define cosh shoal_cosh
#define tanh shoal_tanh
#define asinh shoal_asinh
#define atanh shoal_atanh
#define __lgamma_r shoal_lgamma_r
#define __sin shoal_kernel_sin
#define __cos shoal_kernel_cos
#define __tan shoal_kernel_tan
#define __rem_pio2 shoal_rem_pio2
#define __rem_pio2_large shoal_rem_pio2_large
#define __expo2 shoal_expo2
#define __math_invalid shoal_math_invalid
#define __math_divzero shoal_math_divzero
#define __math_oflow shoal_math_oflow
#define __math_uflow shoal_math_uflow
#define __math_xflow shoal_math_xflow

typedef double double_t;

#define FLT_EVAL_METHOD 0
#define INFINITY __builtin_inff()
#define NAN __builtin_nanf("")
#define isnan(x) __builtin_isnan(x)
#define isinf(x) __builtin_isinf(x)
#define fabs(x) __builtin_fabs(x)
#define sqrt(x) __builtin_sqrt(x)

double sin(double);
double cos(double);
void sincos(double, double*, double*);
double tan(double);
double asin(double);
double acos(double);
double atan(double);
double atan2(double, double);
double exp(double);
double expm1(double);
double log(double);
double log1p(double);
double log10(double);
double log2(double);
double pow(double, double);
double hypot(double, double);
double cbrt(double);
double erf(double);
double erfc(double);
double lgamma_r(double, int*);
double sinh(double);
double cosh(double);
double tanh(double);
double asinh(double);
double atanh(double);
double floor(double);
double scalbn(double, int);

#endif
