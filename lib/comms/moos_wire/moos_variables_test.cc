#include "lib/comms/moos_wire/moos_variables.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::moos_variables_test {

constexpr MoosClientId kAnn = 1;
constexpr MoosClientId kBob = 2;

/// "1:X=3 2:X=3": which client gets which value.
std::string TextOf(const MoosMail& mail) {
  std::string text;
  for (const auto& [client, message] : mail) {
    if (!text.empty()) text += ' ';
    text += std::to_string(client) + ":" + message.key + "=";
    text += message.IsDouble() ? std::to_string(static_cast<int>(message.value)) : message.text;
  }
  return text;
}

struct Variables {
  std::string Write(const std::string& key, double value, double time_s = 0,
                    const std::string& source = "ann") {
    MoosMail mail;
    variables.Write(MoosNotify(source, key, value), time_s, &mail);
    return TextOf(mail);
  }
  std::string WriteText(const std::string& key, const std::string& text) {
    MoosMail mail;
    variables.Write(MoosNotify("ann", key, text), 0, &mail);
    return TextOf(mail);
  }
  std::string Subscribe(MoosClientId client, const std::string& key, double interval_s = 0,
                        double time_s = 0) {
    MoosMail mail;
    variables.Subscribe(client, key, interval_s, time_s, &mail);
    return TextOf(mail);
  }
  std::string SubscribePattern(MoosClientId client, const std::string& text) {
    MoosMail mail;
    variables.SubscribePattern(client, ParseMoosPattern(text), 0, &mail);
    return TextOf(mail);
  }
  MoosVariables variables;
};

TEST(MoosVariables, GiveThePresentValueAtEachRegistration) {
  Variables all;
  EXPECT_EQ(all.Subscribe(kAnn, "X"), "") << "never written";
  EXPECT_EQ(all.Write("X", 3), "1:X=3") << "the writer too, if it is subscribed";
  EXPECT_EQ(all.Subscribe(kAnn, "X"), "1:X=3");
  EXPECT_EQ(all.Subscribe(kBob, "X"), "2:X=3");
  EXPECT_EQ(all.Write("X", 4), "1:X=4 2:X=4");
  all.variables.Unsubscribe(kAnn, "X");
  EXPECT_EQ(all.Write("X", 5), "2:X=5");
  all.variables.Remove(kBob);
  EXPECT_EQ(all.Write("X", 6), "");
  EXPECT_EQ(all.variables.num_subscriptions(), 0U);
}

TEST(MoosVariables, DropWhatComesBeforeAnIntervalHasPassed) {
  Variables all;
  all.Subscribe(kAnn, "X", 0.5);
  EXPECT_EQ(all.Write("X", 1, 10), "1:X=1");
  EXPECT_EQ(all.Write("X", 2, 10.4), "");
  EXPECT_EQ(all.Write("X", 3, 10.5), "1:X=3");
  all.Subscribe(kAnn, "X", 0, 10.5);
  EXPECT_EQ(all.Write("X", 4, 10.5), "1:X=4") << "the later registration counts";
}

TEST(MoosVariables, KeepTheTypeOfTheFirstWrite) {
  Variables all;
  all.Subscribe(kAnn, "X");
  all.Write("X", 1);
  EXPECT_EQ(all.WriteText("X", "one"), "");
  EXPECT_EQ(all.variables.counts().wrong_type, 1);
  EXPECT_EQ(all.variables.Find("X")->value, 1);
  EXPECT_EQ(all.variables.Find("Y"), nullptr);
}

TEST(MoosVariables, TakePatternsOfSourcesAndNamesAsTheCaptureWildcardShows) {
  Variables all;
  all.Write("NAV_X", 4, 0, "gold_writer");
  all.Write("NAV_Y", 5, 0, "other");
  const std::string pattern = "AppPattern=gold_w*,VarPattern=NAV_*,Interval=0.5";
  EXPECT_EQ(all.SubscribePattern(kAnn, pattern), "1:NAV_X=4");
  EXPECT_EQ(all.Write("NAV_NEW", 6, 1, "gold_writer"), "1:NAV_NEW=6") << "written later";
  EXPECT_EQ(all.Write("NAV_X", 7, 1.1, "gold_writer"), "1:NAV_X=7");
  EXPECT_EQ(all.Write("NAV_X", 8, 1.2, "gold_writer"), "") << "by its interval";
  all.variables.UnsubscribePattern(kAnn, ParseMoosPattern("AppPattern=gold_w*,VarPattern=NAV_*"));
  EXPECT_EQ(all.Write("NAV_X", 9, 3, "gold_writer"), "");
  EXPECT_EQ(all.Write("NAV_AFTER", 1, 4, "gold_writer"), "1:NAV_AFTER=1")
      << "what is first written afterwards still arrives";
}

TEST(MoosVariables, TakeNamesWithAnythingInThem) {
  Variables all;
  all.Subscribe(kAnn, "");
  EXPECT_EQ(all.Write("", 1), "1:=1");
  const std::string odd("\0\x1b*\xff", 4);
  all.Subscribe(kAnn, odd);
  EXPECT_EQ(all.Write(odd, 2), "1:" + odd + "=2");
}

TEST(MoosVariables, RememberNoMoreThanTheirLimits) {
  MoosVariables variables({.max_variables = 10,
                           .max_key_bytes = 8,
                           .max_value_bytes = 100,
                           .max_subscriptions = 5,
                           .max_patterns = 2});
  MoosMail mail;
  for (int i = 0; i < 1000; ++i) {
    variables.Subscribe(kAnn, "V" + std::to_string(i), 0, 0, &mail);
  }
  EXPECT_EQ(variables.num_subscriptions(), 5U);
  EXPECT_EQ(variables.counts().beyond, 995);
  EXPECT_FALSE(variables.Write(MoosNotify("a", "LONGNAMES", 1), 0, &mail));
  EXPECT_FALSE(variables.Write(MoosNotify("a", "BIG", std::string(200, 'x')), 0, &mail));
  EXPECT_FALSE(variables.Write(MoosNotify("a", "V1000", 1), 0, &mail)) << "the eleventh";
  EXPECT_TRUE(variables.Write(MoosNotify("a", "V1", 1), 0, &mail));
  for (int i = 0; i < 5; ++i) {
    variables.SubscribePattern(kAnn, {.key = "V" + std::to_string(i)}, 0, &mail);
  }
  EXPECT_EQ(variables.counts().beyond, 995 + 3 + 3);
  variables.Remove(kAnn);
  EXPECT_EQ(variables.Names(), (std::vector<std::string>{"V1"}));
  EXPECT_TRUE(variables.Write(MoosNotify("a", "NEW", 1), 0, &mail)) << "room again";
}

}  // namespace shoal::moos_variables_test
