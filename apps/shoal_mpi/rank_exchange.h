// Rounds in which every rank of an MPI job gives every other rank one batch of bytes.
//
//   Result<std::unique_ptr<RankExchange>> joined = RankExchange::Join({.give_up_after_s = 60});
//   ...
//   outgoing[1] = bytes;
//   if (const auto lost = exchange.Round("step 12", outgoing, &incoming)) return Fail(*lost);
//   Use(incoming[1]);
//
// A rank that is waited for is named on standard error, after a second by default: it is slow, or
// stopped, or gone. One that is gone, or that does not come at all, ends the round.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/bus.h"

namespace shoal {

struct RankExchangeOptions {
  double name_after_s = 1;      ///< A rank that is waited for is named after this wall time, ...
  double give_up_after_s = 60;  ///< ... and given up after this.
  /// Asked while waiting: true where a signal has asked this process to end.
  std::function<bool()> is_interrupted = [] { return false; };
};

/// Where a rank runs, for the errors that name it.
struct RankPlace {
  std::string host;
  pid_t pid = 0;
};

class RankExchange {
 public:
  /// Of this rank, since it joined or ResetTotals().
  struct Totals {
    double wait_s = 0;  ///< Wall time within Round().
    int64_t bytes_sent = 0;
  };

  /// Joins the MPI job that this process was started in. @pre no other RankExchange
  explicit RankExchange(RankExchangeOptions options);
  /// Leaves the job, together with all ranks; after End() at once.
  ~RankExchange();
  RankExchange(const RankExchange&) = delete;
  RankExchange& operator=(const RankExchange&) = delete;

  size_t rank() const { return rank_; }
  size_t num_ranks() const { return num_ranks_; }

  /// Returns "rank 1 (host n1, process 123)". @pre SetPlaces() was called
  std::string NameOf(size_t rank) const;
  void SetPlaces(std::vector<RankPlace> places);
  const std::vector<RankPlace>& places() const { return places_; }

  /// Gives outgoing[p] to each other rank p and returns what that gave in incoming[p]; incoming of
  /// this rank is empty. All ranks call it for the same `what`, which errors name ("step 12").
  /// The error names the ranks that are lost, and no further round is possible then.
  std::optional<Error> Round(const std::string& what,
                             std::span<const std::span<const uint8_t>> outgoing,
                             std::vector<Bytes>* incoming);

  /// Ends the job with this exit code, all ranks. Does not return.
  [[noreturn]] void Abort(int exit_code);

  const Totals& totals() const { return totals_; }
  void ResetTotals() { totals_ = {}; }

 private:
  struct Requests;
  bool Advance(Requests* requests, std::vector<Bytes>* incoming);
  std::vector<size_t> Gone(const std::vector<size_t>& waited_for) const;
  std::string NamesOf(const std::vector<size_t>& ranks) const;
  bool IsFirstToWait(const std::vector<size_t>& waited_for) const;

  const RankExchangeOptions options_;
  double next_name_after_s_ =
      0;               ///< Doubled each time, so that a slow mission is not all warnings.
  double spin_s_ = 0;  ///< Waits so long before it lets others have the core.
  size_t rank_ = 0;
  size_t num_ranks_ = 1;
  std::vector<RankPlace> places_;
  Totals totals_;
};

}  // namespace shoal
