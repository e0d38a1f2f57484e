#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_commands_testing.h"

namespace shoal::log_csv_test {

using LogCsv_ = LogCommandsTest;

TEST_F(LogCsv_, WritesOneTablePerChannelWithARowPerElement) {
  comms_fates_t fates = FatesMessage(100'000, {"lost", "a \"b\", c"});
  acoustic_path_t path_taken{};
  path_taken.packet = 7;
  path_taken.sent_utime = 2'500'000;
  path_taken.air_s = 0.25;
  path_taken.num_named = 1;
  path_taken.colliders = {"alpha 12"};
  fates.fates[1].num_paths = 1;
  fates.fates[1].path = {path_taken};
  const std::string path = Log("a.lcm", {{100'000, "DESIRED_ALPHA", Desired(0, 90)},
                                         {100'000, "COMMS_FATES", Encoded(fates)},
                                         {200'000, "COMMS_FATES", Fates(200'000, {})}});
  const std::string dir = directory_.File("csv");
  EXPECT_EQ(Csv({.path = path, .out_dir = dir}),
            dir + "/COMMS_FATES.csv: 2 messages\n" + dir + "/DESIRED_ALPHA.csv: 1 messages\n");
  EXPECT_EQ(TextOfFile(dir + "/DESIRED_ALPHA.csv"),
            "time_s,utime_s,heading_deg,speed_mps,depth_m\n0.100,0.000,90,1.5,0\n");
  EXPECT_EQ(TextOfFile(dir + "/COMMS_FATES.csv"),
            "time_s,utime_s,num_fates,index,fates.kind,fates.source,fates.destination,"
            "fates.count,fates.number,fates.cause,fates.override_rule,fates.range_m,fates.limit_m,"
            "fates.age_s,fates.age_limit_s,fates.wait_s,fates.loss_pct,fates.length_bytes,"
            "fates.length_limit_bytes,fates.num_paths,fates.path.packet,fates.path.channel,"
            "fates.path.sent_utime_s,fates.path.num_bytes,fates.path.air_s,fates.path.travel_s,"
            "fates.path.jitter_s,fates.path.snr_db,fates.path.loss_probability,"
            "fates.path.bit_error_probability,fates.path.bits_flipped,fates.path.num_colliders,"
            "fates.path.own_packet,fates.path.num_named,fates.path.colliders\n"
            "0.100,0.100,2,0,report,alpha,bravo,0,0,lost,,12.5,0,0,0,0,0,0,0,0,,,,,,,,,,,,,,,\n"
            "0.100,0.100,2,1,report,alpha,bravo,0,0,\"a \"\"b\"\", c\",,12.5,0,0,0,0,0,0,0,1,"
            "7,0,2.500,0,0.25,0,0,0,0,0,0,0,0,1,\"[\"\"alpha 12\"\"]\"\n"
            "0.200,0.200,0,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,\n");
  EXPECT_EQ(err_.str(), "");
}

TEST_F(LogCsv_, KeepsFilesOfHostileChannelsInItsDirectory) {
  const std::string path = Log("a.lcm", {{0, "../x/y", Desired(0, 1)},
                                         {0, "___x_y", Desired(0, 2)},
                                         {0, "___x_y", Fates(0, {})},
                                         {0, "Z", {1}}});
  const std::string dir = directory_.File("csv");
  EXPECT_EQ(Csv({.path = path, .out_dir = dir}), dir + "/___x_y.comms_fates_t.csv: 1 messages\n" +
                                                     dir + "/___x_y.csv: 1 messages\n" + dir +
                                                     "/___x_y.desired_t.csv: 1 messages\n");
  EXPECT_NE(err_.str().find("Z: 1 messages left out"), std::string::npos);
}

TEST_F(LogCsv_, WritesLinesBesideTheTablesOfOneTypeWhereAskedTo) {
  const std::string path = Log("a.lcm", {{1, "D", Desired(0, 1)},
                                         {2, "D", Fates(0, {})},
                                         {3, "D", Desired(0, 2)},
                                         {4, "F", Fates(0, {})}});
  const std::string dir = directory_.File("csv");
  const auto append = [](int64_t event_utime, std::string_view channel,
                         std::span<const uint8_t> message, std::string* out) {
    *out += std::to_string(event_utime) + " " + std::string(channel) + " " +
            std::to_string(message.size()) + "\n";
  };
  const LogLines lines{
      .type = "desired_t", .extension = ".txt", .header = "%%\n", .append = append};
  EXPECT_EQ(Csv({.path = path, .out_dir = dir, .lines = lines}),
            dir + "/D.comms_fates_t.csv: 1 messages\n" + dir + "/D.csv: 2 messages\n" + dir +
                "/D.txt: 2 lines\n" + dir + "/F.csv: 1 messages\n");
  EXPECT_EQ(TextOfFile(dir + "/D.txt"), "%%\n1 D 40\n3 D 40\n");
}

TEST_F(LogCsv_, ReplacesLinksAndLeavesWhatTheyLeadTo) {
  const std::string path = Log("a.lcm", {{0, "A", Desired(0, 1)}, {0, "B", Desired(0, 2)}});
  const std::string dir = directory_.File("csv");
  const std::string victim = directory_.File("victim");
  std::filesystem::create_directory(dir);
  std::ofstream(victim) << "precious";
  std::filesystem::create_symlink("../victim", dir + "/A.csv");
  std::filesystem::create_hard_link(victim, dir + "/B.csv");
  Csv({.path = path, .out_dir = dir});
  EXPECT_EQ(exit_code_, kExitOk) << err_.str();
  EXPECT_EQ(TextOfFile(victim), "precious");
  for (const char* name : {"/A.csv", "/B.csv"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(dir + name)));
    EXPECT_TRUE(TextOfFile(dir + name).starts_with("time_s,")) << name;
  }
}

TEST_F(LogCsv_, StatesWhatItCannotWrite) {
  const std::string path = Log("a.lcm", {{0, "D", Desired(0, 1)}});
  Csv({.path = path, .out_dir = "/dev/null/x"});
  EXPECT_EQ(exit_code_, kExitEnvironment);
  EXPECT_NE(err_.str().find("cannot make /dev/null/x"), std::string::npos);
}

TEST_F(LogCsv_, HasAColumnForEachKeyOfTheUsersOwnFields) {
  const auto report = [](std::vector<key_value_t> extra) {
    node_report_t message{};
    message.extra = std::move(extra);
    message.num_extra = static_cast<int32_t>(message.extra.size());
    return Encoded(message);
  };
  const std::string path = Log(
      "a.lcm", {{0, "NODE_REPORT_LOCAL", report({{"fuel", "9"}})},
                {1, "NODE_REPORT_LOCAL", report({})},
                {2, "NODE_REPORT_LOCAL", report({{"a,b", "1"}, {"fuel", "8"}, {"fuel", "7"}})}});
  Csv({.path = path, .out_dir = directory_.File("csv")});
  std::istringstream table(TextOfFile(directory_.File("csv/NODE_REPORT_LOCAL.csv")));
  std::string header;
  std::getline(table, header);
  EXPECT_TRUE(
      header.ends_with(",num_extra,row_index,extra.key,extra.value,extra[fuel],"
                       "\"extra[a,b]\""))
      << header;
  std::string rest;
  for (std::string line; std::getline(table, line);) {
    std::vector<std::string> cells;
    std::string_view row = line;
    ASSERT_TRUE(TakeCsvRow(&row, &cells));
    for (size_t i = cells.size() - 5; i < cells.size(); ++i) rest += cells[i] + "|";
    rest += "\n";
  }
  EXPECT_EQ(rest,
            "0|fuel|9|9||\n"
            "|||||\n"
            "0|a,b|1|8|1|\n1|fuel|8|8|1|\n2|fuel|7|8|1|\n");
}

}  // namespace shoal::log_csv_test
