// Counts fates of one kind by link and cause, for a mission's verdict and for its link matrix.
//
//   FateCounts counts({"alpha", "bravo"});
//   counts.Add("alpha", "bravo", "out_of_range");
//   counts.Count(0, FateCounts::kAll, "out_of_range");   // 1
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lib/base/codec/little_endian.h"
#include "lib/comms/routing/sparse_row.h"

namespace shoal {

class FateCounts {
 public:
  /// Stands for every vehicle, those outside the mission included.
  static constexpr int kAll = -1;

  explicit FateCounts(const std::vector<std::string>& vehicles);

  /// Counts a fate of `count` destinations; nothing where that is less than 1. Names without regard
  /// to case; vehicles that are not of the mission, no vehicle, and those that a fate gives
  /// together ("*") count as one and the same other.
  void Add(std::string_view source, std::string_view destination, std::string_view cause,
           int32_t count = 1);

  /// Returns how many fates of this cause the link had; vehicles by their place in the
  /// constructor's list, or kAll.
  int64_t Count(int source, int destination, std::string_view cause) const;
  /// The same over all causes: the link's offered transmissions.
  int64_t CountOffered(int source, int destination) const;

  /// All fates by cause, "delivered" among them.
  std::map<std::string, int64_t> Totals() const;

  /// Appends all counts.
  void AppendTo(std::vector<uint8_t>* bytes) const;
  /// Adds what counts of the same vehicles have appended. Returns false where it is damaged.
  [[nodiscard]] bool AddFrom(LittleEndianReader* reader);

 private:
  struct TextHash {
    using is_transparent = void;
    size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };
  /// One cause's counts, with sums: a large fleet has few of its links, and many vehicles to list.
  struct CauseCount {
    std::string cause;
    int64_t total = 0;
    std::vector<int64_t> by_source = {};
    std::vector<int64_t> by_destination = {};
    std::vector<SparseRow<int64_t, 0>> by_link = {};  ///< By source, then destination.
  };

  size_t PlaceOf(std::string_view name) const;
  static void Add(size_t from, size_t to, int64_t count, CauseCount* counted);
  CauseCount& FindOrAdd(std::string_view cause);
  int64_t Sum(const CauseCount& count, int source, int destination) const;

  size_t num_places_;  ///< The mission's vehicles, and one for all others.
  std::unordered_map<std::string, size_t, TextHash, std::equal_to<>> places_;  ///< By key.
  std::vector<CauseCount> counts_;  ///< In order of appearance.
};

}  // namespace shoal
