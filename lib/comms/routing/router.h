// Takes node reports in, remembers each vehicle's last, and gives every report, message, ack and
// packet its fate at every destination.
//
//   Router router(rules, mission.seed, {"alpha", "bravo"});
//
//   const Admission report = router.Admit(facts, utime);
//   if (!report.refused) router.Route(report, utime, &fates);
//
//   router.RouteMessage(message, utime, &fates, &unknown_names);
//
//   router.ForgetSilent(utime);
//
// All reports of a step are admitted before any is routed, so that each vehicle is where it is now.
//
// What goes over the acoustic network is not delivered once the rules have let it pass: it is in
// transit until the caller states what became of it:
//
//   router.Conclude(decision, "alpha", "bravo", Cause::kCollision);
//
// fates = admitted reports x other known vehicles + refused reports, always; and of messages: their
// destinations, or 1 where they have none. "Fates" counts Decision::count, and what is in transit.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/broadcast_router.h"
#include "lib/comms/routing/contact_book.h"
#include "lib/comms/routing/fate_ledger.h"
#include "lib/comms/routing/message_router.h"
#include "lib/comms/routing/rules.h"

namespace shoal {

/// What the rules ask about a node report.
struct ReportFacts {
  std::string_view name;
  std::string_view group = {};
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
};

/// The outcome of a report's intake.
struct Admission {
  std::optional<Cause> refused;  ///< Absent: admitted.
  int32_t source = kNoContact;   ///< kNoContact where refused and not known.
  int64_t number = 0;            ///< Of the report.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  std::string group_key;
};

/// What the rules ask about a packet for the acoustic network.
struct PacketFacts {
  std::string_view source;
  int64_t length_bytes = 0;
  int64_t length_limit_bytes = 0;
  bool is_sound = true;
  bool has_range_rule = true;  ///< False: comms_range, stealth and earange are not asked.
};

class Router {
 public:
  static constexpr int kMaxUnregistered = ContactBook::kMaxUnregistered;

  /// @pre `vehicles`: the mission's, legal names of different keys.
  Router(const RoutingRules& rules, uint64_t seed, std::span<const std::string> vehicles);
  Router(const Router&) = delete;
  Router& operator=(const Router&) = delete;

  const RoutingRules& rules() const { return rules_; }
  /// The rules hold from the next decision on.
  void SetRules(const RoutingRules& rules);

  /// Returns the factors of a vehicle, known or not, or nothing where there is no room for another
  /// unregistered vehicle, or the name is illegal.
  std::optional<LinkFactors> FindFactors(std::string_view name) const;
  /// Sets them, from the next decision on. Returns false where FindFactors returns nothing.
  bool SetFactors(std::string_view name, const LinkFactors& factors);

  /// From now on `name` receives the next report of each vehicle that is known, or of the mission,
  /// whatever the other rules decide, even where that vehicle is forgotten meanwhile and comes
  /// back. Returns false for a vehicle that is neither.
  bool RequestFullReports(std::string_view name);

  /// Takes a report in. Its sender is known from now on and is where the report puts it. Refuses
  /// illegal names, positions that are not finite and the ignored group; these leave all else as it
  /// was.
  Admission Admit(const ReportFacts& report, int64_t utime);

  /// From now on packets to and from this vehicle of the mission go by this position, whether it
  /// reports or not; all else stays with its reports. @pre finite
  void PlaceTruth(std::string_view name, const Eigen::Vector3d& position_m);

  /// Counts a report of `name` that the caller found invalid for a reason of its own.
  Admission Refuse(std::string_view name);

  /// Appends the fate of an admitted report at each other known vehicle, in order of keys; those
  /// that are not distinguished come last.
  /// @pre !report.refused; no ForgetSilent came between.
  void Route(const Admission& report, int64_t utime, std::vector<Decision>* decisions);

  /// From now on these vehicles of the mission are gateways: they receive every message and ack,
  /// whoever it is for.
  void SetGateways(std::span<const std::string> names) { messages_.SetGateways(names); }

  /// Appends the fates of a report of a member of `group` that a gateway forwards: as Route, of a
  /// transmission of the gateway from where that is, without min_rpt_interval and requests. Of a
  /// gateway that is not known: unknown source.
  void RouteForwarded(std::string_view gateway, std::string_view group, int64_t utime,
                      std::vector<Decision>* decisions);
  /// Appends the one fate of what a gateway does not forward.
  void RefuseForwarded(Kind kind, std::string_view gateway, Cause cause,
                       std::vector<Decision>* decisions);

  /// Appends the fates of a message: vehicles in order of keys, then names of no vehicle as
  /// written, which are appended to `unknown_names`. Asks in this order: invalid, too soon, too
  /// long, unknown source, then at each destination. A message that is not too soon
  /// restarts the source's interval, unless it is invalid.
  void RouteMessage(const MessageFacts& message, int64_t utime, std::vector<Decision>* decisions,
                    std::vector<std::string>* unknown_names);

  /// Appends the one fate of an ack. Asks: invalid, unknown source, then as a message.
  void RouteAck(const AckFacts& ack, int64_t utime, std::vector<Decision>* decisions,
                std::vector<std::string>* unknown_names);

  /// Appends the fates of a packet at each other vehicle that is known or whose place in truth is,
  /// in order of keys; those that are not distinguished come last. Asks: invalid, unknown source,
  /// too long, then at each destination.
  void RoutePacket(const PacketFacts& packet, int64_t utime, std::vector<Decision>* decisions);

  /// Gives a transmission that is in transit its fate, for the counts. Names, since either vehicle
  /// may have been replaced by another unregistered one meanwhile. Returns the decision with that
  /// cause.
  /// @pre pending.cause is kInTransit, and it was not concluded before.
  Decision Conclude(const Decision& pending, std::string_view source, std::string_view destination,
                    Cause cause);

  /// Forgets the vehicles that have been silent for the forget time: all but counts, numbers and
  /// factors. Appends their indices to `forgotten`, where given.
  void ForgetSilent(int64_t utime, std::vector<int32_t>* forgotten = nullptr);

  /// Returns the contact of this index, as long as it has not been replaced by another.
  const Contact& contact(int32_t index) const { return contacts_.at(index); }
  /// All contacts, known or not, in order of keys.
  std::span<const Contact* const> contacts() const { return contacts_.all(); }

  int num_known() const { return contacts_.num_known(); }
  int NumStale(int64_t utime) const;
  /// Reports taken in so far, those of vehicles that are gone included.
  int64_t num_admitted() const { return num_admitted_; }
  /// All fates so far by cause, those of refused transmissions included.
  const CauseCounts& counts(Kind kind) const { return ledger_.counts(kind); }
  /// Returns what is in transit, of all kinds.
  int64_t NumInTransit() const { return ledger_.NumInTransit(); }
  /// Transmissions of each kind that came in.
  int64_t num_offered(Kind kind) const { return ledger_.num_offered(kind); }

 private:
  Admission RefuseBecause(Cause cause, Contact* source);

  RoutingRules rules_;
  std::string ignored_group_key_;
  uint64_t seed_;
  ContactBook contacts_;
  FateLedger ledger_;
  BroadcastRouter broadcasts_;
  MessageRouter messages_;
  int64_t num_admitted_ = 0;
};

}  // namespace shoal
