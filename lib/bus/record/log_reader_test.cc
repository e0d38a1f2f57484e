#include "lib/bus/record/log_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/mman.h>

#include <lcm/lcm-cpp.hpp>

#include "lib/bus/record/log_testing.h"

namespace shoal::log_reader_test {

/// What a reader finds in a file: the channels of the events, "!" for each skipped damage, and the
/// error.
struct Reading {
  std::string channels;
  std::vector<LogDamage> damages;
  std::string error;
};

Reading ReadAll(const std::string& path, OnDamage on_damage) {
  Reading reading;
  auto reader = LogReader::Open(path, on_damage);
  if (!reader.ok()) {
    reading.error = reader.error();
    return reading;
  }
  while (const auto event = reader->Next()) reading.channels += event->channel;
  reading.damages = reader->damages();
  reading.error = reader->error();
  return reading;
}

/// A file that lives in memory: quick to rewrite a hundred times.
class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("log", MFD_CLOEXEC)) {}
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_.get()); }
  void Set(std::span<const uint8_t> bytes) {
    ASSERT_EQ(::ftruncate(file_.get(), 0), 0);
    ASSERT_EQ(::pwrite(file_.get(), bytes.data(), bytes.size(), 0),
              static_cast<ssize_t>(bytes.size()));
  }

 private:
  FileDescriptor file_;
};

/// Makes a log at `path`, and returns its bytes, whose events have these one-letter channels and
/// three bytes of data.
Bytes LogBytes(const std::string& path, const std::string& channels) {
  std::vector<TestEvent> events;
  for (const char c : channels) events.push_back({.utime = 1, .channel = {c}, .data = {1, 2, 3}});
  WriteLog(path, events);
  return FileBytes(path);
}
constexpr size_t kEventSize = kLogHeaderSize + 1 + 3;

TEST(LogReader, ReadsWhatLcmsOwnWriterWrites) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  {
    lcm::LogFile log(path, "w");
    uint8_t data[] = {4, 5, 6};
    lcm::LogEvent event{};
    event.timestamp = 1234567890123456;
    event.channel = "NAV_ALPHA";
    event.datalen = 3;
    event.data = data;
    ASSERT_EQ(log.writeEvent(&event), 0);
    event.channel = "B";
    ASSERT_EQ(log.writeEvent(&event), 0);
  }
  auto reader = LogReader::Open(path);
  ASSERT_TRUE(reader.ok()) << reader.error();
  auto event = reader->Next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->number, 0);
  EXPECT_EQ(event->utime, 1234567890123456);
  EXPECT_EQ(event->channel, "NAV_ALPHA");
  EXPECT_EQ(Bytes(event->data.begin(), event->data.end()), (Bytes{4, 5, 6}));
  event = reader->Next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->number, 1);
  EXPECT_EQ(event->channel, "B");
  EXPECT_FALSE(reader->Next());
  EXPECT_EQ(reader->error(), "");
}

TEST(LogReader, ReadsAnEmptyFileAsALogWithoutEvents) {
  const TestDirectory directory;
  WriteBytes(directory.File("a.lcm"), {});
  EXPECT_EQ(ReadAll(directory.File("a.lcm"), OnDamage::kStop).error, "");
}

TEST(LogReader, StatesWhyAFileCannotBeRead) {
  const TestDirectory directory;
  const std::string missing = directory.File("missing.lcm");
  EXPECT_EQ(ReadAll(missing, OnDamage::kStop).error,
            "cannot read " + missing + ": No such file or directory");
  EXPECT_EQ(ReadAll("/dev/null", OnDamage::kStop).error,
            "cannot read /dev/null: not a regular file");
}

TEST(LogReader, StatesThatAForeignFileIsNoLog) {
  const TestDirectory directory;
  const std::string path = directory.File("a.png");
  WriteBytes(path, {0x89, 'P', 'N', 'G', 1, 2, 3, 4, 5, 6, 7, 8, 9});
  EXPECT_EQ(ReadAll(path, OnDamage::kStop).error,
            path + ": byte 0: not an LCM event log: it does not begin with eda1da01");
}

TEST(LogReader, ReadsWholeEventsOfALogThatIsCutAnywhereAndStatesWhere) {
  MemoryFile file;
  const std::string path = file.path();
  const Bytes whole = LogBytes(file.path(), "abc");
  for (size_t size = 1; size < whole.size(); ++size) {
    file.Set(std::span(whole).first(size));
    const size_t num_whole = size / kEventSize;
    const size_t cut_at = num_whole * kEventSize;
    const std::string expected = std::string("abc").substr(0, num_whole);

    const Reading strict = ReadAll(path, OnDamage::kStop);
    EXPECT_EQ(strict.channels, expected) << size;
    const Reading lenient = ReadAll(path, OnDamage::kSkip);
    EXPECT_EQ(lenient.channels, expected) << size;
    EXPECT_EQ(lenient.error, "");
    if (size == cut_at) {
      EXPECT_EQ(strict.error, "") << size;
      EXPECT_TRUE(lenient.damages.empty()) << size;
    } else {
      EXPECT_EQ(strict.error,
                path + ": byte " + std::to_string(cut_at) + ": the log ends inside an event");
      ASSERT_EQ(lenient.damages.size(), 1U) << size;
      EXPECT_EQ(lenient.damages[0].begin, cut_at);
      EXPECT_EQ(lenient.damages[0].end, size);
    }
  }
}

TEST(LogReader, SkipsGarbageBetweenEvents) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  Bytes bytes = LogBytes(path, "abc");
  const Bytes garbage = {0xed, 0xa1, 0xda, 0x01, 7, 7, 0xed, 0xa1, 0xda};
  for (const size_t after : {2U, 1U, 0U}) {  // one before every event
    bytes.insert(bytes.begin() + static_cast<ptrdiff_t>(after * kEventSize), garbage.begin(),
                 garbage.end());
  }
  WriteBytes(path, bytes);
  const Reading lenient = ReadAll(path, OnDamage::kSkip);
  EXPECT_EQ(lenient.channels, "abc");
  ASSERT_EQ(lenient.damages.size(), 3U);
  EXPECT_EQ(lenient.damages[1].begin, garbage.size() + kEventSize);
  EXPECT_EQ(lenient.damages[1].end, 2 * garbage.size() + kEventSize);
  EXPECT_NE(ReadAll(path, OnDamage::kStop).error, "");
}

void SetDataLength(uint32_t length, size_t event_offset, Bytes* bytes) {
  for (size_t i = 0; i < 4; ++i) {
    (*bytes)[event_offset + 24 + i] = static_cast<uint8_t>(length >> (24 - 8 * i));
  }
}

TEST(LogReader, LosesOnlyTheEventWhoseLengthIsWrong) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  for (const uint32_t lie : {0xffffffffU, 0x7fffffffU, 1000U, 50U}) {
    Bytes bytes = LogBytes(path, "abcd");
    SetDataLength(lie, kEventSize, &bytes);
    WriteBytes(path, bytes);
    EXPECT_EQ(ReadAll(path, OnDamage::kSkip).channels, "acd") << lie;
  }
}

TEST(LogReader, TakesNoMemoryForAWrongLength) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  Bytes bytes = LogBytes(path, "ab");
  SetDataLength(0x7fffff00, 0, &bytes);
  WriteBytes(path, bytes);
  std::filesystem::resize_file(path, uint64_t{3} << 30);  // a hole; the length stays inside
  auto reader = LogReader::Open(path);
  EXPECT_FALSE(reader->Next());
  EXPECT_EQ(reader->error(), path + ": byte 0: an event's data has an impossible length");
}

TEST(LogReader, MakesReadersThatGoOnAtAnyEvent) {
  TestDirectory directory;
  WriteLog(directory.File("a.lcm"), {{.utime = 1, .channel = "A", .data = Bytes(100)},
                                     {.utime = 2, .channel = "B", .data = Bytes(5000)},
                                     {.utime = 3, .channel = "C", .data = Bytes(100)}});
  auto reader = LogReader::Open(directory.File("a.lcm"), OnDamage::kSkip);
  ASSERT_TRUE(reader.ok());
  reader->Next();
  const uint64_t second = reader->Next()->offset;
  LogReader another = reader->Another(/*buffer_size=*/0);
  std::filesystem::remove(directory.File("a.lcm"));
  another.Seek(second);
  const auto event = another.Next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->channel, "B");
  EXPECT_EQ(event->data.size(), 5000U);
  EXPECT_EQ(another.Next()->channel, "C");
  EXPECT_FALSE(another.Next());
  another.Seek(0);
  EXPECT_EQ(another.Next()->channel, "A");
  EXPECT_EQ(reader->Next()->channel, "C");
}

TEST(LogReader, ReadsEventsLargerThanItsBuffer) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  Bytes large((1 << 20) + 5, 5);
  WriteLog(path, {{1, "A", {}}, {2, "B", large}, {3, "C", {}}});
  for (const OnDamage on_damage : {OnDamage::kStop, OnDamage::kSkip}) {
    auto reader = LogReader::Open(path, on_damage);
    EXPECT_EQ(reader->Next()->channel, "A");
    EXPECT_TRUE(std::ranges::equal(reader->Next()->data, large));
    EXPECT_EQ(reader->Next()->channel, "C");
    EXPECT_FALSE(reader->Next());
  }
}

RC_GTEST_PROP(LogReader, EndsForAnyBytesAndReportsAllThatItSkips, ()) {
  MemoryFile file;
  Bytes bytes = LogBytes(file.path(), std::string(*rc::gen::inRange<size_t>(0, 6), 'x'));
  const auto num_damages = *rc::gen::inRange(0, 5);
  for (int i = 0; i < num_damages && !bytes.empty(); ++i) {
    const auto at = static_cast<ptrdiff_t>(*rc::gen::inRange<size_t>(0, bytes.size()));
    if (*rc::gen::arbitrary<bool>()) {
      bytes[static_cast<size_t>(at)] = *rc::gen::arbitrary<uint8_t>();
    } else {
      const auto inserted = *rc::gen::arbitrary<Bytes>();
      bytes.insert(bytes.begin() + at, inserted.begin(), inserted.end());
    }
  }
  file.Set(bytes);
  auto reader = LogReader::Open(file.path(), OnDamage::kSkip);
  RC_ASSERT(reader.ok());
  uint64_t total = 0;
  while (const auto event = reader->Next()) {
    total += kLogHeaderSize + event->channel.size() + event->data.size();
  }
  for (const LogDamage& damage : reader->damages()) total += damage.end - damage.begin;
  RC_ASSERT(total == bytes.size());
}

/// At any byte of its first frames a process may be killed.
TEST(BeginOfCompressedLog, NamesTheLossWhereverItIsCutAtItsBegin) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm.zst");
  WriteLog(path, {{1, "A", {1, 2, 3}}});
  const Bytes whole = FileBytes(path);
  // The list of frames alone can be missing in part: all events are there then.
  constexpr size_t kList_bytes = 8 + 9 + 2 * 8;
  for (size_t size = 0; size + kList_bytes <= whole.size(); ++size) {
    WriteBytes(path, Bytes(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size)));
    auto reader = LogReader::Open(path, OnDamage::kSkip);
    if (!reader.ok()) continue;  // Which is an error with the reason.
    while (reader->Next()) {
    }
    EXPECT_GT(reader->num_damages(), 0) << size << " bytes";
  }
}

}  // namespace shoal::log_reader_test
