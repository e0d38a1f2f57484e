// Reads the members of an encoded LCM message in place, and never beyond its end.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace shoal {

class WireReader {
 public:
  explicit WireReader(std::span<const uint8_t> data) : next_(data.data()), left_(data.size()) {}

  /// False after a read beyond the end; all reads after it return 0 or an empty text.
  bool ok() const { return ok_; }
  bool at_end() const { return left_ == 0; }
  size_t num_left() const { return left_; }

  int64_t Int64() { return static_cast<int64_t>(Word<uint64_t>()); }
  int32_t Int32() { return static_cast<int32_t>(Word<uint32_t>()); }
  int16_t Int16() { return static_cast<int16_t>(Word<uint16_t>()); }
  bool Boolean() { return Word<uint8_t>() != 0; }
  double Double() { return std::bit_cast<double>(Word<uint64_t>()); }
  /// Returns the text without its closing zero, which must be the only one.
  std::string_view Text() {
    const int32_t size = Int32();
    if (size < 1 || static_cast<size_t>(size) > left_) {
      Fail();
      return {};
    }
    const std::string_view text(reinterpret_cast<const char*>(next_),
                                static_cast<size_t>(size) - 1);
    if (std::memchr(next_, 0, static_cast<size_t>(size)) != next_ + size - 1) {
      Fail();
      return {};
    }
    Skip(static_cast<size_t>(size));
    return text;
  }
  /// Returns the length of an array whose elements take at least `least_bytes` each.
  size_t Count(size_t least_bytes) {
    const int32_t count = Int32();
    if (count < 0 || static_cast<size_t>(count) > left_ / least_bytes) {
      Fail();
      return 0;
    }
    return static_cast<size_t>(count);
  }

 private:
  template <class T>
  T Word() {
    if (left_ < sizeof(T)) {
      Fail();
      return 0;
    }
    T word;
    std::memcpy(&word, next_, sizeof(T));
    Skip(sizeof(T));
    if constexpr (std::endian::native == std::endian::little) {
      if constexpr (sizeof(T) == 8) {
        word = __builtin_bswap64(word);
      } else if constexpr (sizeof(T) == 4) {
        word = __builtin_bswap32(word);
      } else if constexpr (sizeof(T) == 2) {
        word = __builtin_bswap16(word);
      }
    }
    return word;
  }
  void Skip(size_t size) {
    next_ += size;
    left_ -= size;
  }
  void Fail() {
    ok_ = false;
    left_ = 0;
  }

  const uint8_t* next_;
  size_t left_;
  bool ok_ = true;
};

}  // namespace shoal
