#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_commands_testing.h"

namespace shoal::log_info_test {

using LogInfo_ = LogCommandsTest;

TEST_F(LogInfo_, IsKeptBesideTheLogAndShownAgain) {
  for (const char* name : {"a.lcm", "a.lcm.zst"}) {
    const std::string path = Log(name, {{12'300'000, "DESIRED_ALPHA", Desired(12'300'000, 90)},
                                        {12'400'000, "OWN", {1, 2, 3, 4, 5, 6, 7, 8, 9}},
                                        {12'400'000, "COMMS_FATES", Bytes(3)}});
    const LogInfoOptions options{.path = path, .least_indexed_bytes = 0};
    const std::string read = Info(options);
    EXPECT_NE(read.find("fingerprint 0x0102030405060708"), std::string::npos) << read;
    ASSERT_TRUE(std::filesystem::exists(path + ".idx"));
    EXPECT_EQ(Info(options), read);
    // What is shown is what is kept: with another number in it, and where that cannot be.
    Bytes index = FileBytes(path + ".idx");
    WriteBytes(path + ".idx", Bytes(index.begin(), index.end() - 1));
    EXPECT_EQ(Info(options), read) << "damaged";
    EXPECT_EQ(FileBytes(path + ".idx"), index) << "and rewritten";
    auto log = LogReader::Open(path);
    ASSERT_TRUE(log.ok());
    const std::string key(index.begin() + 44, index.begin() + 44 + index[40]);
    const auto kept = ReadIndexPart(*log, IndexPart::kInfo, key, 0);
    ASSERT_TRUE(kept);
    int num_shown = 0;
    for (size_t i = 0; i < kept->size(); i += 11) {
      auto other = *kept;
      other[i] ^= 0x41;
      KeepIndexPart(*log, IndexPart::kInfo, key, other, 0);
      if (Info(options) != read) ++num_shown;
      EXPECT_EQ(out_.str().find('\033'), std::string::npos);
    }
    EXPECT_GT(num_shown, 3) << "numbers and names that can be";
  }
}

TEST_F(LogInfo_, NamesTheLogAsItWasNamedThisTime) {
  const std::string path = Log("a.lcm", {{12'300'000, "OWN", {1}}, {12'400'000, "OWN", {1}}});
  Bytes bytes = FileBytes(path);
  bytes.resize(bytes.size() - 1);
  WriteBytes(path, bytes);
  const std::string moved = directory_.File("b.lcm");
  (void)Info({.path = path, .least_indexed_bytes = 0});
  EXPECT_NE(err_.str().find(path + ": byte "), std::string::npos) << err_.str();
  std::filesystem::rename(path, moved);
  std::filesystem::rename(path + ".idx", moved + ".idx");
  (void)Info({.path = moved, .least_indexed_bytes = 0});
  EXPECT_NE(err_.str().find(moved + ": byte "), std::string::npos) << err_.str();
}

TEST_F(LogInfo_, LeavesAFileThatIsNoIndex) {
  const std::string path = Log("a.lcm", {{12'300'000, "OWN", {1}}});
  for (const Bytes& bytes : {Bytes(100, 'x'), Bytes{'S', 'H', 'O', 'P'}}) {
    WriteBytes(path + ".idx", bytes);
    (void)Info({.path = path, .least_indexed_bytes = 0});
    EXPECT_EQ(FileBytes(path + ".idx"), bytes);
  }
  // What a disk without room, or power, left of one.
  WriteBytes(path + ".idx", {});
  (void)Info({.path = path, .least_indexed_bytes = 0});
  EXPECT_GT(FileBytes(path + ".idx").size(), 40U);
}

TEST_F(LogInfo_, PrintsSpanAndATableOfChannels) {
  std::vector<TestEvent> events;
  for (int i = 0; i <= 10; ++i) {
    events.push_back({i * 100'000, "DESIRED_ALPHA", Desired(i * 100'000, i)});
  }
  events.push_back({1'000'000, "MINE", {1, 2, 3, 4, 5, 6, 7, 8}});
  const std::string path = Log("a.lcm", events);
  const std::string bytes = std::to_string(std::filesystem::file_size(path));
  EXPECT_EQ(Info({.path = path}),
            path + ": 12 events, 2 channels, " + bytes + " bytes, 0.000 s to 1.000 s\n" + R"(
channel        type         events        Hz     first_s      last_s       bytes
DESIRED_ALPHA  desired_t        11    10.000       0.000       1.000         440
MINE           ?                 1         -       1.000       1.000           8
MINE: 1 events of unknown type, fingerprint 0x0102030405060708 (give its .lcm file)
)");
  EXPECT_EQ(exit_code_, kExitOk);
}

TEST_F(LogInfo_, ReportsUndecodableEventsAndATruncatedTail) {
  Bytes cut = Desired(0, 0);
  cut.pop_back();
  const std::string path = Log("a.lcm", {{0, "C", cut}, {0, "C", Desired(0, 1)}, {0, "D", {}}});
  Bytes bytes = FileBytes(path);
  bytes.pop_back();
  WriteBytes(path, bytes);
  const std::string text = Info({.path = path});
  EXPECT_NE(text.find("C: 1 events do not decode, the first in the event at byte 0: the message "
                      "ends too early\n"),
            std::string::npos)
      << text;
  EXPECT_NE(err_.str().find("the log ends inside an event (28 bytes skipped)"), std::string::npos)
      << err_.str();
  EXPECT_EQ(exit_code_, kExitEnvironment);
}

TEST_F(LogInfo_, CalculatesWithTimesAtTheEndsOfTheirRange) {
  const std::string path = Log("a.lcm", {{std::numeric_limits<int64_t>::min(), "A", {}},
                                         {std::numeric_limits<int64_t>::max(), "A", {}}});
  EXPECT_NE(Info({.path = path}).find("-9223372036854.775808 s to 9223372036854.775807 s"),
            std::string::npos);
}

}  // namespace shoal::log_info_test
