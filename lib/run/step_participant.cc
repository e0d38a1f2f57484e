#include "lib/run/step_participant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "lib/bus/channels.h"
#include "lib/bus/seal.h"
#include "lib/run/appcast.h"

namespace shoal {

namespace {

constexpr int64_t kHelloInterval_us = 200'000;
constexpr int64_t kRequestInterval_us = 50'000;
/// People ask for pages seldom, and a lost message is asked for again every 50 ms; floods of either
/// must not hold up the steps.
constexpr int64_t kPageInterval_us = 20'000;
constexpr int64_t kResendInterval_us = 30'000;
constexpr size_t kStepsKept = 2;

}  // namespace

StepParticipant::StepParticipant(ParticipantOptions options, PortPlan plan, Transport& transport)
    : options_(std::move(options)),
      plan_(std::move(plan)),
      transport_(transport),
      inbox_([this](std::string_view channel) { return handlers_.Wants(channel); },
             options_.secret),
      mission_id_(options_.mission_id) {
  transport_.Listen(plan_.tick_port(), channels::Tick().name);
  transport_.Listen(plan_.tick_port(), channels::Resend().name);
  transport_.Listen(plan_.tick_port(), channels::AppcastReq().name);
}

void StepParticipant::Attach(App* app) {
  app_ = app;
  for (const std::string& channel : app->RequestChannels()) {
    transport_.Listen(plan_.tick_port(), channel);
  }
}

void StepParticipant::PublishBytes(std::string_view channel, std::span<const uint8_t> data) {
  SHOAL_CHECK(in_step_, "an app publishes only while it handles a step");
  Sent sent{.channel = std::string(channel), .datagram = Bytes(data.begin(), data.end())};
  AppendSeal({.publisher = options_.name,
              .mission_id = mission_id_,
              .step = step_,
              .sequence = sequence_++},
             options_.secret, channel, &sent.datagram);
  transport_.Send(plan_.PortOf(channel), channel, sent.datagram);
  ++counters_.published;
  sent_.back().messages.push_back(std::move(sent));
}

void StepParticipant::SubscribeBytes(const std::string& channel, Handler handler) {
  if (handlers_.Add(channel, std::move(handler))) {
    transport_.Listen(plan_.PortOf(channel), channel);
  }
}

void StepParticipant::SubscribeAll(Handler handler) {
  SHOAL_CHECK(handlers_.empty(), "SubscribeAll comes before any other subscription");
  handlers_.AddForAll(std::move(handler));
  for (const int port : plan_.DataPorts()) transport_.ListenToAll(port);
}

void StepParticipant::OnDatagram(int port, std::string_view channel,
                                 std::span<const uint8_t> datagram, int64_t wall_us) {
  if (port == plan_.tick_port()) {
    if (channel == topics::kTick) {
      const auto message = Open(channel, datagram);
      tick_t tick;
      if (message && Decode(*message, &tick)) {
        OnTick(tick, wall_us);
      } else if (message) {
        CountUndecodable(channel);
      }
    } else if (channel == topics::kResend) {
      OnResend(datagram, wall_us);
    } else if (channel == topics::kAppcastReq) {
      OnAppcastRequest(datagram, wall_us);
    } else {
      OnAppRequest(channel, datagram, wall_us);
    }
    return;
  }
  // What came from outside before the first tick came before the mission.
  if (step_ < 0 && !pending_ && !Unseal(datagram).seal) return;
  const std::optional<int64_t> step = inbox_.Add(channel, datagram, mission_id_);
  if (pending_ && step == pending_->step - 1 && --num_awaited_ <= 0) TryStep();
}

std::optional<std::span<const uint8_t>> StepParticipant::Open(std::string_view channel,
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

void StepParticipant::OnTick(const tick_t& tick, int64_t wall_us) {
  if (mission_id_ == 0) mission_id_ = tick.mission_id;
  if (tick.mission_id != mission_id_) {
    ++num_foreign_ticks_;
    return;
  }
  if (pending_ && tick.step <= pending_->step) return;
  if (tick.step <= step_) {
    // The clock did not receive the answer, be it to END: send it again.
    if (tick.step == step_) SendSealed(channels::StepDone(), done_, step_);
    return;
  }
  if (ended_ || !TakesPart(tick)) return;
  if (tick.step != step_ + 1) inbox_.StartAt(std::max<int64_t>(tick.step - 1, 0));
  pending_ = tick;
  if (step_ < 0) {
    // What a former process of this name published is lost.
    std::erase_if(pending_->totals,
                  [this](const step_total_t& total) { return total.publisher == options_.name; });
  }
  collecting_since_ = wall_us;
  next_request_ = wall_us + kRequestInterval_us;
  TryStep();
}

/// False until the clock waits for the answers of this very process: what it published before would
/// not be announced. A tick that names a former process of this name is repeated, or replayed.
bool StepParticipant::TakesPart(const tick_t& tick) const {
  if (step_ >= 0 || pending_ || tick.kind == tick_t::END) return true;
  for (size_t i = 0; i < tick.joined.size(); ++i) {
    if (tick.joined[i] == options_.name && tick.joined_pids[i] == options_.pid) return true;
  }
  return false;
}

void StepParticipant::TryStep() {
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

void StepParticipant::RunStep() {
  const bool is_end = pending_->kind == tick_t::END;
  step_ = pending_->step;
  utime_ = pending_->utime;
  sequence_ = 0;
  sent_.push_back({.step = step_, .messages = {}});
  while (sent_.size() > kStepsKept) sent_.pop_front();
  const tick_t tick = std::move(*pending_);
  pending_.reset();
  in_step_ = true;
  for (const StepInbox::Stored& stored : inbox_.Take(tick)) {
    counters_.handled += handlers_.Call(
        {.channel = stored.channel, .publisher = stored.publisher, .data = stored.data});
  }
  if (is_end) {
    app_->End();
    ended_ = true;
  } else {
    if (warp_ != tick.warp) app_->OnWarp(tick.warp);
    warp_ = tick.warp;
    app_->Tick(utime_);
    if (const std::string crash = app_->Crash(); !crash.empty()) {
      fmt::print(stderr, "{}: {}\n", options_.name, crash);
      std::abort();
    }
  }
  in_step_ = false;
  SendDone(app_->Fault());
}

void StepParticipant::SendDone(const std::string& fault) {
  done_ = step_done_t{};
  done_.utime = utime_;
  done_.mission_id = mission_id_;
  done_.step = step_;
  done_.participant = options_.name;
  done_.pid = options_.pid;
  done_.repeated = num_requests_;
  done_.outside = inbox_.counters().outside;
  done_.foreign = num_foreign();
  done_.undecodable = counters_.undecodable;
  done_.refused = num_refused();
  done_.fault = fault;
  if (step_ >= 0) {
    std::map<std::string_view, int32_t> counts;
    for (const Sent& sent : sent_.back().messages) ++counts[sent.channel];
    for (const auto& [channel, count] : counts) {
      done_.published.push_back({.channel = std::string(channel), .count = count});
    }
    done_.num_published = static_cast<int32_t>(done_.published.size());
  }
  SendSealed(channels::StepDone(), done_, step_);
}

template <class T>
void StepParticipant::SendSealed(const Channel<T>& channel, const T& message, int64_t step) {
  Bytes bytes;
  EncodeInto(message, &bytes);
  AppendSeal({.publisher = options_.name, .mission_id = mission_id_, .step = step, .sequence = 0},
             options_.secret, channel.name, &bytes);
  transport_.Send(plan_.PortOf(channel.name), channel.name, bytes);
}

int64_t StepParticipant::num_refused() const {
  return num_forged_ + inbox_.counters().forged + inbox_.counters().no_room +
         transport_.num_refused();
}

void StepParticipant::OnTime(int64_t wall_us) {
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
      pending_->step - 1, options_.name, static_cast<double>(options_.give_up_us) / 1e6));
}

int64_t StepParticipant::NextDeadline() const {
  if (step_ < 0 && !pending_) return next_hello_;
  if (pending_) return next_request_;
  return std::numeric_limits<int64_t>::max();
}

void StepParticipant::RequestMissing(const std::vector<MiscountedMessages>& missing) {
  for (const MiscountedMessages& each : missing) {
    num_requests_ += each.expected - each.received;
    resend_t request;
    request.utime = utime_;
    request.mission_id = mission_id_;
    request.step = pending_->step - 1;
    request.requester = options_.name;
    request.publisher = each.publisher;
    request.channel = each.channel;
    SendSealed(channels::Resend(), request, request.step);
  }
}

void StepParticipant::OnResend(std::span<const uint8_t> datagram, int64_t wall_us) {
  const auto message = Open(topics::kResend, datagram);
  resend_t request;
  if (!message) return;
  if (!Decode(*message, &request)) {
    CountUndecodable(topics::kResend);
    return;
  }
  if (request.mission_id != mission_id_ || request.publisher != options_.name) return;
  const bool is_own = std::any_of(sent_.begin(), sent_.end(), [&](const SentStep& step) {
    return std::any_of(step.messages.begin(), step.messages.end(),
                       [&](const Sent& sent) { return sent.channel == request.channel; });
  });
  if (!is_own) return;
  int64_t& next_resend = next_resends_.try_emplace(request.channel, 0).first->second;
  if (wall_us < next_resend) return;
  next_resend = wall_us + kResendInterval_us;
  for (const SentStep& step : sent_) {
    if (step.step != request.step) continue;
    for (const Sent& sent : step.messages) {
      if (sent.channel == request.channel) {
        transport_.Send(plan_.PortOf(sent.channel), sent.channel, sent.datagram);
      }
    }
  }
}

void StepParticipant::OnAppcastRequest(std::span<const uint8_t> datagram, int64_t wall_us) {
  appcast_req_t request;
  if (!Decode(datagram, &request)) {
    CountUndecodable(topics::kAppcastReq);
    return;
  }
  if (request.app != "all" && request.app != options_.name) return;
  if (wall_us < next_page_) return;
  next_page_ = wall_us + kPageInterval_us;
  Bytes bytes;  // Pages are read by programs that do not step; they have no seal.
  EncodeInto(ToAppcast(Status(), options_.name, utime_, step_), &bytes);
  transport_.Send(plan_.PortOf(topics::kAppcast), topics::kAppcast, bytes);
}

void StepParticipant::OnAppRequest(std::string_view channel, std::span<const uint8_t> datagram,
                                   int64_t wall_us) {
  if (app_ == nullptr || wall_us < next_answer_) return;
  const std::optional<App::RequestAnswer> answer = app_->Answer(channel, datagram);
  if (!answer) return;
  next_answer_ = wall_us + kPageInterval_us;
  transport_.Send(plan_.PortOf(answer->channel), answer->channel, answer->data);
}

StatusPage StepParticipant::Status() const {
  StatusPage page = app_->Status();
  if (num_foreign() > 0) {
    page.run_warnings.push_back(
        fmt::format("{} messages of another mission rejected: two missions share a block of ports",
                    num_foreign()));
  }
  for (const auto& [channel, count] : counters_.undecodable_by_channel) {
    page.run_warnings.push_back(fmt::format("{} undecodable messages on {}", count, channel));
  }
  if (num_forged_ + inbox_.counters().forged > 0) {
    page.run_warnings.push_back(fmt::format(
        "{} messages refused whose seals do not prove this mission's secret{}",
        num_forged_ + inbox_.counters().forged,
        inbox_.first_forged().empty() ? "" : "; the first: on " + inbox_.first_forged()));
  }
  if (inbox_.counters().no_room > 0) {
    page.run_warnings.push_back(fmt::format("{} sealed messages refused: more than {} wait",
                                            inbox_.counters().no_room, StepInbox::kMaxSealed));
  }
  if (inbox_.counters().dropped > 0) {
    page.run_warnings.push_back(
        fmt::format("{} messages from outside dropped: more than {} in one step",
                    inbox_.counters().dropped, StepInbox::kMaxOutside));
  }
  page.text += fmt::format(
      "\nBus: {} published, {} handled, {} undecodable, {} from outside, {} asked for again, {} "
      "late or repeated, {} refused\n",
      counters_.published, counters_.handled, counters_.undecodable, inbox_.counters().outside,
      num_requests_, inbox_.counters().late, num_refused());
  return page;
}

}  // namespace shoal
