#include "lib/run/command_line/own_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace shoal::own_files_test {

namespace fs = std::filesystem;

class OwnFilesTest : public ::testing::Test {
 protected:
  OwnFilesTest()
      : folder_(fs::temp_directory_path() / ("shoal_own_files." + std::to_string(getpid()))) {}
  ~OwnFilesTest() override { fs::remove_all(folder_); }

  std::string Make(const std::string& path) const {
    fs::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path) << "x";
    return (folder_ / path).string();
  }

  fs::path folder_;
};

TEST_F(OwnFilesTest, AreFoundInTheTreeOfABuild) {
  const std::string page = Make("docs/index.md");
  EXPECT_EQ(FindOwnFile("docs/index.md", (folder_ / "build/bin").string()), page);
}

TEST_F(OwnFilesTest, AreFoundWhereTheyAreInstalled) {
  const std::string page = Make("usr/share/doc/shoal/index.md");
  const std::string log = Make("usr/share/shoal/examples/recorded/mission.lcm");
  const std::string programs = (folder_ / "usr/lib/shoal/bin").string();
  EXPECT_EQ(FindOwnFile("docs/index.md", programs), page);
  EXPECT_EQ(FindOwnFile("examples/recorded/mission.lcm", programs), log);
}

TEST_F(OwnFilesTest, AreNothingWhereTheyAreMissing) {
  Make("docs/index.md");
  EXPECT_EQ(FindOwnFile("docs/other.md", (folder_ / "build/bin").string()), std::nullopt);
  EXPECT_EQ(FindOwnFile("docs/index.md", ""), std::nullopt);
}

}  // namespace shoal::own_files_test
