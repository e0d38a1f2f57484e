// Decides what is for all: node reports and packets, from the source to each other vehicle that
// takes part. With more known vehicles than `each_fate_up_to`, it looks only at those that the
// rules' reach can include, and counts the others together, where the rules can be counted so; but
// for packets by truth, which have a fate each.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/comms/routing/contact_book.h"
#include "lib/comms/routing/decide.h"
#include "lib/comms/routing/fate_ledger.h"
#include "lib/comms/routing/reach_grid.h"
#include "lib/comms/routing/rules.h"

namespace shoal {

class BroadcastRouter {
 public:
  /// All must outlive this.
  BroadcastRouter(const RoutingRules& rules, ContactBook& contacts, FateLedger& ledger)
      : rules_(rules), contacts_(contacts), ledger_(ledger) {}

  /// Appends the fate at each other vehicle that takes part, in order of keys; those that are
  /// counted together come last.
  void Route(const Transmission& sent, Contact* source, int64_t utime,
             std::vector<Decision>* decisions);

  // What has changed since the last Route:
  void OnRules();
  void OnFactors() { grid_is_valid_ = false; }
  void OnReport(const Contact& contact);
  void OnForgotten(const Contact& contact);
  /// From now on places of vehicles in truth are known.
  void OnTruth() { has_truth_ = true; }

 private:
  /// Receivers at which everything is stopped before the range is asked for, by cause.
  struct StoppedCounts {
    int64_t utime = kNever;  ///< When they were counted; kNever: not valid.
    CauseCounts counts = {};
  };

  void RouteNear(const Transmission& sent, Contact* source, int64_t utime,
                 std::vector<Decision>* decisions);
  void DecideOne(const Transmission& sent, Contact* source, Contact* receiver, int64_t utime,
                 std::vector<Decision>* decisions);
  void ForgetStopped();
  const CauseCounts& CountStopped(Kind kind, int64_t utime);
  void FindNear(const Transmission& sent, const Contact& source, double reach_m);
  void PrepareGrid();

  const RoutingRules& rules_;
  RoutingRules rules_without_range_;  ///< For transmissions that have no range rule.
  ContactBook& contacts_;
  FateLedger& ledger_;

  ReachGrid grid_;
  bool grid_is_valid_ = false;
  double max_earange_ = 1;
  bool has_truth_ = false;  ///< Packets go by other positions than those of grid_.
  std::array<StoppedCounts, kNumKinds> stopped_;
  std::vector<int32_t> near_;  ///< Kept for its memory, like the next.
  std::vector<Decision> far_fates_;
};

}  // namespace shoal
