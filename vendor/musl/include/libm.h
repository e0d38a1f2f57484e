/* What the files of musl include as "libm.h": access to the bits of a double, and what their
 * functions share. Rounding is to nearest, and no exception flag is asked for. */
#ifndef SHOAL_VENDOR_MUSL_LIBM_H
#define SHOAL_VENDOR_MUSL_LIBM_H

#include <features.h>
#include <float.h>
#include <math.h>
#include <stdint.h>

#undef FLT_EVAL_METHOD
#define FLT_EVAL_METHOD 0
#define weak_alias(old, new) _Static_assert(1, "no second name")
#define WANT_ROUNDING 1
#define TOINT_INTRINSICS 0
#define issignaling_inline(x) 0
#define predict_true(x) __builtin_expect(!!(x), 1)
#define predict_false(x) __builtin_expect(x, 0)
#define FORCE_EVAL(x) ((void)(x))

static inline double eval_as_double(double x) { return x; }
static inline double fp_barrier(double x) { return x; }
static inline void fp_force_eval(double x) { (void)x; }

static inline uint64_t asuint64(double x) {
  uint64_t bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  return bits;
}

static inline double asdouble(uint64_t bits) {
  double x;
  __builtin_memcpy(&x, &bits, sizeof x);
  return x;
}

#define EXTRACT_WORDS(hi, lo, d)     \
  do {                               \
    const uint64_t word_ = asuint64(d); \
    (hi) = (uint32_t)(word_ >> 32);     \
    (lo) = (uint32_t)word_;             \
  } while (0)
#define GET_HIGH_WORD(hi, d) ((hi) = (uint32_t)(asuint64(d) >> 32))
#define GET_LOW_WORD(lo, d) ((lo) = (uint32_t)asuint64(d))
#define INSERT_WORDS(d, hi, lo) ((d) = asdouble((uint64_t)(hi) << 32 | (uint32_t)(lo)))
#define SET_HIGH_WORD(d, hi) INSERT_WORDS(d, hi, (uint32_t)asuint64(d))
#define SET_LOW_WORD(d, lo) INSERT_WORDS(d, asuint64(d) >> 32, lo)

int __rem_pio2_large(double*, double*, int, int, int);
int __rem_pio2(double, double*);
double __sin(double, double, int);
double __cos(double, double);
double __tan(double, double, int);
double __expo2(double, double);

double __math_xflow(uint32_t, double);
double __math_uflow(uint32_t);
double __math_oflow(uint32_t);
double __math_divzero(uint32_t);
double __math_invalid(double);
#define __math_check_uflow(x) (x)
#define __math_check_oflow(x) (x)

#endif
