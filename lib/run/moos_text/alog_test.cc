#include "lib/run/moos_text/alog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/record/log_testing.h"
#include "lib/run/moos_text/node_report_text.h"

namespace shoal::alog_test {

node_report_t Report(const std::string& name) {
  node_report_t report{};
  report.name = name;
  report.altitude_m = -1;
  return report;
}

TEST(AppendAlogLine, HasTimeVariableSourceAndValueInColumns) {
  std::string text;
  AppendAlogLine(12'300'000, "NODE_REPORT_LOCAL", Report("alpha"), &text);
  EXPECT_EQ(text.substr(0, 71),
            "12.3            NODE_REPORT_LOCAL    node_reporter        NAME=alpha,X=");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
}

TEST(AppendAlogLine, NamesTheAppThatPublishesReportsOnTheChannel) {
  std::string text;
  AppendAlogLine(0, "NODE_REPORT_BRAVO", Report("a"), &text);
  AppendAlogLine(0, "NODE_REPORT", Report("a"), &text);
  EXPECT_NE(text.find("NODE_REPORT_BRAVO    shore_broker "), std::string::npos);
  EXPECT_NE(text.find("NODE_REPORT          outside "), std::string::npos);
}

TEST(AppendAlogLine, StaysOneLineOfFourColumnsWhateverTheReportHolds) {
  std::string text;
  AppendAlogLine(0, "A B\nC", Report("x\ny"), &text);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_NE(text.find(" A_B_C "), std::string::npos);
}

TEST(AlogHeader, IsCommentsOnly) {
  const std::string header = AlogHeader();
  ASSERT_FALSE(header.empty());
  for (size_t begin = 0; begin < header.size(); begin = header.find('\n', begin) + 1) {
    EXPECT_EQ(header.substr(begin, 2), "%%");
  }
  EXPECT_NE(header.find("%% LOGSTART        0\n"), std::string::npos);
}

TEST(NodeReportsAsAlog, WritesALogOfNodeReports) {
  TestDirectory directory;
  node_report_t report{};
  report.name = "alpha";
  report.altitude_m = -1;
  WriteLog(directory.File("a.lcm"), {{500'000, "NODE_REPORT_LOCAL", Encoded(report)}});
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(LogCsv({.path = directory.File("a.lcm"),
                    .out_dir = directory.File("csv"),
                    .lines = NodeReportsAsAlog()},
                   out, err),
            kExitOk);
  EXPECT_NE(
      TextOfFile(directory.File("csv/NODE_REPORT_LOCAL.alog"))
          .find("\n0.5             NODE_REPORT_LOCAL    node_reporter        NAME=alpha,X=0,"),
      std::string::npos);
  EXPECT_NE(out.str().find("NODE_REPORT_LOCAL.alog: 1 lines"), std::string::npos);
}

}  // namespace shoal::alog_test
