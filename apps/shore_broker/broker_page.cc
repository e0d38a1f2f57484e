#include "apps/shore_broker/broker_page.h"

#include <fmt/format.h>

#include <numeric>
#include <sstream>

#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/control.h"
#include "lib/comms/routing/decide.h"
#include "lib/sea/acoustics/acoustic_statistics.h"

namespace shoal {

namespace {

constexpr int kMaxRows = 200;  ///< Of each list; the totals above it always count all.
constexpr std::string_view kRule = "    ------------------\n";

int64_t CountOf(const CauseCounts& counts, Cause cause) {
  return counts[static_cast<size_t>(cause)];
}

/// Calls `row` for the first contacts that `wanted` picks, and states how many more there are.
template <class Wanted, class Row>
void AppendRows(const Router& router, Wanted wanted, Row row, std::string* text) {
  int num_rows = 0;
  for (const Contact* contact : router.contacts()) {
    if (wanted(*contact) && ++num_rows <= kMaxRows) *text += row(*contact);
  }
  if (num_rows > kMaxRows) *text += fmt::format("        (and {} more)\n", num_rows - kMaxRows);
}

std::string Configuration(const Router& router) {
  const RoutingRules& rules = router.rules();
  std::string text = "Configuration:\n";
  for (const RuleRow& row : kRuleTable) {
    if (row.of_vehicle) continue;
    const std::string shown = ShownValue(row, rules);
    if (row.is_shown_always || shown != ShownValue(row, {})) {
      text += fmt::format("    {}: {}\n", row.label, shown);
    }
  }
  AppendRows(
      router, [](const Contact& contact) { return contact.factors != LinkFactors(); },
      [](const Contact& contact) {
        return fmt::format("    {}: stealth {:g}, earange {:g}\n", UpperCase(contact.name),
                           contact.factors.stealth, contact.factors.earange);
      },
      &text);
  return text;
}

std::string ReceivedReports(const Router& router, const BrokerPageFacts& facts) {
  const double elapsed_s = SecondsBetween(facts.start_utime, facts.now_utime);
  std::string text = fmt::format(
      "    {:<26}{:>10}{:>10}\n",
      fmt::format("Total Received: {}", router.num_offered(Kind::kReport)), "Elapsed", "Rate");
  constexpr auto kReports = static_cast<size_t>(Kind::kReport);
  AppendRows(
      router, [](const Contact& contact) { return contact.num_sent[kReports] > 0; },
      [&](const Contact& contact) {
        const int64_t num_received = contact.num_sent[kReports];
        const std::string age =
            contact.known
                ? fmt::format("({:.1f})", SecondsBetween(contact.received_utime, facts.now_utime))
            : contact.num_admitted > 0 ? "(forgotten)"
                                       : "(refused)";
        const double rate = elapsed_s > 0 ? static_cast<double>(num_received) / elapsed_s : 0;
        return fmt::format("        {:<22}{:>10}{:>10}\n",
                           fmt::format("{}: {}", UpperCase(contact.name), num_received), age,
                           fmt::format("[{:.2f}]", rate));
      },
      &text);
  return text;
}

std::string ReceivedMessages(const Router& router, Kind kind, std::string_view what,
                             const BrokerPageFacts& facts) {
  const auto place = static_cast<size_t>(kind);
  std::string text = fmt::format("    Total {} Received: {}\n", what, router.num_offered(kind));
  AppendRows(
      router, [&](const Contact& contact) { return contact.num_sent[place] > 0; },
      [&](const Contact& contact) {
        const std::string age =
            kind == Kind::kMessage && contact.last_message_utime != kNever
                ? fmt::format("    ({:.1f})",
                              SecondsBetween(contact.last_message_utime, facts.now_utime))
                : "";
        return fmt::format("        {}: {}{}\n", UpperCase(contact.name), contact.num_sent[place],
                           age);
      },
      &text);
  return text;
}

std::string Sent(const Router& router, Kind kind) {
  const auto place = static_cast<size_t>(kind);
  constexpr auto kDelivered = static_cast<size_t>(Cause::kDelivered);
  std::string text = fmt::format("    Total Sent: {}\n", router.counts(kind)[kDelivered]);
  AppendRows(
      router, [&](const Contact& contact) { return contact.received[place][kDelivered] > 0; },
      [&](const Contact& contact) {
        return fmt::format("        {}: {}\n", UpperCase(contact.name),
                           contact.received[place][kDelivered]);
      },
      &text);
  const CauseCounts& counts = router.counts(kind);
  if (const int64_t num_damaged = CountOf(counts, Cause::kDamaged); num_damaged > 0) {
    text += fmt::format("    Total Sent Damaged: {}\n", num_damaged);
  }
  if (const int64_t num_in_transit = CountOf(counts, Cause::kInTransit); num_in_transit > 0) {
    text += fmt::format("    {}: {}\n", RowOf(Cause::kInTransit).label, num_in_transit);
  }
  return text;
}

/// "12 of 40" sent and received, of each vehicle that had to do with this kind.
std::string ByVehicle(const Router& router, Kind kind) {
  const auto place = static_cast<size_t>(kind);
  const auto share = [&](const KindCounts& counts) {
    const CauseCounts& of_kind = counts[place];
    return fmt::format("{} of {}", of_kind[static_cast<size_t>(Cause::kDelivered)],
                       std::accumulate(of_kind.begin(), of_kind.end(), int64_t{0}));
  };
  std::string text =
      fmt::format("    {:<26}{:>16}{:>16}\n", "By Vehicle (delivered of)", "Sent", "Received");
  AppendRows(
      router,
      [&](const Contact& contact) {
        return contact.sent[place] != CauseCounts{} || contact.received[place] != CauseCounts{};
      },
      [&](const Contact& contact) {
        return fmt::format("        {:<22}{:>16}{:>16}\n", UpperCase(contact.name) + ":",
                           share(contact.sent), share(contact.received));
      },
      &text);
  return text;
}

/// A row for each cause that the rules can give to this kind, and for others that were counted.
std::string Blocked(const Router& router, Kind kind, std::string_view what) {
  const CauseCounts& counts = router.counts(kind);
  int64_t total = 0;
  std::string rows;
  for (const CauseRow& row : kCauseTable) {
    if (row.outcome != CauseOutcome::kStopped) continue;
    const int64_t count = CountOf(counts, row.cause);
    total += count;
    if (count > 0 || row.of_rules.Has(kind)) {
      rows += fmt::format("        {}: {}\n", row.label, count);
    }
  }
  return fmt::format("    Total Blocked {}: {}\n{}", what, total, rows);
}

std::string AcousticSummary(const AcousticTraffic& traffic) {
  const AcousticStatistics statistics = traffic.network().statistics();
  if (statistics.num_transmissions == 0) return "";
  std::istringstream lines(StatisticsText(statistics));
  std::string text = "\nAcoustic Network\n======================================\n";
  for (std::string line; std::getline(lines, line);) text += "    " + line + "\n";
  return text;
}

}  // namespace

std::string FormatBrokerPage(const Router& router, const AcousticTraffic& traffic,
                             const BrokerPageFacts& facts) {
  constexpr std::string_view kDoubleRule = "======================================\n";
  std::string text = Configuration(router);
  text += fmt::format("\nNode Report Summary\n{}", kDoubleRule);
  text += ReceivedReports(router, facts);
  text += fmt::format("{}{}", kRule, Sent(router, Kind::kReport));
  text += fmt::format("{}    Known Vehicles: {}\n    Stale Vehicles: {}\n", kRule,
                      router.num_known(), router.NumStale(facts.now_utime));
  text += fmt::format("{}{}", kRule, Blocked(router, Kind::kReport, "Reports"));
  text += fmt::format("{}{}", kRule, ByVehicle(router, Kind::kReport));

  text += fmt::format("\nNode Message Summary\n{}", kDoubleRule);
  text += ReceivedMessages(router, Kind::kMessage, "Msgs", facts);
  text += fmt::format("{}{}", kRule, Sent(router, Kind::kMessage));
  text += fmt::format("{}{}", kRule, Blocked(router, Kind::kMessage, "Msgs"));
  if (router.num_offered(Kind::kMessage) > 0) {
    text += fmt::format("{}{}", kRule, ByVehicle(router, Kind::kMessage));
  }

  if (router.num_offered(Kind::kAck) > 0) {
    text += fmt::format("\nAck Summary\n{}", kDoubleRule);
    text += ReceivedMessages(router, Kind::kAck, "Acks", facts);
    text += fmt::format("{}{}", kRule, Sent(router, Kind::kAck));
    text += fmt::format("{}{}", kRule, Blocked(router, Kind::kAck, "Acks"));
  }

  if (router.num_offered(Kind::kPacket) > 0) {
    text += fmt::format("\nPacket Summary\n{}", kDoubleRule);
    text += ReceivedMessages(router, Kind::kPacket, "Packets", facts);
    text += fmt::format("{}{}", kRule, Sent(router, Kind::kPacket));
    text += fmt::format("{}{}", kRule, Blocked(router, Kind::kPacket, "Packets"));
  }
  text += AcousticSummary(traffic);

  text += fmt::format(
      "\nReports Shared (NODE_REPORT_UNC): {}\n"
      "Undecodable Messages: {}\n"
      "Helm Commands Handed On: {}\n",
      facts.num_shared, facts.num_undecodable, facts.num_commands_handed_on);
  return text;
}

}  // namespace shoal
