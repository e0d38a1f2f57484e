// Logs that 0.1.0 and 0.2.0 wrote (tests/golden/README.md): this build reads them as its own.
#include <gtest/gtest.h>

#include <sstream>

#include "apps/shoal_log/log_comms.h"
#include "apps/shoal_log/log_encounters.h"
#include "apps/shoal_rebroker/rebroker_command.h"
#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_testing.h"
#include "lib/tools/mcap/log_mcap.h"
#include "lib/tools/sqlite/log_sqlite.h"
#include "lib/tools/view/recorded_view.h"

namespace shoal::old_logs_test {

struct OldLog {
  std::string name;
  std::string first_range;  ///< The rule comms_range at the log's begin and end.
  std::string last_range;
  std::string decisions;
};

const OldLog kOldLogs[] = {
    {"two_vessels_0.1", "60", "40", "Recorded: reproduced 79 of 79 decisions"},
    {"two_media_0.2", "250", "250", "Recorded: reproduced 79 of 79 decisions"},
};

class OldLogs : public testing::TestWithParam<OldLog> {
 protected:
  std::string Path() const {
    return std::string(SHOAL_SOURCE_DIR) + "/tests/golden/logs/" + GetParam().name + ".lcm";
  }

  TestDirectory directory_;
  std::ostringstream out_;
  std::ostringstream err_;
};

INSTANTIATE_TEST_SUITE_P(Of, OldLogs, testing::ValuesIn(kOldLogs), [](const auto& log) {
  return log.index == 0 ? "Version_0_1" : "Version_0_2";
});

TEST_P(OldLogs, AreDecidedAgainToTheLastDecision) {
  const std::string again = directory_.File("again.lcm");
  EXPECT_EQ(RunRebroker({.logs = {Path()}, .out_path = again}, out_, err_), kExitOk) << err_.str();
  EXPECT_NE(out_.str().find(GetParam().decisions), std::string::npos) << out_.str();
  EXPECT_EQ(err_.str(), "") << "no rule is unknown or lacking";

  // What it writes has today's type, and the same rules.
  out_.str("");
  EXPECT_EQ(RunRebroker({.logs = {again}}, out_, err_), kExitOk) << err_.str();
  EXPECT_NE(out_.str().find(GetParam().decisions), std::string::npos) << out_.str();
}

TEST_P(OldLogs, AreViewedWithTheRulesOfEachMoment) {
  const auto view = RecordedView::Open(Path());
  ASSERT_TRUE(view.ok()) << view.error();
  for (const std::string& note : (*view)->notes()) {
    EXPECT_EQ(note.find("do not decode"), std::string::npos) << note;
    EXPECT_EQ(note.find("rule"), std::string::npos) << note;
  }
  const auto has_range = [&](double t_s, const std::string& range) {
    return (*view)->FrameJson(t_s).find("\"comms_range\":\"" + range + "\"") != std::string::npos;
  };
  EXPECT_TRUE(has_range((*view)->begin_s(), GetParam().first_range));
  EXPECT_TRUE(has_range((*view)->end_s(), GetParam().last_range));
  EXPECT_NE((*view)->FrameJson((*view)->end_s()).find("\"alpha\":{\"stealth\":"),
            std::string::npos);
}

TEST_P(OldLogs, AreJudgedAndCounted) {
  EXPECT_EQ(LogEncounters({.path = Path(), .encounter = {.open_s = 1}}, out_, err_), kExitOk);
  EXPECT_NE(out_.str().find("alpha"), std::string::npos) << out_.str();
  EXPECT_EQ(LogComms({.path = Path()}, out_, err_), kExitOk);
  EXPECT_EQ(err_.str(), "");
}

TEST_P(OldLogs, AreWrittenAsTablesWithTheirOwnType) {
  EXPECT_EQ(LogCsv({.path = Path(), .out_dir = directory_.File("csv")}, out_, err_), kExitOk);
  const std::string rules = TextOfFile(directory_.File("csv/COMMS_RULES.csv"));
  EXPECT_NE(rules.substr(0, rules.find('\n')).find("comms_range_m"), std::string::npos) << rules;
  EXPECT_EQ(LogSqlite({.path = Path(), .out_path = directory_.File("l.sqlite")}, out_, err_),
            kExitOk);
  EXPECT_EQ(LogMcap({.path = Path(), .out_path = directory_.File("l.mcap")}, out_, err_), kExitOk);
  EXPECT_NE(TextOfFile(directory_.File("l.mcap")).find("comms_rules_t"), std::string::npos);
  EXPECT_EQ(err_.str(), "");
}

}  // namespace shoal::old_logs_test
