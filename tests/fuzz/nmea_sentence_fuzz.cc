// Any bytes as an NMEA sentence: what is read is written again and read as the same.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lib/base/check/check.h"
#include "lib/base/codec/nmea_sentence.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  const auto sentence = shoal::ParseNmea(line);
  if (!sentence) return 0;
  std::string body = sentence->address;
  for (const std::string& field : sentence->fields) body += "," + field;
  const auto again = shoal::ParseNmea(shoal::NmeaSentence(body));
  SHOAL_CHECK(again && again->has_checksum, "a sentence of what was read is a sentence");
  SHOAL_CHECK(again->address == sentence->address && again->fields == sentence->fields,
              "the written sentence parses to the same");
  return 0;
}
