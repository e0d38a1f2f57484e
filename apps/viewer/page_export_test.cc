#include "apps/viewer/page_export.h"

#include <gtest/gtest.h>

#include "lib/tools/page/script_hash.h"

namespace shoal::page_export_test {

int CountOf(std::string_view what, std::string_view text) {
  int count = 0;
  for (size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

constexpr std::string_view kHostile = R"({"name":"</script><script>alert(1)</script>"})";

TEST(PageExport, NamesScriptAndStylesByTheirHashesAndAllowsNothingElse) {
  const PageFiles files = EmbeddedPageFiles();
  const auto page = SelfContainedPage(files, kHostile);
  ASSERT_TRUE(page.ok()) << page.error();
  for (const char* name : {"/style.css", "/panels/panels.css", "/vendor/uPlot.min.css"}) {
    EXPECT_EQ(CountOf(ScriptHash(files.at(name).bytes), *page), 1) << name;
  }
  EXPECT_EQ(CountOf("'unsafe-", *page), 0);
  EXPECT_EQ(CountOf("default-src 'none'", *page), 1);
  EXPECT_EQ(CountOf("script-src 'sha256-", *page), 1);
}

TEST(PageExport, HoldsNoNameOfAMissionAsText) {
  const auto page = SelfContainedPage(EmbeddedPageFiles(), kHostile);
  ASSERT_TRUE(page.ok()) << page.error();
  EXPECT_EQ(CountOf("alert(1)", *page), 0);
  EXPECT_EQ(CountOf("</script>", *page), 2) << "of the recording and of the page's own script";
  EXPECT_EQ(CountOf(DeflatedBase64(kHostile), *page), 1);
}

TEST(PageExport, LoadsNothingFromBesideIt) {
  const auto page = SelfContainedPage(EmbeddedPageFiles(), "{}");
  ASSERT_TRUE(page.ok()) << page.error();
  EXPECT_EQ(CountOf("rel=\"stylesheet\"", *page), 0);
  EXPECT_EQ(CountOf("modulepreload", *page), 0);
  EXPECT_EQ(CountOf(" src=\"", *page), 0);
  EXPECT_EQ(CountOf("\nimport ", *page), 0);
}

TEST(PageExport, NamesWhatAPageLacks) {
  PageFiles files;
  EXPECT_EQ(SelfContainedPage(files, "{}").error(), "the page has no index.html");
  files["/index.html"] = {"text/html", "<link rel=\"stylesheet\" href=\"a.css\">\n"};
  EXPECT_EQ(SelfContainedPage(files, "{}").error(), "index.html names a.css, which is not there");
}

TEST(PageExport, DeflatesAsBrowsersUndoIt) {
  // zlib's header of the best compression, in base64.
  EXPECT_EQ(DeflatedBase64("aaaaaaaaaaaaaaaaaaaa").substr(0, 2), "eN");
  EXPECT_LT(DeflatedBase64(std::string(100'000, 'a')).size(), 300);
}

}  // namespace shoal::page_export_test
