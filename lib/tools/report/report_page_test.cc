#include "lib/tools/report/report_page.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "lib/tools/campaign/campaign_testing.h"
#include "lib/tools/page/script_hash.h"

namespace shoal {

namespace {

/// Returns how often `part` is in `text`.
int CountOf(std::string_view part, std::string_view text) {
  int count = 0;
  for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) {
    ++count;
  }
  return count;
}

/// Returns the text without comments of the form /* ... */.
std::string WithoutComments(std::string text) {
  for (size_t at = text.find("/*"); at != text.npos; at = text.find("/*", at)) {
    const size_t end = text.find("*/", at);
    text.erase(at, end == text.npos ? end : end + 2 - at);
  }
  return text;
}

CampaignResults OneCase(int64_t num) {
  CampaignResults results = EmptyCampaign(num);
  AddCase({}, "", &results);
  AddPasses(
      num, [](int64_t i) { return static_cast<double>(i) / 7; }, &results);
  return results;
}

std::string PageOf(const CampaignResults& results) {
  return ReportPage(results, MakeReportTables(results), "/tmp/berta");
}

}  // namespace

TEST(ReportPage, IsOneFileThatNamesNoHost) {
  const std::string page = PageOf(OneCase(10));
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_EQ(CountOf("{{", page.substr(0, page.find("<style>"))), 0) << "each place is filled";
  EXPECT_EQ(CountOf("src=", page), 0);
  EXPECT_EQ(CountOf("@import", page) + CountOf("url(", page), 0);
  const std::string code = WithoutComments(page);
  EXPECT_EQ(CountOf("\nimport ", code) + CountOf("\nexport ", code), 0) << "no module is left";
  EXPECT_EQ(CountOf("const uPlot = module", code), 1);
}

TEST(ReportPage, HoldsTheTextReportForBrowsersWithoutScript) {
  const std::string page = PageOf(OneCase(10));
  const size_t begin = page.find("<noscript>");
  const size_t end = page.find("</noscript>");
  ASSERT_NE(begin, page.npos);
  EXPECT_NE(page.substr(begin, end - begin).find("10 of 10 trials: 10 pass"), std::string::npos);
}

TEST(ReportPage, TakesNoTextOfAFolderForMarkup) {
  CampaignResults results = OneCase(3);
  const std::string hostile = "</noscript></script><script>alert(1)</script>{{script}}";
  results.campaign.file = hostile;
  results.metrics[0].name = results.metrics[0].unit = results.metrics[0].text = hostile;
  results.cases[0].policy = results.cases[0].id = hostile;
  results.rows[1].result = {.outcome = TrialOutcome::kError, .why = hostile, .metrics = {}};
  const std::string page = PageOf(results);
  const std::string plain = PageOf(OneCase(3));
  for (const char* part : {"<script", "</script", "</noscript", "<style"}) {
    EXPECT_EQ(CountOf(part, page), CountOf(part, plain)) << part;
  }
}

TEST(ReportPage, NamesItsStyleByItsHash) {
  const std::string page = PageOf(OneCase(3));
  const size_t begin = page.find("<style>") + 7;
  const std::string style = page.substr(begin, page.find("</style>") - begin);
  EXPECT_EQ(CountOf("style-src " + ScriptHash(style), page), 1);
  EXPECT_EQ(CountOf("'unsafe-", page), 0);
}

TEST(ReportPage, TakesTensOfBytesForATrial) {
  const size_t few = PageOf(OneCase(100)).size();
  const size_t many = PageOf(OneCase(10'100)).size();
  EXPECT_LT(many - few, 10'000U * 30) << "repetition, outcome, why and one metric";
}

}  // namespace shoal
