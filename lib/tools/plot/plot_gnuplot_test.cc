#include "lib/tools/plot/plot_gnuplot.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "lib/bus/record/log_testing.h"
#include "lib/run/command_line/find_program.h"

namespace shoal::plot_gnuplot_test {

class Gnuplot : public ::testing::Test {
 protected:
  std::string WriteProgram(const std::string& name, const std::string& text) {
    const std::string path = directory_.File(name);
    WriteBytes(path, Bytes(text.begin(), text.end()));
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }
  TestDirectory directory_;
};

TEST_F(Gnuplot, IsFoundInTheFirstFolderThatHasIt) {
  const std::string program = WriteProgram("gnuplot", "");
  EXPECT_EQ(FindExecutable("gnuplot", "/nowhere::" + directory_.File("")), program);
  EXPECT_EQ(FindExecutable("gnuplot", "/nowhere:"), "");
  EXPECT_EQ(FindExecutable("gnuplot", ""), "");
}

TEST_F(Gnuplot, IsNoFolderAndNothingThatCannotRun) {
  std::filesystem::create_directory(directory_.File("gnuplot"));
  EXPECT_EQ(FindExecutable("gnuplot", directory_.File("")), "");
  WriteBytes(directory_.File("plain"), {});
  EXPECT_EQ(FindExecutable("plain", directory_.File("")), "");
}

TEST_F(Gnuplot, IsGivenTheScriptInItsFolderAndNoSettings) {
  const std::string program = WriteProgram("fake", "#!/bin/sh\necho \"$1 $2\" > output\n");
  ASSERT_TRUE(RunGnuplot(program, directory_.File(""), "a.gp").ok());
  EXPECT_EQ(TextOfFile(directory_.File("output")), "-d a.gp\n");
}

TEST_F(Gnuplot, ReturnsItsOutputWhereItFails) {
  const std::string program = WriteProgram("fake", "#!/bin/sh\necho 'no such thing' >&2\nexit 4\n");
  const auto drawn = RunGnuplot(program, directory_.File(""), "a.gp");
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error(),
            program + " exited with code 4 drawing a.gp; its output:\nno such thing\n");
}

TEST_F(Gnuplot, MustBeAProgram) {
  EXPECT_FALSE(RunGnuplot(directory_.File("none"), directory_.File(""), "a.gp").ok());
  const std::string program = WriteProgram("fake", "#!/bin/sh\n");
  EXPECT_FALSE(RunGnuplot(program, directory_.File("no_folder"), "a.gp").ok());
}

}  // namespace shoal::plot_gnuplot_test
