#include "lib/run/hosts/home_relay.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <unordered_map>

#include "lib/base/text/letters.h"
#include "lib/base/text/terminal_text.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/channel_set.h"
#include "lib/run/run/step_answers.h"
#include "lib/run/run/step_inbox.h"

namespace shoal {

namespace {

constexpr size_t kMaxKnownChannels = 100'000;
constexpr size_t kLongestShownChannel = 100;
/// Programs of vehicles, as the table of channels has them.
constexpr std::array<std::string_view, 7> kVehiclePublishers = {
    "vehicle_sim", "helm",          "node_reporter",        "acomms",
    "gateway",     "your programs", "vehicles from outside"};

/// Returns the vehicle whose channel it is, of `vehicles` in upper case; empty: of none.
std::string_view VehicleIn(std::string_view channel,
                           const std::set<std::string, std::less<>>& vehicles) {
  // Vehicle names may hold '_': the longest name that ends the channel's wins, as in PortPlan.
  for (size_t i = channel.find('_'); i != std::string_view::npos; i = channel.find('_', i + 1)) {
    const auto found = vehicles.find(channel.substr(i + 1));
    if (found != vehicles.end()) return *found;
  }
  return {};
}

bool IsOfVehicles(const ChannelRow& row) {
  // "helm, vehicle_sim (collision)": a name, and when.
  std::string_view rest = row.publishers;
  while (!rest.empty()) {
    const size_t comma = rest.find(", ");
    const std::string_view each = rest.substr(0, comma);
    if (std::ranges::find(kVehiclePublishers, each.substr(0, each.find(" ("))) !=
        kVehiclePublishers.end()) {
      return true;
    }
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 2);
  }
  return false;
}

constexpr int64_t kNeverDue = std::numeric_limits<int64_t>::max();

}  // namespace

HomeRelay::HomeRelay(RelayOptions options, PortPlan plan, Transport& transport,
                     std::vector<RelayedHost> hosts, SendToHost send)
    : bus_(std::move(options), std::move(plan), transport), send_(std::move(send)) {
  for (RelayedHost& each : hosts) hosts_.push_back({.relayed = std::move(each)});
  transport.Listen(bus_.plan().tick_port(), std::string(topics::kTick));
  transport.Listen(bus_.plan().tick_port(), std::string(topics::kAppcastReq));
}

bool HomeRelay::IsPlayed(std::string_view publisher) const {
  return std::any_of(hosts_.begin(), hosts_.end(), [&](const Host& host) {
    return host.relayed.participants.contains(publisher);
  });
}

void HomeRelay::OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                           int64_t wall_us) {
  if (port == bus_.plan().tick_port()) {
    if (channel == topics::kTick) {
      OnTick(datagram, wall_us);
    } else if (channel == topics::kResend) {
      bus_.OnResend(
          datagram, [this](std::string_view name) { return IsPlayed(name); }, wall_us);
    } else {
      LinkMessage aside{.kind = LinkKind::kAside, .mission_id = bus_.mission_id()};
      aside.parts.push_back(
          {.name = std::string(channel), .data = Bytes(datagram.begin(), datagram.end())});
      for (size_t i = 0; i < hosts_.size(); ++i) {
        if (hosts_[i].is_connected) send_(i, aside);
      }
    }
    return;
  }
  const auto unsealed = Unseal(datagram);
  if (!unsealed.seal) {
    // What came from outside before the first tick came before the mission.
    if (step_ < 0 || IsAnswer(channel) || bus_.IsEcho(channel, datagram)) return;
    outside_.Add(channel, datagram);
    return;
  }
  if (IsPlayed(unsealed.seal->publisher)) return;  // This relay's own.
  const std::optional<int64_t> step = bus_.kept().Add(channel, datagram);
  if (pending_ && step == pending_->step - 1 && --num_awaited_ <= 0) TrySend();
}

void HomeRelay::OnTick(std::span<const uint8_t> datagram, int64_t wall_us) {
  const auto opened = bus_.Open(topics::kTick, datagram);
  tick_t tick;
  if (!opened || !Decode(opened->message, &tick)) return;
  if (tick.step == step_) {
    // The clock lacks an answer; it may have been lost on this bus.
    for (const auto& [publisher, answer] : answers_) bus_.SendPlain(answer);
  }
  if (tick.step <= step_) return;
  step_ = tick.step;
  is_end_ = tick.kind == tick_t::END;
  tick_at_us_ = wall_us;
  const double step_us = static_cast<double>(bus_.tick_us()) / tick.warp;
  due_us_ = tick.warp > 0 && step_us < 1e15 ? wall_us + static_cast<int64_t>(step_us) : kNeverDue;
  answers_.clear();
  bus_.kept().ForgetBefore(step_ - 2);
  tick_part_ = {.name = std::string(topics::kTick),
                .data = Bytes(datagram.begin(), datagram.end())};
  pending_ = std::move(tick);
  next_request_us_ = wall_us + kRelayRepeat_us;
  TrySend();
}

template <class Use>
void HomeRelay::ForEachMissing(Use use) const {
  for (const step_total_t& total : pending_->totals) {
    const bool is_wanted = std::any_of(hosts_.begin(), hosts_.end(), [&](const Host& host) {
      return host.is_connected && !host.relayed.participants.contains(total.publisher) &&
             host.relayed.wants(total.channel);
    });
    if (!is_wanted) continue;
    const int32_t received = bus_.kept().Count(pending_->step - 1, total.publisher, total.channel);
    if (received < total.count) use(total, total.count - received);
  }
}

void HomeRelay::TrySend() {
  num_awaited_ = 0;
  ForEachMissing([this](const step_total_t&, int32_t missing) { num_awaited_ += missing; });
  if (num_awaited_ > 0) return;
  for (size_t i = 0; i < hosts_.size(); ++i) {
    if (hosts_[i].is_connected) send_(i, BatchFor(i));
  }
  outside_.Clear();
  pending_.reset();
}

LinkMessage HomeRelay::BatchFor(size_t number) const {
  const Host& host = hosts_[number];
  LinkMessage batch{
      .kind = LinkKind::kTick, .mission_id = bus_.mission_id(), .step = pending_->step};
  for (const OutsideQueue::Waiting& each : outside_.waiting()) {
    const bool is_wanted = each.from != number && host.relayed.wants(each.part.name);
    if (is_wanted) batch.parts.push_back(each.part);
  }
  bus_.kept().ForEach(
      pending_->step - 1, [&](const std::string& publisher, const KeptMessages::Kept& kept) {
        if (host.relayed.participants.contains(publisher) || !host.relayed.wants(kept.channel)) {
          return;
        }
        batch.parts.push_back({.name = kept.channel, .data = kept.datagram});
      });
  batch.parts.push_back(tick_part_);
  return batch;
}

/// Empty: it is not a genuine answer of participants of this host alone.
std::string HomeRelay::PublisherOfAnswer(const Host& host, const LinkPart& part) {
  const auto opened = bus_.Open(part.name, part.data);
  if (!opened) return {};
  const std::optional<step_dones_t> answers = DecodeStepAnswers(part.name, opened->message);
  const auto is_of_host = [&](const step_done_t& done) {
    return host.relayed.participants.contains(done.participant);
  };
  if (answers && std::all_of(answers->dones.begin(), answers->dones.end(), is_of_host)) {
    return answers->dones.front().participant;
  }
  bus_.CountRefused();
  return {};
}

bool HomeRelay::MayPublish(const Host& host, const LinkPart& part) const {
  const Unsealed unsealed = Unseal(part.data);
  return host.relayed.may_publish(unsealed.seal ? unsealed.seal->publisher : std::string_view(),
                                  part.name);
}

std::string HomeRelay::OnMessage(size_t host, const LinkMessage& message, int64_t wall_us) {
  Host& from = hosts_[host];
  std::string dropped;
  bool has_answer = false;
  size_t num_outside = 0;
  for (const LinkPart& part : message.parts) {
    if (part.name == topics::kAppcast) {
      bus_.SendPlain(part);
    } else if (IsStepAnswer(part.name)) {
      const std::string publisher = PublisherOfAnswer(from, part);
      if (publisher.empty()) continue;
      if (message.step == step_ && step_ >= 0) {
        answers_[publisher] = part;
        has_answer = true;
      }
      bus_.SendPlain(part);
    } else if (!MayPublish(from, part)) {
      ++from.num_dropped;
      if (dropped.empty()) dropped = TerminalLine(part.name, kLongestShownChannel);
    } else if (!Unseal(part.data).seal) {
      // No host hands on more in a step.
      if (++num_outside > StepInbox::kMaxOutside) {
        bus_.CountRefused();
        continue;
      }
      bus_.SendOutside(part);
      outside_.Add(part.name, part.data, host);
    } else {
      bus_.SendSealed(part, [&](std::string_view publisher) {
        return from.relayed.participants.contains(publisher);
      });
    }
  }
  if (!has_answer || is_end_ || from.timed_step == step_) return dropped;
  from.timed_step = step_;
  from.timing.answer_us.push_back(static_cast<int32_t>(
      std::min<int64_t>(wall_us - tick_at_us_, std::numeric_limits<int32_t>::max())));
  if (wall_us <= due_us_) return dropped;
  ++from.timing.num_late;
  from.timing.worst_late_us = std::max(from.timing.worst_late_us, wall_us - due_us_);
  return dropped;
}

int64_t HomeRelay::WaitedFor(size_t host, int64_t wall_us) const {
  const Host& each = hosts_[host];
  const bool owes = each.is_connected && step_ >= 0 && !is_end_ && !pending_;
  return owes && each.timed_step == step_ - 1 ? wall_us - tick_at_us_ : 0;
}

void HomeRelay::OnTime(int64_t wall_us) {
  if (!pending_ || wall_us < next_request_us_) return;
  next_request_us_ = wall_us + kRelayRepeat_us;
  ForEachMissing([this](const step_total_t& total, int32_t) {
    bus_.Request(pending_->step - 1, total.publisher, total.channel);
  });
  TrySend();  // Without a host that has been lost, nothing may be missing any more.
}

int64_t HomeRelay::NextDeadline() const {
  return pending_ ? next_request_us_ : std::numeric_limits<int64_t>::max();
}

RelayedHost::MayPublish ChannelsFrom(const std::vector<std::string>& all_vehicles,
                                     const std::vector<std::string>& vehicles,
                                     const std::set<std::string, std::less<>>& programs) {
  std::set<std::string, std::less<>> all;
  for (const std::string& each : all_vehicles) all.insert(UpperCase(each));
  std::set<std::string, std::less<>> own;
  for (const std::string& each : vehicles) own.insert(UpperCase(each));
  std::set<std::string, std::less<>> stepping;  // On the ports of the step protocol.
  std::set<std::string, std::less<>> others;    // Of the shore, and of no vehicle's app.
  for (const ChannelRow& row : ChannelTable()) {
    if (row.home == ChannelHome::kTickPort || row.home == ChannelHome::kDonePort) {
      stepping.emplace(row.topic);
    } else if (row.home == ChannelHome::kShore && !IsOfVehicles(row)) {
      others.emplace(row.topic);
    }
  }
  // A step brings the same channels again and again.
  auto known = std::make_shared<std::unordered_map<std::string, bool, TextHash, std::equal_to<>>>();
  return [=](std::string_view publisher, std::string_view channel) {
    const bool is_of_program = publisher.empty() ? !programs.empty() : programs.contains(publisher);
    if (is_of_program) return !stepping.contains(channel);
    if (const auto found = known->find(channel); found != known->end()) return found->second;
    const std::string_view vehicle = VehicleIn(channel, all);
    const bool may = !stepping.contains(channel) && !others.contains(channel) &&
                     (vehicle.empty() || own.contains(vehicle));
    if (known->size() < kMaxKnownChannels) known->emplace(channel, may);
    return may;
  };
}

std::function<bool(std::string_view)> ChannelsOf(const std::vector<std::string>& all_vehicles,
                                                 const std::vector<std::string>& vehicles,
                                                 const std::vector<std::string>& others) {
  // The ports of the `communities` layout show whose a channel is; vehicles beyond 128 share them.
  const auto plan =
      std::make_shared<PortPlan>(PortPlan::kDefaultBase, Layout::kCommunities, all_vehicles);
  auto ports = std::make_shared<std::set<int>>();
  ports->insert(plan->shore_port());
  for (const std::string& vehicle : vehicles) {
    ports->insert(plan->PortOf(channels::Nav(vehicle).name));
  }
  // A step asks for the same channels again and again.
  auto known = std::make_shared<std::unordered_map<std::string, bool, TextHash, std::equal_to<>>>();
  for (const std::string& channel : others) known->emplace(channel, true);
  return [plan, ports, known, num_others = known->size()](std::string_view channel) {
    const auto found = known->find(channel);
    if (found != known->end()) return found->second;
    const bool is_wanted = ports->contains(plan->PortOf(channel));
    if (known->size() < num_others + kMaxKnownChannels) known->emplace(channel, is_wanted);
    return is_wanted;
  };
}

}  // namespace shoal
