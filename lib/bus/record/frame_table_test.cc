// Compressed logs: written, read, sought, cut and damaged.
#include "lib/bus/record/frame_table.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "lib/bus/record/log_reader.h"
#include "lib/bus/record/log_testing.h"
#include "lib/bus/record/log_writer.h"
#include "tests/fuzz/mutation.h"

namespace shoal::frame_table_test {

constexpr int64_t kNumEvents = 3000;

struct Event {
  int64_t utime;
  std::string channel;
  std::vector<uint8_t> data;

  bool operator==(const Event&) const = default;
};

/// 3000 events of a second each, of 0 to 4999 bytes that hardly repeat: six MB.
std::vector<Event> Events() {
  std::mt19937 generator(36);
  std::vector<Event> events;
  for (int64_t i = 0; i < kNumEvents; ++i) {
    std::vector<uint8_t> data(generator() % 5000);
    for (size_t k = 0; k < data.size(); k += 8) data[k] = static_cast<uint8_t>(generator());
    events.push_back({i * 1'000'000, "CHANNEL_" + std::to_string(i % 7), std::move(data)});
  }
  return events;
}

class CompressedLog : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return directory_.File(name); }

  void Write(const std::string& name, const std::vector<Event>& events) const {
    Result<LogWriter> writer = LogWriter::Create(Path(name));
    ASSERT_TRUE(writer.ok());
    for (const Event& event : events) {
      writer->Append(event.utime, event.channel, event.data);
      ASSERT_FALSE(writer->Flush());
    }
    ASSERT_FALSE(writer->Close());
    EXPECT_EQ(writer->counters().events, static_cast<int64_t>(events.size()));
  }

  std::string Bytes(const std::string& name) const { return TextOfFile(Path(name)); }
  void SetBytes(const std::string& name, const std::string& bytes) const {
    std::ofstream(Path(name), std::ios::binary) << bytes;
  }

  struct Read {
    std::vector<Event> events;
    std::string error;
    std::vector<LogDamage> damages;
  };
  Read ReadAll(const std::string& name, OnDamage on_damage = OnDamage::kStop) const {
    Result<LogReader> reader = LogReader::Open(Path(name), on_damage);
    if (!reader.ok()) return {.events = {}, .error = reader.error(), .damages = {}};
    Read read;
    while (const auto event = reader->Next()) {
      read.events.push_back(
          {event->utime, std::string(event->channel), {event->data.begin(), event->data.end()}});
    }
    read.error = reader->error();
    read.damages = reader->damages();
    return read;
  }

  TestDirectory directory_;
};

TEST_F(CompressedLog, HoldsTheEventsOfThePlainOneInSeveralFrames) {
  const std::vector<Event> events = Events();
  Write("a.lcm.zst", events);
  const Read read = ReadAll("a.lcm.zst");
  EXPECT_EQ(read.error, "");
  EXPECT_TRUE(read.events == events);
  Result<FileWindow> window = FileWindow::Open(Path("a.lcm.zst"));
  ASSERT_TRUE(window.ok());
  EXPECT_GT(window->size(), size_t{6} << 20);
  EXPECT_LT(Bytes("a.lcm.zst").size(), window->size() / 4);
}

TEST_F(CompressedLog, IsTheSameFileForTheSameEvents) {
  Write("a.lcm.zst", Events());
  Write("b.lcm.zst", Events());
  EXPECT_TRUE(Bytes("a.lcm.zst") == Bytes("b.lcm.zst"));
}

TEST_F(CompressedLog, IsDecompressedToThePlainOneByZstd) {
  if (std::system("zstd --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "no zstd: scripts/setup --with-tests installs it";
  }
  Write("a.lcm.zst", Events());
  Write("b.lcm", Events());
  ASSERT_EQ(std::system(("zstd -q -d " + Path("a.lcm.zst")).c_str()), 0);
  EXPECT_TRUE(Bytes("a.lcm") == Bytes("b.lcm"));
}

TEST_F(CompressedLog, MadeByZstdItselfIsReadWhereItsFramesAreSmall) {
  if (std::system("zstd --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "no zstd: scripts/setup --with-tests installs it";
  }
  Write("a.lcm", Events());
  ASSERT_EQ(std::system(("zstd -q < " + Path("a.lcm") + " > " + Path("b")).c_str()), 0);
  EXPECT_TRUE(ReadAll("b").events == Events()) << "without its size in the head";
  ASSERT_EQ(std::system(("zstd -q " + Path("a.lcm") + " -o " + Path("c")).c_str()), 0);
  EXPECT_TRUE(ReadAll("c").events == Events());
  ASSERT_EQ(std::system(("head -c 80000000 /dev/zero | zstd -q > " + Path("bomb")).c_str()), 0);
  EXPECT_EQ(ReadAll("bomb").error,
            "cannot read " + Path("bomb") +
                ": the frame that begins at byte 0 holds more than 64 MiB, which must fit into "
                "memory: make a log of it by `zstd -d`");
}

TEST_F(CompressedLog, IsSoughtToAnyEvent) {
  const std::vector<Event> events = Events();
  Write("a.lcm.zst", events);
  Result<LogReader> reader = LogReader::Open(Path("a.lcm.zst"));
  ASSERT_TRUE(reader.ok());
  std::vector<uint64_t> offsets;
  while (const auto event = reader->Next()) offsets.push_back(event->offset);
  ASSERT_EQ(offsets.size(), events.size());
  LogReader other = reader->Another(64);
  std::mt19937 generator(1);
  for (int i = 0; i < 50; ++i) {
    const size_t number = generator() % offsets.size();
    other.Seek(offsets[number]);
    const auto event = other.Next();
    ASSERT_TRUE(event);
    EXPECT_EQ(event->utime, events[number].utime);
    EXPECT_TRUE(std::ranges::equal(event->data, events[number].data));
  }
}

TEST_F(CompressedLog, CutAnywhereGivesTheEventsBeforeAndNamesWhatIsLost) {
  const std::vector<Event> events = Events();
  Write("a.lcm.zst", events);
  const std::string whole = Bytes("a.lcm.zst");
  std::mt19937 generator(50);
  size_t num_whole_frames = 0;
  for (int i = 0; i < 50; ++i) {
    SetBytes("b.lcm.zst", whole.substr(0, 1000 + generator() % (whole.size() - 1000)));
    const Read read = ReadAll("b.lcm.zst");
    ASSERT_LE(read.events.size(), events.size());
    EXPECT_TRUE(std::equal(read.events.begin(), read.events.end(), events.begin()));
    num_whole_frames += read.events.size();
    if (read.events.size() == events.size()) continue;  // The list of frames was cut.
    EXPECT_NE(read.error, "");
    const Read skipped = ReadAll("b.lcm.zst", OnDamage::kSkip);
    EXPECT_EQ(skipped.events.size(), read.events.size());
    EXPECT_EQ(skipped.error, "");
    EXPECT_FALSE(skipped.damages.empty());
  }
  EXPECT_GT(num_whole_frames, events.size() * 50 / 3) << "half of them on average";
}

TEST_F(CompressedLog, CutBetweenTwoEventsNamesTheLastOne) {
  Write("a.lcm.zst", Events());
  const std::string whole = Bytes("a.lcm.zst");
  // Behind the first frame: its events are whole, and four bytes of the next frame stand there.
  const FrameTable table = [&] {
    const FileDescriptor file(::open(Path("a.lcm.zst").c_str(), O_RDONLY | O_CLOEXEC));
    return *FrameTable::Read(file.get(), whole.size());
  }();
  ASSERT_GT(table.frames().size(), 2U);
  const uint64_t begin = table.frames()[1].file_begin;
  SetBytes("b.lcm.zst", whole.substr(0, begin + 4));
  const Read read = ReadAll("b.lcm.zst");
  const std::string expected =
      Path("b.lcm.zst") + ": byte " + std::to_string(table.frames()[1].begin) +
      ": the compressed file ends inside the frame that begins at its byte " +
      std::to_string(begin) + ": what came after event " + std::to_string(read.events.size() - 1) +
      ", at " + std::to_string(read.events.size() - 1) + ".000000 s, is lost";
  EXPECT_EQ(read.error, expected);
}

TEST_F(CompressedLog, CutBehindAFrameIsNotTakenForAWholeOne) {
  Write("a.lcm.zst", Events());
  const std::string whole = Bytes("a.lcm.zst");
  const FrameTable table = [&] {
    const FileDescriptor file(::open(Path("a.lcm.zst").c_str(), O_RDONLY | O_CLOEXEC));
    return *FrameTable::Read(file.get(), whole.size());
  }();
  ASSERT_GT(table.frames().size(), 2U);
  for (const size_t num_frames : {size_t{0}, size_t{1}, table.frames().size() - 1}) {
    SetBytes("b.lcm.zst", whole.substr(0, table.frames()[num_frames].file_begin));
    const Read read = ReadAll("b.lcm.zst");
    EXPECT_NE(read.error.find("ended before it closed the log: "), std::string::npos)
        << num_frames << " " << read.error;
    EXPECT_NE(read.error.find(num_frames == 0 ? "its events are lost" : "what came after event"),
              std::string::npos)
        << read.error;
  }
  // All frames, and a part of the list: nothing is lost.
  SetBytes("b.lcm.zst", whole.substr(0, whole.size() - 5));
  const Read read = ReadAll("b.lcm.zst");
  EXPECT_EQ(read.error, "");
  EXPECT_TRUE(read.events == Events());
}

TEST_F(CompressedLog, DamagedInOneFrameGivesTheOthers) {
  const std::vector<Event> events = Events();
  Write("a.lcm.zst", events);
  std::string bytes = Bytes("a.lcm.zst");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  SetBytes("b.lcm.zst", bytes);
  const Read stopped = ReadAll("b.lcm.zst");
  EXPECT_NE(stopped.error.find("of the compressed file is damaged"), std::string::npos)
      << stopped.error;
  const Read read = ReadAll("b.lcm.zst", OnDamage::kSkip);
  EXPECT_GT(read.events.size(), stopped.events.size());
  EXPECT_LT(read.events.size(), events.size());
  EXPECT_EQ(read.events.back(), events.back());
  ASSERT_EQ(read.damages.size(), 1U);
}

TEST_F(CompressedLog, MutatedFiveThousandTimesIsReadOrRefusedInLittleMemory) {
  std::vector<Event> events = Events();
  events.resize(8);
  Write("a.lcm.zst", events);
  const std::string whole = Bytes("a.lcm.zst");
  constexpr std::array<std::string_view, 4> kWords = {
      std::string_view("\x28\xB5\x2F\xFD", 4), std::string_view("\x5E\x2A\x4D\x18", 4),
      std::string_view("\xB1\xEA\x92\x8F", 4), std::string_view("\xFF\xFF\xFF\xFF", 4)};
  EXPECT_TRUE(LastsWithin(size_t{512} << 20, [&] {
    std::mt19937_64 generator(36);
    for (int i = 0; i < 5000; ++i) {
      SetBytes("b.lcm.zst", Mutated(whole, kWords, generator));
      const Read read = ReadAll("b.lcm.zst", OnDamage::kSkip);
      if (read.events.size() > events.size()) return false;
    }
    return true;
  }));
}

TEST_F(CompressedLog, OfNothingIsALogWithoutEvents) {
  Write("a.lcm.zst", {});
  const Read read = ReadAll("a.lcm.zst");
  EXPECT_EQ(read.error, "");
  EXPECT_TRUE(read.events.empty());
}

TEST_F(CompressedLog, CountsEachEventOnceWhereTheDiskIsFullInTheMiddle) {
  std::filesystem::create_symlink("/dev/full", Path("full.zst"));
  Result<LogWriter> writer = LogWriter::Create(Path("full.zst"));
  ASSERT_TRUE(writer.ok());
  for (const Event& event : Events()) {
    writer->Append(event.utime, event.channel, event.data);
    (void)writer->Flush();
  }
  EXPECT_TRUE(writer->Close());
  EXPECT_EQ(writer->counters().events, 0);
  EXPECT_EQ(writer->counters().bytes, 0);
  EXPECT_EQ(writer->counters().dropped, kNumEvents);
}

TEST_F(CompressedLog, OnAFullDiskStatesItAndCountsWhatIsDropped) {
  std::filesystem::create_symlink("/dev/full", Path("full.zst"));
  Result<LogWriter> compressed = LogWriter::Create(Path("full.zst"));
  ASSERT_TRUE(compressed.ok());
  for (const Event& event : Events()) compressed->Append(event.utime, event.channel, event.data);
  const std::optional<Error> error = compressed->Close();
  ASSERT_TRUE(error);
  EXPECT_NE(error->message.find("No space left on device"), std::string::npos) << error->message;
  EXPECT_EQ(compressed->counters().events, 0);
  EXPECT_EQ(compressed->counters().dropped, kNumEvents);
}

}  // namespace shoal::frame_table_test
