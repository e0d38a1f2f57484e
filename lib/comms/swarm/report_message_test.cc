#include "lib/comms/swarm/report_message.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace shoal::report_message_test {

nlohmann::json Golden() {
  std::ifstream in(SHOAL_SOURCE_DIR "/tests/golden/munet/message_encodings.json");
  return nlohmann::json::parse(in);
}

std::vector<uint8_t> BytesOf(const std::string& hex) {
  std::vector<uint8_t> bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<uint8_t>(std::strtoul(hex.substr(i, 2).c_str(), nullptr, 16)));
  }
  return bytes;
}

Eigen::Vector3f VectorOf(const nlohmann::json& numbers) {
  return {numbers[0].get<float>(), numbers[1].get<float>(), numbers[2].get<float>()};
}

ReportMessage ReportOf(const nlohmann::json& decoded) {
  const std::vector<uint8_t> flag = BytesOf(decoded["type"]);
  ReportMessage report = {.group_id = BytesOf(decoded["group_id"])[0],
                          .reporter_id = decoded["reporter_id"],
                          .position_m = VectorOf(decoded["reporter_pos"]),
                          .velocity_mps = VectorOf(decoded["reporter_vel"]),
                          .time_stamp_s = decoded["time_stamp"]};
  for (size_t i = 0; i < flag.size(); ++i) report.flag[i] = static_cast<char>(flag[i]);
  return report;
}

TEST(ReportMessage, HasTheBytesOfMuNet) {
  int num_reports = 0;
  const nlohmann::json golden = Golden();
  for (const nlohmann::json& row : golden["valid"]) {
    if (row["kind"] != "RPRT") continue;
    ++num_reports;
    const std::vector<uint8_t> bytes = BytesOf(row["hex"]);
    const ReportMessage report = ReportOf(row["decoded"]);
    EXPECT_EQ(EncodeReport(report), bytes) << row["call"];
    EXPECT_EQ(DecodeReport(bytes), report) << row["call"];
  }
  EXPECT_GE(num_reports, 3);
}

TEST(ReportMessage, IsParsedAsMuNetParsesIt) {
  int num_reports = 0;
  const nlohmann::json golden = Golden();
  for (const nlohmann::json& row : golden["parser_edge_cases"]) {
    if (row["kind"] != "RPRT") continue;
    ++num_reports;
    EXPECT_EQ(DecodeReport(BytesOf(row["hex"])).has_value(), row["result"] == "ok") << row["note"];
  }
  EXPECT_GE(num_reports, 3);
}

RC_GTEST_PROP(ReportMessage, AnyBytesReadAreWrittenAgain, (std::vector<uint8_t> bytes)) {
  const std::optional<ReportMessage> report = DecodeReport(bytes);
  RC_ASSERT(report.has_value() == (bytes.size() >= kReportBytes));
  if (!report) return;
  bytes.resize(kReportBytes);
  RC_ASSERT(EncodeReport(*report) == bytes);
}

}  // namespace shoal::report_message_test
