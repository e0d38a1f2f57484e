// What lib/comms/swarm/slot_timing.h promises, played through: members that send by their schedules
// over a sea of their own, at its worst.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "lib/comms/swarm/slot_timing.h"

namespace shoal::slots_apart_test {

/// A message at a receiver, in microseconds.
struct ReceivedSignal {
  double begin_us = 0;
  double end_us = 0;
  int64_t source = 0;
};

struct Request {
  int64_t handled_us = 0;  ///< The step in which its receiver handles it.
  int64_t start_us = 0;
};

double AirTime_us(const SwarmAir& air, SwarmMessage message) {
  const double extra = static_cast<double>(air.extra_bytes);
  const double num_bytes = message == SwarmMessage::kLeaderReport ? 57
                           : message == SwarmMessage::kBroadcastRequest
                               ? 65.0 + 32.0 * static_cast<double>(air.num_followers)
                               : 37;
  return 8e6 * (num_bytes + extra) / air.data_rate_bps;
}

/// Returns nothing, `most`, or anything between; draws nothing where there is no choice.
double AnyUpTo(double most) {
  if (most == 0) return 0;
  const int choice = *rc::gen::element(0, 1, 2, 2, 2);
  return choice == 2 ? most : choice * *rc::gen::inRange(0, 1001) * 1e-3 * most;
}

/// Members that stay where they are; distances are anything up to the greatest.
class Play {
 public:
  Play(const SlotPlan& plan, const SwarmAir& air) : plan_(plan), air_(air) {
    for (int64_t i = 0; i <= air.num_followers; ++i) {
      members_.emplace_back(plan, SwarmPlace{.is_leader = i == 0, .place = i});
    }
    for (size_t i = 0; i < members_.size() * members_.size(); ++i) {
      travel_us_.push_back(AnyUpTo(1e6 * air.max_distance_m / air.sound_speed_mps));
    }
    requests_.resize(members_.size());
    num_sent_.resize(members_.size());
  }

  void Run(int64_t until_us) {
    for (int64_t utime = 0; utime < until_us; utime += plan_.tick_us) {
      for (size_t i = 0; i < members_.size(); ++i) {
        if (requests_[i] && requests_[i]->handled_us <= utime) {
          members_[i].Take({requests_[i]->start_us, static_cast<int>(i) - 1});
          requests_[i].reset();
        }
        if (const auto due = members_[i].Due(utime)) Send(i, utime, *due);
      }
    }
  }

  const std::vector<int64_t>& num_sent() const { return num_sent_; }

  /// Returns how often two messages overlapped at a receiver, on one channel.
  int64_t NumOverlaps() {
    int64_t num_overlaps = 0;
    for (auto& [where, signals] : signals_) {
      std::sort(signals.begin(), signals.end(),
                [](const ReceivedSignal& a, const ReceivedSignal& b) {
                  return std::pair(a.begin_us, a.end_us) < std::pair(b.begin_us, b.end_us);
                });
      constexpr double kRounding_us = 0.01;
      for (size_t i = 1; i < signals.size(); ++i) {
        if (signals[i].begin_us < signals[i - 1].end_us - kRounding_us) ++num_overlaps;
      }
    }
    return num_overlaps;
  }

 private:
  void Send(size_t source, int64_t utime, const DueMessage& due) {
    ++num_sent_[source];
    for (size_t receiver = 0; receiver < members_.size(); ++receiver) {
      if (receiver == source) continue;
      const double begin_us = static_cast<double>(utime) +
                              travel_us_[source * members_.size() + receiver] +
                              AnyUpTo(1e6 * air_.max_jitter_s);
      const double end_us = begin_us + AirTime_us(air_, due.message);
      const size_t channel = plan_.scheme == SwarmScheme::kFdmaLf ? source : 0;
      signals_[{receiver, channel}].push_back({begin_us, end_us, static_cast<int64_t>(source)});
      if (due.message != SwarmMessage::kBroadcastRequest) continue;
      // Handed over in the first step after it has arrived, handled in the next.
      const double arrived_steps = std::ceil(end_us / static_cast<double>(plan_.tick_us));
      requests_[receiver] = {
          .handled_us = (static_cast<int64_t>(arrived_steps) + 1) * plan_.tick_us,
          .start_us = due.response_start_us};
    }
  }

  const SlotPlan& plan_;
  const SwarmAir& air_;
  std::vector<SwarmSchedule> members_;
  std::vector<double> travel_us_;  ///< By source and receiver.
  std::vector<std::optional<Request>> requests_;
  std::vector<int64_t> num_sent_;
  std::map<std::pair<size_t, size_t>, std::vector<ReceivedSignal>>
      signals_;  ///< By receiver and channel.
};

SwarmAir AnySea() {
  return {.num_followers = *rc::gen::inRange<int64_t>(1, 9),
          .extra_bytes = *rc::gen::inRange<int64_t>(0, 12),
          .data_rate_bps = *rc::gen::inRange(200, 8000) * 1.01,
          .sound_speed_mps = *rc::gen::inRange(1400, 1600) * 1.003,
          .max_distance_m = *rc::gen::inRange(0, 5000) * 1.007,
          .max_jitter_s = *rc::gen::inRange(0, 1000) * 1e-3};
}

constexpr int64_t kNumEpisodes = 3;

RC_GTEST_PROP(AutoPlan, KeepsAllMessagesApartAndLetsAllAnswer, ()) {
  const SwarmAir air = AnySea();
  const auto scheme =
      *rc::gen::element(SwarmScheme::kFdmaLf, SwarmScheme::kTdma, SwarmScheme::kTdmaLf);
  const int64_t tick_us = *rc::gen::element<int64_t>(50'000, 100'000, 130'000);
  const SlotPlan plan = *AutoPlan(scheme, tick_us, air);
  Play play(plan, air);
  play.Run(kNumEpisodes * plan.episode_us);
  RC_ASSERT(play.NumOverlaps() == 0);
  RC_ASSERT(play.num_sent() ==
            std::vector<int64_t>(static_cast<size_t>(air.num_followers) + 1, kNumEpisodes));
}

RC_GTEST_PROP(PlansWithoutProblems, KeepAllMessagesApartAndLetAllAnswer, ()) {
  const SwarmAir air = AnySea();
  const auto scheme =
      *rc::gen::element(SwarmScheme::kFdmaLf, SwarmScheme::kTdma, SwarmScheme::kTdmaLf);
  const SlotPlan shortest = *AutoPlan(scheme, 100'000, air);
  // Around the shortest plan that is right: sometimes a step too short.
  SlotPlan plan = shortest;
  for (int64_t SlotPlan::*length : {&SlotPlan::episode_us, &SlotPlan::offset_us,
                                    &SlotPlan::broadcast_us, &SlotPlan::response_us}) {
    plan.*length += *rc::gen::weightedElement<int64_t>({{3, 0}, {1, -1}, {2, 1}, {1, 4}}) * 100'000;
  }
  plan.answer_window_us = *rc::gen::inRange<int64_t>(0, 400'000);
  RC_PRE(FindTimingProblems(plan, air).empty());
  Play play(plan, air);
  play.Run(kNumEpisodes * plan.episode_us);
  RC_ASSERT(play.NumOverlaps() == 0);
  if (scheme != SwarmScheme::kFdmaLf) {
    RC_ASSERT(std::all_of(play.num_sent().begin(), play.num_sent().end(),
                          [](int64_t num_sent) { return num_sent == kNumEpisodes; }));
  }
}

TEST(MuNetsDefaults, LetTheMessagesOfNineFollowersOverlap) {
  const SlotPlan plan = {.scheme = SwarmScheme::kTdmaLf,
                         .tick_us = 20'000,
                         .broadcast_us = 1'000'000,
                         .response_us = 1'000'000,
                         .answer_window_us = 1'000'000};
  const SwarmAir air = {.num_followers = 9, .max_distance_m = 0, .max_jitter_s = 0};
  Play play(plan, air);
  play.Run(4 * plan.episode_us);
  EXPECT_GT(play.NumOverlaps(), 0);
}

}  // namespace shoal::slots_apart_test
