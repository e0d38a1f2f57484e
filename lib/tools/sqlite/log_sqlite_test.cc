#include "lib/tools/sqlite/log_sqlite.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <memory>
#include <sstream>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::log_sqlite_test {

Bytes Report(const std::string& name, std::vector<key_value_t> extra) {
  node_report_t report{};
  report.name = name;
  report.x_m = 1.5;
  report.y_m = 3;
  report.index = 7;
  report.extra = std::move(extra);
  report.num_extra = static_cast<int32_t>(report.extra.size());
  return Encoded(report);
}

Bytes Fates() {
  comms_fates_t fates{};
  fate_t fate{};
  fate.kind = "report";
  fate.source = "alpha";
  fate.cause = "out_of_range";
  fate.range_m = 512.25;
  fates.fates = {fate, fate};
  fates.fates[1].cause = "delivered";
  fates.num_fates = 2;
  return Encoded(fates);
}

class LogSqlite_ : public ::testing::Test {
 protected:
  int Convert(const std::vector<TestEvent>& events) {
    WriteLog(directory_.File("mission.lcm"), events);
    return ConvertLog();
  }
  int ConvertLog() {
    err_.str("");
    return LogSqlite({.path = directory_.File("mission.lcm"), .out_path = path_}, out_, err_);
  }

  /// Returns the rows, each with | between its values; or why there are none.
  std::string Query(const std::string& sql) {
    sqlite3* opened = nullptr;
    sqlite3_open_v2(path_.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
    const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(opened, &sqlite3_close);
    std::string rows;
    const auto add = [](void* to, int count, char** values, char**) {
      auto& text = *static_cast<std::string*>(to);
      for (int i = 0; i < count; ++i) {
        text.append(i > 0 ? "|" : "").append(values[i] == nullptr ? "NULL" : values[i]);
      }
      text += '\n';
      return 0;
    };
    if (sqlite3_exec(opened, sql.c_str(), add, &rows, nullptr) != SQLITE_OK) {
      rows = sqlite3_errmsg(opened);
    }
    return rows;
  }

  TestDirectory directory_;
  std::string path_ = directory_.File("a.sqlite");
  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_F(LogSqlite_, HasATableForEachChannelWithNumbersAsNumbers) {
  EXPECT_EQ(Convert({{2'500'000, "NODE_REPORT_LOCAL", Report("alpha", {})}}), kExitOk);
  EXPECT_EQ(Query("SELECT time_s, name, x_m, y_m, typeof(y_m), \"index\", row_index "
                  "FROM NODE_REPORT_LOCAL"),
            "2.5|alpha|1.5|3.0|real|7|NULL\n");
  EXPECT_EQ(Query("SELECT * FROM channels"),
            "NODE_REPORT_LOCAL|node_report_t|NODE_REPORT_LOCAL|1|1\n");
}

TEST_F(LogSqlite_, HasFatesWithTheirNumbers) {
  EXPECT_EQ(Convert({{1'000'000, "COMMS_FATES", Fates()}}), kExitOk);
  EXPECT_EQ(Query("SELECT time_s, source, cause, range_m, path_snr_db FROM fates"),
            "1.0|alpha|out_of_range|512.25|NULL\n1.0|alpha|delivered|512.25|NULL\n");
}

TEST_F(LogSqlite_, HasTheUsersOwnFieldsAsRowsAndThoseOfAllMessagesAsColumns) {
  EXPECT_EQ(Convert({{0, "NODE_REPORT_LOCAL", Report("alpha", {{"fuel", "9"}, {"crew", "x"}})},
                     {1'000'000, "NODE_REPORT_LOCAL", Report("bravo", {{"fuel", "8"}})}}),
            kExitOk);
  EXPECT_EQ(Query("SELECT * FROM \"NODE_REPORT_LOCAL.extra\""),
            "0.0|alpha|fuel|9\n0.0|alpha|crew|x\n1.0|bravo|fuel|8\n");
  EXPECT_EQ(Query("SELECT DISTINCT name, \"extra[fuel]\" FROM NODE_REPORT_LOCAL"),
            "alpha|9\nbravo|8\n");
  EXPECT_EQ(Query("SELECT count(*) FROM pragma_table_info('NODE_REPORT_LOCAL') WHERE name = "
                  "'extra[crew]'"),
            "0\n");
}

TEST_F(LogSqlite_, HasTheMissionAndTheVerdictThatLieBesideTheLog) {
  std::ofstream(directory_.File("mission.toml")) << "[mission]\nname = \"x\"\n";
  std::ofstream(directory_.File("summary.txt")) << "alpha: 3 reports\n\nFAIL\nlost: 2\n";
  EXPECT_EQ(Convert({}), kExitOk);
  EXPECT_EQ(Query("SELECT name, text FROM mission"),
            "mission.toml|[mission]\nname = \"x\"\n\nsummary.txt|alpha: 3 reports\n\nFAIL\nlost: "
            "2\n\nverdict|FAIL\n");
}

TEST_F(LogSqlite_, TakesChannelsWhoseNamesSqliteWouldTakeForOthers) {
  const Bytes report = Report("alpha", {});
  EXPECT_EQ(Convert({{0, "mission", report},
                     {0, "sqlite_master", report},
                     {0, "a\"; DROP TABLE mission; --", report},
                     {0, "nav", report},
                     {0, "NAV", report}}),
            kExitOk)
      << err_.str();
  EXPECT_EQ(Query("SELECT table_name, messages FROM channels ORDER BY table_name"),
            "NAV_2|1\n_sqlite_master|1\na\"; DROP TABLE mission; --|1\nmission_2|1\nnav|1\n");
}

TEST_F(LogSqlite_, IsTheSameFileEachTime) {
  EXPECT_EQ(Convert({{0, "NODE_REPORT_LOCAL", Report("alpha", {{"fuel", "9"}})},
                     {1'000'000, "COMMS_FATES", Fates()}}),
            kExitOk);
  const Bytes first = FileBytes(path_);
  EXPECT_EQ(ConvertLog(), kExitOk);
  EXPECT_EQ(FileBytes(path_), first);
}

TEST_F(LogSqlite_, OfACutLogHasWhatCanBeRead) {
  WriteLog(directory_.File("mission.lcm"), {{0, "COMMS_FATES", Fates()}, {1, "X", Fates()}});
  Bytes bytes = FileBytes(directory_.File("mission.lcm"));
  bytes.resize(bytes.size() - 3);
  WriteBytes(directory_.File("mission.lcm"), bytes);
  EXPECT_EQ(ConvertLog(), kExitEnvironment);
  EXPECT_NE(err_.str(), "");
  EXPECT_EQ(Query("SELECT channel FROM channels"), "COMMS_FATES\n");
}

TEST_F(LogSqlite_, OfAFolderThatIsNotThereIsAnErrorAndLeavesNoFile) {
  path_ = directory_.File("none/a.sqlite");
  EXPECT_EQ(Convert({}), kExitEnvironment);
  EXPECT_NE(err_.str().find("cannot write"), std::string::npos) << err_.str();
}

}  // namespace shoal::log_sqlite_test
