#include "lib/bus/os/replace_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lib/bus/os/cannot_write.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::replace_file_test {

namespace fs = std::filesystem;

TEST(ReplaceFile, TakesThePlaceOfTheOldOne) {
  const TestDirectory directory;
  const std::string path = directory.File("page.html");
  std::ofstream(path) << "old";
  EXPECT_EQ(ReplaceFile(path, "new"), "");
  EXPECT_EQ(TextOfFile(path), "new");
}

TEST(ReplaceFile, StatesWhyItCannotBeWrittenAndWhatToTry) {
  const TestDirectory directory;
  const std::string nowhere = directory.File("no/such/folder/page.html");
  EXPECT_EQ(ReplaceFile(nowhere, "new"),
            "cannot write " + nowhere + ": No such file or directory (make its folder first)");
  const std::string folder = directory.File("folder");
  fs::create_directory(folder);
  EXPECT_EQ(ReplaceFile(folder, "new"),
            "cannot write " + folder + ": Is a directory (it is a folder: name a file in it)");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory.File(".")), {}), 1)
      << "no part is left behind";
}

TEST(CannotWrite, HasARemedyForEachReason) {
  for (const int reason : {ENOSPC, EACCES, EROFS, ENOENT, EISDIR, EMFILE, EIO}) {
    const std::string text = CannotWrite("a.lcm", reason).message;
    EXPECT_TRUE(text.starts_with("cannot write a.lcm: ") && text.ends_with(")")) << text;
  }
}

}  // namespace shoal::replace_file_test
