#include "lib/run/command_line/find_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lib/bus/record/log_testing.h"

namespace shoal::find_program_test {

/// Tests lie in <build folder>/tests, and programs of shoal in <build folder>/bin.
class FindProgram_ : public ::testing::Test {
 protected:
  std::string Executable(const std::string& name) {
    std::ofstream(directory_.File(name)) << "#!/bin/sh\n";
    std::filesystem::permissions(directory_.File(name), std::filesystem::perms::owner_all);
    return directory_.File(name);
  }

  TestDirectory directory_;
};

TEST_F(FindProgram_, StatesTheCommandThatBuildsAProgramOfShoal) {
  const auto found = FindProgram("acoustic_ping", "");
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().find("the program acoustic_ping is not built: cmake --build "),
            std::string::npos)
      << found.error();
  EXPECT_TRUE(found.error().ends_with(" --target acoustic_ping")) << found.error();
}

TEST_F(FindProgram_, NamesTheTargetOfAProgramWithAnotherName) {
  EXPECT_TRUE(WhyMissing("shoal-viewer").ends_with(" --target viewer"));
  EXPECT_TRUE(WhyMissing("shoal-campaign").ends_with(" --target shoal_campaign"));
}

TEST_F(FindProgram_, StatesWhereItLookedForAnotherProgram) {
  const auto found = FindProgram("./no_such_program", "");
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().find("cannot find the program './no_such_program'; looked for /"),
            std::string::npos)
      << found.error();
}

TEST_F(FindProgram_, FindsAProgramBesideTheMissionFile) {
  const std::string program = Executable("planner");
  const auto found = FindProgram("./planner", directory_.File("mission.toml"));
  ASSERT_TRUE(found.ok()) << found.error();
  EXPECT_TRUE(std::filesystem::equivalent(*found, program));
}

TEST_F(FindProgram_, BesideShoalDoesNotSearchThePath) {
  EXPECT_TRUE(FindProgram("sh", "").ok()) << "by the PATH";
  EXPECT_FALSE(FindBeside("sh").ok());
}

}  // namespace shoal::find_program_test
