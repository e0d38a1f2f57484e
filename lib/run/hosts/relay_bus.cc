#include "lib/run/hosts/relay_bus.h"

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/step_inbox.h"

namespace shoal {

namespace {

/// As participants: a lost message is asked for again every 50 ms, by several at once.
constexpr int64_t kRelayResend_us = 30'000;
constexpr size_t kMaxEchoes = 2 * StepInbox::kMaxOutside;
/// Of what is asked for again: a publisher's channels, for each participant.
constexpr size_t kMaxResends = 1'000'000;

}  // namespace

RelayBus::RelayBus(RelayOptions options, PortPlan plan, Transport& transport)
    : options_(std::move(options)),
      plan_(std::move(plan)),
      transport_(transport),
      kept_(options_.mission_id, options_.secret) {
  transport_.Listen(plan_.tick_port(), std::string(topics::kResend));
  for (const int port : plan_.DataPorts()) transport_.ListenToAll(port);
}

std::optional<RelayBus::Opened> RelayBus::Open(std::string_view channel,
                                               std::span<const uint8_t> datagram) {
  const Unsealed unsealed = Unseal(datagram);
  const bool is_of_mission = unsealed.seal && unsealed.seal->mission_id == options_.mission_id;
  // A hello may not know the mission's id yet.
  const bool is_hello = unsealed.seal && unsealed.seal->step < 0 && unsealed.seal->mission_id == 0;
  if ((is_of_mission || is_hello) && IsGenuine(unsealed, options_.secret, channel)) {
    return Opened{.publisher = std::string(unsealed.seal->publisher), .message = unsealed.message};
  }
  ++num_refused_;
  return std::nullopt;
}

void RelayBus::SendSealed(const LinkPart& part,
                          const std::function<bool(std::string_view)>& runs_there) {
  const Unsealed unsealed = Unseal(part.data);
  if (!unsealed.seal || !runs_there(unsealed.seal->publisher)) {
    ++num_refused_;
    return;
  }
  if (kept_.Add(part.name, part.data)) SendPlain(part);
}

void RelayBus::SendPlain(const LinkPart& part) {
  transport_.Send(plan_.PortOf(part.name), part.name, part.data);
}

void RelayBus::SendOutside(const LinkPart& part) {
  const size_t bytes = part.name.size() + part.data.size();
  if (echoes_.size() < kMaxEchoes && echo_bytes_ + bytes <= StepInbox::kMaxOutsideBytes) {
    if (++echoes_[{part.name, part.data}] == 1) echo_bytes_ += bytes;
  }
  SendPlain(part);
}

bool RelayBus::IsEcho(std::string_view channel, std::span<const uint8_t> datagram) {
  const auto found = echoes_.find({std::string(channel), Bytes(datagram.begin(), datagram.end())});
  if (found == echoes_.end()) return false;
  if (--found->second == 0) {
    echo_bytes_ -= found->first.first.size() + found->first.second.size();
    echoes_.erase(found);
  }
  return true;
}

void RelayBus::OnResend(std::span<const uint8_t> datagram,
                        const std::function<bool(std::string_view)>& is_played, int64_t wall_us) {
  const std::optional<Opened> opened = Open(topics::kResend, datagram);
  resend_t request;
  if (!opened || !Decode(opened->message, &request) || !is_played(request.publisher)) return;
  if (next_resends_.size() >= kMaxResends) next_resends_.clear();
  int64_t& next = next_resends_.try_emplace({request.publisher, request.channel}, 0).first->second;
  if (wall_us < next) return;
  next = wall_us + kRelayResend_us;
  kept_.ForEach(request.step, [&](const std::string& publisher, const KeptMessages::Kept& kept) {
    if (publisher != request.publisher || kept.channel != request.channel) return;
    transport_.Send(plan_.PortOf(kept.channel), kept.channel, kept.datagram);
  });
}

void RelayBus::Request(int64_t step, const std::string& publisher, const std::string& channel) {
  resend_t request{};
  request.mission_id = options_.mission_id;
  request.step = step;
  request.requester = options_.name;
  request.publisher = publisher;
  request.channel = channel;
  Bytes bytes;
  EncodeInto(request, &bytes);
  AppendSeal(
      {.publisher = options_.name, .mission_id = options_.mission_id, .step = step, .sequence = 0},
      options_.secret, topics::kResend, &bytes);
  transport_.Send(plan_.tick_port(), topics::kResend, bytes);
}

void OutsideQueue::Add(std::string_view channel, std::span<const uint8_t> datagram, size_t from) {
  if (waiting_.size() >= StepInbox::kMaxOutside ||
      bytes_ + datagram.size() > StepInbox::kMaxOutsideBytes / 2) {
    return;
  }
  bytes_ += datagram.size();
  waiting_.push_back(
      {.part = {.name = std::string(channel), .data = Bytes(datagram.begin(), datagram.end())},
       .from = from});
}

void OutsideQueue::Clear() {
  waiting_.clear();
  bytes_ = 0;
}

}  // namespace shoal
