#include "lib/verdict/acoustic_tally.h"

#include <fmt/format.h>

#include <algorithm>

namespace shoal {

namespace {

/// More than any mission flips; sums stay numbers.
constexpr int64_t kMostBits = int64_t{1} << 60;

/// Wrong bits arrived, whether the receiver took them or a checksum threw them away.
bool IsDamage(std::string_view cause) {
  return cause == "damaged" || cause == "rejected" || cause == "bit_errors";
}

}  // namespace

void AcousticTally::Add(const AcousticReception& reception) {
  ++num_receptions_;
  const bool overlapped = reception.num_colliders > 0;
  const bool has_bit_errors = reception.bits_flipped > 0;
  if (overlapped) ++num_overlapped_;
  if (has_bit_errors) {
    ++num_with_bit_errors_;
    const int64_t bits = std::min(reception.bits_flipped, kMostBits);
    num_bits_flipped_ = std::min(num_bits_flipped_ + bits, kMostBits);
  }
  if (!IsDamage(reception.cause)) return;
  if (overlapped && has_bit_errors) {
    ++num_damaged_by_either_;
  } else {
    ++(overlapped ? num_damaged_by_collision_ : num_damaged_by_bit_errors_);
  }
}

int64_t AcousticTally::NumInTransit() const {
  int64_t num_in_transit = 0;
  for (const auto& [source, packets] : packets_) {
    // A broker that is started again counts anew: packets of one number are then one.
    const auto num_concluded = static_cast<int64_t>(packets.concluded.size());
    num_in_transit += std::max<int64_t>(0, packets.num_sent - num_concluded);
  }
  return num_in_transit;
}

AcousticTally::Rows AcousticTally::Counts() const {
  return {{"receptions", num_receptions_},
          {"overlapped by others", num_overlapped_},
          {"with bits flipped", num_with_bit_errors_},
          {"bits flipped", num_bits_flipped_},
          {"damaged by collision", num_damaged_by_collision_},
          {"damaged by bit errors", num_damaged_by_bit_errors_},
          {"damaged by either", num_damaged_by_either_},
          {"packets in transit", NumInTransit()}};
}

std::string AcousticTally::Text() const {
  if (IsEmpty()) return "";
  std::string text = "Acoustic network\n";
  for (const auto& [name, count] : Counts())
    text += fmt::format("    {:<24} {:>10}\n", name, count);
  return text;
}

std::string AcousticTally::Csv() const {
  std::string text = "what,count\n";
  for (const auto& [name, count] : Counts()) text += fmt::format("{},{}\n", name, count);
  return text;
}

}  // namespace shoal
