#include "apps/shoal_log/log_comms.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"
#include "lib/tools/analysis/swarm_testing.h"

namespace shoal::log_comms_test {

class LogCommsCommand : public ::testing::Test {
 protected:
  int Run() {
    out_.str("");
    err_.str("");
    return LogComms(options_, out_, err_);
  }

  static TestEvent Fates() {
    comms_fates_t fates{};
    fates.utime = 1'000'000;
    fate_t fate{};
    fate.kind = "packet";
    fate.source = "alpha";
    fate.destination = "bravo";
    fate.count = 1;
    for (const char* cause : {"delivered", "collision"}) {
      fate.cause = cause;
      fates.fates.push_back(fate);
      ++fates.num_fates;
    }
    return {.utime = fates.utime, .channel = "COMMS_FATES", .data = Encoded(fates)};
  }
  static TestEvent Swarm(int64_t utime, int64_t report_utime) {
    swarm_t swarm = SwarmAt(utime, "bravo", {ContactAt("alpha", report_utime)});
    AddSourceTo(&swarm, "alpha", 1, 0, 0);
    return {.utime = utime, .channel = "SWARM_BRAVO", .data = Encoded(swarm)};
  }

  TestDirectory directory_;
  LogCommsOptions options_{.path = directory_.File("mission.lcm")};
  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_F(LogCommsCommand, ShowsLinksMessagesAndAges) {
  WriteLog(options_.path, {Fates(), Swarm(2'000'000, 0), Swarm(3'000'000, 0)});
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_EQ(err_.str(), "");
  for (const char* part : {"Packets ", "alpha -> bravo", "collision 1", "bravo from alpha",
                           "bravo of alpha, its target"}) {
    EXPECT_NE(out_.str().find(part), std::string::npos) << part << "\n" << out_.str();
  }
}

TEST_F(LogCommsCommand, SumsUpWhatTheAcousticNetworkDid) {
  comms_fates_t fates{};
  fate_t fate{};
  fate.kind = "packet";
  fate.source = "alpha";
  fate.destination = "bravo";
  fate.count = fate.num_paths = 1;
  fate.cause = "damaged";
  fate.path.resize(1);
  fate.path[0].bits_flipped = 5;
  fates.fates.push_back(fate);
  fates.num_fates = 1;
  acoustic_tx_t packet{};
  packet.source = "alpha";
  const TestEvent sent = {.utime = 0, .channel = "ACOUSTIC_TX", .data = Encoded(packet)};
  WriteLog(options_.path,
           {sent, sent, {.utime = 1'000'000, .channel = "COMMS_FATES", .data = Encoded(fates)}});
  options_.csv_dir = directory_.File("csv");
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(out_.str().find("    bits flipped                      5\n"), std::string::npos)
      << out_.str();
  const std::string csv = TextOfFile(options_.csv_dir + "/acoustic.csv");
  EXPECT_NE(csv.find("damaged by bit errors,1\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("packets in transit,1\n"), std::string::npos) << csv;
}

TEST_F(LogCommsCommand, WritesTablesWithTheAgeOverTime) {
  WriteLog(options_.path, {Fates(), Swarm(2'000'000, 0), Swarm(3'000'000, 2'500'000)});
  options_.csv_dir = directory_.File("new/csv");
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_EQ(TextOfFile(options_.csv_dir + "/age_over_time.csv"),
            "time_s,vehicle,contact,is_target,age_s\n"
            "2.000000,bravo,alpha,1,2.000000\n"
            "3.000000,bravo,alpha,1,3.000000\n"
            "3.000000,bravo,alpha,1,0.500000\n");
  for (const char* name : {"links.csv", "losses.csv", "swarm_sources.csv", "swarm_events.csv",
                           "age.csv", "age_over_time.csv"}) {
    EXPECT_GT(TextOfFile(options_.csv_dir + "/" + name).size(), 20U) << name;
    EXPECT_NE(out_.str().find(options_.csv_dir + "/" + name + "\n"), std::string::npos) << name;
  }
}

TEST_F(LogCommsCommand, ReplacesLinksAndLeavesWhatTheyLeadTo) {
  WriteLog(options_.path, {Fates(), Swarm(2'000'000, 0), Swarm(3'000'000, 2'500'000)});
  options_.csv_dir = directory_.File("csv");
  std::filesystem::create_directory(options_.csv_dir);
  std::ofstream(directory_.File("victim")) << "precious";
  for (const char* name : {"/links.csv", "/age_over_time.csv"}) {
    std::filesystem::create_symlink("../victim", options_.csv_dir + name);
  }
  EXPECT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_EQ(TextOfFile(directory_.File("victim")), "precious");
  for (const char* name : {"/links.csv", "/age_over_time.csv"}) {
    EXPECT_FALSE(std::filesystem::is_symlink(options_.csv_dir + name)) << name;
    EXPECT_NE(TextOfFile(options_.csv_dir + name), "") << name;
  }
}

TEST_F(LogCommsCommand, LeavesOutWhatTheLogDoesNotHold) {
  WriteLog(options_.path, {Fates()});
  options_.csv_dir = directory_.File("csv");
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_EQ(out_.str().find("Age of information"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(options_.csv_dir + "/links.csv"));
  EXPECT_FALSE(std::filesystem::exists(options_.csv_dir + "/age.csv"));
}

TEST_F(LogCommsCommand, RefusesALogThatHoldsNothingOfTheKind) {
  WriteLog(options_.path, {{.utime = 0, .channel = "NAV_ALPHA", .data = Encoded(nav_t{})}});
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("holds neither COMMS_FATES nor SWARM_*"), std::string::npos);
}

TEST_F(LogCommsCommand, CountsWhatDoesNotDecode) {
  WriteLog(options_.path, {Fates(), {.utime = 0, .channel = "SWARM_BRAVO", .data = {1, 2, 3}}});
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(err_.str().find("1 messages do not decode"), std::string::npos) << err_.str();
}

TEST_F(LogCommsCommand, StatesWhatItCannotReadOrWrite) {
  EXPECT_EQ(Run(), kExitEnvironment);
  WriteLog(options_.path, {Fates()});
  options_.csv_dir = options_.path + "/csv";
  EXPECT_EQ(Run(), kExitEnvironment);
  EXPECT_NE(err_.str().find("cannot write " + options_.csv_dir), std::string::npos) << err_.str();
}

TEST_F(LogCommsCommand, EndsWithAnErrorWhereTheLogIsCutOff) {
  WriteLog(options_.path, {Fates(), Swarm(2'000'000, 0)});
  Bytes bytes = FileBytes(options_.path);
  bytes.resize(bytes.size() - 5);
  WriteBytes(options_.path, bytes);
  EXPECT_EQ(Run(), kExitEnvironment);
  EXPECT_NE(out_.str().find("alpha -> bravo"), std::string::npos) << "what can be read is shown";
}

}  // namespace shoal::log_comms_test
