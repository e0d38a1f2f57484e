// The elementary functions: their bits, against stored digests; the edge cases of the C standard;
// and how far they are from libm's.
#include "lib/base/arithmetic/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "lib/base/arithmetic/arithmetic_id.h"

namespace shoal::elementary_test {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();
const double kPi = std::acos(-1.0);

constexpr int kCount = 10'000;

/// A function, the interval that its arguments are from, what libm has, and the digest of its bits.
struct Case {
  std::string name;
  double low = 0;
  double high = 0;
  std::function<double(double)> ours;
  std::function<double(double)> libms;
  uint64_t digest = 0;
  double units = 2;  ///< As far as ours and libm's are apart, in units in the last place.
};

void PrintTo(const Case& tested, std::ostream* out) { *out << tested.name; }

class Elementary : public testing::TestWithParam<Case> {};

// Half of the arguments from the interval, half from a thousandth of it, about zero or its end.
std::vector<double> ArgumentsOf(const Case& tested) {
  FixedSequence numbers(7);
  std::vector<double> arguments;
  for (int i = 0; i < kCount; ++i) {
    const double x = tested.low + (tested.high - tested.low) * numbers.Next();
    arguments.push_back(i % 2 == 0 ? x : x / 1000);
  }
  return arguments;
}

TEST_P(Elementary, HasTheBitsOfThisVersion) {
  BitsDigest digest;
  for (const double x : ArgumentsOf(GetParam())) {
    const double y = GetParam().ours(x);
    ASSERT_FALSE(std::isnan(y)) << "of " << x << ": no processor agrees on the bits of a NaN";
    digest.Add(y);
  }
  EXPECT_EQ(digest.value(), GetParam().digest) << std::hex << "0x" << digest.value();
}

// libm's own functions are within 1 unit, Erfc within 3.
TEST_P(Elementary, IsAsExactAsLibm) {
  double farthest = 0;
  for (const double x : ArgumentsOf(GetParam())) {
    const double expected = GetParam().libms(x);
    int exponent = 0;
    std::frexp(expected, &exponent);
    const double unit = std::ldexp(1, std::max(exponent - 53, -1074));
    farthest = std::max(farthest, std::abs(GetParam().ours(x) - expected) / unit);
  }
  EXPECT_LE(farthest, GetParam().units);
}

const std::vector<Case> kCases = {
    {"Sin", -10, 10, Sin, [](double x) { return std::sin(x); }, 0x4a0e90ca6cce8733},
    {"SinOfLargeAngles", -1e15, 1e15, Sin, [](double x) { return std::sin(x); },
     0xbdca67c0f9f82d33},
    {"Cos", -10, 10, Cos, [](double x) { return std::cos(x); }, 0xd58e40c7b396ccc7},
    {"CosOfLargeAngles", -1e300, 1e300, Cos, [](double x) { return std::cos(x); },
     0xd938325e56b6747f},
    {"Tan", -10, 10, Tan, [](double x) { return std::tan(x); }, 0x650a7f0270ca82d},
    {"Asin", -1, 1, Asin, [](double x) { return std::asin(x); }, 0x7a918d176a557458},
    {"Acos", -1, 1, Acos, [](double x) { return std::acos(x); }, 0xcf89199988c1090b},
    {"Atan", -100, 100, Atan, [](double x) { return std::atan(x); }, 0xa59e7e141b493108},
    {"Atan2", -10, 10, [](double x) { return Atan2(x, 1.7); },
     [](double x) { return std::atan2(x, 1.7); }, 0xb8412392a0feef86},
    {"Atan2Behind", -10, 10, [](double x) { return Atan2(x, -1.7); },
     [](double x) { return std::atan2(x, -1.7); }, 0xd99fbc89d3314cbc},
    {"Exp", -700, 700, Exp, [](double x) { return std::exp(x); }, 0x934a91be670c89b5},
    {"Expm1", -30, 30, Expm1, [](double x) { return std::expm1(x); }, 0x10bc5a711c87eaeb},
    {"Log", 0, 1000, Log, [](double x) { return std::log(x); }, 0x22a88fd00a898299},
    {"Log1p", -0.999, 10, Log1p, [](double x) { return std::log1p(x); }, 0xc7a989fc577d2501},
    {"Log10", 0, 1e6, Log10, [](double x) { return std::log10(x); }, 0x71f314e1c408aa7c},
    {"Log2", 0, 1e6, Log2, [](double x) { return std::log2(x); }, 0x7a4ab87029206aed},
    {"PowOfTen", -300, 300, [](double x) { return Pow(10, x); },
     [](double x) { return std::pow(10, x); }, 0x24f01c777a2ca0f},
    {"PowToRoots", 0, 1e4, [](double x) { return Pow(x, 0.37); },
     [](double x) { return std::pow(x, 0.37); }, 0xf048699f54570c10},
    {"Hypot", -1e3, 1e3, [](double x) { return Hypot(x, 7.3); },
     [](double x) { return std::hypot(x, 7.3); }, 0xf81aae30b9120ae},
    {"Erfc", -5, 25, Erfc, [](double x) { return std::erfc(x); }, 0xc3216ab170260420, 5},
    {"LogGamma", 3, 1e6, LogGamma, [](double x) { return std::lgamma(x); }, 0x14ebc3b34d8e9c9e, 4},
};

INSTANTIATE_TEST_SUITE_P(Functions, Elementary, testing::ValuesIn(kCases),
                         [](const auto& tested) { return tested.param.name; });

TEST(SinCos, HasTheBitsOfSinAndCos) {
  FixedSequence numbers(9);
  for (int i = 0; i < kCount; ++i) {
    const double x = (numbers.Next() - 0.5) * (i % 2 == 0 ? 20 : 1e10);
    const auto [sine, cosine] = SinCos(x);
    ASSERT_EQ(sine, Sin(x)) << x;
    ASSERT_EQ(cosine, Cos(x)) << x;
  }
}

/// True for the same number, with the same sign; NaN equals NaN.
bool IsSame(double a, double b) {
  return std::isnan(b) ? std::isnan(a) : a == b && std::signbit(a) == std::signbit(b);
}

#define EXPECT_SAME(a, b) EXPECT_PRED2(IsSame, a, b)

// ISO/IEC 9899:2011, F.10.1.
TEST(Trigonometry, HasTheEdgesOfTheCStandard) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_SAME(Sin(zero), zero);
    EXPECT_SAME(Cos(zero), 1.0);
    EXPECT_SAME(SinCos(zero).sine, zero);
    EXPECT_SAME(SinCos(zero).cosine, 1.0);
    EXPECT_SAME(Tan(zero), zero);
    EXPECT_SAME(Asin(zero), zero);
    EXPECT_SAME(Atan(zero), zero);
  }
  for (const double x : {kInf, -kInf, kNan}) {
    EXPECT_SAME(Sin(x), kNan);
    EXPECT_SAME(Cos(x), kNan);
    EXPECT_SAME(SinCos(x).sine, kNan);
    EXPECT_SAME(SinCos(x).cosine, kNan);
    EXPECT_SAME(Tan(x), kNan);
    EXPECT_SAME(Asin(x), kNan);
    EXPECT_SAME(Acos(x), kNan);
  }
  EXPECT_SAME(Asin(1 + 0x1p-52), kNan);
  EXPECT_SAME(Asin(-1 - 0x1p-52), kNan);
  EXPECT_SAME(Acos(1 + 0x1p-52), kNan);
  EXPECT_SAME(Asin(1), kPi / 2);
  EXPECT_SAME(Asin(-1), -kPi / 2);
  EXPECT_SAME(Acos(1), 0.0);
  EXPECT_SAME(Acos(-1), kPi);
  EXPECT_SAME(Atan(kInf), kPi / 2);
  EXPECT_SAME(Atan(-kInf), -kPi / 2);
  EXPECT_SAME(Atan(kNan), kNan);
}

TEST(Atan2, HasTheEdgesOfTheCStandard) {
  for (const double y : {0.0, -0.0}) {
    EXPECT_SAME(Atan2(y, -0.0), std::copysign(kPi, y));
    EXPECT_SAME(Atan2(y, +0.0), y);
    EXPECT_SAME(Atan2(y, -1), std::copysign(kPi, y));
    EXPECT_SAME(Atan2(y, 1), y);
    EXPECT_SAME(Atan2(1, y), kPi / 2);
    EXPECT_SAME(Atan2(-1, y), -kPi / 2);
  }
  for (const double y : {1.0, -1.0}) {
    EXPECT_SAME(Atan2(y, -kInf), std::copysign(kPi, y));
    EXPECT_SAME(Atan2(y, kInf), std::copysign(0.0, y));
    EXPECT_SAME(Atan2(y * kInf, 1), std::copysign(kPi / 2, y));
    EXPECT_SAME(Atan2(y * kInf, -kInf), std::copysign(3 * kPi / 4, y));
    EXPECT_SAME(Atan2(y * kInf, kInf), std::copysign(kPi / 4, y));
  }
  EXPECT_SAME(Atan2(kNan, 1), kNan);
  EXPECT_SAME(Atan2(1, kNan), kNan);
}

// F.10.3.
TEST(ExpAndLog, HaveTheEdgesOfTheCStandard) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_SAME(Exp(zero), 1.0);
    EXPECT_SAME(Expm1(zero), zero);
    EXPECT_SAME(Log(zero), -kInf);
    EXPECT_SAME(Log1p(zero), zero);
    EXPECT_SAME(Log10(zero), -kInf);
    EXPECT_SAME(Log2(zero), -kInf);
  }
  EXPECT_SAME(Exp(kInf), kInf);
  EXPECT_SAME(Exp(-kInf), 0.0);
  EXPECT_SAME(Exp(710), kInf);
  EXPECT_SAME(Exp(-746), 0.0);
  EXPECT_SAME(Exp(-745), kTiny);
  EXPECT_SAME(Expm1(kInf), kInf);
  EXPECT_SAME(Expm1(-kInf), -1.0);
  EXPECT_SAME(Log1p(-1), -kInf);
  EXPECT_SAME(Log1p(-1 - 0x1p-52), kNan);
  EXPECT_SAME(Log1p(kInf), kInf);
  for (const auto& log : {Log, Log10, Log2}) {
    EXPECT_SAME(log(1), 0.0);
    EXPECT_SAME(log(-kTiny), kNan);
    EXPECT_SAME(log(-kInf), kNan);
    EXPECT_SAME(log(kInf), kInf);
    EXPECT_SAME(log(kNan), kNan);
  }
  EXPECT_SAME(Log2(kTiny), -1074.0);
  EXPECT_SAME(Log10(1e22), 22.0);
  for (const auto& function : {Exp, Expm1, Log1p}) EXPECT_SAME(function(kNan), kNan);
}

// F.10.4.4.
TEST(Pow, HasTheEdgesOfTheCStandard) {
  for (const double any : {0.0, -0.0, 1.0, -1.5, kInf, -kInf, kNan}) {
    EXPECT_SAME(Pow(any, 0.0), 1.0);
    EXPECT_SAME(Pow(any, -0.0), 1.0);
    EXPECT_SAME(Pow(1, any), 1.0);
  }
  EXPECT_SAME(Pow(0.0, -3), kInf);
  EXPECT_SAME(Pow(-0.0, -3), -kInf);
  EXPECT_SAME(Pow(-0.0, -2), kInf);
  EXPECT_SAME(Pow(-0.0, -0.5), kInf);
  EXPECT_SAME(Pow(0.0, -kInf), kInf);
  EXPECT_SAME(Pow(0.0, 3), 0.0);
  EXPECT_SAME(Pow(-0.0, 3), -0.0);
  EXPECT_SAME(Pow(-0.0, 2), 0.0);
  EXPECT_SAME(Pow(-1, kInf), 1.0);
  EXPECT_SAME(Pow(-1, -kInf), 1.0);
  EXPECT_SAME(Pow(-2, 0.5), kNan);
  EXPECT_SAME(Pow(-2, 3), -8.0);
  EXPECT_SAME(Pow(0.5, -kInf), kInf);
  EXPECT_SAME(Pow(2, -kInf), 0.0);
  EXPECT_SAME(Pow(0.5, kInf), 0.0);
  EXPECT_SAME(Pow(2, kInf), kInf);
  EXPECT_SAME(Pow(-kInf, -3), -0.0);
  EXPECT_SAME(Pow(-kInf, -2), 0.0);
  EXPECT_SAME(Pow(-kInf, 3), -kInf);
  EXPECT_SAME(Pow(-kInf, 2), kInf);
  EXPECT_SAME(Pow(kInf, -1), 0.0);
  EXPECT_SAME(Pow(kInf, 1), kInf);
  EXPECT_SAME(Pow(kNan, 1), kNan);
  EXPECT_SAME(Pow(2, kNan), kNan);
  EXPECT_SAME(Pow(10, 400), kInf);
  EXPECT_SAME(Pow(10, -400), 0.0);
}

TEST(Hypot, HasTheEdgesOfTheCStandard) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_SAME(Hypot(sign * kInf, kNan), kInf);
    EXPECT_SAME(Hypot(kNan, sign * kInf), kInf);
    EXPECT_SAME(Hypot(sign * 3, -4), 5.0);
    EXPECT_SAME(Hypot(sign * 2.5, 0), 2.5);
    EXPECT_SAME(Hypot(sign * 1e300, 1e300), 1e300 * std::sqrt(2.0));
  }
  EXPECT_SAME(Hypot(kMax, kMax), kInf);
  EXPECT_SAME(Hypot(kTiny, 0), kTiny);
  EXPECT_SAME(Hypot(-0.0, -0.0), 0.0);
  EXPECT_SAME(Hypot(kNan, 1), kNan);
}

// F.10.5.
TEST(ErfcAndLogGamma, HaveTheEdgesOfTheCStandard) {
  EXPECT_SAME(Erfc(kInf), 0.0);
  EXPECT_SAME(Erfc(-kInf), 2.0);
  EXPECT_SAME(Erfc(0), 1.0);
  EXPECT_SAME(Erfc(kNan), kNan);
  EXPECT_SAME(LogGamma(1), 0.0);
  EXPECT_SAME(LogGamma(2), 0.0);
  EXPECT_SAME(LogGamma(0), kInf);
  EXPECT_SAME(LogGamma(-3), kInf);
  EXPECT_SAME(LogGamma(kInf), kInf);
  EXPECT_SAME(LogGamma(-kInf), kInf);
  EXPECT_SAME(LogGamma(kNan), kNan);
}

}  // namespace shoal::elementary_test
