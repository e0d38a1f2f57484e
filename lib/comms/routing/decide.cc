#include "lib/comms/routing/decide.h"

#include "lib/base/time/seconds.h"

namespace shoal {

namespace {

/// The receiver asked for the next report of this source.
struct FullReportRule {
  static constexpr Cause kCause = Cause::kDelivered;
  static constexpr Scope kScope = Scope::kWanted;
  static Answer AskWanted(const LinkFacts& link, Decision* decision) {
    decision->override_rule = OverrideRule::kFullReport;
    decision->range_m = link.Range_m();
    decision->age_s = SecondsBetween(link.receiver.received_utime, link.utime);
    return Answer::kDelivers;
  }
};

/// A receiver whose last report is too old has no usable position.
struct StaleReceiverRule {
  static constexpr Cause kCause = Cause::kStaleReceiver;
  static constexpr Scope kScope = Scope::kReceiver;
  static bool StopsAt(const RoutingRules& rules, const Contact& receiver, int64_t utime,
                      Decision* decision) {
    decision->age_s = SecondsBetween(receiver.received_utime, utime);
    if (rules.stale_time_s < 0) return false;
    decision->age_limit_s = rules.stale_time_s;
    return !(decision->age_s < decision->age_limit_s);
  }
  static void FillLimits(const RoutingRules& rules, Decision* decision) {
    decision->age_limit_s = rules.stale_time_s;
  }
};

/// Vehicles this close to each other receive each other's reports.
struct CriticalRangeRule {
  static constexpr Cause kCause = Cause::kDelivered;
  static constexpr Scope kScope = Scope::kNear;
  static double Reach_m(const RoutingRules& rules) { return rules.critical_range_m; }
  static Answer AskNear(const LinkFacts& link, double range_m, Decision* decision) {
    decision->range_m = range_m;
    decision->limit_m = link.rules.critical_range_m;
    decision->override_rule = OverrideRule::kCriticalRange;
    return Answer::kDelivers;
  }
};

/// Strictly less, in three dimensions.
struct CommsRangeRule {
  static constexpr Cause kCause = Cause::kOutOfRange;
  static constexpr Scope kScope = Scope::kFar;
  static bool IsOn(const RoutingRules& rules) { return rules.comms_range_m >= 0; }
  static double Reach_m(const RoutingRules& rules, double stealth, double earange) {
    return rules.comms_range_m * stealth * earange;
  }
};

template <bool RoutingRules::*kFlag>
struct GroupsRule {
  static constexpr Cause kCause = Cause::kOtherGroup;
  static constexpr Scope kScope = Scope::kLink;
  static bool IsOn(const RoutingRules& rules) { return rules.*kFlag; }
  static Answer Ask(const LinkFacts& link, Decision*) {
    return link.sent.group_key != link.receiver.group_key ? Answer::kStops : Answer::kNext;
  }
};

struct DropRule {
  static constexpr Cause kCause = Cause::kDropped;
  static constexpr Scope kScope = Scope::kLink;
  static bool IsOn(const RoutingRules& rules) { return rules.drop_percentage > 0; }
  static Answer Ask(const LinkFacts& link, Decision* decision) {
    if (!link.sent.link_key) return Answer::kNext;
    decision->loss_pct = link.rules.drop_percentage;
    Stream stream(link.sent.link_key->With(link.receiver.key).With(link.sent.number));
    return stream.Uniform() * 100 >= link.rules.drop_percentage ? Answer::kNext : Answer::kStops;
  }
};

struct ReportIntervalRule {
  static constexpr Cause kCause = Cause::kTooSoon;
  static constexpr Scope kScope = Scope::kLink;
  static bool IsOn(const RoutingRules& rules) { return !(rules.min_rpt_interval_s < 0); }
  static Answer Ask(const LinkFacts& link, Decision* decision) {
    if (link.delivered_utime == kNever) return Answer::kNext;
    const double elapsed_s = SecondsBetween(link.delivered_utime, link.utime);
    if (elapsed_s >= link.rules.min_rpt_interval_s) return Answer::kNext;
    decision->wait_s = link.rules.min_rpt_interval_s - elapsed_s;
    return Answer::kStops;
  }
};

using ReportRules =
    RuleSequence<FullReportRule, StaleReceiverRule, CriticalRangeRule, CommsRangeRule,
                 GroupsRule<&RoutingRules::groups>, DropRule, ReportIntervalRule>;
using MessageRules = RuleSequence<GroupsRule<&RoutingRules::msg_groups>, StaleReceiverRule,
                                  CommsRangeRule, DropRule>;
/// Without groups: its message has passed, and a vehicle may have changed its group since.
using AckRules = RuleSequence<StaleReceiverRule, CommsRangeRule, DropRule>;
/// All else is for the acoustic network to decide.
using PacketRules = RuleSequence<CommsRangeRule>;

/// Calls `use` with the rules of a kind.
template <class Use>
decltype(auto) WithRulesOf(Kind kind, const Use& use) {
  switch (kind) {
    case Kind::kReport:
      return use(ReportRules());
    case Kind::kMessage:
      return use(MessageRules());
    case Kind::kAck:
      return use(AckRules());
    case Kind::kPacket:
      break;
  }
  return use(PacketRules());
}

}  // namespace

StreamKey DropKey(uint64_t seed, Kind kind, std::string_view source_key) {
  return StreamKey(seed, "drop_percentage").With(KindText(kind)).With(source_key);
}

Transmission TransmissionOf(const RoutingRules& rules, uint64_t seed, Kind kind, int64_t number,
                            const Contact& source) {
  Transmission sent = {.kind = kind,
                       .number = number,
                       .position_m = source.PositionFor(kind),
                       .group_key = source.group_key,
                       .stealth = source.factors.stealth,
                       .link_key = std::nullopt};
  if (rules.drop_percentage > 0) sent.link_key = DropKey(seed, kind, source.key);
  return sent;
}

Decision DecideAt(Kind kind, const LinkFacts& link) {
  Decision decision = WithRulesOf(kind, [&](auto rules) { return decltype(rules)::Decide(link); });
  decision.kind = kind;
  return decision;
}

std::span<const Cause> OrderOfCauses(Kind kind) {
  return WithRulesOf(kind,
                     [](auto rules) { return std::span<const Cause>(decltype(rules)::kCauses); });
}

bool CountsFar(const RoutingRules& rules, Kind kind) {
  return WithRulesOf(kind, [&](auto of_kind) { return decltype(of_kind)::CountsFar(rules); });
}

double Reach_m(const RoutingRules& rules, Kind kind, double stealth, double max_earange) {
  return WithRulesOf(
      kind, [&](auto of_kind) { return decltype(of_kind)::Reach_m(rules, stealth, max_earange); });
}

std::optional<Cause> CauseAt(const RoutingRules& rules, Kind kind, const Contact& receiver,
                             int64_t utime) {
  return WithRulesOf(
      kind, [&](auto of_kind) { return decltype(of_kind)::CauseAt(rules, receiver, utime); });
}

void AppendFarFates(const RoutingRules& rules, Kind kind, double reach_m,
                    std::vector<Decision>* fates) {
  WithRulesOf(kind, [&](auto of_kind) {
    decltype(of_kind)::EachFarFate(rules, reach_m, [&](Decision fate) {
      fate.kind = kind;
      fates->push_back(fate);
    });
  });
}

bool IsStale(const RoutingRules& rules, int64_t received_utime, int64_t utime) {
  return rules.stale_time_s >= 0 && SecondsBetween(received_utime, utime) >= rules.stale_time_s;
}

}  // namespace shoal
