#include "lib/bus/os/file_bytes.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <string>

#include "lib/bus/os/file_descriptor.h"

namespace shoal::file_bytes_test {

class FileBytesTest : public testing::Test {
 protected:
  FileDescriptor file_{memfd_create("file_bytes_test", MFD_CLOEXEC)};

  void Rewind() const { ASSERT_EQ(lseek(file_.get(), 0, SEEK_SET), 0); }
};

TEST_F(FileBytesTest, ReadBackWhatWasWritten) {
  const std::string text(200'000, 'x');
  ASSERT_TRUE(WriteAll(file_.get(), text));
  Rewind();
  std::string read = "y";
  EXPECT_TRUE(ReadToEnd(file_.get(), 1'000'000, &read));
  EXPECT_EQ(read, "y" + text);
}

TEST_F(FileBytesTest, StopBehindTheMostThatIsWanted) {
  ASSERT_TRUE(WriteAll(file_.get(), std::string(1'000'000, 'x')));
  Rewind();
  std::string read;
  EXPECT_TRUE(ReadToEnd(file_.get(), 100'000, &read));
  EXPECT_GT(read.size(), 100'000U);
  EXPECT_LE(read.size(), 100'000U + 65'536U);
}

TEST_F(FileBytesTest, RefuseAFileThatEndsBeforeTheBufferIsFull) {
  ASSERT_TRUE(WriteAll(file_.get(), "abc"));
  std::array<char, 4> four{};
  Rewind();
  EXPECT_FALSE(ReadAll(file_.get(), four));
  Rewind();
  EXPECT_TRUE(ReadAll(file_.get(), std::span(four).first(3)));
  EXPECT_EQ(std::string(four.data(), 3), "abc");
}

TEST(FileBytes, NameTheReasonOfAFailure) {
  std::string text;
  EXPECT_FALSE(ReadToEnd(-1, 10, &text));
  EXPECT_EQ(errno, EBADF);
  EXPECT_FALSE(WriteAll(-1, "x"));
  EXPECT_EQ(errno, EBADF);
}

}  // namespace shoal::file_bytes_test
