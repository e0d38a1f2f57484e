// Who hears whom: takes node reports in, remembers each vehicle's last, and gives every report and
// every message its fate at every destination.
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
// All reports of a step are admitted before any is routed, so that everybody is where he is now.
//
// What goes over the acoustic network is not delivered once the rules have let it pass: it is in
// transit until the caller says what became of it:
//
//   router.Conclude(decision, "alpha", "bravo", Cause::kCollision);
//
// fates = admitted reports x other known vehicles + refused reports, always; and of messages: their
// destinations, or 1 where they have none. "Fates" counts Decision::count, and what is in transit.
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
#include "lib/routing/decide.h"
#include "lib/routing/destinations.h"
#include "lib/routing/fate.h"
#include "lib/routing/reach_grid.h"
#include "lib/routing/rules.h"

namespace shoal {

/// What the rules ask about a node report.
struct ReportFacts {
  std::string_view name;
  std::string_view group = {};
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
};

/// What intake said to a report.
struct Admission {
  std::optional<Cause> refused;  ///< Absent: admitted.
  int32_t source = kNobody;      ///< kNobody where refused and not known.
  int64_t number = 0;            ///< Of the report.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  std::string group_key;
};

/// What the rules ask about a node message.
struct MessageFacts {
  std::string_view source;
  std::string_view dest_node = {};   ///< Names joined by ':', or all.
  std::string_view dest_group = {};  ///< A group, or all.
  int64_t length_bytes = 0;          ///< Of its string_val.
  bool is_sound = true;  ///< False: the caller found something missing or impossible in it.
};

/// What the rules ask about an ack.
struct AckFacts {
  std::string_view source;
  std::string_view destination;
  bool is_sound = true;
};

/// What the rules ask about a packet for the acoustic network.
struct PacketFacts {
  std::string_view source;
  int64_t length_bytes = 0;
  int64_t length_limit_bytes = 0;
  bool is_sound = true;
};

class Router {
 public:
  /// So many vehicles that are not of the mission are remembered at a time: made-up names must
  /// not fill the memory, nor squeeze out the mission's own vehicles, nor make so many fates of
  /// what each of them hears of the others that a step takes seconds.
  static constexpr int kMaxStrangers = 200;

  /// @pre `vehicles`: the mission's, legal names of different keys.
  Router(const RoutingRules& rules, uint64_t seed, std::span<const std::string> vehicles);
  Router(const Router&) = delete;
  Router& operator=(const Router&) = delete;

  const RoutingRules& rules() const { return rules_; }
  /// The rules hold from the next decision on.
  void SetRules(const RoutingRules& rules);

  /// Returns the factors of a vehicle, known or not, or nothing where there is no room for another
  /// stranger, or the name is illegal.
  std::optional<LinkFactors> FindFactors(std::string_view name) const;
  /// Sets them, from the next decision on. Returns false where FindFactors returns nothing.
  bool SetFactors(std::string_view name, const LinkFactors& factors);

  /// From now on `name` receives the next report of each vehicle that is known, or of the mission,
  /// whatever the rules say, even where that vehicle is forgotten meanwhile and comes back. Returns
  /// false for a vehicle that is neither.
  bool RequestFullReports(std::string_view name);

  /// Takes a report in. Its sender is known from now on and is where the report says. Refuses
  /// illegal names, positions that are not finite and the ignored group; these leave all else as it
  /// was.
  Admission Admit(const ReportFacts& report, int64_t utime);

  /// Counts a report of `name` that the caller found invalid for a reason of its own.
  Admission Refuse(std::string_view name);

  /// Appends the fate of an admitted report at each other known vehicle, in order of keys; those
  /// that are not told apart come last.
  /// @pre !report.refused; no ForgetSilent came between.
  void Route(const Admission& report, int64_t utime, std::vector<Decision>* decisions);

  /// Appends the fates of a message: vehicles in order of keys, then names of no vehicle as
  /// written, which are appended to `unknown_names`. Asks in this order: invalid, too soon, too
  /// long, unknown or stale source, then at each destination. A message that is not too soon
  /// restarts the source's interval, unless it is invalid.
  void RouteMessage(const MessageFacts& message, int64_t utime, std::vector<Decision>* decisions,
                    std::vector<std::string>* unknown_names);

  /// Appends the one fate of an ack. Asks: invalid, unknown or stale source, then as a message.
  void RouteAck(const AckFacts& ack, int64_t utime, std::vector<Decision>* decisions,
                std::vector<std::string>* unknown_names);

  /// Appends the fates of a packet at each other known vehicle, in order of keys; those that are
  /// not told apart come last. Asks: invalid, unknown source, too long, then at each destination.
  void RoutePacket(const PacketFacts& packet, int64_t utime, std::vector<Decision>* decisions);

  /// Gives a transmission that is in transit its fate, for the counts. Names, since either vehicle
  /// may have been replaced by another stranger meanwhile. Returns the decision with that cause.
  /// @pre pending.cause is kInTransit, and it was not concluded before.
  Decision Conclude(const Decision& pending, std::string_view source, std::string_view destination,
                    Cause cause);

  /// Forgets who has been silent for the forget time: all but counts, numbers and factors. Appends
  /// their indices to `forgotten`, where given.
  void ForgetSilent(int64_t utime, std::vector<int32_t>* forgotten = nullptr);

  /// Returns the contact of this index, as long as it has not been replaced by another stranger.
  const Contact& contact(int32_t index) const { return *by_index_[static_cast<size_t>(index)]; }
  /// All contacts, known or not, in order of keys.
  std::span<const Contact* const> contacts() const { return {by_rank_.data(), by_rank_.size()}; }

  int num_known() const { return num_known_; }
  int NumStale(int64_t utime) const;
  /// Reports taken in so far, those of vehicles that are gone included.
  int64_t num_admitted() const { return num_admitted_; }
  /// All fates so far by cause, those of refused transmissions included.
  const CauseCounts& counts(Kind kind) const { return counts_[static_cast<size_t>(kind)]; }
  /// Returns what is in transit, of all kinds.
  int64_t NumInTransit() const;
  /// Transmissions of each kind that came in.
  int64_t num_offered(Kind kind) const { return num_offered_[static_cast<size_t>(kind)]; }

 private:
  Contact* Find(std::string_view name);
  const Contact* Find(std::string_view name) const;
  Contact* FindOrAdd(std::string_view name);
  bool MakeRoomForAStranger();
  void RankContacts();

  Admission RefuseBecause(Cause cause, Contact* source);
  int64_t TakeNumber(Kind kind, Contact* source);
  Transmission MakeTransmission(Kind kind, int64_t number, const Contact& source) const;

  void DecideReportAt(const Transmission& report, Contact* source, Contact* receiver, int64_t utime,
                      std::vector<Decision>* decisions);
  /// A report or a packet at each other known vehicle.
  void Broadcast(const Transmission& sent, Contact* source, int64_t utime,
                 std::vector<Decision>* decisions);
  void BroadcastNear(const Transmission& sent, Contact* source, int64_t utime,
                     std::vector<Decision>* decisions);
  void DecideAt(const Transmission& sent, Contact* source, Contact* receiver, int64_t utime,
                std::vector<Decision>* decisions);
  bool CountsFarTogether() const;
  void PrepareGrid();

  /// To whom a message goes.
  struct Audience {
    std::vector<Contact*> contacts;  ///< In order of keys, known or not.
    std::vector<std::string> names;  ///< Of no contact, as written.
  };
  Audience Resolve(const Destinations& named, std::string_view dest_group, const Contact& source);
  std::optional<Decision> RefuseMessage(int64_t length_bytes, Contact* source, int64_t utime);
  std::optional<Decision> RefuseSource(const Contact& source, int64_t utime) const;
  void DecideMessageAt(const Transmission& message, const std::optional<Decision>& refusal,
                       const Audience& audience, Contact* source, int64_t utime,
                       std::vector<Decision>* decisions, std::vector<std::string>* unknown_names);
  /// Counts a fate and appends it; what the rules let pass may be in transit. `source` and
  /// `receiver` may be null.
  void Record(const Decision& decision, Contact* source, Contact* receiver,
              std::vector<Decision>* decisions);

  RoutingRules rules_;
  std::string ignored_group_key_;
  uint64_t seed_;
  std::map<std::string, Contact, std::less<>> contacts_;
  std::vector<Contact*> by_index_;
  std::vector<Contact*> by_rank_;
  std::vector<int32_t> free_indices_;
  int num_known_ = 0;
  int num_strangers_ = 0;                              ///< Contacts not of the mission.
  int num_unknown_strangers_ = 0;                      ///< Of these, the ones that are not known.
  int num_wanting_ = 0;                                ///< Contacts with num_wanted > 0.
  std::array<int64_t, kNumKinds> num_of_nobody_ = {};  ///< Numbers what has no known sender.
  std::array<int64_t, kNumKinds> num_offered_ = {};
  int64_t num_admitted_ = 0;
  KindCounts counts_ = {};

  ReachGrid grid_;
  bool grid_is_valid_ = false;
  double max_earange_ = 1;
  std::vector<int32_t> near_;                 ///< Kept for its memory.
  mutable int64_t num_stale_utime_ = kNever;  ///< When num_stale_ was counted; kNever: not valid.
  mutable int num_stale_ = 0;
};

}  // namespace shoal
