// How every link of a mission did: sent, delivered, lost and why, and how long it took.
//
//   LinkStatistics links;
//   for (const fate_t& fate : fates) links.Add(fate);
//   print(links.Text(50));
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "shoal/fate_t.hpp"

namespace shoal {

/// What became of what one vehicle sent to another. sent = delivered + damaged + the sum of `lost`.
struct LinkOutcome {
  int64_t sent = 0;       ///< With a fate: not what was in transit when the log ended.
  int64_t delivered = 0;  ///< As it was sent.
  int64_t damaged = 0;    ///< Handed over with wrong bits.
  std::map<std::string, int64_t, std::less<>> lost;  ///< By the cause in COMMS_FATES.
  /// From the first byte sent to the last byte received, of acoustic traffic that was handed over;
  /// in no order.
  std::vector<double> delays_s;

  [[nodiscard]] int64_t NumLost() const { return sent - delivered - damaged; }
};

class LinkStatistics {
 public:
  /// Kind as its number in fate_kinds.h, source, destination.
  using Key = std::tuple<int, std::string, std::string>;

  /// Adds `count` of the fate to its cause; ignores a fate whose count is less than 1.
  void Add(const fate_t& fate);

  const std::map<Key, LinkOutcome>& links() const { return links_; }
  /// Delays that no packet has: not finite, negative, or of more than a day. Left out.
  int64_t num_impossible() const { return num_impossible_; }

  /// Returns a table of each kind, its totals first. Of more than `max_links` links those that lost
  /// the greatest share are shown, and the rest is counted.
  [[nodiscard]] std::string Text(size_t max_links) const;

  /// Return tables for other programs: a line for each link; a line for each link and cause of
  /// loss.
  [[nodiscard]] std::string LinksCsv() const;
  [[nodiscard]] std::string LossesCsv() const;

 private:
  std::map<Key, LinkOutcome> links_;
  int64_t num_impossible_ = 0;
};

/// Returns the smallest of `values` that at least this share of them does not exceed (the nearest
/// rank). @pre values are not empty, and 0 < share <= 1
[[nodiscard]] double Percentile(std::vector<double> values, double share);

}  // namespace shoal
