#include "lib/base/codec/nmea_sentence.h"

#include <algorithm>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

constexpr std::string_view kHexDigits = "0123456789ABCDEF";

std::string ChecksumText(std::string_view body) {
  const uint8_t checksum = NmeaChecksum(body);
  return {kHexDigits[checksum >> 4], kHexDigits[checksum & 0xF]};
}

char UpperHex(char digit) {
  return digit >= 'a' && digit <= 'f' ? static_cast<char>(digit - 'a' + 'A') : digit;
}

bool MayStandInABody(char letter) {
  return letter >= ' ' && letter <= '~' && letter != '$' && letter != '*';
}

bool IsBody(std::string_view text) {
  return std::all_of(text.begin(), text.end(), MayStandInABody);
}

}  // namespace

uint8_t NmeaChecksum(std::string_view body) {
  uint8_t checksum = 0;
  for (const char letter : body) checksum ^= static_cast<uint8_t>(letter);
  return checksum;
}

std::string NmeaSentence(std::string_view body) {
  SHOAL_CHECK(body.find_first_of("$*\r\n") == body.npos, "an NMEA body has no '$', '*', CR or LF");
  return "$" + std::string(body) + "*" + ChecksumText(body) + "\r\n";
}

std::optional<NmeaFields> ParseNmea(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (!line.starts_with('$')) return std::nullopt;
  line.remove_prefix(1);

  NmeaFields sentence;
  const size_t star = line.find('*');
  const std::string_view body = line.substr(0, star);
  if (!IsBody(body)) return std::nullopt;
  if (star != line.npos) {
    std::string given(line.substr(star + 1));
    std::transform(given.begin(), given.end(), given.begin(), UpperHex);
    if (given != ChecksumText(body)) return std::nullopt;
    sentence.has_checksum = true;
  }

  size_t comma = body.find(',');
  sentence.address = body.substr(0, comma);
  if (sentence.address.empty()) return std::nullopt;
  while (comma != body.npos) {
    const size_t begin = comma + 1;
    comma = body.find(',', begin);
    sentence.fields.emplace_back(body.substr(begin, comma - begin));
  }
  return sentence;
}

}  // namespace shoal
