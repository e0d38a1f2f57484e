#include "lib/bus/os/text_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "lib/bus/record/log_testing.h"

namespace shoal::text_file_test {

namespace fs = std::filesystem;

/// Appends 100,000 bytes of `letter`.
auto Many(char letter) {
  return [letter](std::string* text) { text->append(100'000, letter); };
}

TEST(TextFile, HoldsAllPiecesInTheirOrder) {
  const TestDirectory directory;
  TextFile file(directory.File("a.csv"), "head\n");
  std::string expected = "head\n";
  for (const char letter : {'a', 'b', 'c', 'd', 'e', 'f', 'g'}) {
    ASSERT_TRUE(file.Append(Many(letter)));
    Many(letter)(&expected);
  }
  EXPECT_TRUE(fs::exists(file.path())) << "pieces of 256 KiB are written at once";
  ASSERT_TRUE(file.Flush());
  EXPECT_TRUE(TextOfFile(file.path()) == expected);
}

TEST(TextFile, TakesThePlaceOfWhatBearsItsName) {
  const TestDirectory directory;
  const std::string victim = directory.File("victim");
  std::ofstream(victim) << "precious";
  std::ofstream(directory.File("file")) << "a longer text than the new one";
  fs::create_symlink("victim", directory.File("link"));
  fs::create_symlink("nothing", directory.File("dangling"));
  fs::create_hard_link(victim, directory.File("hard"));
  ASSERT_EQ(mkfifo(directory.File("pipe").c_str(), 0600), 0);
  const mode_t umask_before = umask(022);
  for (const char* name : {"file", "link", "dangling", "hard", "pipe", "none"}) {
    const std::string path = directory.File(name);
    EXPECT_TRUE(TextFile(path, "new").Flush()) << name;
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path))) << name;
    EXPECT_EQ(TextOfFile(path), "new") << name;
    EXPECT_EQ(static_cast<unsigned>(fs::status(path).permissions()), 0644U) << name;
  }
  umask(umask_before);
  EXPECT_EQ(TextOfFile(victim), "precious");
  EXPECT_FALSE(fs::exists(directory.File("nothing")));
}

TEST(TextFile, LeavesNothingElseInItsFolder) {
  const TestDirectory directory;
  EXPECT_TRUE(TextFile(directory.File("a"), "x").Flush());
  fs::create_directory(directory.File("b"));
  EXPECT_FALSE(TextFile(directory.File("b"), "x").Flush());
  EXPECT_EQ(errno, EISDIR);
  const fs::directory_iterator entries(directory.File(""));
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 2);
}

TEST(TextFile, DoesNotFollowALinkThatComesBetweenTwoPieces) {
  const TestDirectory directory;
  std::ofstream(directory.File("victim")) << "precious";
  TextFile file(directory.File("a"), "x");
  ASSERT_TRUE(file.Flush());
  fs::remove(file.path());
  fs::create_symlink("victim", file.path());
  ASSERT_TRUE(file.Append([](std::string* text) { *text += "y"; }));
  EXPECT_FALSE(file.Flush());
  EXPECT_EQ(errno, ELOOP);
  EXPECT_EQ(TextOfFile(directory.File("victim")), "precious");
}

TEST(TextFile, StaysFailedWithItsFirstReason) {
  const TestDirectory directory;
  TextFile file(directory.File("none/a"), "x");
  EXPECT_FALSE(file.Flush());
  fs::create_directory(directory.File("none"));
  errno = 0;
  EXPECT_FALSE(file.Append([](std::string* text) { *text += "y"; }));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_TRUE(fs::is_empty(directory.File("none")));
}

}  // namespace shoal::text_file_test
