// The clock alone: what it makes of orders, and what it shows of itself. With participants:
// step_protocol_test.cc.
#include "lib/run/run/step_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/network_testing.h"
#include "shoal/clock_state_t.hpp"

namespace shoal::step_clock_test {

constexpr int64_t kMissionId = 4711;
constexpr int64_t kTick_us = 100'000;

/// A clock with one participant, "a", that answers each tick at once unless the test wants none.
struct ClockAlone {
  explicit ClockAlone(ClockOptions options = {.mission_id = kMissionId, .last_step = 1'000'000})
      : clock(std::move(options), {"a"}, plan, node) {
    other.Listen(plan.tick_port(), "TICK");
    other.Listen(plan.tick_port(), "CLOCK_STATE");
    other.receiver = [this](int, std::string_view channel, std::span<const uint8_t> bytes) {
      if (channel == "CLOCK_STATE") {
        ASSERT_TRUE(Decode(bytes, &state.emplace()));
        ++num_states;
      } else if (answers) {
        tick_t tick;
        ASSERT_TRUE(Decode(Unseal(bytes).message, &tick));
        Answer(tick.step);
      }
    };
    node.receiver = [this](int port, std::string_view channel, std::span<const uint8_t> bytes) {
      clock.OnDatagram(port, channel, bytes, now);
    };
  }

  void Answer(int64_t step) {
    step_done_t done{};
    done.mission_id = kMissionId;
    done.step = step;
    done.participant = "a";
    Bytes bytes;
    EncodeInto(done, &bytes);
    AppendSeal({.publisher = "a", .mission_id = kMissionId, .step = step, .sequence = 0},
               MissionSecret{}, topics::kStepDone, &bytes);
    other.Send(plan.done_port(), "STEP_DONE", bytes);
  }

  void Order(const std::string& word, double warp = 0) {
    clock_command_t command{};
    command.command = word;
    command.warp = warp;
    Bytes bytes;
    EncodeInto(command, &bytes);
    other.Send(plan.done_port(), "CLOCK_COMMAND", bytes);
    network.DeliverAll();
  }

  /// Sends hello, and lets the mission begin.
  void Begin() {
    Answer(-1);
    network.DeliverAll();
    Run(0);
  }

  void Run(int64_t duration_us) {
    const int64_t end = now + duration_us;
    for (;; now += 1'000) {
      clock.OnTime(now);
      network.DeliverAll();
      if (now >= end) return;
    }
  }

  PortPlan plan{7665, Layout::kShared, {}};
  FakeNetwork network;
  FakeNetwork::Node& node = network.Add();
  FakeNetwork::Node& other = network.Add();
  StepClock clock;
  int64_t now = 0;
  bool answers = true;
  std::optional<clock_state_t> state;  ///< The last CLOCK_STATE.
  int num_states = 0;
};

TEST(StepClock, PublishesItsState) {
  ClockAlone alone;
  alone.Run(0);
  ASSERT_TRUE(alone.state);
  EXPECT_EQ(alone.state->state, "gathering");
  EXPECT_EQ(alone.state->awaited, std::vector<std::string>{"a"});
  EXPECT_EQ(alone.state->step, -1);
  EXPECT_EQ(alone.state->mission_id, kMissionId);
  alone.Begin();
  alone.Run(3'000'000);
  EXPECT_EQ(alone.state->state, "running");
  EXPECT_EQ(alone.state->warp, 1);
  EXPECT_NEAR(alone.state->factor, 1, 0.11);
  EXPECT_EQ(alone.state->num_commands, 0);
  EXPECT_EQ(alone.num_states, 8);  // At first, at its beginning, and twice per second.
  EXPECT_NEAR(static_cast<double>(alone.state->utime), 3e6, 0.6e6);
  EXPECT_EQ(alone.state->utime, alone.state->step * kTick_us);
}

TEST(StepClock, PublishesItsEnd) {
  ClockAlone alone({.mission_id = kMissionId, .warp = 0, .last_step = 5});
  alone.Begin();
  alone.Run(50'000);
  ASSERT_EQ(alone.clock.state(), StepClock::State::kEnded);
  EXPECT_EQ(alone.state->state, "ending");
  EXPECT_EQ(alone.state->utime, 5 * kTick_us);
}

TEST(StepClock, EndsAfterThePresentStepWhereThatIsMadeTheLast) {
  ClockAlone alone({.mission_id = kMissionId, .warp = 0, .last_step = 1'000'000});
  alone.answers = false;
  alone.Begin();
  for (int64_t step = 0; step < 3; ++step) {
    alone.Answer(step);
    alone.Run(1'000);
  }
  ASSERT_EQ(alone.clock.step(), 3);
  alone.clock.MakeLast();
  for (const int64_t step : {3, 4}) {  // The present one, and END.
    alone.Answer(step);
    alone.Run(1'000);
  }
  ASSERT_EQ(alone.clock.state(), StepClock::State::kEnded);
  EXPECT_EQ(alone.state->utime, 3 * kTick_us);
}

TEST(StepClock, AnswersEachOrderAtOnce) {
  ClockAlone alone;
  alone.Begin();
  alone.Run(1'234'000);
  const int num_states = alone.num_states;
  alone.Order("pause");
  EXPECT_EQ(alone.num_states, num_states + 1);
  EXPECT_EQ(alone.state->state, "paused");
  EXPECT_EQ(alone.state->num_commands, 1);
  EXPECT_EQ(alone.state->refusal, "");
  EXPECT_EQ(alone.state->factor, 0);
  EXPECT_EQ(alone.state->step, 12);
  alone.Run(2'000'000);
  EXPECT_EQ(alone.state->step, 12);
  alone.Order("warp", 4);
  EXPECT_EQ(alone.state->state, "paused");
  alone.Order("resume");
  EXPECT_EQ(alone.state->state, "running");
  EXPECT_EQ(alone.state->warp, 4);
  EXPECT_EQ(alone.state->num_commands, 3);
  alone.Run(600'000);
  EXPECT_NEAR(alone.state->factor, 4, 0.4);
}

TEST(StepClock, RefusesWhatIsNoOrderAndGoesOn) {
  ClockAlone alone;
  alone.Begin();
  alone.Order("fly\x1b[2J");
  EXPECT_EQ(alone.state->refusal,
            "fly?[2J refused: unknown command 'fly?[2J': pause, resume or warp");
  alone.Order("");
  EXPECT_NE(alone.state->refusal, "");
  for (const double warp :
       {-1.0, 1e-7, 1e7, std::nan(""), std::numeric_limits<double>::infinity()}) {
    alone.Order("warp", warp);
    EXPECT_TRUE(alone.state->refusal.starts_with("warp refused: ")) << warp;
    EXPECT_EQ(alone.state->warp, 1);
  }
  const uint8_t noise[] = {1, 2, 3};
  alone.other.Send(alone.plan.done_port(), "CLOCK_COMMAND", noise);
  alone.network.DeliverAll();
  EXPECT_EQ(alone.clock.counters().undecodable, 1);
  EXPECT_EQ(alone.state->num_commands, 7);
  alone.Run(1'000'000);
  EXPECT_EQ(alone.clock.step(), 10);
  alone.Order("pause");
  EXPECT_EQ(alone.state->refusal, "");
}

TEST(StepClock, RefusesWhereThePaceIsFixedOrTheMissionEnds) {
  ClockAlone fixed(
      {.mission_id = kMissionId, .fixed_pace = "it keeps to the wall's clock", .last_step = 100});
  fixed.Begin();
  for (const char* word : {"pause", "resume", "warp"}) {
    fixed.Order(word, 2);
    EXPECT_EQ(fixed.state->refusal, std::string(word) + " refused: it keeps to the wall's clock");
  }
  EXPECT_FALSE(fixed.clock.paused());

  ClockAlone ending;
  ending.Begin();
  ending.answers = false;
  ending.clock.Stop(ending.now, 0);
  ending.Run(10'000);
  ASSERT_EQ(ending.clock.state(), StepClock::State::kEnding);
  ending.Order("pause");
  EXPECT_EQ(ending.state->state, "ending");
  EXPECT_EQ(ending.state->refusal, "pause refused: the mission is ending");
}

TEST(StepClock, CanBePausedBeforeTheFirstStep) {
  ClockAlone alone;
  alone.Order("pause");
  EXPECT_EQ(alone.state->refusal, "");
  alone.Begin();
  alone.Run(1'000'000);
  EXPECT_EQ(alone.clock.step(), -1);
  EXPECT_EQ(alone.state->state, "paused");
  alone.Order("resume");
  alone.Run(1'000'000);
  EXPECT_EQ(alone.clock.step(), 10);
}

TEST(StepClock, IsNotHurriedByAFloodOfOrders) {
  ClockAlone alone;
  alone.Begin();
  for (int i = 0; i < 2'000; ++i) {
    alone.Order("pause");
    alone.Order("resume");
    alone.Order("warp", 0.5);
    alone.Order("warp", 1);
    alone.Run(1'000);
  }
  EXPECT_LE(alone.clock.step(), 20);
  EXPECT_GE(alone.clock.step(), 19);
}

TEST(StepClock, SurvivesTheSlowestWarpAndComesBackFromIt) {
  ClockAlone alone({.mission_id = kMissionId, .warp = 100, .last_step = 1'000'000});
  alone.Begin();
  alone.Run(2'000'000);
  EXPECT_EQ(alone.clock.step(), 2'000);
  alone.Order("warp", 1e-6);
  alone.Run(10'000'000);
  EXPECT_EQ(alone.clock.step(), 2'000);
  EXPECT_GT(alone.clock.NextDeadline(), alone.now + 1'000'000'000);
  alone.Order("warp", 100);
  alone.Run(100'000);
  EXPECT_NEAR(static_cast<double>(alone.clock.step()), 2'100, 2);
}

TEST(StepClock, BlamesParticipantsThatOweAnAnswerAlsoWhilePaused) {
  ClockAlone alone;
  alone.Begin();
  alone.Run(1'050'000);
  alone.Order("pause");
  alone.Run(10'000'000);
  EXPECT_TRUE(alone.clock.Silent(alone.now).empty());
  alone.Order("resume");
  alone.answers = false;
  alone.Run(200'000);
  alone.Order("pause");
  alone.Run(6'000'000);
  EXPECT_EQ(alone.clock.Silent(alone.now), std::vector<std::string>{"a"});
}

}  // namespace shoal::step_clock_test
