// Reads a sentence's fields, and remembers the first that is wrong.
#pragma once

#include <string>
#include <string_view>

#include "lib/base/codec/nmea_sentence.h"

namespace shoal {

/// Fields are counted from 1, behind the sentence's name. What follows the fields that are read
/// does not matter.
class SentenceReader {
 public:
  explicit SentenceReader(const NmeaFields& sentence) : sentence_(sentence) {}

  /// Returns the field as a number; `low` where it is none, or beyond the limits.
  int Number(size_t field, int low, int high);
  /// Returns the field; empty where there is none.
  std::string_view Text(size_t field);
  /// Notes that a field should be something else, as "an even number of hex digits".
  void Reject(size_t field, std::string_view wanted);

  /// Returns what is wrong, in words without a comma; empty where nothing is.
  const std::string& problem() const { return problem_; }

 private:
  const NmeaFields& sentence_;
  std::string problem_;
};

}  // namespace shoal
