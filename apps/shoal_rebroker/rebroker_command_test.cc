#include "apps/shoal_rebroker/rebroker_command.h"

#include <gtest/gtest.h>

#include <sstream>

#include "lib/base/check/result.h"
#include "tests/analysis/rebroker_testing.h"

namespace shoal::rebroker_command_test {

struct Printed {
  int code = 0;
  std::string out;
  std::string err;
};

Printed Rebrokered(const RebrokerOptions& options) {
  std::ostringstream out;
  std::ostringstream err;
  Printed printed;
  printed.code = RunRebroker(options, out, err);
  printed.out = out.str();
  printed.err = err.str();
  return printed;
}

void WriteText(const std::string& path, std::string_view text) {
  WriteBytes(path, Bytes(text.begin(), text.end()));
}

class RebrokerCommandTest : public ::testing::Test {
 protected:
  RebrokerCommandTest() { Record(kMixedTraffic, log()); }
  std::string log() const { return directory_.File("m.lcm"); }
  std::string File(const std::string& name) const { return directory_.File(name); }

  TestDirectory directory_;
};

TEST_F(RebrokerCommandTest, ReproducesARecordingAndItsOwnLog) {
  const Printed first = Rebrokered({.logs = {log()}, .out_path = File("out.lcm")});
  EXPECT_EQ(first.code, kExitOk) << first.out << first.err;
  EXPECT_EQ(first.err, "");
  EXPECT_NE(first.out.find("Recorded: reproduced "), std::string::npos) << first.out;
  EXPECT_EQ(first.out.find("first difference"), std::string::npos) << first.out;
  EXPECT_EQ(first.out.find("\n*"), std::string::npos) << first.out;
  EXPECT_EQ(Rebrokered({.logs = {File("out.lcm")}, .out_path = File("again.lcm")}).code, kExitOk);
  EXPECT_EQ(FileBytes(File("out.lcm")), FileBytes(File("again.lcm")));
}

TEST_F(RebrokerCommandTest, ShowsWhichRulesDifferAndWhatChanges) {
  WriteText(File("c.toml"), "[comms]\ncomms_range = 300\ncritical_range = 10\n");
  const Printed printed = Rebrokered({.logs = {log()}, .comms_file = File("c.toml")});
  EXPECT_EQ(printed.code, kExitOk) << printed.err;
  EXPECT_NE(printed.out.find("comms_range = 300 (was 80)"), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("drop_percentage = 0 (was 30)"), std::string::npos) << printed.out;
  EXPECT_EQ(printed.out.find("critical_range ="), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("the recorded controls apply"), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("\n* alpha -> bravo"), std::string::npos) << printed.out;
}

TEST_F(RebrokerCommandTest, TakesStealthAndEarangeFromAMissionFile) {
  std::string text = kMixedTraffic;
  text.replace(text.find("stealth = 0.5"), 13, "earange = 2.0");
  WriteText(File("m.toml"), text);
  const Printed printed =
      Rebrokered({.logs = {log()}, .comms_file = File("m.toml"), .no_controls = true});
  EXPECT_NE(printed.out.find("charlie: stealth = 1 (was 0.5), earange = 2 (was 1)"),
            std::string::npos)
      << printed.out;
  EXPECT_NE(printed.out.find("the recorded controls are left out"), std::string::npos);
}

TEST_F(RebrokerCommandTest, EndsWithOneAndShowsBothWhereDecisionsDiffer) {
  std::vector<TestEvent> events = EventsOf(log());
  for (TestEvent& event : events) {
    comms_fates_t fates;
    if (event.utime < 10'000'000 || event.channel != "COMMS_FATES") continue;
    ASSERT_TRUE(Decode(event.data, &fates));
    fates.fates[0].cause = "forged";
    event.data = Encoded(fates);
    break;
  }
  WriteLog(File("forged.lcm"), events);
  const Printed printed = Rebrokered({.logs = {File("forged.lcm")}});
  EXPECT_EQ(printed.code, kDecisionsDiffer);
  EXPECT_NE(printed.out.find("recorded: report"), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("forged"), std::string::npos) << printed.out;
}

TEST_F(RebrokerCommandTest, WarnsOfWhatAnLcmLoggerLost) {
  std::vector<TestEvent> events = Sealed(EventsOf(log()));
  int64_t count = 0;
  std::erase_if(events, [&](const TestEvent& event) {
    return event.channel == "NODE_REPORT_LOCAL" && ++count > 6 && count < 12;
  });
  WriteLog(File("logger.lcm"), events);
  const Printed printed = Rebrokered({.logs = {File("logger.lcm")}});
  EXPECT_NE(printed.err.find("5 node reports seem to be missing"), std::string::npos)
      << printed.err;
  EXPECT_NE(printed.out.find("restored from the seals"), std::string::npos) << printed.out;
}

TEST_F(RebrokerCommandTest, NeedsRulesForALogThatHasNone) {
  std::vector<TestEvent> events = EventsOf(log());
  std::erase_if(events, [](const TestEvent& event) { return event.channel == "COMMS_RULES"; });
  WriteLog(File("bare.lcm"), events);
  const Printed without = Rebrokered({.logs = {File("bare.lcm")}});
  EXPECT_EQ(without.code, kExitUsage);
  EXPECT_NE(without.err.find("--comms"), std::string::npos) << without.err;

  // The mission file has all that the log lacks: rules, factors and the seed.
  WriteText(File("m.toml"), kMixedTraffic);
  const Printed with = Rebrokered({.logs = {File("bare.lcm")}, .comms_file = File("m.toml")});
  EXPECT_EQ(with.code, kExitOk);
  EXPECT_NE(with.err.find("no COMMS_RULES"), std::string::npos) << with.err;
  EXPECT_EQ(with.out.find("\n*"), std::string::npos) << with.out;
}

TEST_F(RebrokerCommandTest, NamesARuleThatItDoesNotKnowAndOneThatTheLogLacks) {
  std::vector<TestEvent> events = EventsOf(log());
  for (TestEvent& event : events) {
    broker_rules_t rules{};
    if (event.channel != "COMMS_RULES" || !Decode(event.data, &rules)) continue;
    for (broker_rule_t& rule : rules.rules) {
      if (rule.key == "msg_color") rule.key = "max_depth";
    }
    event.data = Encoded(rules);
  }
  WriteLog(File("later.lcm"), events);
  const Printed printed = Rebrokered({.logs = {File("later.lcm")}});
  EXPECT_EQ(printed.code, kExitOk) << printed.out;
  EXPECT_EQ(printed.err,
            "shoal: warning: the log has the rule 'max_depth' ('white'), which this build does not "
            "know: decisions may differ\n"
            "shoal: warning: the log does not have the rule 'msg_color': it has its default, "
            "'white'\n");
}

TEST_F(RebrokerCommandTest, RefusesToOverwriteTheLogThatItReads) {
  EXPECT_EQ(Rebrokered({.logs = {log()}, .out_path = log()}).code, kExitUsage);
  EXPECT_EQ(Rebrokered({.logs = {log()}}).code, kExitOk) << "it is still there";
}

TEST_F(RebrokerCommandTest, StatesWhatIsWrongWithItsFiles) {
  WriteText(File("c.toml"), "[comms]\ncoms_range = 300\n");
  const Printed unknown_key = Rebrokered({.logs = {log()}, .comms_file = File("c.toml")});
  EXPECT_EQ(unknown_key.code, kExitUsage);
  EXPECT_NE(unknown_key.err.find("c.toml:2:1: unknown key"), std::string::npos) << unknown_key.err;
  EXPECT_EQ(Rebrokered({.logs = {File("none.lcm")}}).code, kExitEnvironment);
  EXPECT_EQ(Rebrokered({.logs = {log()}, .out_path = File("no/such/dir.lcm")}).code,
            kExitEnvironment);

  WriteLog(File("empty.lcm"), {});
  const Printed empty = Rebrokered({.logs = {File("empty.lcm")}});
  EXPECT_EQ(empty.code, kExitUsage);
  EXPECT_NE(empty.err.find("nothing to broker"), std::string::npos) << empty.err;
}

TEST_F(RebrokerCommandTest, ReadsADamagedLogUpToTheDamageAndStatesWhereThatIs) {
  Bytes bytes = FileBytes(log());
  bytes.resize(bytes.size() * 3 / 4 + 5);
  WriteBytes(File("cut.lcm"), bytes);
  const Printed printed = Rebrokered({.logs = {File("cut.lcm")}});
  EXPECT_EQ(printed.code, kExitEnvironment);
  EXPECT_NE(printed.err.find("byte "), std::string::npos) << printed.err;
  EXPECT_NE(printed.out.find("Node reports"), std::string::npos) << printed.out;
}

}  // namespace shoal::rebroker_command_test
