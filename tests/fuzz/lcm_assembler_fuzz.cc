// LCM's datagrams as they come from the network. The first byte of each numbers its sender, the
// next two state its length.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lib/base/check/check.h"
#include "lib/bus/bus/lcm_assembler.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::span<const uint8_t> rest(data, size);
  shoal::LcmAssembler assembler;
  uint64_t sum = 0;
  while (rest.size() > 3) {
    const uint64_t sender = rest[0] % 4;
    const size_t length = std::min<size_t>(size_t{rest[1]} << 8 | rest[2], rest.size() - 3);
    if (const auto message = assembler.Add(sender, rest.subspan(3, length))) {
      SHOAL_CHECK(
          !message->channel.empty() && message->channel.size() <= shoal::LcmAssembler::kMaxChannel,
          "a channel has 1 to 63 bytes");
      for (const uint8_t byte : message->data) sum += byte;  // A sanitizer sees it.
      for (const char byte : message->channel) sum += static_cast<uint8_t>(byte);
    }
    SHOAL_CHECK(assembler.num_pending() <= shoal::LcmAssembler::kMaxPending,
                "messages are bounded");
    rest = rest.subspan(3 + length);
  }
  return sum == UINT64_MAX ? 1 : 0;
}
