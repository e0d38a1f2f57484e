// How many decisions of each cause every link had: as recorded, and as they are now.
//
//   LinkTable table;
//   for (const fate_t& fate : recorded) table.AddRecorded(fate);
//   for (const fate_t& fate : now) table.AddNow(fate);
//   print(table.Text(LinkTable::kAllLinks));
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "shoal/fate_t.hpp"

namespace shoal {

class LinkTable {
 public:
  /// For Text: no link is left out.
  static constexpr size_t kAllLinks = SIZE_MAX;

  struct Change {
    int64_t recorded = 0;
    int64_t now = 0;

    bool operator==(const Change&) const = default;
  };

  /// Add `count` of the fate to its cause; ignore a fate whose count is less than 1.
  void AddRecorded(const fate_t& fate);
  void AddNow(const fate_t& fate);

  /// Returns the numbers of one link and cause; names as COMMS_FATES writes them.
  Change Of(std::string_view kind, std::string_view source, std::string_view destination,
            std::string_view cause) const;

  /// Returns the table, one block for each kind with its totals first. Where there are more than
  /// `max_links` links, those without a difference are left out, and counted. Without a recorded
  /// column where `has_recorded` is false.
  std::string Text(size_t max_links, bool has_recorded = true) const;

 private:
  /// Kind, source, destination, cause.
  using Key = std::tuple<int, std::string, std::string, std::string>;

  Change& Find(const fate_t& fate);

  std::map<Key, Change> changes_;
};

}  // namespace shoal
