#include <gtest/gtest.h>

#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_commands_testing.h"

namespace shoal::log_diff_test {

using LogDiff_ = LogCommandsTest;

TEST_F(LogDiff_, StatesThatLogsAreEqual) {
  const std::vector<TestEvent> events = {{0, "D", Desired(0, 1)}, {100'000, "D", Desired(0, 2)}};
  EXPECT_EQ(Diff(Log("a.lcm", events), Log("b.lcm", events)), "equal: 2 events in 2 steps\n");
  EXPECT_EQ(exit_code_, kExitOk);
}

TEST_F(LogDiff_, FindsStepTimeChannelAndFieldOfTheFirstDifference) {
  const TestEvent first = {0, "D", Desired(0, 1)};
  const std::string a = Log("a.lcm", {first, {100'000, "COMMS_FATES", Fates(0, {"lost", "lost"})}});
  const std::string b =
      Log("b.lcm", {first, {100'000, "COMMS_FATES", Fates(0, {"lost", "delivered"})}});
  EXPECT_EQ(Diff(a, b),
            "first difference: step 1, 0.100 s, COMMS_FATES, comms_fates_t "
            "fates[1].cause\n  " +
                a + ": lost\n  " + b + ": delivered\n" +
                "every channel has the same number of events in both logs\n");
  EXPECT_EQ(exit_code_, kLogsDiffer);
}

TEST_F(LogDiff_, LeavesOutChannels) {
  const std::string a = Log("a.lcm", {{0, "D", Desired(0, 1)}, {0, "E_X", Desired(0, 1)}});
  const std::string b =
      Log("b.lcm", {{0, "E_X", Desired(0, 2)}, {0, "E_Y", {}}, {0, "D", Desired(0, 1)}});
  EXPECT_EQ(Diff(a, b, {"F", "E_*"}), "equal: 1 events in 1 steps\n");
  EXPECT_EQ(exit_code_, kExitOk);
  EXPECT_NE(Diff(a, b, {"E_Y"}), "equal: 2 events in 1 steps\n");
  EXPECT_EQ(exit_code_, kLogsDiffer);
}

TEST_F(LogDiff_, NamesTheArithmeticOfBothLogsWhereItDiffers) {
  const auto rules_of = [](const std::string& arithmetic) {
    broker_rules_t rules{};
    rules.arithmetic = arithmetic;
    return Encoded(rules);
  };
  const std::string a = Log("a.lcm", {{0, "COMMS_RULES", rules_of("a1")}, {0, "D", Desired(0, 1)}});
  const std::string b = Log("b.lcm", {{0, "COMMS_RULES", rules_of("b2")}, {0, "D", Desired(0, 1)}});
  const std::string note =
      "the logs are of builds with another arithmetic, which give other logs:\n  " + a +
      ": a1\n  " + b + ": b2\n";
  EXPECT_NE(Diff(a, b).find(note), std::string::npos);
  EXPECT_EQ(exit_code_, kLogsDiffer);
  EXPECT_EQ(Diff(a, b, {"COMMS_RULES"}), note + "equal: 1 events in 1 steps\n");
  EXPECT_EQ(exit_code_, kExitOk);
  const std::string old = Log("c.lcm", {{0, "COMMS_RULES", rules_of("")}, {0, "D", Desired(0, 1)}});
  EXPECT_EQ(Diff(a, old).find("arithmetic, which"), std::string::npos);
}

TEST_F(LogDiff_, FindsAMissingMessageAndCountsItsChannel) {
  const std::string a = Log("a.lcm", {{0, "D", Desired(0, 1)}, {0, "E", Desired(0, 1)}});
  const std::string b = Log("b.lcm", {{0, "E", Desired(0, 1)}});
  const std::string line = " desired_t heading_deg=1 speed_mps=1.5 depth_m=0\n";
  EXPECT_EQ(Diff(a, b), "first difference: step 0, 0.000 s, other messages follow\n  " + a +
                            ": 0.000 D" + line + "  " + b + ": 0.000 E" + line +
                            "different numbers of events:\n  D: 1 in " + a + ", 0 in " + b + "\n");
}

TEST_F(LogDiff_, FindsThatOneLogEnds) {
  const std::string a = Log("a.lcm", {{0, "D", Desired(0, 1)}});
  const std::string b = Log("b.lcm", {{0, "D", Desired(0, 1)}, {5, "E", {}}});
  EXPECT_EQ(Diff(a, b), "first difference: step 1, 0.000005 s, one log ends\n  " + a +
                            ": (ends here)\n  " + b + ": 0.000005 E ? (no fingerprint, 0 bytes)\n" +
                            "different numbers of events:\n  E: 0 in " + a + ", 1 in " + b + "\n");
}

TEST_F(LogDiff_, NamesTheByteWhereItKnowsNoField) {
  const std::string a = Log("a.lcm", {{0, "D", {1, 2, 3}}});
  const std::string b = Log("b.lcm", {{0, "D", {1, 2}}});
  EXPECT_EQ(Diff(a, b), "first difference: step 0, 0.000 s, D, byte 2 of the message\n  " + a +
                            ": 0x03\n  " + b + ": (ends)\n" +
                            "every channel has the same number of events in both logs\n");
}

TEST_F(LogDiff_, RefusesADamagedLog) {
  const std::string a = Log("a.lcm", {{0, "D", {1, 2, 3}}});
  const std::string b = Log("b.lcm", {{0, "D", {1, 2, 3}}});
  Bytes bytes = FileBytes(b);
  bytes.pop_back();
  WriteBytes(b, bytes);
  Diff(a, b);
  EXPECT_EQ(exit_code_, kExitEnvironment);
  EXPECT_NE(err_.str().find(b + ": byte 0: the log ends inside an event"), std::string::npos);
}

}  // namespace shoal::log_diff_test
