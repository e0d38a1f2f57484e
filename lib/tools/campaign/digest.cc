#include "lib/tools/campaign/digest.h"

#include <fmt/format.h>
#include <sodium.h>

#include <array>

#include "lib/base/check/check.h"

namespace shoal {

Digest::Digest() {
  static const int is_ready = sodium_init();
  SHOAL_CHECK(is_ready >= 0, "libsodium works on this machine");
}

Digest& Digest::Add(std::string_view part) {
  parts_ += fmt::format("{}:", part.size());
  parts_ += part;
  return *this;
}

std::string Digest::Hex(size_t num_digits) const {
  constexpr size_t kSize = 32;
  SHOAL_CHECK(num_digits >= 1 && num_digits <= 2 * kSize, "a digest has 64 digits");
  std::array<unsigned char, kSize> bytes{};
  crypto_generichash(bytes.data(), bytes.size(),
                     reinterpret_cast<const unsigned char*>(parts_.data()), parts_.size(), nullptr,
                     0);
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  text.resize(num_digits);
  return text;
}

}  // namespace shoal
