// Things that keep their index; the place of one that is gone is used again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shoal {

template <class Place>
class Places {
 public:
  /// Returns the index of a free place, with what its last user left there, or of a new one.
  int32_t Take() {
    if (free_.empty()) {
      places_.emplace_back();
      return static_cast<int32_t>(places_.size() - 1);
    }
    const int32_t index = free_.back();
    free_.pop_back();
    return index;
  }
  void Free(int32_t index) { free_.push_back(index); }

  Place& operator[](int32_t index) { return places_[static_cast<size_t>(index)]; }
  const Place& operator[](int32_t index) const { return places_[static_cast<size_t>(index)]; }

  size_t num_places() const { return places_.size(); }  ///< Used and free.
  size_t num_used() const { return places_.size() - free_.size(); }

 private:
  std::vector<Place> places_;
  std::vector<int32_t> free_;
};

}  // namespace shoal
