#include "lib/bus/os/files_below.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "lib/bus/os/read_file.h"

namespace shoal::files_below_test {

namespace fs = std::filesystem;

class FilesBelow : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "belowXXXXXX";
    folder_ = mkdtemp(pattern.data());
    fs::create_directories(folder_ / "mission/sea");
    for (const char* name : {"mission/sea/in.txt", "out.txt", "mission-of-others.txt"}) {
      std::ofstream(folder_ / name) << "text";
    }
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string Path(const char* name) const { return (folder_ / name).string(); }
  fs::path folder_;
};

TEST_F(FilesBelow, AreReadAndNoOthers) {
  const OnlyFilesBelow bounds(Path("mission"));
  EXPECT_EQ(ReadRegularFile(Path("mission/sea/in.txt")).text, "text");
  EXPECT_EQ(ReadRegularFile(Path("mission/sea/../sea/in.txt")).text, "text");
  for (const char* name : {"out.txt", "mission/../out.txt", "mission-of-others.txt", "none.txt"}) {
    for (const FileText& read : {ReadRegularFile(Path(name)), ReadFile(Path(name))}) {
      EXPECT_EQ(read.text, "") << name;
      EXPECT_EQ(read.problem, "lies outside of the folder that the mission came in") << name;
    }
    EXPECT_FALSE(OpenRegularFile(Path(name)).ok()) << name;
  }
}

TEST_F(FilesBelow, AreAllFilesAgainAfterwards) {
  {
    const OnlyFilesBelow bounds(Path("mission"));
    const OnlyFilesBelow inner(folder_.string());
    EXPECT_FALSE(MayReadFile(Path("out.txt"))) << "the outer one counts too";
  }
  EXPECT_EQ(ReadRegularFile(Path("out.txt")).text, "text");
}

}  // namespace shoal::files_below_test
