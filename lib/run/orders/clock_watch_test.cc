#include "lib/run/orders/clock_watch.h"

#include <gtest/gtest.h>

namespace shoal::clock_watch_test {

clock_command_t Command(const std::string& word, double warp = 0) {
  clock_command_t command{};
  command.command = word;
  command.warp = warp;
  return command;
}

clock_state_t State(const std::string& word, int64_t num_commands,
                    const std::string& refusal = "") {
  clock_state_t state{};
  state.mission_id = 7;
  state.state = word;
  state.warp = 1;
  state.num_commands = num_commands;
  state.refusal = refusal;
  return state;
}

TEST(ClockWatch, TakesTheFirstStateThatAgreesAfterTheOrder) {
  ClockWatch watch(Command("pause"), State("running", 3));
  EXPECT_FALSE(watch.OnState(State("running", 3)));
  EXPECT_TRUE(watch.OnState(State("paused", 4)));
  EXPECT_EQ(watch.refusal(), "");
}

TEST(ClockWatch, ReportsWhyTheClockRefused) {
  ClockWatch watch(Command("warp", 5), State("running", 0, "warp refused: long ago"));
  EXPECT_FALSE(watch.OnState(State("running", 0, "warp refused: long ago")));
  EXPECT_TRUE(watch.OnState(State("running", 1, "warp refused: the mission is ending")));
  EXPECT_EQ(watch.refusal(), "the mission is ending");
}

TEST(ClockWatch, DoesNotTakeAnAnswerToAnotherOrderForItsOwn) {
  ClockWatch watch(Command("resume"), State("paused", 3));
  EXPECT_FALSE(watch.OnState(State("paused", 4, "fly refused: unknown command")));
  EXPECT_FALSE(watch.OnState(State("paused", 5)));
  EXPECT_TRUE(watch.OnState(State("running", 6)));
  EXPECT_EQ(watch.refusal(), "");
}

TEST(ClockWatch, BelievesAnotherMissionsCount) {
  ClockWatch watch(Command("pause"), State("running", 30));
  clock_state_t state = State("paused", 1);
  state.mission_id = 8;
  EXPECT_TRUE(watch.OnState(state));
}

TEST(ClockText, StatesWhatTheClockDoes) {
  clock_state_t state = State("paused", 1);
  state.utime = 12'300'000;
  EXPECT_EQ(ClockText(state), "paused at 12.3 s");
  state.state = "running";
  state.warp = 10;
  EXPECT_EQ(ClockText(state), "running at warp 10");
  state.factor = 9.84;
  EXPECT_EQ(ClockText(state), "running at warp 10 (9.8 x real time)");
  state.warp = 0;
  EXPECT_EQ(ClockText(state), "running at warp max (9.8 x real time)");
  state.state = "ga\x1b[2Jthering";
  EXPECT_EQ(ClockText(state), "ga?[2Jthering at 12.3 s");
}

}  // namespace shoal::clock_watch_test
