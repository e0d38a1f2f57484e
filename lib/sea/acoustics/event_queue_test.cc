#include "lib/sea/acoustics/event_queue.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace shoal::event_queue_test {

RC_GTEST_PROP(OrderOf, GrowsWithTime, (double a_s, double b_s)) {
  RC_PRE(!std::isnan(a_s) && !std::isnan(b_s));
  RC_ASSERT((OrderOf(a_s) < OrderOf(b_s)) == (a_s < b_s));
  RC_ASSERT((OrderOf(a_s) == OrderOf(b_s)) == (a_s == b_s));
}

TEST(OrderOf, HoldsAtZeroAndAtTheEnds) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(OrderOf(-0.0), OrderOf(0.0));
  EXPECT_LT(OrderOf(-infinity), OrderOf(-1e300));
  EXPECT_LT(OrderOf(-5e-324), OrderOf(0.0));
  EXPECT_LT(OrderOf(0.0), OrderOf(5e-324));
  EXPECT_LT(OrderOf(1e300), OrderOf(infinity));
}

RC_GTEST_PROP(OrderOf, GivesTheTimeBack, (double time_s)) {
  RC_PRE(!std::isnan(time_s));
  RC_ASSERT(TimeOf(OrderOf(time_s)) == time_s);
}

using Key = std::tuple<double, int, int64_t, int32_t>;

RC_GTEST_PROP(EventQueue, GivesEventsInOrderOfTimeKindTurnAndReceiver, ()) {
  const auto kinds = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3));
  EventQueue queue;
  std::vector<Key> keys;
  for (size_t i = 0; i < kinds.size(); ++i) {
    const int turn = *rc::gen::inRange(0, 3);
    const int receiver = *rc::gen::inRange(0, 3);
    const double time_s = *rc::gen::inRange(-2, 3);
    queue.Push(MakeEvent(static_cast<AcousticEventKind>(kinds[i]), time_s, turn, receiver,
                         static_cast<int32_t>(i)));
    keys.emplace_back(time_s, kinds[i], turn, receiver);
  }
  Key last = {-1e9, 0, 0, 0};
  for (size_t left = keys.size(); left > 0; --left) {
    RC_ASSERT(queue.HasEventUntil(2));
    const AcousticEvent event = queue.First();
    const Key& key = keys[static_cast<size_t>(event.slot)];
    RC_ASSERT(static_cast<int>(event.kind()) == std::get<1>(key));
    RC_ASSERT(last <= key);
    RC_ASSERT(!queue.HasEventUntil(std::get<0>(key) - 0.5));
    last = key;
    queue.PopFirst();
  }
  RC_ASSERT(!queue.HasEventUntil(1e9));
}

TEST(EventQueue, PutsAnEventThatReplacesTheFirstWhereItBelongs) {
  EventQueue queue;
  for (int i = 0; i < 10; ++i) {
    queue.Push(MakeEvent(AcousticEventKind::kReceptionStarts, i, i, 0, i));
  }
  queue.ReplaceFirst(EndOf(queue.First(), 4));
  std::vector<int32_t> slots;
  for (; queue.HasEventUntil(100); queue.PopFirst()) slots.push_back(queue.First().slot);
  EXPECT_EQ(slots, (std::vector<int32_t>{1, 2, 3, 0, 4, 5, 6, 7, 8, 9}));
}

}  // namespace shoal::event_queue_test
