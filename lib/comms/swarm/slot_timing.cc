#include "lib/comms/swarm/slot_timing.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/leader_message.h"
#include "lib/comms/swarm/report_message.h"
#include "lib/sea/acoustics/number_text.h"

namespace shoal {

namespace {

constexpr auto kReportSize = static_cast<int64_t>(kReportBytes);
constexpr auto kLeaderReportSize = static_cast<int64_t>(kLeaderReportBytes);
/// A message is no longer on the air than this, and nothing is longer on its way.
constexpr double kLongest_s = 1e5;
/// Then a thousand slots are no later than SwarmSchedule::kLatestSlot_us.
constexpr int64_t kLongestPlan_us = 900'000'000'000;
constexpr int64_t kLongestStep_us = 3'600'000'000;

/// Returns a length in seconds, exactly: "12.05".
std::string LengthText(int64_t length_us) {
  constexpr int64_t kSecond_us = 1'000'000;
  std::string text = length_us < 0 ? "-" : "";
  text += std::to_string(std::abs(length_us / kSecond_us));
  if (length_us % kSecond_us == 0) return text;
  std::string digits = std::to_string(kSecond_us + std::abs(length_us % kSecond_us));
  digits.erase(0, 1);
  digits.erase(digits.find_last_not_of('0') + 1);
  return text + "." + digits;
}

int64_t WholeSteps_us(int64_t length_us, int64_t tick_us) {
  return (length_us + tick_us - 1) / tick_us * tick_us;
}

/// Rounded up, but for the noise of doubles.
int64_t WholeMicroseconds(double length_s) {
  constexpr double kNoise_us = 1e-3;
  return static_cast<int64_t>(std::ceil(length_s * 1e6 - kNoise_us));
}

std::string Followers(int64_t count) {
  return std::to_string(count) + (count == 1 ? " follower" : " followers");
}

/// Returns what is wrong with numbers that no plan can fix; empty: nothing.
std::vector<TimingProblem> FindAirProblems(const SwarmAir& air) {
  std::vector<TimingProblem> problems;
  const auto check = [&](bool is_right, std::string_view key, const std::string& should,
                         const std::string& value) {
    if (is_right) return;
    problems.push_back({.key = std::string(key),
                        .message = std::string(key) + " must be " + should + ", not " + value});
  };
  const auto check_number = [&](double value, std::string_view key, bool zero_is_right) {
    const bool is_right = std::isfinite(value) && (zero_is_right ? value >= 0 : value > 0);
    check(is_right, key, zero_is_right ? "0 or more" : "more than 0", RoundedText(value));
  };
  check(air.num_followers >= 1 && air.num_followers <= kMaxFollowers, "num_followers",
        "1 to " + std::to_string(kMaxFollowers), std::to_string(air.num_followers));
  check(air.extra_bytes >= 0 && air.extra_bytes <= 1000, "extra_bytes", "0 to 1000",
        std::to_string(air.extra_bytes));
  check_number(air.data_rate_bps, "data_rate_bps", false);
  check_number(air.sound_speed_mps, "sound_speed_mps", false);
  check_number(air.max_distance_m, "max_distance_m", true);
  check_number(air.max_jitter_s, "max_jitter_s", true);
  return problems;
}

std::string TickText(int64_t tick_us) {
  return "tick_s must be more than 0, at most 3600, not " + LengthText(tick_us);
}

int64_t RequestSize(const SwarmAir& air) {
  return static_cast<int64_t>(BroadcastBytes(static_cast<uint64_t>(air.num_followers))) +
         air.extra_bytes;
}

/// A request is handed over in the first step after its last byte, and handled in the next.
int64_t NeededBroadcast_us(const AirTimes& times, int64_t tick_us) {
  return WholeSteps_us(times.request_us + times.travel_us + times.jitter_us, tick_us) + tick_us;
}

/// Finds what is wrong with the lengths of one plan.
class PlanCheck {
 public:
  PlanCheck(const SlotPlan& plan, const SwarmAir& air, const AirTimes& times)
      : plan_(plan), air_(air), times_(times) {}

  std::vector<TimingProblem> Find() {
    switch (plan_.scheme) {
      case SwarmScheme::kFdmaLf:
        CheckFdma();
        break;
      case SwarmScheme::kTdma:
        CheckTdma();
        break;
      case SwarmScheme::kTdmaLf:
        CheckTdmaLf();
        break;
    }
    return problems_;
  }

 private:
  /// "57 bytes at 1000 bit/s take 0.456 s + 0.667 s for 1000 m + 0.2 s of jitter".
  std::string Takes(int64_t num_bytes, int64_t air_us) const {
    return std::to_string(num_bytes) + " bytes at " + RoundedText(air_.data_rate_bps) +
           " bit/s take " + LengthText(air_us) + " s + " + LengthText(times_.travel_us) +
           " s for " + RoundedText(air_.max_distance_m) + " m + " + LengthText(times_.jitter_us) +
           " s of jitter";
  }

  /// Checks one length, and returns the one that would do.
  int64_t Check(std::string_view key, int64_t length_us, int64_t needed_us,
                const std::string& what_for, const std::string& why) {
    const int64_t at_least_us =
        WholeSteps_us(std::max<int64_t>(std::max(length_us, needed_us), 1), plan_.tick_us);
    const bool is_short = length_us < needed_us || length_us <= 0;
    if (!is_short && at_least_us == length_us) return length_us;
    std::string message = std::string(key) + " = " + LengthText(length_us);
    if (is_short) {
      message += " is too short for " + what_for + ": " + why + " = " + LengthText(needed_us) +
                 " s; use at least " + LengthText(at_least_us);
    } else {
      message += " is not a whole number of steps of " + LengthText(plan_.tick_us) + " s; use " +
                 LengthText(at_least_us);
    }
    problems_.push_back({.key = std::string(key),
                         .at_least_us = at_least_us,
                         .message = message + ", or " + std::string(key) + " = \"auto\""});
    return at_least_us;
  }

  void CheckFdma() {
    if (plan_.offset_us < 0 || plan_.offset_us % plan_.tick_us != 0) {
      Check("offset_s", plan_.offset_us, 0, "a step", "0 s");
    }
    const int64_t needed_us = times_.leader_report_us + times_.travel_us + times_.jitter_us;
    Check("episode_s", plan_.episode_us, needed_us, "a leader's report",
          Takes(kLeaderReportSize + air_.extra_bytes, times_.leader_report_us));
  }

  void CheckTdma() {
    const int64_t needed_us = times_.leader_report_us + times_.travel_us + times_.jitter_us;
    const int64_t slot_us =
        Check("offset_s", plan_.offset_us, needed_us, "a leader's report",
              Takes(kLeaderReportSize + air_.extra_bytes, times_.leader_report_us));
    const int64_t num_members = air_.num_followers + 1;
    Check("episode_s", plan_.episode_us, slot_us * num_members,
          std::to_string(num_members) + " members",
          std::to_string(num_members) + " x " + LengthText(slot_us) + " s of offset_s");
  }

  void CheckTdmaLf() {
    const int64_t broadcast_us =
        Check("broadcast_s", plan_.broadcast_us, NeededBroadcast_us(times_, plan_.tick_us),
              "a request to " + Followers(air_.num_followers),
              Takes(RequestSize(air_), times_.request_us) + ", in whole steps, + " +
                  LengthText(plan_.tick_us) + " s to handle it");
    const int64_t report_bytes = kReportSize + air_.extra_bytes;
    const int64_t response_us = Check("response_s", plan_.response_us,
                                      times_.report_us + times_.travel_us + times_.jitter_us,
                                      "an answer", Takes(report_bytes, times_.report_us));
    Check("episode_s", plan_.episode_us, broadcast_us + air_.num_followers * response_us,
          Followers(air_.num_followers),
          LengthText(broadcast_us) + " s for the request + " + std::to_string(air_.num_followers) +
              " x " + LengthText(response_us) + " s of answers");
    SlotPlan fixed = plan_;
    fixed.response_us = response_us;
    const int64_t window_us = SafeAnswerWindow_us(fixed, times_);
    if (plan_.answer_window_us >= 0 && plan_.answer_window_us <= window_us) return;
    problems_.push_back({.key = "answer_window_s",
                         .at_least_us = 0,
                         .message = "answer_window_s = " + LengthText(plan_.answer_window_us) +
                                    " lets late answers run into the next slot; use at most " +
                                    LengthText(window_us)});
  }

  const SlotPlan& plan_;
  const SwarmAir& air_;
  const AirTimes& times_;
  std::vector<TimingProblem> problems_;
};

}  // namespace

Result<AirTimes> FindAirTimes(const SwarmAir& air) {
  if (const auto problems = FindAirProblems(air); !problems.empty()) {
    return Error{problems.front().message};
  }
  const auto air_s = [&](int64_t num_bytes) {
    return 8 * static_cast<double>(num_bytes) / air.data_rate_bps;
  };
  const double travel_s = air.max_distance_m / air.sound_speed_mps;
  const double request_s = air_s(RequestSize(air));
  if (!(request_s + travel_s + air.max_jitter_s <= kLongest_s)) {
    return Error{"a message of " + std::to_string(RequestSize(air)) + " bytes takes " +
                 RoundedText(request_s) + " s, and " + RoundedText(travel_s) +
                 " s to get there; check data_rate_bps, max_distance_m and sound_speed_mps"};
  }
  return AirTimes{.report_us = WholeMicroseconds(air_s(kReportSize + air.extra_bytes)),
                  .leader_report_us = WholeMicroseconds(air_s(kLeaderReportSize + air.extra_bytes)),
                  .request_us = WholeMicroseconds(request_s),
                  .travel_us = WholeMicroseconds(travel_s),
                  .jitter_us = WholeMicroseconds(air.max_jitter_s)};
}

int64_t SafeAnswerWindow_us(const SlotPlan& plan, const AirTimes& times) {
  const int64_t spare_us = plan.response_us - (times.report_us + times.travel_us + times.jitter_us);
  return spare_us < 0 ? 0 : spare_us + 1;  // An answer may begin as late as `spare_us`.
}

Result<SlotPlan> AutoPlan(SwarmScheme scheme, int64_t tick_us, const SwarmAir& air) {
  if (tick_us <= 0 || tick_us > kLongestStep_us) return Error{TickText(tick_us)};
  const Result<AirTimes> times = FindAirTimes(air);
  if (!times.ok()) return Error{times.error()};
  const int64_t way_us = times->travel_us + times->jitter_us;
  const int64_t longest_us = WholeSteps_us(times->leader_report_us + way_us, tick_us);
  const int64_t num_members = air.num_followers + 1;
  SlotPlan plan = {.scheme = scheme, .tick_us = tick_us, .offset_us = 0};
  switch (scheme) {
    case SwarmScheme::kFdmaLf:
      plan.episode_us = longest_us;
      plan.offset_us = longest_us / num_members / tick_us * tick_us;
      break;
    case SwarmScheme::kTdma:
      plan.offset_us = longest_us;
      plan.episode_us = longest_us * num_members;
      break;
    case SwarmScheme::kTdmaLf:
      plan.broadcast_us = NeededBroadcast_us(*times, tick_us);
      plan.response_us = WholeSteps_us(times->report_us + way_us, tick_us);
      plan.episode_us = plan.broadcast_us + air.num_followers * plan.response_us;
      plan.answer_window_us = SafeAnswerWindow_us(plan, *times);
      break;
  }
  if (plan.episode_us > kLongestPlan_us) {
    return Error{"an episode for " + Followers(air.num_followers) + " takes " +
                 LengthText(plan.episode_us) + " s; check data_rate_bps and max_distance_m"};
  }
  return plan;
}

std::vector<TimingProblem> FindTimingProblems(const SlotPlan& plan, const SwarmAir& air) {
  std::vector<TimingProblem> problems = FindAirProblems(air);
  if (plan.tick_us <= 0 || plan.tick_us > kLongestStep_us) {
    problems.push_back({.key = "tick_s", .message = TickText(plan.tick_us)});
  }
  for (const auto& [key, length_us] :
       {std::pair("episode_s", plan.episode_us), std::pair("offset_s", plan.offset_us),
        std::pair("broadcast_s", plan.broadcast_us), std::pair("response_s", plan.response_us),
        std::pair("answer_window_s", plan.answer_window_us)}) {
    if (length_us >= -kLongestPlan_us && length_us <= kLongestPlan_us) continue;
    problems.push_back({.key = key,
                        .message = std::string(key) + " must be at most " +
                                   LengthText(kLongestPlan_us) + ", not " + LengthText(length_us)});
  }
  if (!problems.empty()) return problems;
  const Result<AirTimes> times = FindAirTimes(air);
  if (!times.ok()) return {{.key = "data_rate_bps", .message = times.error()}};
  return PlanCheck(plan, air, *times).Find();
}

}  // namespace shoal
