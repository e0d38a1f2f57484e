// What became of the acoustic messages of a swarm at their receivers: how many were applied as
// they came, repaired, or refused, by SWARM_<V>.
//
//   SwarmTally tally;
//   for (const swarm_t& swarm : messages) tally.Add(swarm);
//   print(tally.Text(50));
//
// SWARM_<V> counts from the beginning of its process. A process that was started again counts from
// 0 again; the tally goes on.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "shoal/swarm_t.hpp"

namespace shoal {

struct SourceCount {
  int64_t received = 0;  ///< = clean + recovered + rejected, in a consistent log.
  int64_t clean = 0;
  int64_t recovered = 0;
  int64_t rejected = 0;

  bool operator==(const SourceCount&) const = default;
};

class SwarmTally {
 public:
  /// Receiver and source.
  using Pair = std::pair<std::string, std::string>;
  /// Receiver, "recovered" or "rejected", field, strategy or reason.
  using Event = std::tuple<std::string, std::string, std::string, std::string>;

  void Add(const swarm_t& swarm);

  [[nodiscard]] std::map<Pair, SourceCount> Sources() const;
  [[nodiscard]] std::map<Event, int64_t> Events() const;
  /// Messages with counts that cannot be: negative, or beyond all missions. Left out.
  int64_t num_impossible() const { return num_impossible_; }

  /// Returns a table of receivers and sources, totals first, and one of what was repaired how and
  /// refused why, by all receivers. Of more than `max_pairs` pairs those with the smallest share of
  /// clean messages are shown, and the rest is counted. Empty where nothing was counted.
  [[nodiscard]] std::string Text(size_t max_pairs) const;

  /// Return tables for other programs: a line for each receiver and source; a line for each
  /// receiver and event.
  [[nodiscard]] std::string SourcesCsv() const;
  [[nodiscard]] std::string EventsCsv() const;

 private:
  /// What one process counted.
  struct Counts {
    int64_t num_published = 0;
    std::map<std::string, SourceCount> sources;
    std::map<std::tuple<std::string, std::string, std::string>, int64_t> events;
  };
  struct Receiver {
    Counts before;  ///< By processes that have ended.
    Counts last;    ///< By the one that runs.
  };

  static void AddTo(const Counts& counts, Counts* sum);

  std::map<std::string, Receiver> receivers_;
  int64_t num_impossible_ = 0;
};

}  // namespace shoal
