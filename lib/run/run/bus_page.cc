#include "lib/run/run/bus_page.h"

#include <fmt/format.h>

namespace shoal {

void AppendBus(const BusFacts& facts, StatusPage* page) {
  const auto warn = [page](std::string text) { page->run_warnings.push_back(std::move(text)); };
  if (facts.num_foreign > 0) {
    warn(fmt::format("{} messages of another mission rejected: two missions share a block of ports",
                     facts.num_foreign));
  }
  for (const auto& [channel, count] : facts.participant.undecodable_by_channel) {
    warn(fmt::format("{} undecodable messages on {}", count, channel));
  }
  if (facts.num_forged > 0) {
    warn(fmt::format("{} messages refused whose seals do not prove this mission's secret{}",
                     facts.num_forged,
                     facts.first_forged.empty() ? "" : "; the first: on " + facts.first_forged));
  }
  if (facts.inbox.no_room > 0) {
    warn(fmt::format("{} sealed messages refused: more than {} wait", facts.inbox.no_room,
                     StepInbox::kMaxSealed));
  }
  if (facts.inbox.dropped > 0) {
    warn(fmt::format("{} messages from outside dropped: more than {} in one step",
                     facts.inbox.dropped, StepInbox::kMaxOutside));
  }
  page->text += fmt::format(
      "\nBus: {} published, {} handled, {} undecodable, {} from outside, {} asked for again, {} "
      "late or repeated, {} refused\n",
      facts.participant.published, facts.participant.handled, facts.participant.undecodable,
      facts.inbox.outside, facts.num_requests, facts.inbox.late, facts.num_refused);
}

}  // namespace shoal
