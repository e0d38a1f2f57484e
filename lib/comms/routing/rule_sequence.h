// The rules that decide one kind of transmission at one receiver, in their order; and, derived from
// the same sequence, what can be counted for receivers that are too far to be looked at.
//
//   using ReportRules = RuleSequence<FullReport, StaleReceiver, CriticalRange, CommsRange, Groups>;
//   Decision decision = ReportRules::Decide(link);
//
// Each rule names its Scope, and is given what that scope may look at and nothing else. A rule that
// names none does not compile. A rule of the scope kLink makes the far receivers of its kind be
// decided one by one, as long as it is on: no rule can be missed.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "lib/comms/routing/contact.h"
#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/rules.h"
#include "lib/comms/routing/transmission.h"

namespace shoal {

/// One transmission at one receiver.
struct LinkFacts {
  const RoutingRules& rules;
  const Transmission& sent;
  const Contact& receiver;
  int64_t utime = 0;
  int64_t delivered_utime = kNever;  ///< When the receiver last received a report of this source.
  bool is_wanted = false;            ///< It asked for the next report of this source.

  double Range_m() const { return (receiver.PositionFor(sent.kind) - sent.position_m).norm(); }
};

enum class Answer : uint8_t { kNext, kStops, kDelivers };

/// What a rule looks at.
enum class Scope : uint8_t {
  /// Receivers that asked for this report. The rule has static Answer AskWanted(link, decision).
  kWanted,
  /// The receiver alone: sender and content do not matter. The rule has static bool StopsAt(rules,
  /// receiver, utime, decision), and static void FillLimits(rules, decision), which writes the
  /// limits
  /// that all receivers share.
  kReceiver,
  /// Receivers within a reach. The rule has static double Reach_m(rules), and static Answer
  /// AskNear(link, range_m, decision) for those that are nearer.
  kNear,
  /// Stops all receivers beyond a reach; later rules are not asked about them. The rule has static
  /// double Reach_m(rules, stealth, earange) and static bool IsOn(rules).
  kFar,
  /// Anything. The rule has static bool IsOn(rules) and static Answer Ask(link, decision).
  kLink,
};

template <class Rule>
Answer AskRule(const LinkFacts& link, Decision* decision) {
  if constexpr (Rule::kScope == Scope::kWanted) {
    return link.is_wanted ? Rule::AskWanted(link, decision) : Answer::kNext;
  } else if constexpr (Rule::kScope == Scope::kReceiver) {
    return Rule::StopsAt(link.rules, link.receiver, link.utime, decision) ? Answer::kStops
                                                                          : Answer::kNext;
  } else if constexpr (Rule::kScope == Scope::kNear) {
    const double reach_m = Rule::Reach_m(link.rules);
    if (!(reach_m > 0)) return Answer::kNext;
    const double range_m = link.Range_m();
    return range_m < reach_m ? Rule::AskNear(link, range_m, decision) : Answer::kNext;
  } else if constexpr (Rule::kScope == Scope::kFar) {
    decision->range_m = link.Range_m();
    if (!Rule::IsOn(link.rules)) return Answer::kNext;
    decision->limit_m = Rule::Reach_m(link.rules, link.sent.stealth, link.receiver.factors.earange);
    return decision->range_m < decision->limit_m ? Answer::kNext : Answer::kStops;
  } else {
    static_assert(Rule::kScope == Scope::kLink);
    return Rule::IsOn(link.rules) ? Rule::Ask(link, decision) : Answer::kNext;
  }
}

template <class... Rules>
struct RuleSequence {
  /// What its rules stop with, in the order in which they are asked; kDelivered: by delivering.
  static constexpr std::array<Cause, sizeof...(Rules)> kCauses = {Rules::kCause...};

  /// The first rule that stops or delivers it decides; the numbers of all that were asked come with
  /// it. Source, destination and number are the caller's.
  static Decision Decide(const LinkFacts& link) {
    Decision decision;
    const auto ends = [&](Answer answer, Cause cause) {
      if (answer == Answer::kStops) decision.cause = cause;
      return answer != Answer::kNext;
    };
    (void)(ends(AskRule<Rules>(link, &decision), Rules::kCause) || ...);
    return decision;
  }

  /// Returns true where the fates of receivers beyond Reach_m can be counted without looking at
  /// each, but for those that asked for this report: there is a rule that stops them all, and none
  /// before it looks at the link.
  static bool CountsFar(const RoutingRules& rules) {
    bool is_stopped = false;
    bool is_countable = true;
    const auto take = [&]<class Rule>(const Rule*) {
      if constexpr (Rule::kScope == Scope::kFar) is_stopped = is_stopped || Rule::IsOn(rules);
      if constexpr (Rule::kScope == Scope::kLink) {
        is_countable = is_countable && (is_stopped || !Rule::IsOn(rules));
      }
    };
    (take(static_cast<const Rules*>(nullptr)), ...);
    return is_stopped && is_countable;
  }

  /// Returns how far rules look, of a source of this stealth and receivers of at most this earange.
  static double Reach_m(const RoutingRules& rules, double stealth, double max_earange) {
    double reach_m = 0;
    const auto take = [&]<class Rule>(const Rule*) {
      if constexpr (Rule::kScope == Scope::kNear) {
        reach_m = std::max(reach_m, Rule::Reach_m(rules));
      } else if constexpr (Rule::kScope == Scope::kFar) {
        if (Rule::IsOn(rules)) {
          reach_m = std::max(reach_m, Rule::Reach_m(rules, stealth, max_earange));
        }
      }
    };
    (take(static_cast<const Rules*>(nullptr)), ...);
    return reach_m;
  }

  /// Returns what stops everything at this receiver before its range is asked for.
  static std::optional<Cause> CauseAt(const RoutingRules& rules, const Contact& receiver,
                                      int64_t utime) {
    std::optional<Cause> cause;
    bool is_before = true;
    Decision ignored;
    const auto take = [&]<class Rule>(const Rule*) {
      if constexpr (Rule::kScope == Scope::kFar) is_before = is_before && !Rule::IsOn(rules);
      if constexpr (Rule::kScope == Scope::kReceiver) {
        if (is_before && !cause && Rule::StopsAt(rules, receiver, utime, &ignored)) {
          cause = Rule::kCause;
        }
      }
    };
    (take(static_cast<const Rules*>(nullptr)), ...);
    return cause;
  }

  /// Calls `take(decision)` for each fate that far receivers can have, in the order of the rules:
  /// its cause, and the limits that they have in common. The last is what stops all that nothing
  /// before it stops. @pre CountsFar(rules)
  template <class Take>
  static void EachFarFate(const RoutingRules& rules, double reach_m, const Take& take) {
    bool is_before = true;
    const auto take_rule = [&]<class Rule>(const Rule*) {
      Decision decision;
      decision.cause = Rule::kCause;
      if constexpr (Rule::kScope == Scope::kReceiver) {
        if (!is_before) return;
        Rule::FillLimits(rules, &decision);
        take(decision);
      } else if constexpr (Rule::kScope == Scope::kFar) {
        if (!is_before || !Rule::IsOn(rules)) return;
        is_before = false;
        decision.limit_m = reach_m;
        take(decision);
      }
    };
    (take_rule(static_cast<const Rules*>(nullptr)), ...);
  }
};

}  // namespace shoal
