#include "lib/sea/acoustics/bit_errors.h"

#include <algorithm>
#include <cstring>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

constexpr double kByteRoundingAllowance = 1e-6;

/// Returns how many whole bytes fit a time, or all of `limit` where more do.
size_t WholeBytes(double duration_s, double bytes_per_s, size_t limit) {
  const double count = duration_s * bytes_per_s + kByteRoundingAllowance;
  if (!(count >= 1)) return 0;
  return count >= static_cast<double>(limit) ? limit : static_cast<size_t>(count);
}

bool BitIsSet(std::span<const uint8_t> bytes, size_t position) {
  return (bytes[position / 8] >> (position % 8) & 1) != 0;
}

}  // namespace

void FlipBit(std::span<uint8_t> bytes, size_t position) {
  bytes[position / 8] = static_cast<uint8_t>(bytes[position / 8] ^ (1U << (position % 8)));
}

// R. Floyd's method (J. Bentley, "Programming pearls: a sample of brilliance", CACM 30 (1987)): no
// draw is thrown away.
void FlipRandomBits(int64_t count, Stream* stream, std::span<uint8_t> bytes,
                    std::vector<uint8_t>* scratch) {
  const auto num_bits = static_cast<int64_t>(bytes.size() * 8);
  SHOAL_CHECK(count >= 0 && count <= num_bits, "0 <= count <= number of bits");
  scratch->assign(bytes.size(), 0);
  const std::span<uint8_t> chosen(*scratch);
  for (int64_t last = num_bits - count; last < num_bits; ++last) {
    const size_t drawn = stream->UniformInt(static_cast<uint64_t>(last) + 1);
    const size_t position = BitIsSet(chosen, drawn) ? static_cast<size_t>(last) : drawn;
    FlipBit(chosen, position);
    FlipBit(bytes, position);
  }
}

ByteWindow FindByteWindow(const Arrival& a, const Arrival& b, double bytes_per_s) {
  const double start_s = std::max(a.start_s, b.start_s);
  const double end_s = std::min(a.end_s, b.end_s);
  ByteWindow window;
  window.begin_a = WholeBytes(start_s - a.start_s, bytes_per_s, a.bytes.size());
  window.begin_b = WholeBytes(start_s - b.start_s, bytes_per_s, b.bytes.size());
  window.count =
      WholeBytes(end_s - start_s, bytes_per_s,
                 std::min(a.bytes.size() - window.begin_a, b.bytes.size() - window.begin_b));
  return window;
}

void XorOverlap(const Arrival& a, const Arrival& b, double bytes_per_s,
                std::span<uint8_t> received) {
  SHOAL_CHECK(received.size() == a.bytes.size(), "received has the size of the packet");
  const ByteWindow window = FindByteWindow(a, b, bytes_per_s);
  const std::span<uint8_t> mine = received.subspan(window.begin_a, window.count);
  const std::span<const uint8_t> theirs = b.bytes.subspan(window.begin_b, window.count);
  size_t i = 0;
  for (uint64_t word = 0, other = 0; i + sizeof word <= window.count; i += sizeof word) {
    std::memcpy(&word, &mine[i], sizeof word);
    std::memcpy(&other, &theirs[i], sizeof word);
    word ^= other;
    std::memcpy(&mine[i], &word, sizeof word);
  }
  for (; i < window.count; ++i) mine[i] ^= theirs[i];
}

void XorOverlapOfRates(const Arrival& a, double a_bytes_per_s, const Arrival& b,
                       double b_bytes_per_s, std::span<uint8_t> received) {
  SHOAL_CHECK(received.size() == a.bytes.size(), "received has the size of the packet");
  for (size_t i = 0; i < received.size(); ++i) {
    const double middle_s = a.start_s + (static_cast<double>(i) + 0.5) / a_bytes_per_s;
    const double place = (middle_s - b.start_s) * b_bytes_per_s;
    if (!(place >= 0 && place < static_cast<double>(b.bytes.size()))) continue;
    received[i] ^= b.bytes[static_cast<size_t>(place)];
  }
}

}  // namespace shoal
