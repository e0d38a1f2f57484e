#include "lib/run/hosts/host_relay.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/step_answers.h"

namespace shoal {

namespace {

/// Well below the time-out after which the clock names what is silent.
constexpr int64_t kPartialAfter_us = 300'000;

}  // namespace

HostRelay::HostRelay(RelayOptions options, PortPlan plan, Transport& transport,
                     std::set<std::string, std::less<>> participants, SendHome send)
    : bus_(std::move(options), std::move(plan), transport),
      participants_(std::move(participants)),
      send_(std::move(send)) {
  transport.Listen(bus_.plan().done_port(), std::string(topics::kStepDone));
  transport.Listen(bus_.plan().done_port(), std::string(topics::kStepDones));
}

void HostRelay::OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                           int64_t wall_us) {
  if (port == bus_.plan().done_port()) return OnAnswer(channel, datagram, wall_us);
  if (port == bus_.plan().tick_port()) {
    const auto is_played = [this](std::string_view name) { return !participants_.contains(name); };
    return bus_.OnResend(datagram, is_played, wall_us);
  }
  const auto unsealed = Unseal(datagram);
  if (!unsealed.seal) {
    if (IsAnswer(channel)) return SendAside(channel, datagram, LinkKind::kAside);
    if (step_ >= 0 && !bus_.IsEcho(channel, datagram)) outside_.Add(channel, datagram);
    return;
  }
  if (!participants_.contains(unsealed.seal->publisher)) return;  // This relay's own.
  if (bus_.kept().Add(channel, datagram) == step_ && awaited_.empty()) SendAnswers(wall_us);
}

void HostRelay::SendAside(std::string_view channel, std::span<const uint8_t> datagram,
                          LinkKind kind) {
  LinkMessage message{.kind = kind, .mission_id = bus_.mission_id()};
  message.parts.push_back(
      {.name = std::string(channel), .data = Bytes(datagram.begin(), datagram.end())});
  send_(std::move(message));
}

void HostRelay::OnAnswer(std::string_view channel, std::span<const uint8_t> datagram,
                         int64_t wall_us) {
  const auto opened = bus_.Open(channel, datagram);
  std::optional<step_dones_t> answers;
  if (opened) answers = DecodeStepAnswers(channel, opened->message);
  if (!answers || opened->publisher != answers->dones.front().participant) return;
  std::vector<step_done_t>& dones = answers->dones;
  const bool is_answer = std::all_of(dones.begin(), dones.end(), [this](const step_done_t& done) {
    return done.step == step_ && step_ >= 0 && active_.contains(done.participant) &&
           done.fault.empty();
  });
  const bool is_repeat = std::all_of(dones.begin(), dones.end(), [this](const step_done_t& done) {
    const auto answered = answered_.find(done.participant);
    return answered != answered_.end() && answered->second == done.pid;
  });
  const bool is_new = std::none_of(dones.begin(), dones.end(), [this](const step_done_t& done) {
    return answered_.contains(done.participant);
  });
  if (is_answer && is_repeat) return;
  if (!is_answer || !is_new) {
    // A hello, a fault, an unregistered name, or two processes of one name: the clock decides.
    return SendAside(channel, datagram, LinkKind::kDone);
  }
  for (const step_done_t& done : dones) {
    answered_[done.participant] = done.pid;
    awaited_.erase(done.participant);
  }
  unsent_.push_back(
      {.part = {.name = std::string(channel), .data = Bytes(datagram.begin(), datagram.end())},
       .dones = std::move(dones)});
  if (awaited_.empty()) SendAnswers(wall_us);
}

std::string HostRelay::OnMessage(const LinkMessage& message, int64_t wall_us) {
  if (message.kind == LinkKind::kTick) return OnTick(message, wall_us);
  for (const LinkPart& part : message.parts) {
    if (part.name == topics::kAppcastReq) bus_.SendPlain(part);
  }
  return {};
}

std::string HostRelay::OnTick(const LinkMessage& message, int64_t wall_us) {
  tick_t tick;
  const LinkPart* part = message.Find(topics::kTick);
  const auto opened = part == nullptr ? std::nullopt : bus_.Open(topics::kTick, part->data);
  if (!opened || !Decode(opened->message, &tick) || tick.step != message.step) {
    return fmt::format("a batch of step {} without its TICK", message.step);
  }
  if (tick.step <= step_) {
    return fmt::format("a batch of step {}, where step {} has begun", tick.step, step_);
  }
  step_ = tick.step;
  is_end_ = tick.kind == tick_t::END;
  tick_at_us_ = wall_us;
  next_repeat_us_ = wall_us + kRelayRepeat_us;
  bus_.kept().ForgetBefore(step_ - 2);
  for (const std::string& name : tick.joined) {
    if (participants_.contains(name)) active_.insert(name);
  }
  awaited_ = active_;
  answered_.clear();
  unsent_.clear();
  const auto runs_elsewhere = [this](std::string_view name) {
    return !participants_.contains(name);
  };
  tick_part_ = *part;
  for (const LinkPart& each : message.parts) {
    if (&each == part) continue;
    if (Unseal(each.data).seal) {
      bus_.SendSealed(each, runs_elsewhere);
    } else {
      bus_.SendOutside(each);
    }
  }
  bus_.SendPlain(tick_part_);
  return {};
}

template <class Use>
void HostRelay::ForEachMissing(const Answer& answer, Use use) const {
  for (const step_done_t& done : answer.dones) {
    for (const step_count_t& each : done.published) {
      if (bus_.kept().Count(step_, done.participant, each.channel) < each.count) use(done, each);
    }
  }
}

/// True where all that the answer announces is here.
bool HostRelay::IsComplete(const Answer& answer) const {
  bool is_complete = true;
  ForEachMissing(answer, [&](const step_done_t&, const step_count_t&) { is_complete = false; });
  return is_complete;
}

/// Sends home what is complete: all, or what is left of it.
void HostRelay::SendAnswers(int64_t wall_us) {
  const auto first_incomplete = std::stable_partition(
      unsent_.begin(), unsent_.end(), [this](const Answer& answer) { return IsComplete(answer); });
  const bool is_all = awaited_.empty() && first_incomplete == unsent_.end();
  const bool is_any = first_incomplete != unsent_.begin();
  if (!is_any || (!is_all && wall_us - tick_at_us_ < kPartialAfter_us)) return;
  std::set<std::string_view> complete;
  for (auto answer = unsent_.begin(); answer != first_incomplete; ++answer) {
    for (const step_done_t& done : answer->dones) complete.insert(done.participant);
  }
  LinkMessage batch{.kind = LinkKind::kDone, .mission_id = bus_.mission_id(), .step = step_};
  for (const OutsideQueue::Waiting& each : outside_.waiting()) batch.parts.push_back(each.part);
  outside_.Clear();
  bus_.kept().ForEach(step_, [&](const std::string& publisher, const KeptMessages::Kept& kept) {
    if (!complete.contains(publisher)) return;
    batch.parts.push_back({.name = kept.channel, .data = kept.datagram});
  });
  for (auto answer = unsent_.begin(); answer != first_incomplete; ++answer) {
    batch.parts.push_back(std::move(answer->part));
  }
  unsent_.erase(unsent_.begin(), first_incomplete);
  send_(std::move(batch));
}

void HostRelay::OnTime(int64_t wall_us) {
  if (step_ < 0 || wall_us < next_repeat_us_ || (awaited_.empty() && unsent_.empty())) return;
  next_repeat_us_ = wall_us + kRelayRepeat_us;
  if (!awaited_.empty()) bus_.SendPlain(tick_part_);
  for (const Answer& answer : unsent_) {
    ForEachMissing(answer, [this](const step_done_t& done, const step_count_t& each) {
      bus_.Request(step_, done.participant, each.channel);
    });
  }
  SendAnswers(wall_us);
}

int64_t HostRelay::NextDeadline() const {
  const bool waits = step_ >= 0 && !(awaited_.empty() && unsent_.empty());
  return waits ? next_repeat_us_ : std::numeric_limits<int64_t>::max();
}

void HostRelay::Forget(const std::string& participant, int64_t wall_us) {
  active_.erase(participant);
  if (awaited_.erase(participant) > 0 && awaited_.empty()) SendAnswers(wall_us);
}

}  // namespace shoal
