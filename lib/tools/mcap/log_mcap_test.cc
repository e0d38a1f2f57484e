#include "lib/tools/mcap/log_mcap.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <sstream>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"
#include "lib/tools/mcap/crc32.h"
#include "lib/tools/mcap/mcap_writer.h"

namespace shoal::log_mcap_test {

/// What a file holds, read from begin to end by its records' lengths.
struct McapContent {
  bool is_whole = false;                ///< Magic, records and magic fill the file.
  std::map<std::string, int> messages;  ///< By topic.
  std::vector<size_t> chunk_sizes;
  bool has_summary = false;
};

template <class T>
T NumberAt(std::string_view bytes, size_t at) {
  T value{};
  std::memcpy(&value, bytes.substr(at, sizeof value).data(), sizeof value);
  return value;
}

std::string_view TextAt(std::string_view bytes, size_t at) {
  return bytes.substr(at + 4, NumberAt<uint32_t>(bytes, at));
}

/// Reads records; returns where the first part that is none begins.
size_t ReadRecords(std::string_view bytes, std::map<uint16_t, std::string>* topics,
                   McapContent* content) {
  size_t at = 0;
  while (at + 9 <= bytes.size()) {
    const auto size = NumberAt<uint64_t>(bytes, at + 1);
    if (size > bytes.size() - at - 9) return at;
    const std::string_view body = bytes.substr(at + 9, size);
    const auto code = static_cast<uint8_t>(bytes[at]);
    if (code == 0x04) topics->emplace(NumberAt<uint16_t>(body, 0), TextAt(body, 4));
    if (code == 0x05) ++content->messages[topics->at(NumberAt<uint16_t>(body, 0))];
    if (code == 0x06) {
      const std::string_view records = body.substr(40);
      EXPECT_EQ(NumberAt<uint32_t>(body, 24), ExtendCrc32(0, records));
      EXPECT_EQ(ReadRecords(records, topics, content), records.size());
      content->chunk_sizes.push_back(records.size());
    }
    if (code == 0x0b) content->has_summary = true;
    at += 9 + size;
    if (code == 0x02) return at;
  }
  return at;
}

McapContent ReadMcap(const std::string& path) {
  const std::string file = TextOfFile(path);
  const std::string magic = "\x89MCAP0\r\n";
  McapContent content;
  std::map<uint16_t, std::string> topics;
  if (file.size() < 2 * magic.size() || !file.starts_with(magic)) return content;
  const std::string_view records = std::string_view(file).substr(8, file.size() - 16);
  content.is_whole =
      ReadRecords(records, &topics, &content) == records.size() && file.ends_with(magic);
  return content;
}

Bytes Nav(int64_t utime) {
  nav_t nav{};
  nav.utime = utime;
  nav.lat_deg = 43.8;
  nav.lon_deg = -70.3;
  return Encoded(nav);
}

Bytes Fates(int64_t utime, const std::vector<std::string>& causes) {
  comms_fates_t fates{};
  fates.utime = utime;
  for (const std::string& cause : causes) {
    fate_t fate{};
    fate.kind = "report";
    fate.source = "alpha";
    fate.destination = "bravo";
    fate.cause = cause;
    fates.fates.push_back(fate);
  }
  fates.num_fates = static_cast<int32_t>(fates.fates.size());
  return Encoded(fates);
}

Bytes Helm(const std::string& task, const std::string& all_stop) {
  helm_state_t helm{};
  helm.state = "DRIVE";
  helm.task = task;
  helm.all_stop = all_stop;
  return Encoded(helm);
}

class LogMcap_ : public ::testing::Test {
 protected:
  int Convert(const std::vector<TestEvent>& events, LogMcapOptions options = {}) {
    WriteLog(directory_.File("a.lcm"), events);
    return ConvertLog(std::move(options));
  }

  int ConvertLog(LogMcapOptions options = {}) {
    options.path = directory_.File("a.lcm");
    options.out_path = out_path_;
    out_.str("");
    err_.str("");
    return LogMcap(options, out_, err_);
  }

  TestDirectory directory_;
  std::string out_path_ = directory_.File("a.mcap");
  std::ostringstream out_;
  std::ostringstream err_;
};

std::vector<TestEvent> SomeEvents(int count) {
  std::vector<TestEvent> events;
  for (int i = 0; i < count; ++i) {
    events.push_back({i * 100'000, "NAV_ALPHA", Nav(i * 100'000)});
    events.push_back(
        {i * 100'000, "COMMS_FATES", Fates(i * 100'000, {"delivered", "out_of_range"})});
  }
  return events;
}

TEST_F(LogMcap_, HasEveryMessageOfTheLogAndWhatIsShownOfThem) {
  EXPECT_EQ(Convert(SomeEvents(5)), kExitOk) << err_.str();
  const McapContent content = ReadMcap(out_path_);
  EXPECT_TRUE(content.is_whole);
  EXPECT_TRUE(content.has_summary);
  EXPECT_EQ(content.messages, (std::map<std::string, int>{{"NAV_ALPHA", 5},
                                                          {"COMMS_FATES", 5},
                                                          {"foxglove/fates", 10},
                                                          {"foxglove/location/ALPHA", 5},
                                                          {"foxglove/pose/ALPHA", 5}}));
}

TEST_F(LogMcap_, HasTheLogAloneWhereThatIsAskedFor) {
  EXPECT_EQ(Convert(SomeEvents(5), {.selection = {.channels = {"NAV_*"}}, .only_log = true}),
            kExitOk);
  EXPECT_EQ(ReadMcap(out_path_).messages, (std::map<std::string, int>{{"NAV_ALPHA", 5}}));
}

TEST_F(LogMcap_, ShowsChangesOfHelmsOnce) {
  EXPECT_EQ(Convert({{0, "HELM_STATE_ALPHA", Helm("survey", "clear")},
                     {1, "HELM_STATE_ALPHA", Helm("survey", "clear")},
                     {2, "HELM_STATE_ALPHA", Helm("survey", "collision")},
                     {3, "HELM_STATE_ALPHA", Helm("survey", "collision")},
                     {4, "HELM_STATE_ALPHA", Helm("return", "clear")}}),
            kExitOk);
  EXPECT_EQ(ReadMcap(out_path_).messages["foxglove/events"], 3);
  EXPECT_NE(TextOfFile(out_path_).find("all-stop: collision"), std::string::npos);
}

TEST_F(LogMcap_, IsTheSameFileEachTime) {
  Convert(SomeEvents(500));
  const Bytes first = FileBytes(out_path_);
  EXPECT_EQ(ConvertLog(), kExitOk);
  EXPECT_EQ(FileBytes(out_path_), first);
}

TEST_F(LogMcap_, IsCutIntoChunksThatFitIntoMemory) {
  EXPECT_EQ(Convert(SomeEvents(20'000)), kExitOk);
  const McapContent content = ReadMcap(out_path_);
  EXPECT_TRUE(content.is_whole);
  EXPECT_GT(content.chunk_sizes.size(), 1u);
  for (const size_t size : content.chunk_sizes) EXPECT_LE(size, McapWriter::kChunkSize + 4096);
  EXPECT_EQ(content.messages.at("NAV_ALPHA"), 20'000);
}

TEST_F(LogMcap_, OfACutLogIsAWholeFileOfWhatCanBeRead) {
  WriteLog(directory_.File("a.lcm"), SomeEvents(5));
  Bytes bytes = FileBytes(directory_.File("a.lcm"));
  bytes.resize(bytes.size() - 10);
  WriteBytes(directory_.File("a.lcm"), bytes);
  EXPECT_EQ(ConvertLog(), kExitEnvironment);
  EXPECT_NE(err_.str().find("a.lcm"), std::string::npos) << err_.str();
  const McapContent content = ReadMcap(out_path_);
  EXPECT_TRUE(content.is_whole);
  EXPECT_EQ(content.messages.at("NAV_ALPHA"), 5);
  EXPECT_EQ(content.messages.at("COMMS_FATES"), 4);
}

TEST_F(LogMcap_, ReportsWhatItLeavesOut) {
  Bytes cut = Nav(0);
  cut.pop_back();
  EXPECT_EQ(Convert({{0, "NAV_ALPHA", cut},
                     {0, "X", {1, 2, 3}},
                     {-1, "NAV_ALPHA", Nav(-1)},
                     {INT64_MAX, "NAV_ALPHA", Nav(0)},
                     {1, "NAV_ALPHA", Nav(1)}}),
            kExitOk);
  EXPECT_EQ(ReadMcap(out_path_).messages["NAV_ALPHA"], 1);
  EXPECT_NE(err_.str().find("NAV_ALPHA: 2 messages left out: MCAP has no such time"),
            std::string::npos)
      << err_.str();
  EXPECT_NE(err_.str().find("X: 1 messages left out: unknown type"), std::string::npos);
}

TEST_F(LogMcap_, DoesNotWriteOverTheLog) {
  WriteLog(directory_.File("a.lcm"), SomeEvents(1));
  const Bytes log = FileBytes(directory_.File("a.lcm"));
  out_path_ = directory_.File("a.lcm");
  EXPECT_EQ(ConvertLog(), kExitUsage);
  EXPECT_EQ(FileBytes(directory_.File("a.lcm")), log);
}

TEST_F(LogMcap_, OfAFolderThatIsNotThereIsAnError) {
  out_path_ = directory_.File("none/a.mcap");
  EXPECT_EQ(Convert(SomeEvents(1)), kExitEnvironment);
  EXPECT_NE(err_.str().find("cannot write"), std::string::npos) << err_.str();
}

TEST_F(LogMcap_, OfAnEmptyLogIsAnEmptyFile) {
  EXPECT_EQ(Convert({}), kExitOk);
  EXPECT_TRUE(ReadMcap(out_path_).is_whole);
}

TEST_F(LogMcap_, OfAMutatedLogIsWholeOrAnError) {
  WriteLog(directory_.File("a.lcm"), SomeEvents(3));
  const Bytes log = FileBytes(directory_.File("a.lcm"));
  uint64_t state = 88172645463325252u;  // xorshift64, Marsaglia 2003
  const auto draw = [&](size_t below) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<size_t>(state % below);
  };
  for (int i = 0; i < 300; ++i) {
    Bytes mutated = log;
    for (size_t k = draw(4) + 1; k > 0; --k) {
      mutated[draw(mutated.size())] = static_cast<uint8_t>(draw(256));
    }
    if (draw(4) == 0) mutated.resize(draw(mutated.size()));
    WriteBytes(directory_.File("a.lcm"), mutated);
    std::filesystem::remove(out_path_);
    const int code = ConvertLog({.skip_damage = draw(2) == 0});
    if (std::filesystem::exists(out_path_)) {
      EXPECT_TRUE(ReadMcap(out_path_).is_whole) << i;
    } else {
      EXPECT_EQ(code, kExitEnvironment) << i;
    }
    EXPECT_TRUE(code == kExitOk || !err_.str().empty()) << i;
  }
}

TEST(Crc32, IsThatOfThePublishedCheck) {
  EXPECT_EQ(ExtendCrc32(0, "123456789"), 0xcbf43926u);
  EXPECT_EQ(ExtendCrc32(ExtendCrc32(0, "1234"), "56789"), 0xcbf43926u);
  EXPECT_EQ(ExtendCrc32(0, ""), 0u);
}

}  // namespace shoal::log_mcap_test
