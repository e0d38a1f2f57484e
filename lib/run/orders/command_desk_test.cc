#include "lib/run/orders/command_desk.h"

#include <gtest/gtest.h>

#include <memory>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/run/run/appcast.h"

namespace shoal::command_desk_test {

using Words = std::vector<std::string>;

constexpr int64_t kRound_us = 20'000;

/// A participant that answers requests for its page, and takes or refuses orders as the test sets
/// it.
struct FakeApp {
  std::string name;
  StatusLog log = {};
  int64_t step = 0;
  bool is_asked = false;
  bool is_mute = false;
};

/// A mission of two vehicles without processes: the test plays helms, simulator, broker and clock.
class Desk : public testing::Test {
 protected:
  Desk() {
    Subscribe(world_, channels::AppcastReq(), [this](const appcast_req_t& request) {
      ++num_requests_;
      for (FakeApp& app : apps_) {
        if (request.app == app.name || request.app == "all") app.is_asked = true;
      }
    });
    for (const char* name : {"alpha", "bravo"}) {
      Subscribe(world_, channels::HelmCommand(name),
                [this, name](const helm_command_t& command) { Note(name, command.command); });
      Subscribe(world_, channels::SimCommand(name),
                [this, name](const sim_command_t& command) { Note(name, command.command); });
    }
    Subscribe(world_, channels::Control(*FindControl("comms_range")),
              [this](const unc_control_t& control) {
                Note("comms_range", std::to_string(static_cast<int>(control.value)));
              });
    Subscribe(world_, channels::ClockCommand(),
              [this](const clock_command_t& command) { Note("clock", command.command); });
  }

  /// Lets the desk work, and all messages arrive, for some time of the wall.
  void Run(int64_t duration_us = 200'000) {
    for (const int64_t end = now_us_ + duration_us; now_us_ < end; now_us_ += kRound_us) {
      for (FakeApp& app : apps_) {
        if (app.is_asked && !app.is_mute) {
          StatusPage page;
          app.log.AppendTo(&page);
          Publish(world_, channels::Appcast(), ToAppcast(page, app.name, 0, app.step));
        }
        app.is_asked = false;
        ++app.step;
      }
      hub_.NextStep();
      hub_.HandleAll();
      desk_.OnTime(now_us_);
    }
  }

  int64_t Send(const std::string& target, const Words& words) {
    const Result<CommandRecord> record = desk_.Send(target, words, 1.5);
    EXPECT_TRUE(record.ok()) << (record.ok() ? "" : record.error());
    return record.ok() ? record->id : -1;
  }

  /// "taken", "refused: why", "sent".
  std::string StateOf(int64_t id) {
    for (const CommandRecord& record : desk_.records()) {
      if (record.id == id) {
        return record.state + (record.reason.empty() ? "" : ": " + record.reason);
      }
    }
    return "forgotten";
  }

  FakeApp& App(const std::string& name) {
    return *std::find_if(apps_.begin(), apps_.end(),
                         [&](const FakeApp& each) { return each.name == name; });
  }
  void Refuse(const std::string& app, const std::string& text) {
    App(app).log.Warn(text);
    App(app).log.Event(0, text);
  }
  void Take(const std::string& app, const std::string& text) { App(app).log.Event(0, text); }

  void PublishClockState(const std::string& word, int64_t num_commands,
                         const std::string& refusal = "") {
    clock_state_t state{};
    state.state = word;
    state.warp = 1;
    state.num_commands = num_commands;
    state.refusal = refusal;
    Publish(world_, channels::ClockState(), state);
    Run(kRound_us * 2);
  }

  void Note(const std::string& target, const std::string& what) {
    published_ += target + ":" + what + " ";
  }

  MemoryBus hub_;
  Bus& desk_bus_ = hub_.Join("desk");
  Bus& world_ = hub_.Join("world");
  CommandDesk desk_{desk_bus_, {.mission = "berta", .vehicles = {"alpha", "bravo"}}};
  std::vector<FakeApp> apps_ = {
      {"helm_alpha"}, {"helm_bravo"}, {"vehicle_sim_alpha"}, {"shore_broker"}};
  std::string published_;  ///< Orders that were published.
  int num_requests_ = 0;
  int64_t now_us_ = 1'000'000;
};

TEST_F(Desk, ReportsAnOrderThatWasTaken) {
  const Result<CommandRecord> record = desk_.Send("ALPHA", Words{"goto", "100", "-50"}, 12.5);
  ASSERT_TRUE(record.ok());
  EXPECT_EQ(record->text, "goto 100 -50 to alpha");
  EXPECT_EQ(record->state, "sent");
  EXPECT_EQ(record->t_s, 12.5);
  Run();
  EXPECT_EQ(published_, "alpha:goto ");
  EXPECT_EQ(StateOf(record->id), "sent");
  Take("helm_alpha", "command: goto");
  Run();
  EXPECT_EQ(StateOf(record->id), "taken");
}

TEST_F(Desk, ReportsWhichOfSeveralVehiclesRefusedAndWhy) {
  const int64_t id = Send("all", {"deploy"});
  Run();
  EXPECT_EQ(published_, "alpha:deploy bravo:deploy ");
  Take("helm_alpha", "command: deploy");
  Refuse("helm_bravo", "HELM_COMMAND refused: deploy: all-stop by command, send resume");
  Run();
  EXPECT_EQ(StateOf(id),
            "refused: bravo: deploy: all-stop by command, send resume; done all the same: alpha: "
            "deploy");
}

TEST_F(Desk, NamesNoVehicleWhereOnlyOneWasMeant) {
  const int64_t id = Send("bravo", {"speed", "-1"});
  Run();
  Refuse("helm_bravo", "HELM_COMMAND refused: speed needs a number");
  Run();
  EXPECT_EQ(StateOf(id), "refused: speed needs a number");
}

TEST_F(Desk, DoesNotMistakeOverlappingOrdersForOneAnother) {
  const int64_t bad = Send("alpha", {"speed", "-1"});
  const int64_t back = Send("alpha", {"return"});
  const int64_t good = Send("alpha", {"speed", "1"});
  Run();
  EXPECT_EQ(published_, "alpha:speed alpha:return alpha:speed ");
  Refuse("helm_alpha", "HELM_COMMAND refused: speed needs a number");
  Take("helm_alpha", "command: return");
  Run();
  EXPECT_EQ(StateOf(bad), "refused: speed needs a number");
  EXPECT_EQ(StateOf(back), "taken");
  EXPECT_EQ(StateOf(good), "sent");
  Take("helm_alpha", "command: speed");
  Run();
  EXPECT_EQ(StateOf(good), "taken");
}

TEST_F(Desk, FollowsRulesAndSimulators) {
  const int64_t rule = Send("comms_range", {"100"});
  const int64_t drift = Send("alpha", {"sim", "drift", "0.3", "0"});
  const int64_t reset = Send("alpha", {"sim", "reset", "1e9", "0", "0", "0"});
  Run();
  EXPECT_EQ(published_, "alpha:drift alpha:reset comms_range:100 ");  // In order of channels.
  Take("shore_broker", "UNC_COMMS_RANGE: 100 (was 250)");
  Take("vehicle_sim_alpha", "drift 0.3 0");
  Refuse("vehicle_sim_alpha", "SIM_COMMAND refused: 'reset' with 4 values; see sim_command_t");
  Run();
  EXPECT_EQ(StateOf(rule), "taken");
  EXPECT_EQ(StateOf(drift), "taken");
  EXPECT_EQ(StateOf(reset), "refused: 'reset' with 4 values; see sim_command_t");
  EXPECT_EQ(desk_.records()[1].text, "sim drift 0.3 0 to alpha");
}

TEST_F(Desk, FollowsTheClock) {
  PublishClockState("running", 0);
  const int64_t pause = Send("clock", {"pause"});
  const int64_t resume = Send("clock", {"resume"});
  Run();
  EXPECT_EQ(published_, "clock:pause clock:resume ");
  EXPECT_EQ(StateOf(pause), "sent");
  PublishClockState("paused", 1);
  EXPECT_EQ(StateOf(pause), "taken");
  EXPECT_EQ(StateOf(resume), "sent");
  PublishClockState("running", 2);
  EXPECT_EQ(StateOf(resume), "taken");
  const int64_t warp = Send("clock", {"warp", "max"});
  Run();
  PublishClockState("running", 3,
                    "warp refused: a mission with [netsim] keeps to the wall's clock");
  EXPECT_EQ(StateOf(warp), "refused: a mission with [netsim] keeps to the wall's clock");
}

TEST_F(Desk, WaitsPatientlyWhileTheMissionIsPaused) {
  PublishClockState("paused", 1);
  const int64_t id = Send("alpha", {"return"});
  const int num_requests = num_requests_;
  Run(60'000'000);
  EXPECT_EQ(published_, "alpha:return ");
  EXPECT_EQ(StateOf(id), "sent");
  EXPECT_LT(num_requests_ - num_requests, 70);
  PublishClockState("running", 2);
  Take("helm_alpha", "command: return");
  Run(1'200'000);
  EXPECT_EQ(StateOf(id), "taken");
}

TEST_F(Desk, ReportsAMissingAnswerAndStillAcceptsALateOne) {
  App("helm_bravo").is_mute = true;
  const int64_t id = Send("all", {"return"});
  Run();
  EXPECT_EQ(published_, "");  // It waits for bravo's page ...
  Run(400'000);
  EXPECT_EQ(published_, "alpha:return bravo:return ");  // ... but not for long.
  Run(4'000'000);
  EXPECT_EQ(StateOf(id), "sent");
  Run(1'000'000);
  EXPECT_EQ(StateOf(id), "sent: no answer yet from alpha, bravo");
  Take("helm_alpha", "command: return");
  Run(2'000'000);
  EXPECT_EQ(StateOf(id), "sent: no answer yet from bravo");
  const int64_t late = Send("alpha", {"all_stop"});
  Run(6'000'000);
  EXPECT_EQ(StateOf(late), "sent: no answer yet");
  Take("helm_alpha", "command: all_stop");
  Run(2'000'000);
  EXPECT_EQ(StateOf(late), "taken");
}

TEST_F(Desk, PublishesNothingThatItDoesNotUnderstand) {
  for (const auto& [target, words] :
       std::vector<std::pair<std::string, Words>>{{"alhpa", {"return"}},
                                                  {"alpha", {}},
                                                  {"alpha", {"fly"}},
                                                  {"alpha", {"goto", "nan", "0"}},
                                                  {"alpha", {"message", "bravo", "X", "1"}},
                                                  {"alpha", {"task", std::string(100'000, 'x')}},
                                                  {"alpha", {"task", "a\nb"}},
                                                  {"alpha", Words(1000, "1")},
                                                  {std::string(1'000'000, 'a'), {"return"}},
                                                  {"clock", {"warp", "0"}},
                                                  {"comms_range", {"far"}},
                                                  {"", {}}}) {
    const Result<CommandRecord> record = desk_.Send(target, words, 0);
    ASSERT_FALSE(record.ok()) << target.substr(0, 40);
    EXPECT_LT(record.error().size(), 5000U);
  }
  Run(1'000'000);
  EXPECT_EQ(published_, "");
  EXPECT_EQ(num_requests_, 0);
  EXPECT_TRUE(desk_.records().empty());
}

TEST_F(Desk, TakesNoFloodOfOrders) {
  int num_taken = 0;
  for (int i = 0; i < 1000; ++i) num_taken += desk_.Send("alpha", Words{"return"}, 0).ok() ? 1 : 0;
  EXPECT_EQ(num_taken, 100);
  Run();
  EXPECT_TRUE(desk_.Send("alpha", Words{"return"}, 0).ok());
}

TEST_F(Desk, RemembersTheLastTwentyOnly) {
  int64_t first = 0;
  for (int i = 0; i < 25; ++i) {
    const int64_t id = Send("alpha", {"return"});
    if (i == 0) first = id;
  }
  const auto records = desk_.records();
  ASSERT_EQ(records.size(), CommandDesk::kMaxRecords);
  EXPECT_EQ(records.back().id, first + 24);
  EXPECT_EQ(StateOf(first), "forgotten");
  Run();
  EXPECT_EQ(published_.size(), 25 * std::string("alpha:return ").size());  // But all were sent.
  for (int i = 0; i < 5; ++i) Take("helm_alpha", "command: return");
  Run();
  EXPECT_EQ(StateOf(records.front().id), "sent");
}

}  // namespace shoal::command_desk_test
