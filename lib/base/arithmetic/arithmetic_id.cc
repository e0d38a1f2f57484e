#include "lib/base/arithmetic/arithmetic_id.h"

#include <Eigen/Core>
#include <cmath>
#include <string_view>

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

namespace {

/// What IEEE 754 rounds exactly, as compilers like to fuse or to reorder it.
void AddBasics(FixedSequence* numbers, BitsDigest* digest) {
  double sum = 0;
  for (int i = 0; i < 16; ++i) {
    const double x = numbers->Next();
    const double y = numbers->Next();
    sum += x * y;
    digest->Add(x * y - x);
    digest->Add(std::sqrt(x) / y);
    digest->Add(std::fmod(100 * x, y));
    digest->Add(std::remainder(100 * x, y));
  }
  digest->Add(sum);
  Eigen::Matrix3d a;
  Eigen::Vector3d b;
  for (int i = 0; i < 9; ++i) a(i) = numbers->Next();
  for (int i = 0; i < 3; ++i) b(i) = numbers->Next();
  const Eigen::Vector3d product = a * a * b;
  for (int i = 0; i < 3; ++i) digest->Add(product(i));
  digest->Add(product.norm());
}

void AddElementary(FixedSequence* numbers, BitsDigest* digest) {
  for (int i = 0; i < 500; ++i) {
    const double unit = numbers->Next();
    const double wide = 40 * (numbers->Next() - 0.5);
    const auto [sine, cosine] = SinCos(50 * wide);
    for (const double result :
         {Sin(wide), Cos(wide), Tan(wide), sine, cosine, Asin(unit), Acos(unit), Atan(wide),
          Atan2(unit, wide), Exp(wide), Expm1(wide), Log(unit), Log1p(-unit), Log10(unit),
          Log2(unit), Pow(unit, wide), Hypot(unit, wide), Erfc(wide), LogGamma(1 + 30 * unit)}) {
      digest->Add(result);
    }
  }
}

std::string MakeId() {
  FixedSequence numbers(33);
  BitsDigest digest;
  AddBasics(&numbers, &digest);
  AddElementary(&numbers, &digest);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string id;
  for (int shift = 60; shift >= 0; shift -= 4) id += kDigits[(digest.value() >> shift) & 0xfU];
  return id;
}

}  // namespace

std::string ArithmeticId() {
  static const std::string id = MakeId();
  return id;
}

}  // namespace shoal
