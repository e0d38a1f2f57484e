// Logs and messages for tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/record/log_writer.h"

namespace shoal {

/// A directory for one test, removed with this object.
class TestDirectory {
 public:
  TestDirectory() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = ::testing::TempDir() + "shoal_" + test->test_suite_name() + "_" + test->name();
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TestDirectory() { std::filesystem::remove_all(path_); }
  TestDirectory(const TestDirectory&) = delete;
  TestDirectory& operator=(const TestDirectory&) = delete;

  std::string File(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

inline Bytes FileBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline std::string TextOfFile(const std::string& path) {
  const Bytes bytes = FileBytes(path);
  return {bytes.begin(), bytes.end()};
}

inline void WriteBytes(const std::string& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

template <class T>
Bytes Encoded(const T& message) {
  Bytes bytes;
  EncodeInto(message, &bytes);
  return bytes;
}

/// One event to write.
struct TestEvent {
  int64_t utime = 0;
  std::string channel;
  Bytes data;
};

inline void WriteLog(const std::string& path, const std::vector<TestEvent>& events) {
  auto writer = LogWriter::Create(path);
  ASSERT_TRUE(writer.ok()) << writer.error();
  for (const TestEvent& event : events) writer->Append(event.utime, event.channel, event.data);
  const auto error = writer->Close();
  ASSERT_FALSE(error) << error->message;
}

}  // namespace shoal
