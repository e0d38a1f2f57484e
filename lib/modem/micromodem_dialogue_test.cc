// The dialogue that Goby's Micro-Modem driver had with another modem, repeated with ours: startup,
// ping, LBL, mini packet, and data cycles with acknowledgements.
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "lib/modem/two_modems.h"
#include "tests/golden/read_golden.h"

namespace shoal::micromodem_dialogue_test {

constexpr int kPorts[] = {62000, 62001};

/// Returns a line without what a clock or an acoustic model decides. Of CACST there remain mode,
/// clock mode, rate, addresses, PSK error, packet type, frames and bad frames, and their places.
std::string Comparable(const std::string& line) {
  std::vector<std::string> fields = FieldsOf(line);
  static const std::regex clock(R"(\d{6}(\.\d{2,4})?)");
  static const std::regex number(R"(-?\d+(\.\d+)?)");
  std::string text;
  for (size_t i = 0; i < fields.size(); ++i) {
    const bool is_measured = fields[0] == "CACST" && ((i > 3 && i < 13) || i > 19);
    if (is_measured) {
      EXPECT_TRUE(std::regex_match(fields[i], number)) << line;
      fields[i] = "measured";
    } else if (std::regex_match(fields[i], clock)) {
      fields[i] = "clock";
    }
    text += (i == 0 ? "" : ",") + fields[i];
  }
  return text;
}

std::string BodyOf(const nlohmann::json& row) {
  const auto line = row["line"].get<std::string>();
  return line.substr(1, line.find('*') - 1);
}

/// Gives the host's lines, each once the modem has written all that it wrote before in the
/// recording.
TEST(MicroModemDialogue, IsTheRecordedOneForAHostThatWaitsForItsAnswers) {
  const auto recording = ReadGoldenJson("netsim/micromodem_mm1.json");
  TwoModems modems({.transponder_travel_s = {0.1, 0.2}}, {});
  std::vector<std::string> expected[2];
  std::vector<std::string> lines[2];
  int num_host_lines = 0;
  for (const auto& row : recording["lines"]) {
    const int port = row["modem_port"].get<int>() == kPorts[0] ? 0 : 1;
    if (row["dir"] == "modem>host") {
      expected[port].push_back(Comparable(BodyOf(row)));
      continue;
    }
    for (int wait = 0; wait < 3000; ++wait) {
      for (int i : {0, 1}) {
        for (const std::string& line : modems.Lines(i)) lines[i].push_back(Comparable(line));
      }
      if (lines[0].size() >= expected[0].size() && lines[1].size() >= expected[1].size()) break;
      modems.Run(0.01);
    }
    ASSERT_EQ(lines[0], expected[0]) << "before " << row["line"];
    ASSERT_EQ(lines[1], expected[1]) << "before " << row["line"];
    modems.Give(port, BodyOf(row));
    ++num_host_lines;
  }
  modems.Run(30);
  for (int i : {0, 1}) {
    for (const std::string& line : modems.Lines(i)) lines[i].push_back(Comparable(line));
    EXPECT_EQ(lines[i], expected[i]) << kPorts[i];
    EXPECT_EQ(modems.modem(i).counts().sentences_refused, 0);
    EXPECT_EQ(modems.modem(i).counts().lines_dropped, 0);
  }
  EXPECT_GT(num_host_lines, 25);
}

}  // namespace shoal::micromodem_dialogue_test
