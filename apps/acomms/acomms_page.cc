// The status page of acomms.
#include <fmt/format.h>

#include "apps/acomms/acomms_app.h"

namespace shoal {

namespace {

std::string_view Name(SwarmScheme scheme) {
  switch (scheme) {
    case SwarmScheme::kFdmaLf:
      return "fdma_lf";
    case SwarmScheme::kTdma:
      return "tdma";
    case SwarmScheme::kTdmaLf:
      break;
  }
  return "tdma_lf";
}

double Seconds(int64_t time_us) { return static_cast<double>(time_us) / 1e6; }

std::string PlanText(const SlotPlan& plan) {
  const std::string episode =
      fmt::format("{}, episode {:g} s", Name(plan.scheme), Seconds(plan.episode_us));
  if (plan.scheme == SwarmScheme::kTdmaLf) {
    return fmt::format("{}, request {:g} s, answer {:g} s", episode, Seconds(plan.broadcast_us),
                       Seconds(plan.response_us));
  }
  return fmt::format("{}, from member to member {:g} s", episode, Seconds(plan.offset_us));
}

std::string ContactText(const swarm_contact_t& contact, int64_t utime) {
  std::string text =
      fmt::format("    {:<16} {:<8}", contact.name, contact.is_target ? "leader" : "follower");
  if (!contact.is_heard) return text + " not heard yet\n";
  if (!contact.is_known) {
    return text + " cannot be used" + (contact.is_silent ? ", silent\n" : "\n");
  }
  text += fmt::format("{:9.1f} s {:9.1f} {:9.1f} {:8.1f}", Seconds(utime - contact.report_utime),
                      contact.x_m, contact.y_m, contact.z_m);
  if (contact.is_silent) text += "  silent";
  for (const std::string& recovered : contact.recovered) text += "  " + recovered;
  return text + "\n";
}

}  // namespace

StatusPage AcommsApp::Status() const {
  const int64_t utime = utime_.value_or(start_utime_);
  const swarm_t swarm = writer_.Write(receiver_, utime);
  StatusPage page;
  page.text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({}), leader {}\n"
      "    Slots: {}\n"
      "    Frames: {}\n"
      "Said: {} messages; {} slots passed without NAV, {} requests unanswered\n"
      "Known:           role     age of report    x [m]     y [m]    z [m]\n",
      name_, receiver_.state.is_leader ? "leads" : "follows", leader_, PlanText(plan_),
      receiver_.has_frames ? "on" : "off", num_said_, num_without_nav_, schedule_.num_missed());
  for (const swarm_contact_t& contact : swarm.contacts) page.text += ContactText(contact, utime);
  page.text += "Heard:           received   clean  recovered  rejected\n";
  for (const swarm_source_t& source : swarm.sources) {
    page.text += fmt::format("    {:<16} {:>4} {:>7} {:>10} {:>9}\n", source.name, source.received,
                             source.clean, source.recovered, source.rejected);
  }
  for (const auto& [id, count] : receiver_.counts.frames) {
    page.text += fmt::format("    frames of {}: {} received, {} lost, {} repeated, {} restarts\n",
                             writer_.NameOfId(id), count.received, count.lost, count.repeated,
                             count.restarted);
  }
  for (const swarm_count_t& count : swarm.counts) {
    page.text += fmt::format("    {} {} times: {}{}{}\n", count.outcome, count.count, count.field,
                             count.field.empty() ? "" : " by ", count.by);
  }
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
