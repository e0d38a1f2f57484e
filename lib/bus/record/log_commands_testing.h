// Logs for the tests of `shoal log`, and its commands run on them.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_testing.h"

namespace shoal {

/// Runs commands on logs in a directory, and keeps what they print.
class LogCommandsTest : public ::testing::Test {
 protected:
  static Bytes Desired(int64_t utime, double heading_deg) {
    desired_t desired{};
    desired.utime = utime;
    desired.heading_deg = heading_deg;
    desired.speed_mps = 1.5;
    return Encoded(desired);
  }

  static comms_fates_t FatesMessage(int64_t utime, const std::vector<std::string>& causes) {
    comms_fates_t fates{};
    fates.utime = utime;
    for (const std::string& cause : causes) {
      fate_t fate{};
      fate.kind = "report";
      fate.source = "alpha";
      fate.destination = "bravo";
      fate.cause = cause;
      fate.range_m = 12.5;
      fates.fates.push_back(fate);
    }
    fates.num_fates = static_cast<int32_t>(fates.fates.size());
    return fates;
  }

  static Bytes Fates(int64_t utime, const std::vector<std::string>& causes) {
    return Encoded(FatesMessage(utime, causes));
  }

  std::string Log(const std::string& name, const std::vector<TestEvent>& events) {
    WriteLog(directory_.File(name), events);
    return directory_.File(name);
  }

  std::string Cat(const LogCatOptions& options) {
    exit_code_ = LogCat(options, out_, err_);
    return Taken();
  }
  std::string Info(const LogInfoOptions& options) {
    exit_code_ = LogInfo(options, out_, err_);
    return Taken();
  }
  std::string Diff(const std::string& a, const std::string& b,
                   const std::vector<std::string>& without = {}) {
    exit_code_ = LogDiff({.path_a = a, .path_b = b, .without = without}, out_, err_);
    return Taken();
  }
  std::string Csv(const LogCsvOptions& options) {
    exit_code_ = LogCsv(options, out_, err_);
    return Taken();
  }

  TestDirectory directory_;
  int exit_code_ = -1;
  std::ostringstream out_;
  std::ostringstream err_;

 private:
  std::string Taken() {
    std::string text = out_.str();
    out_.str("");
    return text;
  }
};

}  // namespace shoal
