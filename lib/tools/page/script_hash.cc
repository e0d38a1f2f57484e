#include "lib/tools/page/script_hash.h"

#include <sodium.h>

#include <array>

#include "lib/tools/page/base64.h"

namespace shoal {

std::string ScriptHash(std::string_view script) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(script.data()),
                     script.size());
  const std::string_view bytes(reinterpret_cast<const char*>(hash.data()), hash.size());
  return "'sha256-" + Base64(bytes) + "'";
}

}  // namespace shoal
