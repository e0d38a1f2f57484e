// Damage to packets: single wrong bits, and other packets on top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/base/random/stream.h"

namespace shoal {

/// Flips bit `position` mod 8, counted from the lowest, of byte `position` div 8.
/// @pre position < 8 * bytes.size()
void FlipBit(std::span<uint8_t> bytes, size_t position);

/// Flips `count` different bits, every choice of them as likely as any other. Where `count` is
/// binomial, each bit is wrong independently of all others. `scratch` is reused to save
/// allocations.
/// @pre 0 <= count <= 8 * bytes.size()
void FlipRandomBits(int64_t count, Stream* stream, std::span<uint8_t> bytes,
                    std::vector<uint8_t>* scratch);

/// A packet at one receiver: its first byte begins at `start_s`, its last ends at `end_s`.
struct Arrival {
  double start_s = 0;
  double end_s = 0;
  std::span<const uint8_t> bytes;
};

/// True where the two share more than a moment.
[[nodiscard]] inline bool Overlap(double start_a_s, double end_a_s, double start_b_s,
                                  double end_b_s) {
  return start_a_s < end_b_s && start_b_s < end_a_s && start_a_s < end_a_s && start_b_s < end_b_s;
}

/// The bytes of two packets that meet.
struct ByteWindow {
  size_t begin_a = 0;
  size_t begin_b = 0;
  size_t count = 0;
};

/// Returns the whole bytes, at this many bytes per second, that two packets spend together. Each
/// packet's window begins with the byte during which the other sets in, so it can begin up to a
/// byte early. Times within a millionth of a byte of a byte's border count as the border.
[[nodiscard]] ByteWindow FindByteWindow(const Arrival& a, const Arrival& b, double bytes_per_s);

/// XORs onto `received`, which arrives as `a`, what `b` puts on top of it.
/// @pre received.size() == a.bytes.size()
void XorOverlap(const Arrival& a, const Arrival& b, double bytes_per_s,
                std::span<uint8_t> received);

/// The same where the two have rates of their own: each byte of `a` is XORed with the byte of `b`
/// that is there in its middle.
/// @pre received.size() == a.bytes.size(); rates are positive
void XorOverlapOfRates(const Arrival& a, double a_bytes_per_s, const Arrival& b,
                       double b_bytes_per_s, std::span<uint8_t> received);

}  // namespace shoal
