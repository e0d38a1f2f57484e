#include "apps/shoal/send_helm.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "apps/shoal/send_words.h"
#include "lib/bus/channels.h"
#include "lib/check/result.h"
#include "lib/run/roster.h"
#include "lib/run/run_app.h"

namespace shoal {

namespace {

/// How long an answer from the helm is waited for: a step, and the second of its own rhythm.
constexpr int64_t kAnswerPatience_us = 1'500'000;
/// How long a helm's page from before the command is waited for; it comes within a millisecond.
constexpr int64_t kPagePatience_us = 300'000;
constexpr int64_t kPageInterval_us = 100'000;  ///< Between two requests.
/// What a page says earlier may have been said before the command arrived: datagrams on different
/// ports may overtake one another.
constexpr int64_t kDelivery_us = 100'000;
/// The command arrives in the step that the page of before names, or the next; it is handled one
/// later at most.
constexpr int64_t kStepsToObey = 2;
/// What a helm's page warns of, with the reason behind it; apps/helm/helm_app.cc.
constexpr std::string_view kRefused = "HELM_COMMAND refused: ";

/// What one helm has told, before and after the command.
struct HelmAnswer {
  std::optional<appcast_t> page_before;  ///< Absent: it does not answer requests.
  std::optional<appcast_t> page;         ///< The last that came after the command.
  std::optional<helm_state_t> state;     ///< The last that came after the command.
};

/// Returns why the helm refused, from a warning that its page did not have before; empty: it did
/// not, as far as the page says. Another count behind a warning makes it another warning.
std::string RefusalOf(const HelmAnswer& answer) {
  if (!answer.page_before || !answer.page) return {};
  const std::vector<std::string>& before = answer.page_before->run_warnings;
  for (const std::string& warning : answer.page->run_warnings) {
    if (!warning.starts_with(kRefused)) continue;
    if (std::find(before.begin(), before.end(), warning) != before.end()) continue;
    std::string reason = warning.substr(kRefused.size());
    if (const size_t count = reason.rfind(" ("); reason.ends_with(" times)")) reason.resize(count);
    return reason;
  }
  return {};
}

/// Speaks to the helms of some vehicles, and keeps what they say.
class HelmTalk {
 public:
  HelmTalk(LcmBus& bus, const std::vector<std::string>& vehicles) : bus_(bus) {
    for (const std::string& vehicle : vehicles) {
      HelmAnswer& answer = answers_[vehicle];
      Subscribe(bus, channels::HelmState(vehicle), [this, &answer](const helm_state_t& state) {
        if (sent_us_) answer.state = state;
      });
    }
    Subscribe(bus, channels::Appcast(), [this](const appcast_t& page) { OnPage(page); });
  }

  /// Gets the pages as they are before a command.
  void AskBefore() {
    const int64_t begin = MonotonicMicroseconds();
    while (MonotonicMicroseconds() - begin < kPagePatience_us && bus_.error().empty()) {
      if (!AskFor([](const HelmAnswer& answer) { return !answer.page_before; })) return;
      bus_.Poll(20'000);
    }
  }

  void Send(const helm_command_t& command) {
    bus_.Poll(0);
    for (const auto& [vehicle, answer] : answers_) {
      Publish(bus_, channels::HelmCommand(vehicle), command);
    }
    sent_us_ = MonotonicMicroseconds();
    next_request_us_ = *sent_us_ + kDelivery_us;
  }

  /// Waits until each helm has refused, or has gone on without refusing, or patience ends.
  void AwaitAnswers() {
    const auto is_open = [](const HelmAnswer& answer) {
      if (!RefusalOf(answer).empty()) return false;
      const bool is_page_late =
          answer.page_before &&
          (!answer.page || answer.page->step < answer.page_before->step + kStepsToObey);
      return is_page_late || !answer.state;
    };
    while (MonotonicMicroseconds() - *sent_us_ < kAnswerPatience_us) {
      if (!AskFor(is_open)) return;
      bus_.Poll(20'000);
    }
  }

  const std::map<std::string, HelmAnswer>& answers() const { return answers_; }

 private:
  /// Asks the helms that are still `open` for their pages, at intervals. Returns false where none
  /// is.
  template <class F>
  bool AskFor(F open) {
    const int64_t now = MonotonicMicroseconds();
    const bool asks = now >= next_request_us_;
    if (asks) next_request_us_ = now + kPageInterval_us;
    bool is_any_open = false;
    for (const auto& [vehicle, answer] : answers_) {
      if (!open(answer)) continue;
      is_any_open = true;
      if (!asks) continue;
      appcast_req_t request{};
      request.app = ParticipantName("helm", vehicle);
      Publish(bus_, channels::AppcastReq(), request);
    }
    return is_any_open;
  }

  void OnPage(const appcast_t& page) {
    for (auto& [vehicle, answer] : answers_) {
      if (page.app != ParticipantName("helm", vehicle)) continue;
      if (!sent_us_) {
        answer.page_before = page;
      } else if (MonotonicMicroseconds() - *sent_us_ >= kDelivery_us) {
        answer.page = page;
      }
    }
  }

  LcmBus& bus_;
  std::map<std::string, HelmAnswer> answers_;
  std::optional<int64_t> sent_us_;
  int64_t next_request_us_ = 0;
};

}  // namespace

int SendHelm(LcmBus& bus, const std::vector<std::string>& vehicles, const helm_command_t& command) {
  HelmTalk talk(bus, vehicles);
  talk.AskBefore();
  talk.Send(command);
  if (!BusWorks(bus)) return kExitEnvironment;
  fmt::print("sent {} to {}\n", command.command, fmt::join(vehicles, ", "));
  std::fflush(stdout);
  talk.AwaitAnswers();

  bool is_any_refused = false;
  size_t num_silent = 0;
  for (const std::string& vehicle : vehicles) {
    const HelmAnswer& answer = talk.answers().at(vehicle);
    if (const std::string refusal = RefusalOf(answer); !refusal.empty()) {
      is_any_refused = true;
      fmt::print(stderr, "{} refused: {}\n", vehicle, refusal);
    } else if (answer.state) {
      fmt::print("{}: {} {} ({})\n", vehicle, answer.state->state, answer.state->task,
                 answer.state->all_stop);
    } else {
      ++num_silent;
    }
  }
  if (num_silent > 0) {
    fmt::print("{} of {} helms have said nothing since; `shoal status` shows who is there\n",
               num_silent, vehicles.size());
  }
  return is_any_refused ? kExitUsage : kExitOk;
}

}  // namespace shoal
