// What DatagramListener receives from LCM's own publishers.
#include "lib/bus/datagram_listener.h"

#include <gtest/gtest.h>

#include <set>

#include "lib/bus/lcm_bus.h"
#include "lib/run/run_registry.h"
#include "tests/missions/shoal_process.h"

namespace shoal::datagram_listener_test {

class DatagramListenerTest : public testing::Test {
 protected:
  DatagramListenerTest()
      : base_(*ClaimPorts(0, PortPlan::NumPorts(Layout::kCommunities, 2))),
        bus_(PortPlan(base_, Layout::kCommunities, {"alpha", "bravo"})) {}

  std::vector<int> CommunityPorts() const { return {base_ + 3, base_ + 4}; }

  /// Publishes on all of `channels` until `awaited` has been received; returns all that was
  /// received.
  std::set<std::string> Received(DatagramListener* listener,
                                 const std::vector<std::string>& channels,
                                 const std::string& awaited) {
    EXPECT_EQ(listener->error(), "");
    const Bytes bytes = {1, 2, 3};
    std::set<std::string> received;
    const double end_s = WallSeconds() + kPatience_s;
    while (!received.contains(awaited) && WallSeconds() < end_s) {
      for (const std::string& channel : channels) bus_.PublishBytes(channel, bytes);
      listener->Poll(50, [&](std::string_view channel, std::span<const uint8_t> datagram) {
        EXPECT_EQ(Bytes(datagram.begin(), datagram.end()), bytes);
        received.emplace(channel);
      });
    }
    return received;
  }

  int base_;
  LcmBus bus_;
};

TEST_F(DatagramListenerTest, ReceivesTheTopicsThatWereNamedOnAllPorts) {
  const std::vector<std::string_view> topics = {"NAV_", "HELM_"};
  DatagramListener listener(CommunityPorts(), topics);
  // What is awaited is published last, so that the others would have come before it.
  EXPECT_EQ(
      Received(&listener, {"NODE_REPORT_ALPHA", "DESIRED_ALPHA", "NAV_ALPHA", "HELM_STATE_ALPHA"},
               "HELM_STATE_ALPHA"),
      (std::set<std::string>{"NAV_ALPHA", "HELM_STATE_ALPHA"}));
  EXPECT_EQ(
      Received(&listener, {"NODE_REPORT_BRAVO", "HELM_STATE_BRAVO", "NAV_BRAVO"}, "NAV_BRAVO"),
      (std::set<std::string>{"NAV_BRAVO", "HELM_STATE_BRAVO"}));
}

TEST_F(DatagramListenerTest, ReceivesEverythingWhereNoTopicIsNamed) {
  DatagramListener listener(CommunityPorts());
  EXPECT_EQ(Received(&listener, {"NODE_REPORT_ALPHA", "NAV_ALPHA"}, "NAV_ALPHA"),
            (std::set<std::string>{"NAV_ALPHA", "NODE_REPORT_ALPHA"}));
}

}  // namespace shoal::datagram_listener_test
