#include "lib/bus/record/log_writer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <lcm/lcm-cpp.hpp>

#include "lib/bus/record/log_reader.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::log_writer_test {

TEST(LogWriter, WritesTheBytesOfTheLcmEventLog) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  WriteLog(path, {{0x0102030405060708, "AB", {9, 8, 7}}, {-1, "C", {}}});
  const Bytes expected = {0xed, 0xa1, 0xda, 0x01,                          // magic
                          0,    0,    0,    0,    0,    0,    0,    0,     // event number
                          1,    2,    3,    4,    5,    6,    7,    8,     // time
                          0,    0,    0,    2,                             // channel length
                          0,    0,    0,    3,                             // data length
                          'A',  'B',  9,    8,    7,                       //
                          0xed, 0xa1, 0xda, 0x01,                          // magic
                          0,    0,    0,    0,    0,    0,    0,    1,     // event number
                          0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff,  // time
                          0,    0,    0,    1,                             // channel length
                          0,    0,    0,    0,                             // data length
                          'C'};
  EXPECT_EQ(FileBytes(path), expected);
}

TEST(LogWriter, IsReadByLcmsOwnReader) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  WriteLog(path, {{5, "NAV_ALPHA", {1, 2}}, {7, "NAV_BRAVO", {3}}});
  lcm::LogFile log(path, "r");
  const lcm::LogEvent* event = log.readNextEvent();
  ASSERT_NE(event, nullptr);
  EXPECT_EQ(event->eventnum, 0);
  EXPECT_EQ(event->timestamp, 5);
  EXPECT_EQ(event->channel, "NAV_ALPHA");
  ASSERT_EQ(event->datalen, 2);
  EXPECT_EQ(static_cast<const uint8_t*>(event->data)[1], 2);
  event = log.readNextEvent();
  ASSERT_NE(event, nullptr);
  EXPECT_EQ(event->eventnum, 1);
  EXPECT_EQ(event->channel, "NAV_BRAVO");
  EXPECT_EQ(log.readNextEvent(), nullptr);
}

TEST(LogWriter, GivesTheFileNothingBeforeFlush) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  auto writer = LogWriter::Create(path);
  ASSERT_TRUE(writer.ok());
  writer->Append(0, "A", {});
  EXPECT_EQ(std::filesystem::file_size(path), 0U);
  EXPECT_FALSE(writer->Flush());
  EXPECT_EQ(std::filesystem::file_size(path), 29U);
  EXPECT_EQ(writer->counters().bytes, 29);
}

TEST(LogWriter, NamesPathCauseAndRemedyWhereTheFileCannotBeMade) {
  const auto writer = LogWriter::Create("/no/such/folder/a.lcm");
  ASSERT_FALSE(writer.ok());
  EXPECT_EQ(writer.error(),
            "cannot write /no/such/folder/a.lcm: No such file or directory (make its folder "
            "first)");
}

TEST(LogWriter, NamesPathCauseAndRemedyWhereTheDiskIsFullAndDropsTheRest) {
  auto writer = LogWriter::Create("/dev/full");
  ASSERT_TRUE(writer.ok());
  writer->Append(0, "A", {});
  const auto error = writer->Flush();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->message,
            "cannot write /dev/full: No space left on device (free some space, or choose "
            "another folder)");
  writer->Append(0, "A", {});
  EXPECT_EQ(writer->Flush()->message, error->message);
  EXPECT_EQ(writer->counters().events, 0);
  EXPECT_EQ(writer->counters().bytes, 0);
  EXPECT_EQ(writer->counters().dropped, 2);
}

/// Lets no file grow beyond a size, as long as it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    signal_before_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_before_);
  }

 private:
  rlimit before_{};
  void (*signal_before_)(int) = nullptr;
};

TEST(LogWriter, LeavesOnlyWholeEventsWhereTheDiskTakesHalfOfAWrite) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  auto writer = LogWriter::Create(path);
  ASSERT_TRUE(writer.ok());
  writer->Append(0, "A", {});
  ASSERT_FALSE(writer->Flush());
  {
    const FileSizeLimit limit(29 + 40);
    writer->Append(1, "B", {});
    writer->Append(2, "C", {});
    EXPECT_TRUE(writer->Flush());
  }
  EXPECT_EQ(std::filesystem::file_size(path), 29U);
  EXPECT_EQ(writer->counters().events, 1);
  EXPECT_EQ(writer->counters().dropped, 2);
}

TEST(LogWriter, DropsAndCountsWhatTheFormatCannotHold) {
  const TestDirectory directory;
  const std::string path = directory.File("a.lcm");
  auto writer = LogWriter::Create(path);
  ASSERT_TRUE(writer.ok());
  writer->Append(0, "", {});
  writer->Append(0, std::string(1000, 'A'), {});
  writer->Append(0, std::string(999, 'A'), {});
  ASSERT_FALSE(writer->Close());
  EXPECT_EQ(writer->counters().dropped, 2);
  auto reader = LogReader::Open(path);
  EXPECT_EQ(reader->Next()->number, 0);
  EXPECT_FALSE(reader->Next());
}

}  // namespace shoal::log_writer_test
