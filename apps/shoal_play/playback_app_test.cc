#include "apps/shoal_play/playback_app.h"

#include <gtest/gtest.h>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::playback_app_test {

class PlaybackAppTest : public ::testing::Test {
 protected:
  void Open(const std::vector<TestEvent>& events) {
    WriteLog(directory_.File("a.lcm"), events);
    auto log = PlaybackLog::Open(directory_.File("a.lcm"));
    ASSERT_TRUE(log.ok()) << log.error();
    log_.emplace(std::move(*log));
    listener_.SubscribeAll([this](const Message& message) {
      received_ += std::string(message.channel) + " " + std::to_string(message.data.size()) + "\n";
    });
  }

  /// Takes a step and returns what was published in it.
  std::string Step(PlaybackApp* app, int64_t utime) {
    received_.clear();
    hub_.NextStep();
    hub_.HandleAll();
    app->Tick(utime);
    hub_.NextStep();
    hub_.HandleAll();
    return received_;
  }

  TestDirectory directory_;
  std::optional<PlaybackLog> log_;
  MemoryBus hub_;
  Bus& bus_ = hub_.Join(kPlaybackName);
  Bus& listener_ = hub_.Join("listener");
  Bus& participant_ = hub_.Join("participant");
  std::string received_;
};

TEST_F(PlaybackAppTest, PublishesEachEventInItsStep) {
  Open({{0, "A", {1}}, {0, "B", {1, 2}}, {150'000, "A", {}}, {200'000, "C", {1, 2, 3}}});
  PlaybackApp app(&*log_, {}, 100'000, nullptr, bus_);
  EXPECT_EQ(Step(&app, 0), "A 1\nB 2\n");
  EXPECT_EQ(Step(&app, 100'000), "A 0\n");
  EXPECT_FALSE(app.is_at_end());
  EXPECT_EQ(Step(&app, 200'000), "C 3\n");
  EXPECT_TRUE(app.is_at_end());
  EXPECT_EQ(Step(&app, 300'000), "");
  EXPECT_EQ(app.counts().played, 4);
  EXPECT_EQ(app.counts().bytes, 6);
}

TEST_F(PlaybackAppTest, PublishesNothingOfTheSteppingOrOfLcm) {
  Open({{0, "TICK", {1}},
        {0, "STEP_DONE", {1}},
        {0, "CLOCK_COMMAND", {1}},
        {0, "CLOCK_STATE", {1}},
        {0, "APPCAST", {1}},
        {0, "LCM_SELF_TEST", {1}},
        {0, std::string(64, 'X'), {1}},
        {0, "A", {1}}});
  PlaybackApp app(&*log_, {}, 100'000, nullptr, bus_);
  EXPECT_EQ(Step(&app, 0), "A 1\n");
  EXPECT_EQ(app.counts().left_out, 7);
}

TEST_F(PlaybackAppTest, PublishesTheChosenChannels) {
  Open({{0, "NAV_A", {1}}, {0, "NAV_B", {1}}, {0, "C", {1}}});
  PlaybackApp app(&*log_, {.only = {"NAV_*"}, .without = {"NAV_B"}}, 100'000, nullptr, bus_);
  EXPECT_EQ(Step(&app, 0), "NAV_A 1\n");
  EXPECT_EQ(app.counts().not_chosen, 2);
}

TEST_F(PlaybackAppTest, TakesSealsOff) {
  Bytes sealed = {1, 2, 3};
  AppendSeal({.publisher = "helm", .mission_id = 7, .step = 1, .sequence = 0}, {}, "A", &sealed);
  Open({{0, "A", sealed}});
  PlaybackApp app(&*log_, {}, 100'000, nullptr, bus_);
  EXPECT_EQ(Step(&app, 0), "A 3\n");
}

TEST_F(PlaybackAppTest, WritesWhatOthersPublishAndNothingElse) {
  Open({{0, "A", {1}}, {100'000, "A", {1}}});
  auto answers = LogWriter::Create(directory_.File("b.lcm"));
  ASSERT_TRUE(answers.ok());
  PlaybackApp app(&*log_, {}, 100'000, &*answers, bus_);
  hub_.NextStep();
  hub_.HandleAll();
  app.Tick(0);
  participant_.PublishBytes("DESIRED_ALPHA", Bytes{9, 9});
  hub_.NextStep();
  hub_.HandleAll();
  app.Tick(100'000);
  ASSERT_FALSE(answers->Close());
  auto reader = LogReader::Open(directory_.File("b.lcm"));
  const auto event = reader->Next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->channel, "DESIRED_ALPHA");
  EXPECT_EQ(event->utime, 0);
  EXPECT_FALSE(reader->Next());
  EXPECT_EQ(app.counts().answers, 1);
}

TEST_F(PlaybackAppTest, AnswersThoseThatComeLateWithTheRules) {
  Open({{0, "COMMS_RULES", {1}}, {100'000, "COMMS_RULES", {1, 2}}});
  PlaybackApp app(&*log_, {}, 100'000, nullptr, bus_);
  const std::string request = channels::CommsRulesReq().name;
  Step(&app, 0);
  EXPECT_EQ(app.Answer(request, {})->data, Bytes{1});
  Step(&app, 100'000);
  EXPECT_EQ(app.Answer(request, {})->data, (Bytes{1, 2}));
  EXPECT_FALSE(app.Answer("APPCAST_REQ", {}));
}

TEST_F(PlaybackAppTest, BeginsWithWhatHoldsThereAfterAJump) {
  Open({{0, "COMMS_RULES", {1, 2}}, {0, "A", {1}}, {900'000, "A", {1, 2, 3}}});
  log_->SeekTo(900'000);
  PlaybackApp app(&*log_, {}, 100'000, nullptr, bus_);
  EXPECT_EQ(Step(&app, 900'000), "A 3\nCOMMS_RULES 2\n") << "in the order of a step";
  EXPECT_EQ(Step(&app, 1'000'000), "");
  EXPECT_EQ(app.counts().repeated, 1);
  EXPECT_EQ(app.counts().played, 1);
}

TEST_F(PlaybackAppTest, IsMarkedAsPlaybackOnItsPage) {
  Open({{0, "A", {1}}});
  PlaybackApp app(&*log_, {}, 100'000, nullptr, bus_);
  EXPECT_TRUE(app.Status().text.starts_with("PLAYBACK of " + log_->path())) << app.Status().text;
}

}  // namespace shoal::playback_app_test
