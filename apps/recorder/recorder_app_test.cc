#include "apps/recorder/recorder_app.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/bus/record/log_reader.h"

namespace shoal::recorder_app_test {

/// A recorder and a publisher, on one bus.
class RecorderTest : public ::testing::Test {
 protected:
  RecorderTest()
      : path_(::testing::TempDir() + "recorder_app_" +
              ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".lcm") {}
  ~RecorderTest() override { std::filesystem::remove(path_); }

  RecorderOptions Options() const { return {.path = path_, .start_utime = 1000}; }

  /// Ends the step that goes on, and has the recorder take part in the next.
  void Step(RecorderApp* recorder, int64_t utime) {
    hub_.NextStep();
    hub_.HandleAll();
    recorder->Tick(utime);
  }

  void Publish(const std::string& channel, const Bytes& data = {1}) {
    publisher_.PublishBytes(channel, data);
  }

  /// Returns the log's events as lines "number utime channel size".
  std::string Log() const {
    auto reader = LogReader::Open(path_);
    EXPECT_TRUE(reader.ok());
    std::string text;
    while (const auto event = reader->Next()) {
      text += std::to_string(event->number) + " " + std::to_string(event->utime) + " " +
              std::string(event->channel) + " " + std::to_string(event->data.size()) + "\n";
    }
    EXPECT_EQ(reader->error(), "");
    return text;
  }

  std::string path_;
  MemoryBus hub_;
  Bus& recorder_bus_ = hub_.Join("recorder");
  Bus& publisher_ = hub_.Join("publisher");
};

TEST_F(RecorderTest, StampsMessagesWithTheStepThatPublishedThem) {
  RecorderApp recorder(Options(), recorder_bus_);
  Publish("EARLY");
  Step(&recorder, 2000);
  Publish("B", {1, 2, 3});
  Publish("A", {});
  Step(&recorder, 3000);
  Step(&recorder, 4000);
  Publish("LAST");
  hub_.NextStep();
  hub_.HandleAll();
  recorder.End();
  EXPECT_EQ(recorder.error(), "");
  EXPECT_EQ(Log(), "0 1000 EARLY 1\n1 2000 A 0\n2 2000 B 3\n3 4000 LAST 1\n");
}

TEST_F(RecorderTest, HasEveryStepInTheFileWhenItsTickEnds) {
  RecorderApp recorder(Options(), recorder_bus_);
  Publish("A");
  Step(&recorder, 2000);
  EXPECT_EQ(Log(), "0 1000 A 1\n");
}

TEST_F(RecorderTest, LeavesOutWhatIsMadeForEyesAndForStepping) {
  RecorderApp recorder(Options(), recorder_bus_);
  for (const char* channel : {"APPCAST", "TICK", "STEP_DONE", "LCM_SELF_TEST", "MINE"})
    Publish(channel);
  Step(&recorder, 2000);
  EXPECT_EQ(Log(), "0 1000 MINE 1\n");
}

TEST_F(RecorderTest, LogsEverythingButLcmsSelfTestWhereAsked) {
  RecorderOptions options = Options();
  options.log_all = true;
  RecorderApp recorder(options, recorder_bus_);
  for (const char* channel : {"APPCAST", "LCM_SELF_TEST", "MINE"}) Publish(channel);
  Step(&recorder, 2000);
  EXPECT_EQ(Log(), "0 1000 APPCAST 1\n1 1000 MINE 1\n");
}

TEST_F(RecorderTest, LogsTheChannelsThatWereChosen) {
  RecorderOptions options = Options();
  options.channels = {.only = {"A*", "APPCAST"}, .without = {"AB"}};
  RecorderApp recorder(options, recorder_bus_);
  for (const char* channel : {"A", "AB", "AC", "APPCAST", "B"}) Publish(channel);
  Step(&recorder, 2000);
  EXPECT_EQ(Log(), "0 1000 A 1\n1 1000 AC 1\n");
}

TEST_F(RecorderTest, ShowsPathAndCountsPerChannel) {
  RecorderApp recorder(Options(), recorder_bus_);
  Publish("A");
  Publish("A");
  Publish("B");
  Step(&recorder, 2000);
  const StatusPage page = recorder.Status();
  EXPECT_TRUE(page.run_warnings.empty());
  EXPECT_NE(page.text.find(path_), std::string::npos);
  EXPECT_NE(page.text.find("Written:  3 events, 90 bytes\n"), std::string::npos) << page.text;
  EXPECT_NE(page.text.find("A                                         2            2\n"),
            std::string::npos)
      << page.text;
}

TEST_F(RecorderTest, ReportsWhyTheFileCannotBeMade) {
  RecorderOptions options = Options();
  options.path = path_ + "/no/such/folder.lcm";
  RecorderApp recorder(options, recorder_bus_);
  EXPECT_NE(recorder.error().find(options.path), std::string::npos);
  Publish("A");
  Step(&recorder, 2000);
  recorder.End();
  EXPECT_NE(recorder.Status().text.find("Dropped:  1 events"), std::string::npos);
}

TEST_F(RecorderTest, RemembersThatTheDiskIsFullAndCountsWhatIsDropped) {
  RecorderOptions options = Options();
  options.path = "/dev/full";
  RecorderApp recorder(options, recorder_bus_);
  EXPECT_EQ(recorder.error(), "");
  Publish("A");
  Step(&recorder, 2000);
  EXPECT_NE(recorder.error().find("/dev/full"), std::string::npos);
  Publish("A");
  Step(&recorder, 3000);
  recorder.End();
  const StatusPage page = recorder.Status();
  EXPECT_EQ(page.run_warnings.size(), 1U);
  EXPECT_NE(page.text.find("Written:  0 events, 0 bytes\nDropped:  2 events"), std::string::npos)
      << page.text;
}

}  // namespace shoal::recorder_app_test
