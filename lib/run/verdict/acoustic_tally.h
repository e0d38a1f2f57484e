// What the acoustic network did with all that a mission sent over it, from the fates.
//
//   AcousticTally tally;
//   tally.AddSent("alpha");                              // with every ACOUSTIC_TX
//   tally.Add({.cause = "damaged", .bits_flipped = 3});  // with every fate that has a path
//   print(tally.Text());
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/codec/little_endian.h"

namespace shoal {

/// One packet at one receiver.
struct AcousticReception {
  std::string_view cause;
  int64_t bits_flipped = 0;  ///< By bit errors.
  int64_t num_colliders = 0;
};

class AcousticTally {
 public:
  void Add(const AcousticReception& reception);
  /// Takes note of a packet that was given to the network, and of a fate of one.
  void AddSent(const std::string& source) { ++packets_[source].num_sent; }
  void AddFate(const std::string& source, int64_t number) {
    packets_[source].concluded.insert(number);
  }

  bool IsEmpty() const { return numbers_.all == 0 && NumInTransit() == 0; }
  /// Packets without any fate yet.
  [[nodiscard]] int64_t NumInTransit() const;

  using Rows = std::vector<std::pair<std::string_view, int64_t>>;
  [[nodiscard]] Rows Counts() const;
  /// Returns a table with a line for each count; "" where nothing was sent.
  [[nodiscard]] std::string Text() const;
  [[nodiscard]] std::string Csv() const;

  /// Appends all counts.
  void AppendTo(std::vector<uint8_t>* bytes) const;
  /// Adds what another tally has appended. Returns false where it is damaged.
  [[nodiscard]] bool AddFrom(LittleEndianReader* reader);

 private:
  struct Packets {
    int64_t num_sent = 0;
    std::set<int64_t> concluded;
  };

  /// Of receptions.
  struct Numbers {
    int64_t all = 0;
    int64_t overlapped = 0;
    int64_t with_bit_errors = 0;
    int64_t bits_flipped = 0;
    int64_t damaged_by_collision = 0;
    int64_t damaged_by_bit_errors = 0;
    int64_t damaged_by_either = 0;  ///< Both happened to them.
  };

  static int64_t Numbers::*const kNumbers[7];

  Numbers numbers_;
  std::map<std::string, Packets> packets_;
};

}  // namespace shoal
