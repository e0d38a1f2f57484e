// Who hears whom: takes node reports in, remembers each vehicle's last, and gives every report its
// fate at every other known vehicle.
//
//   Router router(rules, {"alpha", "bravo"});
//   const Admission admission = router.Admit(report, utime);       // all reports of the step
//   first, if (!admission.refused) {                                      // so that both ends of a
//   link are
//     router.Route(admission, report.position_m, utime, &fates);   // where they are now
//   }
//   router.ForgetSilent(utime);
//
// fates = admitted reports x other known vehicles + refused reports, always.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/routing/contact.h"
#include "lib/routing/fate.h"
#include "lib/routing/rules.h"

namespace shoal {

/// What the rules ask about a node report.
struct ReportFacts {
  std::string_view name;
  std::string_view group;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
};

/// What intake said to a report.
struct Admission {
  std::optional<Cause> refused;  ///< Absent: admitted.
  int32_t source = kNobody;      ///< kNobody where refused and not known.
  int64_t number = 0;            ///< Of the report.
};

class Router {
 public:
  /// So many vehicles that are not of the mission are remembered at a time: made-up names must
  /// not fill the memory, nor squeeze out the mission's own vehicles.
  static constexpr int kMaxStrangers = 1000;

  /// @pre `vehicles`: the mission's, legal names of different keys.
  Router(const RoutingRules& rules, std::span<const std::string> vehicles);

  /// The rules hold from the next decision on. The forget time stays when the stale time changes.
  RoutingRules& rules() { return rules_; }
  const RoutingRules& rules() const { return rules_; }

  /// Takes a report in. Its sender is known from now on and is where the report says. Refuses
  /// illegal names and positions that are not finite, which leave all else as it was.
  Admission Admit(const ReportFacts& report, int64_t utime);

  /// Counts a report of `name` that the caller found invalid for a reason of its own.
  Admission Refuse(std::string_view name);

  /// Appends the fate of an admitted report at each other known vehicle, in order of keys.
  /// @pre !admission.refused; no ForgetSilent came between.
  void Route(const Admission& admission, const Eigen::Vector3d& position_m, int64_t utime,
             std::vector<Decision>* decisions);

  /// Forgets who has been silent for the forget time. Their counts and numbers stay. Appends their
  /// indices to `forgotten`, where given.
  void ForgetSilent(int64_t utime, std::vector<int32_t>* forgotten = nullptr);

  /// Returns the contact of this index, as long as it has not been replaced by another stranger.
  const Contact& contact(int32_t index) const { return *by_index_[static_cast<size_t>(index)]; }
  /// All contacts by key, known or not.
  const std::map<std::string, Contact, std::less<>>& contacts() const { return contacts_; }

  int num_known() const { return num_known_; }
  /// Reports taken in so far, those of vehicles that are gone included.
  int64_t num_admitted() const { return num_admitted_; }
  /// All fates so far by cause, those of refused reports included.
  const CauseCounts& counts() const { return counts_; }

 private:
  Contact* FindOrAdd(std::string_view name);
  bool MakeRoomForAStranger();
  Admission RefuseBecause(Cause cause, Contact* source);

  RoutingRules rules_;
  std::map<std::string, Contact, std::less<>> contacts_;
  std::vector<Contact*> by_index_;
  std::vector<int32_t> free_indices_;
  int num_known_ = 0;
  int64_t num_admitted_ = 0;
  int num_strangers_ = 0;  ///< Contacts not of the mission, known or forgotten.
  int num_forgotten_strangers_ = 0;
  int64_t num_refused_unknown_ = 0;  ///< Numbers the refused reports of unknown senders.
  CauseCounts counts_ = {};
};

}  // namespace shoal
