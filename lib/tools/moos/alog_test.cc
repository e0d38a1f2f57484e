#include "lib/tools/moos/alog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lib/tools/moos/node_report_text.h"

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

}  // namespace shoal::alog_test
