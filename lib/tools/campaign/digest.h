// A short name of what a text holds (BLAKE2b, RFC 7693).
#pragma once

#include <string>
#include <string_view>

namespace shoal {

class Digest {
 public:
  Digest();

  /// Adds a part; ("ab", "c") and ("a", "bc") have different digests.
  Digest& Add(std::string_view part);

  /// Returns the first `num_digits` hexadecimal digits. @pre 1 <= num_digits <= 64
  [[nodiscard]] std::string Hex(size_t num_digits) const;

 private:
  std::string parts_;
};

}  // namespace shoal
