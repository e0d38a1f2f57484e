#include "apps/viewer/growing_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::growing_log_test {

/// A log of one vehicle, 3000 s of it.
class GrowingLogTest : public ::testing::Test {
 protected:
  GrowingLogTest() {
    std::vector<TestEvent> events;
    for (int64_t i = 0; i < 30'000; ++i) {
      nav_t nav{};
      nav.utime = i * 100'000;
      nav.x_m = static_cast<double>(i);
      events.push_back({nav.utime, "NAV_ALPHA", Encoded(nav)});
    }
    WriteLog(path_, events);
  }

  static nlohmann::json SetupOf(const GrowingLog& log) {
    return nlohmann::json::parse(log.source()->SetupJson(false));
  }

  TestDirectory directory_;
  const std::string path_ = directory_.File("a.lcm");
};

TEST_F(GrowingLogTest, ShowsAShortLogAsAWhole) {
  const auto log = GrowingLog::Open(path_, "", [] { return int64_t{0}; });
  ASSERT_TRUE(log.ok()) << log.error();
  const nlohmann::json setup = SetupOf(**log);
  EXPECT_FALSE(setup.contains("indexing"));
  EXPECT_NEAR(setup["end_s"].get<double>(), 2999.9, 0.01);
}

TEST_F(GrowingLogTest, ShowsTheBeginOfALongLogAtOnceAndThenAllOfIt) {
  int64_t now_us = 0;
  // Each look at the clock takes a third of the time that there is.
  const auto log = GrowingLog::Open(path_, "", [&] { return now_us += GrowingLog::kFirst_us / 3; });
  ASSERT_TRUE(log.ok()) << log.error();
  const auto part = (*log)->source();
  const nlohmann::json first = nlohmann::json::parse(part->SetupJson(false));
  ASSERT_TRUE(first.contains("indexing")) << first.dump();
  EXPECT_LT(first["end_s"].get<double>(), 2000);
  EXPECT_GT(first["end_s"].get<double>(), 0);
  EXPECT_NE(part->FrameJson(1).find("alpha"), std::string::npos);
  (*log)->AwaitAll();
  const nlohmann::json whole = SetupOf(**log);
  EXPECT_FALSE(whole.contains("indexing"));
  EXPECT_NE(whole["boot"], first["boot"]) << "so that pages start again";
  EXPECT_NEAR(whole["end_s"].get<double>(), 2999.9, 0.01);
}

TEST_F(GrowingLogTest, ShowsOnThePageWhyTheRestCannotBeRead) {
  int64_t now_us = 0;
  const auto log = GrowingLog::Open(path_, "", [&] {
    if (now_us > 0) std::filesystem::remove(path_);  // It is open then.
    return now_us += GrowingLog::kFirst_us / 3;
  });
  ASSERT_TRUE(log.ok()) << log.error();
  (*log)->AwaitAll();
  const nlohmann::json setup = SetupOf(**log);
  EXPECT_FALSE(setup.contains("indexing")) << "nothing is awaited any more";
  const std::string note = setup["notes"].at(0).get<std::string>();
  EXPECT_NE(note.find("only the log's begin is shown"), std::string::npos) << note;
  EXPECT_NE(note.find("cannot read"), std::string::npos) << note;
  EXPECT_NE((*log)->source()->FrameJson(1).find("alpha"), std::string::npos);
}

TEST_F(GrowingLogTest, EndsWhileItReads) {
  int64_t now_us = 0;
  auto log = GrowingLog::Open(path_, "", [&] { return now_us += GrowingLog::kFirst_us; });
  ASSERT_TRUE(log.ok()) << log.error();
  const auto part = (*log)->source();
  log->reset();
  EXPECT_NE(part->FrameJson(0), "") << "a page that still asks";
}

TEST_F(GrowingLogTest, ReportsALogThatCannotBeRead) {
  EXPECT_FALSE(GrowingLog::Open(path_ + ".none", "", [] { return int64_t{0}; }).ok());
}

}  // namespace shoal::growing_log_test
