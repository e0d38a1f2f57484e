#include "lib/run/orders/order_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace shoal {

namespace {

/// How long a page from before an order is waited for; it comes within a millisecond.
constexpr int64_t kPagePatience_us = 300'000;
/// An order arrives in the step that the page of before names, or the next; it is handled one later
/// at most. An earlier page may have been published before the order arrived: datagrams on
/// different ports may overtake one another.
constexpr int64_t kStepsToExecute = 2;
constexpr int64_t kDelivery_us = 100'000;
constexpr size_t kMaxReason = 300;  ///< Characters.

/// The recent events of a page, the newest first, and how many there were in all; StatusLog writes
/// them.
struct PageEvents {
  int64_t total = 0;
  std::vector<std::string_view> texts;  ///< Each with its '\n'.
};

PageEvents EventsOf(const appcast_t& appcast) {
  constexpr std::string_view kHead = "\nMost recent events (";
  PageEvents events;
  std::string_view rest = appcast.page;
  const size_t head = rest.rfind(kHead);
  if (head == std::string_view::npos) return events;
  rest.remove_prefix(head + kHead.size());
  std::from_chars(rest.data(), rest.data() + rest.size(), events.total);
  events.total = std::max<int64_t>(events.total, 0);
  rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
  constexpr std::string_view kIndent = "    [";
  while (rest.starts_with(kIndent)) {
    const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size() - 1) + 1);
    const size_t text = line.find("]: ");
    if (text == std::string_view::npos) break;
    events.texts.push_back(line.substr(text + 3));
    rest.remove_prefix(line.size());
  }
  return events;
}

/// "HELM_COMMAND refused: speed: no task runs\n" -> "speed: no task runs".
std::string ReasonOf(std::string_view refusal) {
  constexpr std::string_view kRefused = "refused: ";
  const size_t at = refusal.find(kRefused);
  if (at != std::string_view::npos) refusal.remove_prefix(at + kRefused.size());
  if (refusal.ends_with('\n')) refusal.remove_suffix(1);
  std::string reason(refusal.substr(0, kMaxReason));
  std::replace_if(
      reason.begin(), reason.end(), [](char each) { return each < ' ' || each > '~'; }, '?');
  return reason;
}

/// Looks for what became of an order of which more events may have followed than a page lists.
void JudgeByWarnings(const appcast_t& page, OrderWatch::Answer* answer) {
  const std::vector<std::string>& before = answer->before->run_warnings;
  answer->outcome = OrderOutcome::kTaken;
  for (const std::string& warning : page.run_warnings) {
    if (!warning.starts_with(answer->trace.refused)) continue;
    // Another count behind a warning makes it another warning.
    if (std::find(before.begin(), before.end(), warning) != before.end()) continue;
    answer->outcome = OrderOutcome::kRefused;
    answer->reason = ReasonOf(warning);
    const size_t count = answer->reason.rfind(" (");
    if (count != std::string::npos && answer->reason.ends_with(" times)")) {
      answer->reason.resize(count);
    }
  }
}

void Judge(const appcast_t& page, bool is_surely_later, OrderWatch::Answer* answer) {
  const PageEvents events = EventsOf(page);
  int64_t num_new = events.total - EventsOf(*answer->before).total;
  if (page.step < answer->before->step || num_new < 0) num_new = events.total;  // It was restarted.
  const auto num_listed = static_cast<int64_t>(events.texts.size());
  if (num_new > num_listed) {
    if (is_surely_later) JudgeByWarnings(page, answer);
    return;
  }
  int num_ahead = answer->num_ahead;
  for (int64_t i = num_new - 1; i >= 0; --i) {
    const std::string_view text = events.texts[static_cast<size_t>(i)];
    const bool is_taken = text.starts_with(answer->trace.taken);
    const bool is_refused = text.starts_with(answer->trace.refused);
    if ((!is_taken && !is_refused) || num_ahead-- > 0) continue;
    answer->outcome = is_taken ? OrderOutcome::kTaken : OrderOutcome::kRefused;
    if (is_refused) answer->reason = ReasonOf(text);
    return;
  }
}

}  // namespace

OrderWatch::OrderWatch(std::vector<OrderTrace> traces) {
  for (OrderTrace& trace : traces) answers_.emplace_back().trace = std::move(trace);
}

std::vector<std::string> OrderWatch::Due(int64_t now_us, int64_t interval_us) {
  std::vector<std::string> due;
  if (!first_request_us_) first_request_us_ = now_us;
  if (now_us < next_request_us_) return due;
  for (const Answer& answer : answers_) {
    const bool is_wanted = sent_us_ ? answer.before && answer.outcome == OrderOutcome::kOpen
                                    : !answer.before.has_value();
    if (is_wanted) due.push_back(answer.trace.app);
  }
  if (!due.empty()) next_request_us_ = now_us + interval_us;
  return due;
}

void OrderWatch::OnPage(const appcast_t& page, int64_t now_us) {
  for (Answer& answer : answers_) {
    if (answer.trace.app != page.app) continue;
    if (!sent_us_) {
      answer.before = page;
    } else if (answer.before && answer.outcome == OrderOutcome::kOpen) {
      const bool is_surely_later =
          page.step >= answer.before->step + kStepsToExecute && now_us - *sent_us_ >= kDelivery_us;
      Judge(page, is_surely_later, &answer);
    }
  }
}

bool OrderWatch::IsReady(int64_t now_us) const {
  const bool are_all_here = std::all_of(answers_.begin(), answers_.end(),
                                        [](const Answer& each) { return each.before.has_value(); });
  return are_all_here || (first_request_us_ && now_us - *first_request_us_ >= kPagePatience_us);
}

void OrderWatch::Sent(int64_t now_us, const std::vector<const OrderWatch*>& earlier) {
  sent_us_ = now_us;
  next_request_us_ = now_us;
  for (size_t i = 0; i < answers_.size(); ++i) {
    Answer& answer = answers_[i];
    const auto count = [&](const Answer& other) {
      if (other.outcome == OrderOutcome::kOpen && other.trace.app == answer.trace.app &&
          other.trace.taken == answer.trace.taken && other.trace.refused == answer.trace.refused) {
        ++answer.num_ahead;
      }
    };
    for (const OrderWatch* watch : earlier) {
      for (const Answer& other : watch->answers_) count(other);
    }
    for (size_t k = 0; k < i; ++k) count(answers_[k]);
  }
}

bool OrderWatch::IsSettled() const {
  return std::all_of(answers_.begin(), answers_.end(),
                     [](const Answer& each) { return each.outcome != OrderOutcome::kOpen; });
}

std::string DoneBesideRefusals(const std::vector<OrderWatch::Answer>& answers) {
  constexpr std::string_view kTakenWord = "command: ";
  std::string done;
  bool is_any_refused = false;
  for (const OrderWatch::Answer& answer : answers) {
    is_any_refused = is_any_refused || answer.outcome == OrderOutcome::kRefused;
    if (answer.outcome != OrderOutcome::kTaken) continue;
    std::string_view what = answer.trace.taken;
    if (what.starts_with(kTakenWord)) what.remove_prefix(kTakenWord.size());
    done += fmt::format("{}{}: {}", done.empty() ? "" : "; ", answer.trace.participant, what);
  }
  return is_any_refused ? done : "";
}

}  // namespace shoal
