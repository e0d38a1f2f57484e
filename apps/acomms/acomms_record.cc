#include "apps/acomms/acomms_record.h"

#include <fmt/format.h>

#include <utility>

#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

constexpr size_t kMaxEvents = 1000;  ///< In a step.

}  // namespace

std::vector<std::string> AcommsRecord::Note(const std::string& source,
                                            const SwarmReception& reception, int64_t utime) {
  std::vector<std::string> lines;
  const auto add = [&](acomms_event_t event, std::string line) {
    if (events_.size() == kMaxEvents) return;
    event.utime = utime;
    event.source = source;
    events_.push_back(std::move(event));
    lines.push_back(fmt::format("message of {} {}", Printable(source), line));
  };
  if (reception.result == ReceptionResult::kRejected) {
    acomms_event_t event{};
    event.outcome = "rejected";
    event.reason = TextOf(reception.reason);
    std::string line = "rejected: " + event.reason;
    if (reception.field) {
      event.field = NameOf(*reception.field);
      event.fault = TextOf(reception.fault);
      line += fmt::format(" ({} is {})", event.field, event.fault);
    }
    add(std::move(event), line);
    return lines;
  }
  for (const FieldRecovery& recovery : reception.recoveries) {
    acomms_event_t event{};
    event.outcome = "recovered";
    event.field = NameOf(recovery.field);
    event.fault = TextOf(recovery.fault);
    event.by = NameOf(recovery.strategy);
    if (recovery.id) event.about = names_.NameOfId(*recovery.id);
    const std::string about = event.about.empty() ? "" : " of " + event.about;
    const std::string line =
        fmt::format("recovered: {}{} is {}, by {}", event.field, about, event.fault, event.by);
    add(std::move(event), line);
  }
  return lines;
}

acomms_member_t AcommsRecord::MemberOf(const SwarmContact& contact,
                                       const FrameCounts& frames) const {
  acomms_member_t member{};
  member.name = names_.NameOfId(contact.id);
  member.has_answered = contact.has_answered;
  const auto found = frames.find(contact.id);
  if (found == frames.end()) return member;
  member.frames_received = found->second.received;
  member.frames_lost = found->second.lost;
  member.frames_repeated = found->second.repeated;
  member.frames_restarted = found->second.restarted;
  return member;
}

std::optional<acomms_t> AcommsRecord::TakeChange(const SwarmReceiver& receiver,
                                                 int64_t num_without_nav, int64_t num_missed,
                                                 int64_t utime) {
  acomms_t message{};
  message.vehicle = vehicle_;
  message.num_without_nav = num_without_nav;
  message.num_missed = num_missed;
  const FrameCounts& frames = receiver.counts.frames;
  if (receiver.state.target) message.members.push_back(MemberOf(*receiver.state.target, frames));
  for (const SwarmContact& member : receiver.state.members) {
    message.members.push_back(MemberOf(member, frames));
  }
  message.num_members = static_cast<int32_t>(message.members.size());
  Bytes now;
  EncodeInto(message, &now);
  if (events_.empty() && now == last_) return std::nullopt;
  last_ = std::move(now);
  message.utime = utime;
  message.events = std::exchange(events_, {});
  message.num_events = static_cast<int32_t>(message.events.size());
  return message;
}

}  // namespace shoal
