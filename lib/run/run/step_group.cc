#include "lib/run/run/step_group.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/appcast.h"
#include "lib/run/run/bus_page.h"
#include "lib/run/run/read_tick.h"

namespace shoal {

namespace {

constexpr int64_t kHelloInterval_us = 200'000;
constexpr int64_t kRequestInterval_us = 50'000;
/// People ask for pages seldom, and a lost message is asked for again every 50 ms; floods of either
/// must not hold up the steps.
constexpr int64_t kPageInterval_us = 20'000;
constexpr int64_t kResendInterval_us = 30'000;

}  // namespace

StepGroup::StepGroup(StepGroupOptions options, PortPlan plan, Transport& transport)
    : options_(options),
      plan_(std::move(plan)),
      transport_(transport),
      inbox_([this](std::string_view channel) { return Wants(channel); }, options_.secret),
      mission_id_(options_.mission_id) {
  hub_.KeepFor([](std::string_view) { return true; });
  numbers_.emplace("", hub_.JoinElsewhere(""));
  transport_.Listen(plan_.tick_port(), channels::Tick().name);
  transport_.Listen(plan_.tick_port(), channels::Resend().name);
  transport_.Listen(plan_.tick_port(), channels::AppcastReq().name);
}

Bus& StepGroup::Join(const std::string& name) {
  Member& member = members_.emplace_back(Member{.name = name, .bus = &hub_.Join(name)});
  members_by_name_.emplace(name, &member);
  return *member.bus;
}

void StepGroup::Attach(std::string_view name, App* app) {
  Member* member = Find(name);
  SHOAL_CHECK(member != nullptr, "an app is attached to a participant that has joined");
  member->app = app;
  for (const std::string& channel : app->RequestChannels()) {
    transport_.Listen(plan_.tick_port(), channel);
  }
}

void StepGroup::Listen() {
  for (const Member& member : members_) {
    SHOAL_CHECK(member.app != nullptr, "each participant has its app");
  }
  wants_all_ = hub_.has_listener();
  for (const std::string_view channel : hub_.SubscribedChannels()) {
    wanted_.Add(channel);
    transport_.Listen(plan_.PortOf(channel), std::string(channel));
  }
  if (!wants_all_) return;
  for (const int port : plan_.DataPorts()) transport_.ListenToAll(port);
}

StepGroup::Member* StepGroup::Find(std::string_view name) const {
  const auto found = members_by_name_.find(name);
  return found == members_by_name_.end() ? nullptr : found->second;
}

bool StepGroup::Wants(std::string_view channel) const {
  return wants_all_ || wanted_.Contains(channel);
}

/// Returns the number that the hub gave to a participant of another process.
uint32_t StepGroup::NumberOf(const std::string& publisher) {
  const auto found = numbers_.find(publisher);
  if (found != numbers_.end()) return found->second;
  return numbers_.emplace(publisher, hub_.JoinElsewhere(publisher)).first->second;
}

void StepGroup::OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                           int64_t wall_us) {
  if (port == plan_.tick_port()) {
    if (channel == topics::kTick) {
      OnTick(datagram, wall_us);
    } else if (channel == topics::kResend) {
      OnResend(datagram, wall_us);
    } else if (channel == topics::kAppcastReq) {
      OnAppcastRequest(datagram, wall_us);
    } else {
      OnAppRequest(channel, datagram, wall_us);
    }
    return;
  }
  if (!Wants(channel)) return;  // For another user of the same transport.
  const std::optional<Seal> seal = Unseal(datagram).seal;
  // What came from outside before the first tick came before the mission.
  if (step_ < 0 && !pending_ && !seal) return;
  // It has come back, or a former process published it.
  if (seal && Find(seal->publisher) != nullptr) return;
  const std::optional<int64_t> step = inbox_.Add(channel, datagram, mission_id_);
  if (pending_ && step == pending_->step - 1 && --num_awaited_ <= 0) TryStep();
}

std::optional<std::span<const uint8_t>> StepGroup::Open(std::string_view channel,
                                                        std::span<const uint8_t> datagram) {
  const Unsealed unsealed = Unseal(datagram);
  if (unsealed.seal && mission_id_ != 0 && unsealed.seal->mission_id != mission_id_) {
    ++num_foreign_ticks_;
    return std::nullopt;
  }
  if (IsGenuine(unsealed, options_.secret, channel)) return unsealed.message;
  ++num_forged_;
  return std::nullopt;
}

void StepGroup::OnTick(std::span<const uint8_t> datagram, int64_t wall_us) {
  const auto message = Open(topics::kTick, datagram);
  if (!message) return;
  tick_t tick;
  const auto is_wanted = [this](std::string_view publisher, std::string_view channel) {
    return Wants(channel) && Find(publisher) == nullptr;
  };
  if (!ReadTick(*message, is_wanted, &tick)) {
    members_.front().bus->CountUndecodable(topics::kTick);
    return;
  }
  if (mission_id_ == 0) mission_id_ = tick.mission_id;
  if (tick.mission_id != mission_id_) {
    ++num_foreign_ticks_;
    return;
  }
  if (pending_ && tick.step <= pending_->step) return;
  if (tick.step <= step_) {
    // The clock did not receive the answer, be it to END: send it again.
    if (tick.step == step_) SendDones();
    return;
  }
  if (ended_ || !TakesPart(tick)) return;
  if (tick.step != step_ + 1) inbox_.StartAt(std::max<int64_t>(tick.step - 1, 0));
  pending_ = std::move(tick);
  collecting_since_ = wall_us;
  next_request_ = wall_us + kRequestInterval_us;
  TryStep();
}

/// False until the clock waits for the answers of this very process: what it published before would
/// not be announced. A tick that names a former process of these names is repeated, or replayed.
bool StepGroup::TakesPart(const tick_t& tick) const {
  if (step_ >= 0 || pending_ || tick.kind == tick_t::END) return true;
  for (size_t i = 0; i < tick.joined.size(); ++i) {
    if (Find(tick.joined[i]) != nullptr && tick.joined_pids[i] == options_.pid) return true;
  }
  return false;
}

void StepGroup::TryStep() {
  num_awaited_ = 0;
  for (const MiscountedMessages& each : inbox_.Missing(*pending_)) {
    num_awaited_ += each.expected - each.received;
  }
  if (num_awaited_ > 0) return;
  const std::vector<MiscountedMessages> excess = inbox_.Excess(*pending_);
  if (excess.empty()) {
    RunStep();
    return;
  }
  const MiscountedMessages& first = excess.front();
  SendDone(fmt::format("{} published {} messages on {} in step {} and announced {}",
                       first.publisher, first.received, first.channel, pending_->step - 1,
                       first.expected));
}

void StepGroup::RunStep() {
  SHOAL_CHECK(NumPublished() == num_sent_, "an app publishes only while it handles a step");
  step_ = pending_->step;
  utime_ = pending_->utime;
  const tick_t tick = std::move(*pending_);
  pending_.reset();
  for (const StepInbox::Stored& stored : inbox_.Take(tick)) {
    hub_.Insert(NumberOf(stored.publisher), stored.channel, stored.sequence, stored.data);
  }
  hub_.NextStep();
  StepApps(tick);
  SendPublished();
  SendDone("");
}

void StepGroup::StepApps(const tick_t& tick) {
  ended_ = tick.kind == tick_t::END;
  for (const Member& member : members_) {
    hub_.Handle(*member.bus);
    if (ended_) {
      member.app->End();
      continue;
    }
    if (warp_ != tick.warp) member.app->OnWarp(tick.warp);
    member.app->Tick(utime_);
    if (const std::string crash = member.app->Crash(); !crash.empty()) {
      fmt::print(stderr, "{}: {}\n", member.name, crash);
      std::abort();
    }
  }
  if (!ended_) warp_ = tick.warp;
}

/// Seals what the participants published in this step, each in its own name, sends and keeps it.
void StepGroup::SendPublished() {
  sent_.BeginStep(step_);
  for (Member& member : members_) {
    for (auto& [channel, count] : member.num_published) count = 0;
  }
  Member* publisher = nullptr;
  hub_.VisitPublished([&](const MemoryBus::Published& each) {
    if (publisher == nullptr || publisher->name != each.publisher) publisher = Find(each.publisher);
    auto count = publisher->num_published.find(each.channel);
    if (count == publisher->num_published.end()) {
      count = publisher->num_published.emplace(each.channel, 0).first;
    }
    ++count->second;
    ++num_sent_;
    SentMessages::Sent* sent = sent_.Add(each.publisher, each.channel);
    sent->datagram.assign(each.data.begin(), each.data.end());
    AppendSeal({.publisher = each.publisher,
                .mission_id = mission_id_,
                .step = step_,
                .sequence = each.sequence},
               options_.secret, each.channel, &sent->datagram);
    transport_.Send(plan_.PortOf(each.channel), each.channel, sent->datagram);
  });
}

/// `fault`: of the process, stated in the name of its first participant; or empty.
void StepGroup::SendDone(const std::string& fault) {
  dones_.utime = utime_;
  dones_.dones.clear();
  for (const Member& member : members_) dones_.dones.push_back(DoneOf(member));
  dones_.num_dones = static_cast<int32_t>(dones_.dones.size());
  // What is counted for the process as a whole counts once.
  step_done_t& first = dones_.dones.front();
  first.repeated = num_requests_;
  first.outside = inbox_.counters().outside;
  first.foreign = num_foreign();
  first.refused = num_refused();
  if (!fault.empty()) first.fault = fault;
  SendDones();
}

step_done_t StepGroup::DoneOf(const Member& member) const {
  step_done_t done{};
  done.utime = utime_;
  done.mission_id = mission_id_;
  done.step = step_;
  done.participant = member.name;
  done.pid = options_.pid;
  done.undecodable = member.bus->counters().undecodable;
  if (step_ < 0) return done;
  done.fault = member.app->Fault();
  for (const auto& [channel, count] : member.num_published) {
    if (count > 0) done.published.push_back({.channel = channel, .count = count});
  }
  done.num_published = static_cast<int32_t>(done.published.size());
  return done;
}

void StepGroup::SendDones() {
  if (dones_.dones.size() == 1) {
    SendSealed(channels::StepDone(), dones_.dones.front(), step_);
  } else {
    SendSealed(channels::StepDones(), dones_, step_);
  }
}

template <class T>
void StepGroup::SendSealed(const Channel<T>& channel, const T& message, int64_t step) {
  Bytes bytes;
  EncodeInto(message, &bytes);
  AppendSeal(
      {.publisher = members_.front().name, .mission_id = mission_id_, .step = step, .sequence = 0},
      options_.secret, channel.name, &bytes);
  transport_.Send(plan_.PortOf(channel.name), channel.name, bytes);
}

int64_t StepGroup::NumPublished() const {
  int64_t num_published = 0;
  for (const Member& member : members_) num_published += member.bus->counters().published;
  return num_published;
}

int64_t StepGroup::num_refused() const {
  return num_forged_ + inbox_.counters().forged + inbox_.counters().no_room +
         transport_.num_refused();
}

void StepGroup::OnTime(int64_t wall_us) {
  if (step_ < 0 && !pending_) {
    if (wall_us >= next_hello_) {
      SendDone("");
      next_hello_ = wall_us + kHelloInterval_us;
    }
    return;
  }
  if (!pending_ || wall_us < next_request_) return;
  const std::vector<MiscountedMessages> missing = inbox_.Missing(*pending_);
  if (missing.empty()) {
    TryStep();
    return;
  }
  next_request_ = wall_us + kRequestInterval_us;
  if (wall_us - collecting_since_ < options_.give_up_us) {
    RequestMissing(missing);
    return;
  }
  const MiscountedMessages& first = missing.front();
  SendDone(fmt::format(
      "{} of {} messages of {} on {} in step {} never reached {}, though asked for again for "
      "{:.1f} s",
      first.expected - first.received, first.expected, first.publisher, first.channel,
      pending_->step - 1, members_.front().name, Seconds(options_.give_up_us)));
}

int64_t StepGroup::NextDeadline() const {
  if (step_ < 0 && !pending_) return next_hello_;
  if (pending_) return next_request_;
  return std::numeric_limits<int64_t>::max();
}

void StepGroup::RequestMissing(const std::vector<MiscountedMessages>& missing) {
  for (const MiscountedMessages& each : missing) {
    num_requests_ += each.expected - each.received;
    resend_t request;
    request.utime = utime_;
    request.mission_id = mission_id_;
    request.step = pending_->step - 1;
    request.requester = members_.front().name;
    request.publisher = each.publisher;
    request.channel = each.channel;
    SendSealed(channels::Resend(), request, request.step);
  }
}

void StepGroup::OnResend(std::span<const uint8_t> datagram, int64_t wall_us) {
  const auto message = Open(topics::kResend, datagram);
  resend_t request;
  if (!message) return;
  if (!Decode(*message, &request)) {
    members_.front().bus->CountUndecodable(topics::kResend);
    return;
  }
  if (request.mission_id != mission_id_ || !sent_.Has(request.publisher, request.channel)) return;
  int64_t& next_resend =
      next_resends_.try_emplace({request.publisher, request.channel}, 0).first->second;
  if (wall_us < next_resend) return;
  next_resend = wall_us + kResendInterval_us;
  sent_.Visit(request.step, request.publisher, request.channel,
              [this](const SentMessages::Sent& sent) {
                transport_.Send(plan_.PortOf(sent.channel), sent.channel, sent.datagram);
              });
}

void StepGroup::OnAppcastRequest(std::span<const uint8_t> datagram, int64_t wall_us) {
  appcast_req_t request;
  if (!Decode(datagram, &request)) {
    members_.front().bus->CountUndecodable(topics::kAppcastReq);
    return;
  }
  for (Member& member : members_) {
    if (request.app != "all" && request.app != member.name) continue;
    if (wall_us < member.next_page) continue;
    member.next_page = wall_us + kPageInterval_us;
    Bytes bytes;  // Pages are read by programs that do not step; they have no seal.
    EncodeInto(ToAppcast(StatusOf(member), member.name, utime_, step_), &bytes);
    transport_.Send(plan_.PortOf(topics::kAppcast), topics::kAppcast, bytes);
  }
}

void StepGroup::OnAppRequest(std::string_view channel, std::span<const uint8_t> datagram,
                             int64_t wall_us) {
  for (Member& member : members_) {
    if (wall_us < member.next_answer) continue;
    const std::optional<App::RequestAnswer> answer = member.app->Answer(channel, datagram);
    if (!answer) continue;
    member.next_answer = wall_us + kPageInterval_us;
    transport_.Send(plan_.PortOf(answer->channel), answer->channel, answer->data);
  }
}

StatusPage StepGroup::Status(std::string_view name) const {
  const Member* member = Find(name);
  SHOAL_CHECK(member != nullptr, "the page of a participant of this process is wanted");
  return StatusOf(*member);
}

StatusPage StepGroup::StatusOf(const Member& member) const {
  StatusPage page = member.app->Status();
  AppendBus({.participant = member.bus->counters(),
             .inbox = inbox_.counters(),
             .first_forged = inbox_.first_forged(),
             .num_foreign = num_foreign(),
             .num_forged = num_forged_ + inbox_.counters().forged,
             .num_requests = num_requests_,
             .num_refused = num_refused()},
            &page);
  return page;
}

}  // namespace shoal
