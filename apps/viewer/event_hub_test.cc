#include "apps/viewer/event_hub.h"

#include <gtest/gtest.h>

#include <thread>

namespace shoal::event_hub_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// The text of the next event, "(none)" or "(end)"; does not wait.
std::string Next(EventHub::Reader& reader) {
  const auto event = reader.Next(milliseconds(0));
  if (!event) return "(end)";
  return *event == nullptr ? "(none)" : **event;
}

TEST(EventHub, GivesEachReaderTheNewestFrameOnce) {
  EventHub hub;
  EventHub::Reader first(hub);
  EventHub::Reader second(hub);
  EXPECT_EQ(Next(first), "(none)");
  hub.Publish("1");
  EXPECT_EQ(Next(first), "data: 1\n\n");
  EXPECT_EQ(Next(first), "(none)");
  hub.Publish("2");
  hub.Publish("3");
  EXPECT_EQ(Next(first), "data: 3\n\n");
  EXPECT_EQ(Next(second), "data: 3\n\n");
}

TEST(EventHub, SharesOneTextAmongReaders) {
  EventHub hub;
  EventHub::Reader first(hub);
  EventHub::Reader second(hub);
  hub.Publish("1");
  EXPECT_EQ(first.Next(milliseconds(0))->get(), second.Next(milliseconds(0))->get());
}

TEST(EventHub, GivesNoReaderAFrameFromBeforeTheLastReaderLeft) {
  EventHub hub;
  {
    EventHub::Reader reader(hub);
    hub.Publish("old");
    EXPECT_EQ(hub.num_readers(), 1);
    EventHub::Reader late(hub);
    EXPECT_EQ(Next(late), "data: old\n\n");
  }
  EXPECT_EQ(hub.num_readers(), 0);
  EventHub::Reader reader(hub);
  EXPECT_EQ(Next(reader), "(none)");
}

TEST(EventHub, LetsNoLineBreakEndAFrame) {
  EventHub hub;
  EventHub::Reader reader(hub);
  hub.Publish("{\n\"a\":\r1}");
  EXPECT_EQ(Next(reader), "data: { \"a\": 1}\n\n");
}

TEST(EventHub, EndsTheStreamsThatThereAreButNotTheNext) {
  EventHub hub;
  EventHub::Reader before(hub);
  hub.Publish("of the mission before");
  hub.EndStreams();
  EXPECT_EQ(Next(before), "(end)");
  EventHub::Reader after(hub);
  EXPECT_EQ(Next(after), "(none)");
  hub.Publish("1");
  EXPECT_EQ(Next(after), "data: 1\n\n");
  EXPECT_EQ(Next(before), "(end)");
}

TEST(EventHub, EndsAllForGoodWhereItStops) {
  EventHub hub;
  hub.Stop();
  EventHub::Reader reader(hub);
  EXPECT_EQ(Next(reader), "(end)");
}

TEST(EventHub, WakesWaitingReaders) {
  EventHub hub;
  EventHub::Reader reader(hub);
  std::thread writer([&] { hub.Publish("1"); });
  EXPECT_EQ(**reader.Next(seconds(60)), "data: 1\n\n");
  writer.join();
  std::thread stopper([&] { hub.Stop(); });
  EXPECT_FALSE(reader.Next(seconds(60)));
  stopper.join();
}

}  // namespace shoal::event_hub_test
