// The dialogue that Goby's Micro-Modem driver had with another modem, repeated with ours: startup,
// ping, LBL, mini packet, and data cycles with acknowledgements.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/sea/modem/two_modems.h"
#include "tests/golden/micromodem_lines.h"
#include "tests/golden/read_golden.h"

namespace shoal::micromodem_dialogue_test {

/// Gives the host's lines, each once the modem has written all that it wrote before in the
/// recording.
TEST(MicroModemDialogue, IsTheRecordedOneForAHostThatWaitsForItsAnswers) {
  const auto recording = ReadGoldenJson("netsim/micromodem_mm1.json");
  TwoModems modems({.transponder_travel_s = {0.1, 0.2}}, {});
  std::vector<std::string> expected[2];
  std::vector<std::string> lines[2];
  int num_host_lines = 0;
  for (const auto& row : recording["lines"]) {
    const int port = row["modem_port"].get<int>() == kRecordedPorts[0] ? 0 : 1;
    if (row["dir"] == "modem>host") {
      expected[port].push_back(ComparableLine(RecordedBody(row)));
      continue;
    }
    for (int wait = 0; wait < 3000; ++wait) {
      for (int i : {0, 1}) {
        for (const std::string& line : modems.Lines(i)) lines[i].push_back(ComparableLine(line));
      }
      if (lines[0].size() >= expected[0].size() && lines[1].size() >= expected[1].size()) break;
      modems.Run(0.01);
    }
    ASSERT_EQ(lines[0], expected[0]) << "before " << row["line"];
    ASSERT_EQ(lines[1], expected[1]) << "before " << row["line"];
    modems.Give(port, RecordedBody(row));
    ++num_host_lines;
  }
  modems.Run(30);
  for (int i : {0, 1}) {
    for (const std::string& line : modems.Lines(i)) lines[i].push_back(ComparableLine(line));
    EXPECT_EQ(lines[i], expected[i]) << kRecordedPorts[i];
    EXPECT_EQ(modems.modem(i).counts().sentences_refused, 0);
    EXPECT_EQ(modems.modem(i).counts().lines_dropped, 0);
  }
  EXPECT_GT(num_host_lines, 25);
}

}  // namespace shoal::micromodem_dialogue_test
