// Messages of events that no medium on their way carries, with the exact texts.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "lib/mission/file/load.h"

namespace shoal::validate_messages_test {

/// A diver, a ship, and a buoy between them that forwards by a modem whose packets hold 64 bytes.
/// The event is in line 27.
std::string WarningsOf(const std::string& message, const std::string& comms = "") {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 60\n[comms]\nmessages_over = [\"vhf\", \"acoustic\"]\n"
      "reports_over = [\"vhf\", \"acoustic\"]\n" +
          comms +
          "\n"
          "[acoustics]\nmodem = \"nanomodem_v3\"\n"
          "[[medium]]\nname = \"vhf\"\nkind = \"radio\"\nrange_m = 9000\n"
          "[[vehicle]]\nname = \"auv_1\"\nmodel = \"remus100\"\nstart = {depth_m = 20}\n"
          "[[vehicle]]\nname = \"ship\"\n"
          "[[vehicle]]\nname = \"buoy\"\nmodel = \"buoy\"\n"
          "gateway = {from = [\"vhf\", \"acoustic\"], to = [\"acoustic\", \"vhf\"]}\n\n\n"
          "[[event]]\nat_s = 10\nmessage = {src_node = \"ship\", " +
          message + "}\n",
      "m.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  std::string text;
  for (const std::string& warning : loaded.warnings) {
    if (warning.find("message") != std::string::npos || warning.find("_val") != std::string::npos) {
      text += warning + "\n";
    }
  }
  return text;
}

TEST(Acks, ThatMayComeAfterTheirMessageIsRepeatedAreWarnedOf) {
  const auto warnings = [](const std::string& jitter_s) {
    const std::vector<std::string> all =
        LoadMissionText(
            "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"alpha\"\n"
            "helm_options = {deploy_at_start = true}\nmessages = {ack_timeout_s = 5}\n"
            "[[vehicle]]\nname = \"bravo\"\nmessages = {ack_jitter_s = " +
                jitter_s + "}\n",
            "m.toml")
            .warnings;
    std::vector<std::string> of_acks;
    std::ranges::copy_if(all, std::back_inserter(of_acks), [](const std::string& warning) {
      return warning.find("acks") != std::string::npos;
    });
    return of_acks;
  };
  EXPECT_EQ(warnings("4"), std::vector<std::string>());
  EXPECT_EQ(
      warnings("5"),
      std::vector<std::string>{
          "m.toml:9:28: warning: its acks may take 5 s, and alpha sends a message again after "
          "ack_timeout_s = 5: write a shorter ack_jitter_s, or a longer ack_timeout_s "
          "there"});
}

TEST(Messages, ThatNoPacketOnTheirWayHoldsAreWarnedOf) {
  // src_node=ship,src_app=shoal,dest_node=auv_1,var_name=GOTO,string_val=goto=0,0 has 77 bytes.
  EXPECT_EQ(
      WarningsOf("dest_node = \"auv_1\", var_name = \"GOTO\", string_val = \"goto=0,0\""),
      "m.toml:27:84: warning: the message cannot reach auv_1 under water: it takes 77 bytes or "
      "more on the "
      "air, and a packet of acoustic holds at most 64; shorten names and text, or choose another "
      "modem or medium\n");
}

TEST(Messages, ThatFitGoByModem) {
  EXPECT_EQ(WarningsOf("dest_node = \"auv_1\", var_name = \"G\", string_val = \"\""), "");
}

TEST(Messages, OfAnyLengthGoByRadio) {
  const std::string text = "var_name = \"GOTO\", string_val = \"" + std::string(200, 'x') + "\"";
  EXPECT_EQ(WarningsOf("dest_node = \"buoy\", " + text), "");
  EXPECT_NE(WarningsOf("dest_node = \"all\", " + text).find("cannot reach auv_1 under water: it"),
            std::string::npos);
  EXPECT_NE(WarningsOf("dest_group = \"all\", " + text).find("cannot reach auv_1 under water: it"),
            std::string::npos);
}

TEST(Messages, ThatTheBrokerRefusesAreWarnedOf) {
  EXPECT_EQ(WarningsOf("dest_node = \"buoy\", var_name = \"G\", string_val = \"12345\"",
                       "max_msg_length = 4"),
            "m.toml:27:80: warning: string_val has 5 bytes, and the broker passes on at most 4: "
            "shorten it, or raise max_msg_length in [comms]\n");
}

}  // namespace shoal::validate_messages_test
