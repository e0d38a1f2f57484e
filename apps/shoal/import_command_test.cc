#include "apps/shoal/import_command.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "lib/check/result.h"
#include "lib/mission/load.h"
#include "lib/record/test_log.h"
#include "shoal/node_report_t.hpp"

namespace shoal::import_command_test {

class Import : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text) {
    WriteBytes(directory_.File(name), Bytes(text.begin(), text.end()));
    return directory_.File(name);
  }

  static constexpr const char* kBlock = "ProcessConfig = uSimMarine\n{\n}\n";
  TestDirectory directory_;
};

TEST_F(Import, WritesAMissionThatLoads) {
  const std::string moos = Write("a.moos", "Community = abe\nProcessConfig = uSimMarine\n{\n}\n");
  const std::string toml = directory_.File("a.toml");
  EXPECT_EQ(RunImport({.files = {moos}, .out_path = toml}), kExitOk);
  const LoadedMission loaded = LoadMission(toml);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(loaded.mission.vehicles.at(0).name, "abe");
}

TEST_F(Import, LeavesAnExistingMissionAlone) {
  const std::string moos = Write("a.moos", kBlock);
  const std::string toml = Write("a.toml", "mine");
  EXPECT_EQ(RunImport({.files = {moos}, .out_path = toml}), kExitUsage);
  EXPECT_EQ(TextOfFile(toml), "mine");
}

TEST_F(Import, RefusesAFileThatItCannotRead) {
  EXPECT_EQ(RunImport({.files = {directory_.File("none.moos")}, .out_path = ""}), kExitUsage);
  EXPECT_EQ(RunImport({.files = {directory_.File("")}, .out_path = ""}), kExitUsage);
  const std::string moos = Write("a.moos", kBlock);
  EXPECT_EQ(RunImport({.files = {moos}, .out_path = "/dev/null/x"}), kExitEnvironment);
}

TEST_F(Import, RefusesWhatIsNoMoosMission) {
  const std::string toml = Write("a.toml", "[mission]\nduration_s = 5\n");
  const std::string binary = Write("b.moos", std::string("\x7F"
                                                         "ELF\0\1\2",
                                                         7));
  EXPECT_EQ(RunImport({.files = {toml}, .out_path = ""}), kExitUsage);
  EXPECT_EQ(RunImport({.files = {binary}, .out_path = ""}), kExitUsage);
}

TEST_F(Import, TakesTheExampleOfTheDocumentation) {
  const std::string folder = std::string(SHOAL_SOURCE_DIR) + "/examples/moos/";
  const std::string toml = directory_.File("mine.toml");
  ASSERT_EQ(RunImport({.files = {folder + "shoreside.moos", folder + "meta_abe.moos",
                                 folder + "meta_ben.moos"},
                       .out_path = toml}),
            kExitOk);
  const LoadedMission loaded = LoadMission(toml);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  ASSERT_EQ(loaded.mission.vehicles.size(), 2U);
  EXPECT_EQ(loaded.mission.vehicles[1].name, "ben");
  EXPECT_EQ(loaded.mission.vehicles[1].start.x_m, 40);
  EXPECT_EQ(loaded.mission.comms.comms_range_m, 250);
}

TEST(NodeReportsAsAlog, WritesALogOfNodeReports) {
  TestDirectory directory;
  node_report_t report{};
  report.name = "alpha";
  report.altitude_m = -1;
  WriteLog(directory.File("a.lcm"), {{500'000, "NODE_REPORT_LOCAL", Encoded(report)}});
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(LogCsv({.path = directory.File("a.lcm"),
                    .out_dir = directory.File("csv"),
                    .lines = NodeReportsAsAlog()},
                   out, err),
            kExitOk);
  EXPECT_NE(
      TextOfFile(directory.File("csv/NODE_REPORT_LOCAL.alog"))
          .find("\n0.5             NODE_REPORT_LOCAL    node_reporter        NAME=alpha,X=0,"),
      std::string::npos);
  EXPECT_NE(out.str().find("NODE_REPORT_LOCAL.alog: 1 lines"), std::string::npos);
}

}  // namespace shoal::import_command_test
