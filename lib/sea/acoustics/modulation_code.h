// From wrong bits to lost packets, with or without an error-correcting code.
//
//   const BlockCode golay = {.block_bits = 23, .data_bits = 12, .corrected_bits = 3};
//   const double loss = PacketErrorRate(1e-3, 37, golay);
//
// The model is the textbook's: bits are wrong independently of each other, and a code corrects up
// to t wrong bits in each block of n and no more (bounded-distance decoding of a binary block code;
// Proakis, Digital Communications, 4th ed., eq. 8-1-77; Lin and Costello, Error Control Coding, 2nd
// ed., ch. 6 for the parameters of BCH codes). Convolutional, turbo and LDPC codes of the same rate
// do better by 1 to 3 dB.
#pragma once

#include <cstdint>
#include <string>

namespace shoal {

/// A binary block code; the default is none.
struct BlockCode {
  int block_bits = 1;      ///< n: transmitted bits of a block; [1, kMaxBlockBits].
  int data_bits = 1;       ///< k: of the user's; [1, n].
  int corrected_bits = 0;  ///< t: wrong bits that a block can correct.

  bool operator==(const BlockCode&) const = default;
};

constexpr int kMaxBlockBits = 1023;

/// Returns why there can be no such code, for the author of a mission file; empty where there can.
/// A code that corrects t bits must leave room for every pattern of errors: sum over i <= t
/// of C(n, i) <= 2^(n-k) (Hamming's bound).
[[nodiscard]] std::string ProblemOf(const BlockCode& code);

/// Returns k / n.
[[nodiscard]] double CodeRate(const BlockCode& code);

/// Returns the probability that a block cannot be corrected. `bit_error_rate` is that of the
/// transmitted bits, clamped to [0, 0.5]; NaN counts as 0.5.
/// @pre ProblemOf(code) is empty
[[nodiscard]] double BlockErrorRate(double bit_error_rate, const BlockCode& code);

/// Returns the probability that any block of a packet of `packet_bytes` cannot be corrected; the
/// last block is filled up. 0 for an empty packet.
/// @pre ProblemOf(code) is empty
[[nodiscard]] double PacketErrorRate(double bit_error_rate, uint64_t packet_bytes,
                                     const BlockCode& code = {});

}  // namespace shoal
