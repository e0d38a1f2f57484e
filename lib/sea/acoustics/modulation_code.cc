#include "lib/sea/acoustics/modulation_code.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

std::string ProblemOf(const BlockCode& code) {
  const std::string n = std::to_string(code.block_bits);
  const std::string k = std::to_string(code.data_bits);
  const std::string t = std::to_string(code.corrected_bits);
  if (code.block_bits < 1 || code.block_bits > kMaxBlockBits) {
    return "a block of " + n + " bits; allowed: 1 to " + std::to_string(kMaxBlockBits);
  }
  if (code.data_bits < 1 || code.data_bits > code.block_bits) {
    return k + " data bits in a block of " + n + " bits; allowed: 1 to " + n;
  }
  if (code.corrected_bits < 0 || code.corrected_bits > code.block_bits) {
    return t + " corrected bits in a block of " + n + " bits; allowed: 0 to " + n;
  }
  double patterns = 0;
  double of_weight_i = 1;
  for (int i = 0; i <= code.corrected_bits; ++i) {
    patterns += of_weight_i;
    of_weight_i *= static_cast<double>(code.block_bits - i) / (i + 1);
  }
  // Binomials of up to 53 bits are exact; beyond, no code comes within 1e-9 of the bound.
  if (Log2(patterns) > code.block_bits - code.data_bits + 1e-9) {
    return "no code of " + n + " bits with " + k + " data bits corrects " + t +
           " errors: there are " + std::to_string(code.block_bits - code.data_bits) +
           " check bits, and distinguishing the error patterns takes " +
           std::to_string(static_cast<int>(std::ceil(Log2(patterns) - 1e-9)));
  }
  return "";
}

double CodeRate(const BlockCode& code) {
  return static_cast<double>(code.data_bits) / code.block_bits;
}

double BlockErrorRate(double bit_error_rate, const BlockCode& code) {
  SHOAL_CHECK(code.block_bits >= 1 && code.block_bits <= kMaxBlockBits && code.data_bits >= 1,
              "ProblemOf(code) is empty");
  const double p = std::isnan(bit_error_rate) ? 0.5 : std::clamp(bit_error_rate, 0.0, 0.5);
  const int n = code.block_bits;
  const double odds = p / (1 - p);
  // The smaller tail of the binomial distribution is summed, so that nothing cancels; its terms
  // fall, faster and faster, once the larger tail is behind. The first term is at least 2^-1023.
  double term = Pow(1 - p, n);
  double corrected = 0;
  int i = 0;
  for (; i <= std::min(code.corrected_bits, n); ++i) {
    corrected += term;
    term *= odds * (n - i) / (i + 1);
  }
  if (corrected < 0.5) return std::clamp(1 - corrected, 0.0, 1.0);
  double uncorrected = 0;
  for (; i <= n && uncorrected + term != uncorrected; ++i) {
    uncorrected += term;
    term *= odds * (n - i) / (i + 1);
  }
  return std::clamp(uncorrected, 0.0, 1.0);
}

double PacketErrorRate(double bit_error_rate, uint64_t packet_bytes, const BlockCode& code) {
  const double blocks = std::ceil(static_cast<double>(packet_bytes) * 8 / code.data_bits);
  if (blocks == 0) return 0;
  return -Expm1(blocks * Log1p(-BlockErrorRate(bit_error_rate, code)));
}

}  // namespace shoal
