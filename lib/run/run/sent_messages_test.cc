#include "lib/run/run/sent_messages.h"

#include <gtest/gtest.h>

namespace shoal::sent_messages_test {

/// Returns the first bytes of what Visit visits.
std::string Visited(const SentMessages& sent, int64_t step, std::string_view publisher,
                    std::string_view channel) {
  std::string bytes;
  sent.Visit(step, publisher, channel,
             [&](const SentMessages::Sent& each) { bytes += static_cast<char>(each.datagram[0]); });
  return bytes;
}

TEST(SentMessages, KeepsEachPublishersMessagesOfTwoStepsInOrder) {
  SentMessages sent;
  const auto add = [&](std::string_view publisher, std::string_view channel, char byte) {
    Bytes* datagram = &sent.Add(publisher, channel)->datagram;
    EXPECT_TRUE(datagram->empty());
    datagram->push_back(static_cast<uint8_t>(byte));
  };
  sent.BeginStep(7);
  add("helm_alpha", "X", 'a');
  add("helm_bravo", "X", 'b');
  add("helm_alpha", "X", 'c');
  add("helm_alpha", "Y", 'd');
  sent.BeginStep(8);
  add("helm_alpha", "X", 'e');
  EXPECT_EQ(Visited(sent, 7, "helm_alpha", "X"), "ac");
  EXPECT_EQ(Visited(sent, 7, "helm_bravo", "X"), "b");
  EXPECT_EQ(Visited(sent, 8, "helm_alpha", "X"), "e");
  EXPECT_TRUE(sent.Has("helm_alpha", "Y"));
  sent.BeginStep(9);
  add("helm_bravo", "Z", 'f');
  EXPECT_EQ(Visited(sent, 7, "helm_alpha", "X"), "") << "two steps are kept";
  EXPECT_FALSE(sent.Has("helm_alpha", "Y"));
  EXPECT_FALSE(sent.Has("helm_alpha", "Z")) << "another published it";
  EXPECT_TRUE(sent.Has("helm_bravo", "Z"));
}

}  // namespace shoal::sent_messages_test
