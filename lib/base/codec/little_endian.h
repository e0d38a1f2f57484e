// Numbers as bytes, the least significant first, whatever the machine.
//
//   std::vector<uint8_t> bytes;
//   AppendLittleEndian<uint32_t>(7, &bytes);
//   AppendLittleEndian<float>(1.5F, &bytes);
//
//   LittleEndianReader reader(bytes);
//   const auto id = reader.Take<uint32_t>();          // 7
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/check.h"

namespace shoal {

static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == 4);

template <class Number>
void AppendLittleEndian(Number number, std::vector<uint8_t>* bytes) {
  std::array<uint8_t, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof number);
  if constexpr (std::endian::native == std::endian::big) {
    bytes->insert(bytes->end(), raw.rbegin(), raw.rend());
  } else {
    bytes->insert(bytes->end(), raw.begin(), raw.end());
  }
}

/// Appends a text behind its length.
inline void AppendSizedText(std::string_view text, std::vector<uint8_t>* bytes) {
  AppendLittleEndian(static_cast<uint32_t>(text.size()), bytes);
  bytes->insert(bytes->end(), text.begin(), text.end());
}

class LittleEndianReader {
 public:
  explicit LittleEndianReader(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  size_t num_left() const { return bytes_.size() - place_; }

  /// @pre num_left() >= sizeof(Number)
  template <class Number>
  Number Take() {
    SHOAL_CHECK(num_left() >= sizeof(Number), "at least sizeof(Number) bytes are left");
    std::array<uint8_t, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes_.data() + place_, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    place_ += sizeof(Number);
    Number number;
    std::memcpy(&number, raw.data(), sizeof number);
    return number;
  }

  /// The same for bytes that may be damaged: returns false if too few are left.
  template <class Number>
  [[nodiscard]] bool Take(Number* number) {
    if (num_left() < sizeof(Number)) return false;
    *number = Take<Number>();
    return true;
  }
  /// Takes what AppendSizedText appended. Returns false where it is not whole.
  [[nodiscard]] bool TakeSizedText(std::string* text) {
    uint32_t size = 0;
    if (!Take(&size) || num_left() < size) return false;
    const auto part = bytes_.subspan(place_, size);
    text->assign(part.begin(), part.end());
    place_ += size;
    return true;
  }

 private:
  std::span<const uint8_t> bytes_;
  size_t place_ = 0;
};

}  // namespace shoal
