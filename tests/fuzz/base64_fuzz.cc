// Any text as base64: what is read is written again as it was.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lib/base/check/check.h"
#include "lib/base/codec/base64.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto bytes = shoal::DecodeBase64(text)) {
    SHOAL_CHECK(shoal::Base64(*bytes).starts_with(text), "each byte string has one text");
  }
  SHOAL_CHECK(shoal::DecodeBase64(shoal::Base64({data, size})).value().size() == size,
              "what is written is read");
  return 0;
}
