// Counters of fates per link: what each vehicle received from each other one so far, and the last
// fate.
//
//   LinkBook book({"alpha", "bravo"});
//   for (const FateView& fate : message.all()) book.Add(fate);
//   const LinkCounts* link = book.Find(0, 1);    // alpha to bravo
//
// Cheap to copy: 320 bytes for each link that had fates; copies share the names.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/view/fate_facts.h"
#include "lib/tools/view/name_table.h"

namespace shoal {

/// One ordered pair of vehicles. Counters saturate.
struct LinkCounts {
  int32_t from = -1;  ///< Index of a name.
  int32_t to = -1;
  std::array<uint32_t, kNumKinds> offered = {};   ///< By kind.
  std::array<uint32_t, kNumKinds> received = {};  ///< By kind: delivered, whole or damaged.
  std::array<uint32_t, kNumCauses> by_cause = {};
  int64_t last_received_utime =
      kNeverReceived;  ///< Of the last step in which something was received.
  FateFacts last;      ///< The last fate of all.

  static constexpr int64_t kNeverReceived = -kFarthest_us - 1;
  uint64_t Offered() const;
  uint64_t Received() const;
};

/// Where a fate was counted; -1: no link.
struct LinkPlace {
  int32_t from = -1;
  int32_t to = -1;
  int32_t link = -1;  ///< Index in LinkBook::links().
};

class LinkBook {
 public:
  /// At most this many names are added to the first ones, and this many links kept; fates of others
  /// count as elsewhere.
  static constexpr size_t kMaxUnregistered = 200;
  static constexpr size_t kMaxLinks = 20'000;

  LinkBook() : LinkBook(std::vector<std::string>()) {}
  explicit LinkBook(const std::vector<std::string>& vehicles);

  /// Counts a fate `count` times, for its link or elsewhere.
  LinkPlace Add(const FateView& fate);
  /// Adds what COMMS_MEDIA has of a fate, where that is the last of its link.
  void AddMedium(const FateView& medium);
  /// Counts fates of unknown kind or cause.
  void AddStrange(int64_t count) { num_strange_ += count; }

  /// The vehicles that it was made with, then others in order of appearance.
  const NameTable& names() const { return *names_; }
  /// In order of appearance.
  std::span<const LinkCounts> links() const { return links_; }
  /// Returns the link's counters, or nullptr where it has had no fate, or there is no such name.
  const LinkCounts* Find(int32_t from, int32_t to) const;

  /// The sum of all counts: num_fates = those of links + num_elsewhere. Strange ones are in none.
  int64_t num_fates() const { return num_fates_; }
  int64_t num_elsewhere() const { return num_elsewhere_; }  ///< To "", "*", or too many.
  int64_t num_strange() const { return num_strange_; }

 private:
  friend class IndexArchive;  ///< kept_index.cc, which writes and reads all of it.

  /// Returns the name's index; adds it where it is legal and there is room. -1: neither.
  int32_t PlaceOf(std::string_view name);
  int32_t LinkOf(int32_t from, int32_t to);
  void GrowTable();

  std::shared_ptr<const NameTable> names_;
  size_t num_first_ = 0;  ///< Names that it was made with.
  size_t table_width_ = 0;
  std::vector<int32_t> table_;  ///< Link of from * table_width_ + to, or -1.
  std::vector<LinkCounts> links_;
  int64_t num_fates_ = 0;
  int64_t num_elsewhere_ = 0;
  int64_t num_strange_ = 0;
};

}  // namespace shoal
