// Sentences of NMEA 0183: "$body*HH", HH the exclusive or of the body's bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// Returns the exclusive or of the body's bytes.
[[nodiscard]] uint8_t NmeaChecksum(std::string_view body);

/// Frames a body, as "GPRMC,1,2": "$GPRMC,1,2*HH\r\n", HH in upper case.
/// @pre `body` has no '$', '*', CR or LF.
[[nodiscard]] std::string NmeaSentence(std::string_view body);

struct NmeaFields {
  std::string address;              ///< Talker and sentence: the first field, as "GPRMC".
  std::vector<std::string> fields;  ///< What follows, split at commas; empty fields stay.
  bool has_checksum = false;
};

/// Reads "$body" or "$body*HH", with or without CR and LF behind; hex digits of either case.
/// Nothing when there is no '$' in front, no address, a checksum that is wrong or not two hex
/// digits, or a byte in the body that is not printable ASCII or is '$' or '*'.
[[nodiscard]] std::optional<NmeaFields> ParseNmea(std::string_view line);

}  // namespace shoal
