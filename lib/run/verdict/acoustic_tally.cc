#include "lib/run/verdict/acoustic_tally.h"

#include <fmt/format.h>

#include <algorithm>

namespace shoal {

namespace {

/// More than any mission flips; sums stay numbers.
constexpr int64_t kMaxBits = int64_t{1} << 60;

/// More than any part of a mission counts.
constexpr int64_t kMaxAdded = int64_t{1} << 50;

/// Wrong bits arrived, whether the receiver took them or a checksum threw them away.
bool IsDamage(std::string_view cause) {
  return cause == "damaged" || cause == "rejected" || cause == "bit_errors";
}

}  // namespace

int64_t AcousticTally::Numbers::*const AcousticTally::kNumbers[] = {&Numbers::all,
                                                                    &Numbers::overlapped,
                                                                    &Numbers::with_bit_errors,
                                                                    &Numbers::bits_flipped,
                                                                    &Numbers::damaged_by_collision,
                                                                    &Numbers::damaged_by_bit_errors,
                                                                    &Numbers::damaged_by_either};

void AcousticTally::Add(const AcousticReception& reception) {
  ++numbers_.all;
  const bool overlapped = reception.num_colliders > 0;
  const bool has_bit_errors = reception.bits_flipped > 0;
  if (overlapped) ++numbers_.overlapped;
  if (has_bit_errors) {
    ++numbers_.with_bit_errors;
    const int64_t bits = std::min(reception.bits_flipped, kMaxBits);
    numbers_.bits_flipped = std::min(numbers_.bits_flipped + bits, kMaxBits);
  }
  if (!IsDamage(reception.cause)) return;
  if (overlapped && has_bit_errors) {
    ++numbers_.damaged_by_either;
  } else {
    ++(overlapped ? numbers_.damaged_by_collision : numbers_.damaged_by_bit_errors);
  }
}

int64_t AcousticTally::NumInTransit() const {
  int64_t num_in_transit = 0;
  for (const auto& [source, packets] : packets_) {
    // A broker that is started again counts from zero: packets of one number are then one.
    const auto num_concluded = static_cast<int64_t>(packets.concluded.size());
    num_in_transit += std::max<int64_t>(0, packets.num_sent - num_concluded);
  }
  return num_in_transit;
}

AcousticTally::Rows AcousticTally::Counts() const {
  return {{"receptions", numbers_.all},
          {"overlapped by others", numbers_.overlapped},
          {"with bits flipped", numbers_.with_bit_errors},
          {"bits flipped", numbers_.bits_flipped},
          {"damaged by collision", numbers_.damaged_by_collision},
          {"damaged by bit errors", numbers_.damaged_by_bit_errors},
          {"damaged by either", numbers_.damaged_by_either},
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

void AcousticTally::AppendTo(std::vector<uint8_t>* bytes) const {
  for (const int64_t Numbers::*number : kNumbers) AppendLittleEndian(numbers_.*number, bytes);
  AppendLittleEndian(static_cast<uint32_t>(packets_.size()), bytes);
  for (const auto& [source, packets] : packets_) {
    AppendSizedText(source, bytes);
    AppendLittleEndian(packets.num_sent, bytes);
    AppendLittleEndian(static_cast<uint32_t>(packets.concluded.size()), bytes);
    for (const int64_t number : packets.concluded) AppendLittleEndian(number, bytes);
  }
}

bool AcousticTally::AddFrom(LittleEndianReader* reader) {
  uint32_t num_sources = 0;
  for (int64_t Numbers::*number : kNumbers) {
    int64_t more = 0;
    if (!reader->Take(&more) || more < 0 || more > kMaxAdded) return false;
    numbers_.*number += more;
  }
  numbers_.bits_flipped = std::min(numbers_.bits_flipped, kMaxBits);
  if (!reader->Take(&num_sources)) return false;
  for (uint32_t i = 0; i < num_sources; ++i) {
    std::string source;
    int64_t num_sent = 0;
    uint32_t num_concluded = 0;
    if (!reader->TakeSizedText(&source) || !reader->Take(&num_sent) ||
        !reader->Take(&num_concluded)) {
      return false;
    }
    if (num_sent < 0 || num_sent > kMaxAdded) return false;
    Packets& packets = packets_[source];
    packets.num_sent += num_sent;
    for (uint32_t k = 0; k < num_concluded; ++k) {
      int64_t number = 0;
      if (!reader->Take(&number)) return false;
      packets.concluded.insert(number);
    }
  }
  return true;
}

}  // namespace shoal
