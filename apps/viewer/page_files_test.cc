#include "apps/viewer/page_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace shoal::page_files_test {

namespace fs = std::filesystem;

TEST(PageFiles, AreThoseOfTheFolderWeb) {
  const std::string folder = std::string(SHOAL_SOURCE_DIR) + "/web";
  auto loaded = LoadPageFiles(folder);
  ASSERT_TRUE(loaded.ok()) << loaded.error();
  // The sources of a campaign's page, which is a file and not served.
  std::erase_if(*loaded, [](const auto& file) { return file.first.starts_with("/campaign/"); });
  const PageFiles embedded = EmbeddedPageFiles();
  EXPECT_GT(embedded.size(), 2U);
  for (const auto& [path, file] : embedded) {
    const auto found = loaded->find(path);
    ASSERT_TRUE(found != loaded->end()) << path;
    EXPECT_TRUE(found->second.bytes == file.bytes) << path << " has changed since the build";
    EXPECT_EQ(found->second.content_type, file.content_type) << path;
  }
  EXPECT_EQ(loaded->size(), embedded.size());
}

TEST(PageFiles, HaveTheTypesThatBrowsersRequire) {
  EXPECT_EQ(ContentTypeOf("/app.js"), "text/javascript; charset=utf-8");
  EXPECT_EQ(ContentTypeOf("/index.html"), "text/html; charset=utf-8");
  EXPECT_EQ(ContentTypeOf("/style.css"), "text/css; charset=utf-8");
  EXPECT_EQ(ContentTypeOf("/a.png"), "image/png");
  EXPECT_EQ(ContentTypeOf("/icon.svg"), "image/svg+xml; charset=utf-8");
  EXPECT_EQ(ContentTypeOf("/README"), "");
  EXPECT_EQ(ContentTypeOf("/secret.key"), "");
}

TEST(PageFiles, BeginWithTheIndex) {
  const PageFiles files = EmbeddedPageFiles();
  ASSERT_TRUE(files.contains("/"));
  EXPECT_EQ(files.at("/").bytes, files.at("/index.html").bytes);
}

class FolderOfAPage : public ::testing::Test {
 protected:
  FolderOfAPage() : folder_(::testing::TempDir() + "page_files_test_" + std::to_string(getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "vendor");
  }
  ~FolderOfAPage() override { fs::remove_all(folder_); }

  void Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }

  fs::path folder_;
};

TEST_F(FolderOfAPage, IsReadWithItsSubfolders) {
  Write("index.html", "<html>");
  Write("vendor/plot.js", std::string("a\0b", 3));
  Write("notes.md", "left out");
  const auto files = LoadPageFiles(folder_.string());
  ASSERT_TRUE(files.ok()) << files.error();
  EXPECT_EQ(files->size(), 3U);
  EXPECT_EQ(files->at("/").bytes, "<html>");
  EXPECT_EQ(files->at("/vendor/plot.js").bytes, std::string("a\0b", 3));
  EXPECT_TRUE(LoadPageFiles(folder_.string() + "/").ok());
}

TEST_F(FolderOfAPage, NeedsAnIndex) {
  Write("app.js", "");
  const auto files = LoadPageFiles(folder_.string());
  ASSERT_FALSE(files.ok());
  EXPECT_NE(files.error().find("no index.html"), std::string::npos) << files.error();
  EXPECT_FALSE(LoadPageFiles(folder_.string() + "/none").ok());
}

}  // namespace shoal::page_files_test
