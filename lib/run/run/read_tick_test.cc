#include "lib/run/run/read_tick.h"

#include <gtest/gtest.h>

#include <random>

#include "lib/bus/bus/bus.h"

namespace shoal::read_tick_test {

tick_t ATick() {
  tick_t tick{};
  tick.utime = -1'234'567'890'123;
  tick.mission_id = 4711;
  tick.step = 99;
  tick.kind = tick_t::END;
  tick.warp = 2.5;
  tick.totals = {{.publisher = "helm_alpha", .channel = "ACTUATORS_ALPHA", .count = 1},
                 {.publisher = "helm_alpha", .channel = "HELM_STATE_ALPHA", .count = 2},
                 {.publisher = "", .channel = "X", .count = -3}};
  tick.num_totals = 3;
  tick.joined = {"helm_alpha", "recorder"};
  tick.joined_pids = {12, 13};
  tick.num_joined = 2;
  return tick;
}

Bytes Encoded(const tick_t& tick) {
  Bytes bytes;
  EncodeInto(tick, &bytes);
  return bytes;
}

bool WantsAll(std::string_view, std::string_view) { return true; }

TEST(ReadTick, ReadsWhatDecodeReads) {
  const Bytes bytes = Encoded(ATick());
  tick_t tick;
  ASSERT_TRUE(ReadTick(bytes, WantsAll, &tick));
  EXPECT_EQ(Encoded(tick), bytes);
}

TEST(ReadTick, LeavesOutTheTotalsThatAreNotWanted) {
  tick_t tick;
  ASSERT_TRUE(ReadTick(
      Encoded(ATick()),
      [](std::string_view publisher, std::string_view channel) {
        return publisher == "helm_alpha" && channel == "HELM_STATE_ALPHA";
      },
      &tick));
  tick_t expected = ATick();
  expected.totals = {expected.totals[1]};
  expected.num_totals = 1;
  EXPECT_EQ(Encoded(tick), Encoded(expected));
}

TEST(ReadTick, RefusesATickThatIsCutOrTooLong) {
  const Bytes bytes = Encoded(ATick());
  tick_t tick;
  for (size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(ReadTick(std::span(bytes).first(size), WantsAll, &tick)) << size;
  }
  Bytes longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(ReadTick(longer, WantsAll, &tick));
}

TEST(ReadTick, AcceptsTheSameBytesAsDecodeWhateverIsChanged) {
  const Bytes bytes = Encoded(ATick());
  std::mt19937 random(7);
  int num_accepted = 0;
  int num_refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    Bytes changed = bytes;
    changed[random() % changed.size()] = static_cast<uint8_t>(random());
    if (random() % 2 == 0) changed[random() % changed.size()] ^= uint8_t{1};
    tick_t by_decode;
    tick_t by_read;
    const bool is_sound = Decode(changed, &by_decode);
    ASSERT_EQ(ReadTick(changed, WantsAll, &by_read), is_sound) << "changed tick number " << i;
    if (is_sound) {
      ASSERT_EQ(Encoded(by_read), Encoded(by_decode)) << i;
    }
    ++(is_sound ? num_accepted : num_refused);
  }
  EXPECT_GT(num_accepted, 1'000);
  EXPECT_GT(num_refused, 1'000);
}

}  // namespace shoal::read_tick_test
