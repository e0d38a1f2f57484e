#include "apps/netcdf_reader/classic_size.h"

#include <algorithm>
#include <array>
#include <vector>

#include "lib/bus/bus/big_endian.h"

namespace shoal {

namespace {

/// Sizes in bytes by nc_type, from NC_BYTE = 1 to NC_UINT64 = 11.
constexpr std::array<uint64_t, 12> kSizes = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
constexpr uint64_t kMax = uint64_t{1} << 60;  ///< Beyond any file: products stay below it.

uint64_t Padded(uint64_t bytes) { return (bytes + 3) / 4 * 4; }
uint64_t Product(uint64_t a, uint64_t b) { return a != 0 && b > kMax / a ? kMax : a * b; }

/// Reads a header from its start. After a fault all is 0.
class ClassicHeader {
 public:
  explicit ClassicHeader(std::span<const uint8_t> bytes) : rest_(bytes) {}

  std::optional<uint64_t> DataEnd() {
    const uint64_t magic = Take(4);
    version_ = magic & 0xFF;
    if (magic >> 8 != 0x434446 || (version_ != 1 && version_ != 2 && version_ != 5)) {
      return std::nullopt;
    }
    const uint64_t num_records = TakeCount();
    const bool is_open = num_records == (version_ == 5 ? ~uint64_t{0} : 0xFFFFFFFF);
    Each([this] {
      SkipName();
      lengths_.push_back(TakeCount());
    });
    SkipAttributes();
    Each([this] { TakeVariable(); });
    if (!ok_) return std::nullopt;
    if (is_open && record_bytes_ > 0) return 0;
    if (num_record_variables_ == 1) record_bytes_ = only_record_bytes_;
    for (const auto& [begin, bytes] : records_) {
      if (num_records == 0) break;
      NoteEnd(begin + Product(num_records - 1, record_bytes_) + bytes);
    }
    return end_;
  }

 private:
  struct Part {
    uint64_t begin = 0;
    uint64_t bytes = 0;
  };

  uint64_t Take(size_t count) {
    ok_ = ok_ && count <= rest_.size();
    if (!ok_) return 0;
    const uint64_t value = ReadBigEndian(rest_.first(count));
    rest_ = rest_.subspan(count);
    return value;
  }
  uint64_t TakeCount() { return Take(version_ == 5 ? 8 : 4); }
  void Skip(uint64_t bytes) {
    ok_ = ok_ && bytes <= rest_.size();
    if (ok_) rest_ = rest_.subspan(static_cast<size_t>(bytes));
  }
  void SkipName() { Skip(Padded(std::min(TakeCount(), kMax))); }
  void SkipAttributes() {
    Each([this] {
      SkipName();
      const uint64_t size = kSizes.at(std::min<uint64_t>(Take(4), kSizes.size() - 1));
      Skip(Padded(Product(TakeCount(), size)));
    });
  }
  /// Reads a list: a tag, the number of its parts, and the parts.
  template <class TakePart>
  void Each(const TakePart& take_part) {
    Take(4);
    for (uint64_t count = TakeCount(); ok_ && count > 0; --count) take_part();
  }

  void TakeVariable() {
    SkipName();
    uint64_t values = 1;
    bool has_records = false;
    const uint64_t rank = TakeCount();
    for (uint64_t i = 0; ok_ && i < rank; ++i) {
      const uint64_t dimension = TakeCount();
      ok_ = ok_ && dimension < lengths_.size();
      if (!ok_) return;
      if (i == 0 && lengths_[dimension] == 0) {
        has_records = true;
      } else {
        values = Product(values, lengths_[dimension]);
      }
    }
    SkipAttributes();
    const uint64_t type = Take(4);
    ok_ = ok_ && type < kSizes.size();
    TakeCount();  // Its size, which is wrong for large variables.
    const uint64_t begin = std::min(Take(version_ == 1 ? 4 : 8), kMax);
    if (!ok_) return;
    const uint64_t bytes = Product(values, kSizes.at(type));
    if (!has_records) return NoteEnd(begin + bytes);
    records_.push_back({.begin = begin, .bytes = bytes});
    record_bytes_ = std::min(record_bytes_ + Padded(bytes), kMax);
    only_record_bytes_ = bytes;  // One alone is not padded.
    ++num_record_variables_;
  }

  void NoteEnd(uint64_t end) { end_ = std::max(end_, end); }

  std::span<const uint8_t> rest_;
  bool ok_ = true;
  uint64_t version_ = 1;
  uint64_t end_ = 0;
  uint64_t record_bytes_ = 0;  ///< Of one record of all variables.
  uint64_t only_record_bytes_ = 0;
  int num_record_variables_ = 0;
  std::vector<uint64_t> lengths_;  ///< Of the dimensions; 0: that of the records.
  std::vector<Part> records_;      ///< The first record of each variable that has records.
};

}  // namespace

std::optional<uint64_t> ClassicDataEnd(std::span<const uint8_t> bytes) {
  return ClassicHeader(bytes).DataEnd();
}

}  // namespace shoal
