// For tests: sends reports and messages through a router and returns their fates by name.
//
//   TestFleet fleet({.comms_range_m = 250});
//   fleet.Report("alpha", {0, 0, 0});
//   EXPECT_EQ(fleet.Report("bravo", {249, 0, 0}).at("alpha").cause, Cause::kDelivered);
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/time/time_units.h"
#include "lib/comms/routing/router.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

/// Fates by the destination's name; "*" stands for others, "" for no vehicle.
using Fates = std::map<std::string, Decision>;

class TestFleet {
 public:
  explicit TestFleet(const RoutingRules& rules = {}, uint64_t seed = 1,
                     const std::vector<std::string>& vehicles = {"alpha", "bravo", "charlie"})
      : router(rules, seed, vehicles) {}

  /// Admits and routes a report. The fate of a refused one is under "".
  Fates Report(std::string_view name, const Eigen::Vector3d& position_m,
               std::string_view group = {}) {
    const ReportFacts facts = {.name = name, .group = group, .position_m = position_m};
    const Admission admission = router.Admit(facts, utime);
    std::vector<Decision> decisions;
    if (admission.refused) {
      decisions.push_back(
          {.source = admission.source, .number = admission.number, .cause = *admission.refused});
    } else {
      router.Route(admission, utime, &decisions);
    }
    return ByName(decisions, {});
  }

  Fates Message(const MessageFacts& message) {
    std::vector<Decision> decisions;
    std::vector<std::string> unknown_names;
    router.RouteMessage(message, utime, &decisions, &unknown_names);
    return ByName(decisions, unknown_names);
  }

  Fates Message(std::string_view source, std::string_view dest_node) {
    return Message({.source = source, .dest_node = dest_node});
  }

  Decision Ack(std::string_view source, std::string_view destination, bool is_sound = true) {
    std::vector<Decision> decisions;
    std::vector<std::string> unknown_names;
    const AckFacts ack = {.source = source, .destination = destination, .is_sound = is_sound};
    router.RouteAck(ack, utime, &decisions, &unknown_names);
    return decisions.at(0);
  }

  const Contact& At(std::string_view name) const {
    for (const Contact* contact : router.contacts()) {
      if (contact->key == VehicleKey(name)) return *contact;
    }
    static const Contact kNone;
    return kNone;
  }

  void ChangeRules(void (*change)(RoutingRules*)) {
    RoutingRules rules = router.rules();
    change(&rules);
    router.SetRules(rules);
  }

  Fates ByName(const std::vector<Decision>& decisions,
               const std::vector<std::string>& unknown_names) const {
    Fates fates;
    for (const Decision& decision : decisions) {
      std::string name;
      if (decision.destination >= 0) {
        name = router.contact(decision.destination).name;
      } else if (decision.destination == kOthers) {
        name = "*";
      } else if (decision.unknown_name >= 0) {
        name = unknown_names.at(static_cast<size_t>(decision.unknown_name));
      }
      // Two fates of one destination must not look like one.
      while (fates.contains(name)) name += "+";
      fates.emplace(name, decision);
    }
    return fates;
  }

  Router router;
  int64_t utime = 0;
};

inline int64_t CountOf(const CauseCounts& counts, Cause cause) {
  return counts[static_cast<size_t>(cause)];
}

inline int64_t Total(const CauseCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), int64_t{0});
}

}  // namespace shoal
