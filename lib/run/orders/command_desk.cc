#include "lib/run/orders/command_desk.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "lib/bus/bus/channels.h"

namespace shoal {

namespace {

/// No order has more words.
constexpr size_t kMaxWords = 16;
constexpr size_t kMaxWordLength = 200;
constexpr size_t kMaxInbox = 100;  ///< OnTime empties it.

constexpr int64_t kPatience_us = 5'000'000;
/// Between two requests where an answer is late, or the mission stands still.
constexpr int64_t kSlowRequest_us = 1'000'000;
/// Of more participants than this, all are asked in one request.
constexpr size_t kMaxRequests = 4;
constexpr size_t kMaxNamed = 5;  ///< In a reason; more are counted.

bool IsText(std::string_view word) {
  return word.size() <= kMaxWordLength && std::all_of(word.begin(), word.end(), [](char each) {
           return static_cast<unsigned char>(each) >= ' ' && each != '\x7f';
         });
}

std::string ListOf(const std::vector<std::string>& parts, std::string_view separator) {
  const size_t num_shown = std::min(parts.size(), kMaxNamed);
  std::string text = fmt::format(
      "{}",
      fmt::join(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(num_shown), separator));
  if (parts.size() > num_shown) text += fmt::format(" and {} more", parts.size() - num_shown);
  return text;
}

/// "return to alpha", "comms_range 100".
std::string TextOf(const Order& order, std::string_view target,
                   std::span<const std::string> words) {
  const std::string what = fmt::format("{}", fmt::join(words, " "));
  const std::vector<std::string>* vehicles = nullptr;
  if (const auto* helms = std::get_if<OrderToHelms>(&order)) vehicles = &helms->vehicles;
  if (const auto* sims = std::get_if<OrderToSims>(&order)) vehicles = &sims->vehicles;
  if (vehicles == nullptr) return fmt::format("{}{}{}", target, what.empty() ? "" : " ", what);
  return fmt::format("{} to {}", what, target == "all" ? "all" : vehicles->front());
}

/// "bravo: speed: no task runs"; of one vehicle the name is in the record's text.
std::string Refusals(const OrderWatch& watch) {
  std::vector<std::string> refusals;
  for (const OrderWatch::Answer& answer : watch.answers()) {
    if (answer.outcome != OrderOutcome::kRefused) continue;
    refusals.push_back(watch.answers().size() == 1
                           ? answer.reason
                           : fmt::format("{}: {}", answer.trace.participant, answer.reason));
  }
  return ListOf(refusals, "; ");
}

std::string NoAnswer(const OrderWatch& watch) {
  std::vector<std::string> silent;
  for (const OrderWatch::Answer& answer : watch.answers()) {
    if (answer.outcome == OrderOutcome::kOpen) silent.push_back(answer.trace.participant);
  }
  if (watch.answers().size() <= 1) return "no answer yet";
  return "no answer yet from " + ListOf(silent, ", ");
}

}  // namespace

CommandDesk::CommandDesk(Bus& bus, OrderScope scope) : bus_(bus), scope_(std::move(scope)) {
  Subscribe(bus, channels::Appcast(), [this](const appcast_t& page) {
    for (Pending& each : pending_) each.watch.OnPage(page, now_us_);
  });
  Subscribe(bus, channels::ClockState(), [this](const clock_state_t& state) {
    if (scope_.mission_id != 0 && state.mission_id != scope_.mission_id) return;
    for (Pending& each : pending_) {
      // Each answer is for one order: the first that it agrees with.
      if (each.clock && each.is_published && !each.clock->IsSettled() &&
          each.clock->OnState(state)) {
        break;
      }
    }
    clock_state_ = state;
  });
}

Result<CommandRecord> CommandDesk::Send(std::string_view target, std::span<const std::string> words,
                                        double t_s) {
  if (words.size() > kMaxWords || !IsText(target) ||
      !std::all_of(words.begin(), words.end(), IsText)) {
    return Error{fmt::format("an order has at most {} words of at most {} characters", kMaxWords,
                             kMaxWordLength)};
  }
  Result<Order> order = ParseOrder(scope_, target, words);
  if (!order.ok()) return Error{order.error()};
  if (std::holds_alternative<MessageOfVehicles>(*order)) {
    return Error{"node messages are sent by `shoal send`, not from here"};
  }
  CommandRecord record;
  record.t_s = t_s;
  record.text = TextOf(*order, target, words);
  record.state = "sent";
  const std::lock_guard lock(mutex_);
  if (inbox_.size() >= kMaxInbox) return Error{"too many orders at once: wait a moment"};
  record.id = ++last_id_;
  records_.push_back(record);
  if (records_.size() > kMaxRecords) records_.pop_front();
  inbox_.emplace_back(record.id, std::move(*order));
  return record;
}

std::vector<CommandRecord> CommandDesk::records() const {
  const std::lock_guard lock(mutex_);
  return {records_.begin(), records_.end()};
}

void CommandDesk::OnTime(int64_t now_us) {
  const bool is_paused = clock_state_ && clock_state_->state == "paused";
  for (Pending& each : pending_) {
    if (each.is_published && (!is_paused || each.clock)) each.waited_us += now_us - now_us_;
  }
  now_us_ = now_us;
  TakeIn();
  PublishDue();
  Request(is_paused);
  Settle();
}

/// Takes over what Send has left, and forgets what no record refers to any more.
void CommandDesk::TakeIn() {
  std::vector<std::pair<int64_t, Order>> inbox;
  int64_t first_id = 0;
  {
    const std::lock_guard lock(mutex_);
    inbox.swap(inbox_);
    if (!records_.empty()) first_id = records_.front().id;
  }
  for (auto& [id, order] : inbox) {
    std::vector<OrderTrace> traces = TracesOf(order);
    pending_.push_back({.id = id,
                        .order = std::move(order),
                        .watch = OrderWatch(std::move(traces)),
                        .clock = std::nullopt});
  }
  std::erase_if(pending_,
                [&](const Pending& each) { return each.is_published && each.id < first_id; });
}

/// In the order of Send: none overtakes another.
void CommandDesk::PublishDue() {
  std::vector<const OrderWatch*> earlier;
  for (Pending& each : pending_) {
    if (!each.is_published) {
      if (!each.watch.IsReady(now_us_)) return;
      Publish(bus_, each.order);
      each.watch.Sent(now_us_, earlier);
      if (const auto* clock = std::get_if<OrderToClock>(&each.order)) {
        each.clock.emplace(clock->command, clock_state_);
      }
      each.is_published = true;
    }
    earlier.push_back(&each.watch);
  }
}

void CommandDesk::Request(bool is_paused) {
  std::set<std::string> apps;
  for (Pending& each : pending_) {
    const bool is_slow = each.is_published && (is_paused || each.waited_us > kPatience_us);
    const std::vector<std::string> due =
        each.watch.Due(now_us_, is_slow ? kSlowRequest_us : OrderWatch::kRequestInterval_us);
    apps.insert(due.begin(), due.end());
  }
  if (apps.size() > kMaxRequests) apps = {"all"};
  for (const std::string& app : apps) {
    appcast_req_t request{};
    request.app = app;
    Publish(bus_, channels::AppcastReq(), request);
  }
}

void CommandDesk::Settle() {
  const std::lock_guard lock(mutex_);
  std::erase_if(pending_, [&](const Pending& each) {
    const auto record = std::find_if(records_.begin(), records_.end(),
                                     [&](const CommandRecord& row) { return row.id == each.id; });
    if (!each.is_published || record == records_.end()) return false;
    if (each.clock ? !each.clock->IsSettled() : !each.watch.IsSettled()) {
      const std::string refusals = Refusals(each.watch);
      record->reason = refusals;
      if (each.waited_us >= kPatience_us) {
        record->reason += (refusals.empty() ? "" : "; ") + NoAnswer(each.watch);
      }
      if (!refusals.empty()) record->state = "refused";
      return false;
    }
    record->reason = each.clock ? each.clock->refusal() : Refusals(each.watch);
    record->state = record->reason.empty() ? "taken" : "refused";
    if (const std::string done = each.clock ? "" : DoneBesideRefusals(each.watch.answers());
        !done.empty()) {
      record->reason += "; done all the same: " + done;
    }
    return true;
  });
}

}  // namespace shoal
