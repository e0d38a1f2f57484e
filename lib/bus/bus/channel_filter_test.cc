#include "lib/bus/bus/channel_filter.h"

#include <gtest/gtest.h>

#include <random>

namespace shoal::channel_filter_test {

constexpr size_t kPlenty = 4000;

/// What the kernel does with a datagram, by its documentation of classic BPF.
bool Accepts(const std::vector<sock_filter>& code, const std::string& datagram) {
  const std::string packet = std::string(8, '\0') + datagram;  // The UDP header is before it.
  uint32_t a = 0;
  for (size_t pc = 0; pc < code.size(); ++pc) {
    const sock_filter& each = code[pc];
    switch (each.code) {
      case BPF_LD | BPF_W | BPF_ABS:
        if (each.k + 4 > packet.size()) return false;  // Beyond the end: the packet is dropped.
        a = 0;
        for (size_t i = 0; i < 4; ++i) a = a << 8 | static_cast<uint8_t>(packet[each.k + i]);
        break;
      case BPF_ALU | BPF_AND | BPF_K:
        a &= each.k;
        break;
      case BPF_JMP | BPF_JEQ | BPF_K:
        pc += a == each.k ? each.jt : each.jf;
        break;
      case BPF_JMP | BPF_JA:
        pc += each.k;
        break;
      case BPF_RET | BPF_K:
        return each.k != 0;
      default:
        ADD_FAILURE() << "an unknown instruction: " << each.code;
        return false;
    }
  }
  ADD_FAILURE() << "the program has no end";
  return false;
}

/// A message of one datagram: magic, sequence number, channel, 0, the smallest LCM message.
std::string Datagram(const std::string& channel) {
  return std::string("LC02") + std::string(4, '\1') + channel + std::string(1, '\0') + "12345678";
}

TEST(ChannelFilter, AcceptsTheNamedChannelsOnly) {
  const std::vector<std::string> names = {"NAV_ALPHA", "NAV_ALPHA2", "NAV", "DESIRED_ALPHA", "X"};
  const std::vector<sock_filter> code = ChannelFilter(names, kPlenty);
  for (const std::string& name : names) EXPECT_TRUE(Accepts(code, Datagram(name))) << name;
  for (const std::string name : {"NAV_ALPH", "NAV_ALPHAX", "NAV_ALPHA22", "NA", "NAV_", "NAV_BRAVO",
                                 "DESIRED_ALPHA_2", "DESIRED", "Y", "XX", "x"}) {
    EXPECT_FALSE(Accepts(code, Datagram(name))) << name;
  }
}

TEST(ChannelFilter, AcceptsFragmentsAndRefusesWhatIsNotLcm) {
  const std::vector<sock_filter> code = ChannelFilter({"NAV"}, kPlenty);
  EXPECT_TRUE(Accepts(code, "LC03 of any message"));
  EXPECT_FALSE(Accepts(code, "LC01" + Datagram("NAV").substr(4)));
  EXPECT_FALSE(Accepts(code, ""));
  EXPECT_FALSE(Accepts(code, "LC02"));
  EXPECT_FALSE(Accepts(code, "LC02....NAV"));
}

TEST(ChannelFilter, AgreesWithASetOfNamesForRandomOnes) {
  std::mt19937 random(1);
  const auto name = [&] {
    std::string text(1 + random() % 9, 'A');
    for (char& each : text) each = static_cast<char>('A' + random() % 2);  // Much in common.
    return text;
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<std::string> names(1 + random() % 30);
    for (std::string& each : names) each = name();
    const std::vector<sock_filter> code = ChannelFilter(names, kPlenty);
    for (int i = 0; i < 200; ++i) {
      const std::string channel = name();
      const bool is_in = std::find(names.begin(), names.end(), channel) != names.end();
      ASSERT_EQ(Accepts(code, Datagram(channel)), is_in) << channel;
    }
  }
}

TEST(ChannelFilter, ComparesTheBeginningsWhereItWouldBeTooLong) {
  std::vector<std::string> names;
  for (int i = 0; i < 1000; ++i) names.push_back("NAV_BOAT_" + std::to_string(i));
  for (const size_t most : {size_t{700}, size_t{100}, size_t{20}}) {
    const std::vector<sock_filter> code = ChannelFilter(names, most);
    ASSERT_FALSE(code.empty());
    EXPECT_LE(code.size(), most);
    for (const std::string& each : names) ASSERT_TRUE(Accepts(code, Datagram(each))) << each;
    EXPECT_FALSE(Accepts(code, Datagram("DESIRED_BOAT_1")));
  }
  EXPECT_TRUE(ChannelFilter(names, 5).empty());
  EXPECT_TRUE(ChannelFilter({}, kPlenty).empty());
}

}  // namespace shoal::channel_filter_test
