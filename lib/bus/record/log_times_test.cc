#include "lib/bus/record/log_times.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "lib/bus/record/log_testing.h"

namespace shoal::log_times_test {

constexpr int64_t kSecond_us = 1'000'000;

class LogTimesTest : public ::testing::Test {
 protected:
  /// Writes events at these seconds, of 100 bytes each.
  LogReader Write(const std::vector<int64_t>& times_s) {
    std::vector<TestEvent> events;
    for (const int64_t time_s : times_s) {
      events.push_back({time_s * kSecond_us, "A", Bytes(100)});
    }
    return Written(events);
  }

  LogReader Written(const std::vector<TestEvent>& events) {
    WriteLog(path_, events);
    auto reader = LogReader::Open(path_, OnDamage::kSkip);
    EXPECT_TRUE(reader.ok()) << reader.error();
    return std::move(*reader);
  }

  /// Of a log of any size.
  static LogTimes Times(const LogReader& log) { return TimesOf(log, {}, 0); }

  static std::vector<int64_t> Seconds(int64_t first, int64_t last) {
    std::vector<int64_t> seconds;
    for (int64_t i = first; i <= last; ++i) seconds.push_back(i);
    return seconds;
  }

  static void Append(const std::vector<int64_t>& more, std::vector<int64_t>* to) {
    to->insert(to->end(), more.begin(), more.end());
  }

  TestDirectory directory_;
  const std::string path_ = directory_.File("a.lcm");
};

TEST_F(LogTimesTest, HasSpanChannelsAndNoWarningOfAPlainLog) {
  const LogReader log = Write(Seconds(5, 104));
  const LogTimes times = Times(log);
  EXPECT_EQ(times.num_events, 100);
  EXPECT_EQ(times.zero_utime, 5 * kSecond_us);
  EXPECT_EQ(times.end_us, 99 * kSecond_us);
  EXPECT_EQ(times.channels, (std::set<std::string, std::less<>>{"A"}));
  EXPECT_TRUE(TimeWarnings(times, path_).empty());
}

TEST_F(LogTimesTest, NamesAStrayEventAndLeavesItOutOfTheSpan) {
  std::vector<int64_t> seconds = Seconds(0, 49);
  seconds.push_back(1'000'000'000);
  Append(Seconds(50, 99), &seconds);
  const LogTimes times = Times(Write(seconds));
  EXPECT_EQ(times.end_us, 99 * kSecond_us);
  ASSERT_TRUE(times.first_stray);
  EXPECT_EQ(times.first_stray->number, 50);
  const auto warnings = TimeWarnings(times, "a.lcm");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("event 50 (byte 6450) has the time 1000000000.000000 s"),
            std::string::npos)
      << warnings[0];
  EXPECT_NE(warnings[0].find("shoal log copy a.lcm part.lcm --from 0 --to 99"), std::string::npos);
}

TEST_F(LogTimesTest, NamesNoSpanToCopyOfAStrayEventWhereTheClockJumpsToo) {
  std::vector<int64_t> seconds = Seconds(5000, 5049);
  seconds.push_back(1'000'000'000);
  Append(Seconds(0, 99), &seconds);
  const LogTimes times = Times(Write(seconds));
  EXPECT_EQ(times.num_jumps, 1);
  const auto warnings = TimeWarnings(times, "a.lcm");
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].find("event 50"), std::string::npos) << warnings[0];
  EXPECT_EQ(warnings[0].find("--to"), std::string::npos) << warnings[0];
}

TEST_F(LogTimesTest, TakesTheExtremesOfANumberForStrays) {
  std::vector<TestEvent> events;
  for (int64_t i = 0; i < 40; ++i) events.push_back({i * kSecond_us, "A", {1}});
  events[20].utime = std::numeric_limits<int64_t>::max();
  events[30].utime = std::numeric_limits<int64_t>::min();
  events.back().utime = std::numeric_limits<int64_t>::max();
  const LogTimes times = Times(Written(events));
  EXPECT_EQ(times.end_us, 38 * kSecond_us);
  EXPECT_EQ(times.num_strays, 3);
}

TEST_F(LogTimesTest, CountsFromTheRightClockWhereTheFirstEventIsOf1970) {
  std::vector<int64_t> seconds = {0};
  Append(Seconds(1'600'000'000, 1'600'000'099), &seconds);
  const LogTimes times = Times(Write(seconds));
  EXPECT_NEAR(static_cast<double>(times.zero_utime), 1.6e15, 20e6);
  EXPECT_LE(times.end_us, 100 * kSecond_us);
  const auto warnings = TimeWarnings(times, path_);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("the clock jumps from 0.000000 s to 1600000000.000000 s at event 1"),
            std::string::npos)
      << warnings[0];
}

TEST_F(LogTimesTest, GoesOnWhereTheClockGoesBack) {
  std::vector<int64_t> seconds = Seconds(0, 99);
  Append(Seconds(0, 99), &seconds);
  const LogTimes times = Times(Write(seconds));
  EXPECT_NEAR(static_cast<double>(times.end_us), 184e6, 2e6) << "16 witnesses do not move the line";
  ASSERT_TRUE(times.first_jump);
  EXPECT_EQ(times.first_jump->number, 100);
  EXPECT_EQ(times.num_strays, 0);
}

TEST_F(LogTimesTest, NamesALongGap) {
  std::vector<int64_t> seconds = Seconds(0, 49);
  Append(Seconds(10'000, 10'049), &seconds);
  const LogTimes times = Times(Write(seconds));
  EXPECT_EQ(times.end_us, 10'049 * kSecond_us);
  const auto warnings = TimeWarnings(times, path_);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("nothing was recorded for 9951 s before event 50"), std::string::npos)
      << warnings[0];
}

TEST_F(LogTimesTest, ReadsAnIndexInsteadOfTheLogAndTheLogWhereItChanged) {
  for (const char* name : {"a.lcm", "a.lcm.zst"}) {
    const std::string path = directory_.File(name);
    WriteLog(path, {{0, "A", Bytes(100)}, {kSecond_us, "B", {}}});
    auto log = LogReader::Open(path);
    ASSERT_TRUE(log.ok());
    const LogTimes read = Times(*log);
    ASSERT_TRUE(std::filesystem::exists(path + ".idx"));
    // What is kept is what is returned: a sum is changed in it and its digest set right.
    const auto kept = ReadIndexPart(*log, IndexPart::kTimes, "1", 0);
    ASSERT_TRUE(kept);
    auto changed = *kept;
    changed[0] = 77;  // Of num_events.
    KeepIndexPart(*log, IndexPart::kTimes, "1", changed, 0);
    EXPECT_EQ(Times(*log).num_events, 77);
    EXPECT_EQ(Times(*log).channels, read.channels);
    // Another log of the same name and size.
    WriteLog(path, {{0, "A", Bytes(100)}, {kSecond_us, "C", {}}});
    auto other = LogReader::Open(path);
    ASSERT_TRUE(other.ok());
    const LogTimes times = Times(*other);
    EXPECT_EQ(times.num_events, 2);
    EXPECT_TRUE(times.channels.contains("C"));
    EXPECT_EQ(ReadIndexPart(*other, IndexPart::kTimes, "1", 0)->at(0), 2) << "it is rewritten";
  }
}

TEST_F(LogTimesTest, KeepsNoIndexOfASmallLog) {
  const LogReader log = Write({1});
  (void)TimesOf(log, {});
  EXPECT_FALSE(std::filesystem::exists(path_ + ".idx"));
}

/// Each byte of an index is damaged in turn, with digests that fit and that do not.
TEST_F(LogTimesTest, ReadsTheLogWhereTheIndexIsDamagedOrMadeToMislead) {
  const LogReader log = Write(Seconds(0, 9));
  (void)Times(log);
  const Bytes file = FileBytes(path_ + ".idx");
  for (size_t i = 0; i < file.size(); i += 41) {
    Bytes damaged = file;
    damaged[i] ^= 0xff;
    WriteBytes(path_ + ".idx", damaged);
    EXPECT_EQ(Times(log).num_events, 10) << i;
    damaged.resize(i);
    WriteBytes(path_ + ".idx", damaged);
    EXPECT_EQ(Times(log).end_us, 9 * kSecond_us) << i;
  }
  const auto kept = ReadIndexPart(log, IndexPart::kTimes, "1", 0);
  ASSERT_TRUE(kept);
  for (size_t i = 0; i < kept->size(); i += 13) {
    for (const int bits : {0xff, 0x01}) {
      auto bytes = *kept;
      bytes[i] = static_cast<uint8_t>(bytes[i] ^ bits);
      KeepIndexPart(log, IndexPart::kTimes, "1", bytes, 0);
      const LogTimes times = Times(log);
      ASSERT_FALSE(times.places.empty());
      EXPECT_LE(times.PlaceBefore(kSecond_us).offset, log.size());
      (void)TimeWarnings(times, path_);
    }
  }
}

}  // namespace shoal::log_times_test
