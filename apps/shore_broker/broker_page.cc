#include "apps/shore_broker/broker_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/bus/channels.h"
#include "lib/routing/decide.h"

namespace shoal {

namespace {

constexpr int kMaxRows = 200;  ///< Of each list; the totals above it always count everybody.

std::string Limit(double value, std::string_view negative) {
  return value < 0 ? std::string(negative) : fmt::format("{:g}", value);
}

double Seconds(int64_t earlier_utime, int64_t later_utime) {
  return static_cast<double>(later_utime - earlier_utime) / 1e6;
}

/// Calls `row` for the first contacts that `wanted` picks, and says how many more there are.
template <class Wanted, class Row>
void AppendRows(const Router& router, Wanted wanted, Row row, std::string* text) {
  int num_rows = 0;
  for (const auto& [key, contact] : router.contacts()) {
    if (wanted(contact) && ++num_rows <= kMaxRows) *text += row(contact);
  }
  if (num_rows > kMaxRows) *text += fmt::format("        (and {} more)\n", num_rows - kMaxRows);
}

}  // namespace

std::string FormatBrokerPage(const Router& router, const BrokerPageFacts& facts) {
  const RoutingRules& rules = router.rules();
  const auto count = [&](Cause cause) { return router.counts()[static_cast<size_t>(cause)]; };
  const double elapsed_s = Seconds(facts.start_utime, facts.now_utime);

  const int64_t num_refused = count(Cause::kInvalid) + count(Cause::kTooManyVehicles);
  int num_stale = 0;
  for (const auto& [key, contact] : router.contacts()) {
    if (contact.known && IsStale(rules, contact.received_utime, facts.now_utime)) ++num_stale;
  }

  std::string text = fmt::format(
      "Configuration:\n"
      "    Comms Range: {}\n"
      "    Stale Drop: {}\n"
      "    Stale Forget: {}\n"
      "\nNode Report Summary\n"
      "======================================\n",
      Limit(rules.comms_range_m, "nolimit"), Limit(rules.stale_time_s, "never"),
      Limit(rules.stale_forget_s, "never"));

  text += fmt::format("    {:<26}{:>10}{:>10}\n",
                      fmt::format("Total Received: {}", router.num_admitted() + num_refused),
                      "Elapsed", "Rate");
  AppendRows(
      router, [](const Contact& contact) { return contact.num_admitted > 0; },
      [&](const Contact& contact) {
        const std::string age =
            contact.known
                ? fmt::format("({:.1f})", Seconds(contact.received_utime, facts.now_utime))
                : "(forgotten)";
        const double rate =
            elapsed_s > 0 ? static_cast<double>(contact.num_admitted) / elapsed_s : 0;
        return fmt::format("        {:<22}{:>10}{:>10}\n",
                           fmt::format("{}: {}", UpperCase(contact.name), contact.num_admitted),
                           age, fmt::format("[{:.2f}]", rate));
      },
      &text);

  text += fmt::format("    ------------------\n    Total Sent: {}\n", count(Cause::kDelivered));
  AppendRows(
      router, [](const Contact& contact) { return contact.num_heard > 0; },
      [](const Contact& contact) {
        return fmt::format("        {}: {}\n", UpperCase(contact.name), contact.num_heard);
      },
      &text);

  text += fmt::format(
      "    ------------------\n"
      "    Known Vehicles: {}\n"
      "    Stale Vehicles: {}\n"
      "    ------------------\n"
      "    Total Blocked Reports: {}\n"
      "        Invalid: {}\n"
      "        Too Many Vehicles: {}\n"
      "        Stale Receiver: {}\n"
      "        Range Too Far: {}\n"
      "    Undecodable Messages: {}\n"
      "    Helm Commands Handed On: {}\n",
      router.num_known(), num_stale,
      num_refused + count(Cause::kStaleReceiver) + count(Cause::kOutOfRange),
      count(Cause::kInvalid), count(Cause::kTooManyVehicles), count(Cause::kStaleReceiver),
      count(Cause::kOutOfRange), facts.num_undecodable, facts.num_commands_handed_on);
  return text;
}

}  // namespace shoal
