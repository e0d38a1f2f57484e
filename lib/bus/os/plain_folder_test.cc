#include "lib/bus/os/plain_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "lib/bus/os/read_file.h"
#include "lib/bus/os/replace_file.h"
#include "lib/bus/os/scratch_folder.h"

namespace shoal::plain_folder_test {

namespace fs = std::filesystem;

class PlainFolders : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "plainXXXXXX";
    folder_ = mkdtemp(pattern.data());
    fs::create_directories(folder_ / "mine/T");
    std::ofstream(folder_ / "mine/T/file") << "mine";
    fs::create_directories(folder_ / "theirs");
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string Mine() const { return ReadFile((folder_ / "mine/T/file").string()).text; }
  fs::path folder_;
};

TEST_F(PlainFolders, MakeAndOpenWhatLiesInThem) {
  EXPECT_FALSE(PlainFolder::Open((folder_ / "new/results").string()).ok());
  fs::create_directories(folder_ / "new/results");
  const auto folder = PlainFolder::Open((folder_ / "new/results").string());
  ASSERT_TRUE(folder.ok()) << folder.error();
  const auto below = folder->Below("shards");
  ASSERT_TRUE(below.ok()) << below.error();
  for (int i = 0; i < 2; ++i) {
    const auto file = below->OpenFile("a", O_APPEND);
    ASSERT_TRUE(file.ok()) << file.error();
    EXPECT_EQ(::write(file->get(), "x", 1), 1);
  }
  EXPECT_EQ(ReadFile((folder_ / "new/results/shards/a").string()).text, "xx");
  EXPECT_EQ(folder->Remove("shards"), "");
  EXPECT_FALSE(fs::exists(folder_ / "new/results/shards"));
  EXPECT_EQ(folder->Remove("shards"), "") << "one that is not there is no error";
}

TEST_F(PlainFolders, FollowNoLinkToAFolder) {
  fs::create_directory_symlink(folder_ / "mine", folder_ / "theirs/replays");
  const auto folder = PlainFolder::Open((folder_ / "theirs").string());
  const auto below = folder->Below("replays");
  ASSERT_FALSE(below.ok());
  EXPECT_NE(below.error().find("theirs/replays: is a link"), std::string::npos) << below.error();
  EXPECT_EQ(folder->Remove("replays"), "");
  EXPECT_FALSE(fs::is_symlink(folder_ / "theirs/replays"));
  EXPECT_EQ(Mine(), "mine");
}

TEST_F(PlainFolders, OpenNoLinkToAFile) {
  fs::create_symlink(folder_ / "mine/T/file", folder_ / "theirs/soft");
  fs::create_hard_link(folder_ / "mine/T/file", folder_ / "theirs/hard");
  fs::create_symlink(folder_ / "mine/T/none", folder_ / "theirs/dangling");
  const auto folder = PlainFolder::Open((folder_ / "theirs").string());
  for (const char* name : {"soft", "hard", "dangling"}) {
    const auto file = folder->OpenFile(name, O_APPEND);
    ASSERT_FALSE(file.ok()) << name;
    EXPECT_NE(file.error().find("link"), std::string::npos) << file.error();
  }
  EXPECT_FALSE(fs::exists(folder_ / "mine/T/none"));
}

TEST_F(PlainFolders, ReadNoLinkAndNoPipe) {
  fs::create_symlink(folder_ / "mine/T/file", folder_ / "theirs/soft");
  fs::create_directory_symlink(folder_ / "mine", folder_ / "theirs/below");
  ASSERT_EQ(mkfifo((folder_ / "theirs/pipe").c_str(), 0600), 0);
  std::ofstream(folder_ / "theirs/file") << "theirs";
  const auto folder = PlainFolder::Open((folder_ / "theirs").string());
  EXPECT_NE(folder->ReadText("soft").problem.find("is a link"), std::string::npos);
  EXPECT_EQ(folder->ReadText("soft").text, "");
  EXPECT_EQ(folder->ReadText("pipe").problem, "is not a regular file");
  EXPECT_EQ(folder->ReadText("file").text, "theirs");
  EXPECT_NE(folder->ReadText("file", 5).problem, "");
  EXPECT_NE(folder->Existing("below").error().find("is a link"), std::string::npos);
  EXPECT_FALSE(folder->Existing("none").ok());
  EXPECT_FALSE(fs::exists(folder_ / "theirs/none"));
  EXPECT_EQ(folder->Names(), (std::vector<std::string>{"below", "file", "pipe", "soft"}));
  EXPECT_TRUE(folder->Has("soft"));
  EXPECT_FALSE(folder->Has("none"));
}

TEST_F(PlainFolders, AreWhatTheUserNamesEvenThroughALink) {
  fs::create_directory_symlink(folder_ / "theirs", folder_ / "chosen");
  const auto folder = PlainFolder::Open((folder_ / "chosen").string());
  ASSERT_TRUE(folder.ok());
  EXPECT_TRUE(folder->OpenFile("lock", 0).ok());
  EXPECT_TRUE(fs::exists(folder_ / "theirs/lock"));
}

TEST_F(PlainFolders, HaveFilesReplacedWithoutADraftThatIsALink) {
  const std::string path = (folder_ / "theirs/results.csv").string();
  fs::create_symlink(folder_ / "mine/T/file", PartPath(path));
  EXPECT_EQ(ReplaceFile(path, "a,b\n"), "");
  EXPECT_EQ(ReadFile(path).text, "a,b\n");
  EXPECT_EQ(Mine(), "mine");
}

class ScratchFolders : public PlainFolders {
 protected:
  void SetUp() override {
    PlainFolders::SetUp();
    setenv("TMPDIR", (folder_ / "theirs").c_str(), 1);
  }
  void TearDown() override {
    unsetenv("TMPDIR");
    PlainFolders::TearDown();
  }
};

TEST_F(ScratchFolders, GoWithTheirOwnerOrWithTheNext) {
  fs::create_directories(folder_ / "theirs/trials-killed/T/record");
  fs::create_directories(folder_ / "theirs/other-killed");
  fs::create_directory_symlink(folder_ / "mine", folder_ / "theirs/trials-link");
  std::string path;
  {
    const ScratchFolder first("trials");
    path = first.path();
    EXPECT_TRUE(fs::is_directory(path));
    EXPECT_FALSE(fs::exists(folder_ / "theirs/trials-killed"));
    EXPECT_TRUE(fs::exists(folder_ / "theirs/other-killed"));
    const ScratchFolder second("trials");
    EXPECT_TRUE(fs::is_directory(path)) << "its owner lives";
    EXPECT_NE(second.path(), path);
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(Mine(), "mine");
}

}  // namespace shoal::plain_folder_test
