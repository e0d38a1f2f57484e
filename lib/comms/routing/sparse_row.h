// Values by index, of which few differ from the rest: a vehicle of a large fleet meets its
// neighbours alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shoal {

/// Reads as kRest wherever nothing was set; has memory for the surroundings of what was.
template <class T, T kRest>
class SparseRow {
 public:
  T Get(size_t index) const {
    const size_t page = PageOf(index);
    return page == 0 ? kRest : pages_[page - 1][index % kPageSize];
  }

  /// Returns the value, to be changed before the next call.
  T& At(size_t index) {
    if (PageOf(index) == 0) {
      if (index / kPageSize >= directory_.size()) directory_.resize(index / kPageSize + 1);
      pages_.emplace_back().fill(kRest);
      directory_[index / kPageSize] = static_cast<uint32_t>(pages_.size());
    }
    return pages_[PageOf(index) - 1][index % kPageSize];
  }

  /// Calls `visit(index, value)` for each value that is not kRest, in order of indices.
  template <class Visit>
  void ForEach(Visit visit) const {
    for (size_t place = 0; place < directory_.size(); ++place) {
      if (directory_[place] == 0) continue;
      const std::array<T, kPageSize>& page = pages_[directory_[place] - 1];
      for (size_t i = 0; i < kPageSize; ++i) {
        if (page[i] != kRest) visit(place * kPageSize + i, page[i]);
      }
    }
  }

  /// Sets the value back to kRest.
  void Reset(size_t index) {
    const size_t page = PageOf(index);
    if (page != 0) pages_[page - 1][index % kPageSize] = kRest;
  }

  void Clear() {
    directory_.clear();
    pages_.clear();
  }

 private:
  static constexpr size_t kPageSize = 32;

  /// Counts from 1; 0: there is none.
  size_t PageOf(size_t index) const {
    const size_t place = index / kPageSize;
    return place < directory_.size() ? directory_[place] : 0;
  }

  std::vector<uint32_t> directory_;
  std::vector<std::array<T, kPageSize>> pages_;  ///< In order of their first use.
};

}  // namespace shoal
