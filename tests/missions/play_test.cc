// `shoal play`: a recording on LCM, with real processes.
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <map>
#include <sstream>
#include <thread>
#include <utility>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/bus/record/log_reader.h"
#include "lib/run/run/run_registry.h"
#include "tests/missions/shoal_process.h"

namespace shoal::play_test {

using Counts = std::map<std::string, int64_t>;

Counts CountsOf(const std::string& path) {
  Counts counts;
  auto reader = LogReader::Open(path);
  EXPECT_TRUE(reader.ok()) << reader.error();
  while (const auto event = reader->Next()) ++counts[std::string(event->channel)];
  return counts;
}

/// A log of two vessels for half a minute, and its playback.
class Play : public ::testing::Test {
 protected:
  Play() {
    EXPECT_EQ(RunShoal(folder_, {"sim", MissionFile("berta.toml"), "--log", log_}).exit_code, 0);
  }

  /// Returns the first port of the playback whose output it is.
  static int PortOf(const std::string& output) {
    constexpr std::string_view kBefore = "LCM ports ";
    const size_t at = output.find(kBefore);
    return at == std::string::npos ? 0 : std::stoi(output.substr(at + kBefore.size()));
  }

  const TestFolder folder_;
  const std::string log_ = (folder_ / "a.lcm.zst").string();
};

TEST_F(Play, GivesASubscriberEachMessageOfTheLogAndIsMarkedAsPlayback) {
  RunningProcess play(folder_,
                      {Program("shoal"), "play", log_, "--speed", "max", "--paused", "--quiet"});
  ASSERT_TRUE(play.WaitFor("LCM ports")) << play.Output();
  LcmBus bus(PortPlan(PortOf(play.Output()), Layout::kShared, {"alpha", "bravo"}));
  const Counts expected = CountsOf(log_);
  Counts counts;
  int64_t num_received = 0;
  for (const auto& [channel, count] : expected) {
    bus.SubscribeBytes(channel, [&](const Message& message) {
      EXPECT_EQ(message.publisher, "playback");
      ++counts[std::string(message.channel)];
      ++num_received;
    });
  }
  bus.Poll(0);
  const Finished status = RunShoal(folder_, {"status", "playback"});
  EXPECT_NE(status.output.find("PLAYBACK of " + log_), std::string::npos) << status.output;
  EXPECT_NE(RunShoal(folder_, {"url"}).output.find("udpm://"), std::string::npos);
  const Finished order = RunShoal(folder_, {"send", "alpha", "return"});
  EXPECT_EQ(order.exit_code, 2);
  EXPECT_NE(order.output.find("a recording takes no orders"), std::string::npos) << order.output;

  std::thread resuming([&] { RunShoal(folder_, {"send", "clock", "resume"}); });
  int64_t num_expected = 0;
  for (const auto& [channel, count] : expected) num_expected += count;
  EXPECT_TRUE(AwaitThat([&] {
    bus.Poll(10'000);
    return num_received >= num_expected;
  }));
  resuming.join();
  EXPECT_EQ(counts, expected);
  const Finished finished = play.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Played: " + std::to_string(num_expected) + " messages"),
            std::string::npos)
      << finished.output;
}

TEST_F(Play, IsMovedPausedAndEnded) {
  RunningProcess play(folder_, {Program("shoal"), "play", log_, "--from", "100", "--loop"});
  ASSERT_TRUE(play.WaitFor("PLAYBACK")) << play.Output();
  const Finished paused = RunShoal(folder_, {"send", "clock", "pause"});
  EXPECT_NE(paused.output.find("clock: paused at 1"), std::string::npos) << paused.output;
  const Finished moved = RunShoal(folder_, {"send", "clock", "seek", "300"});
  EXPECT_EQ(moved.exit_code, 0) << moved.output;
  const std::string page = AwaitStatus(folder_, "playback", {"300.0 s of 600.0 s"});
  EXPECT_NE(page.find("300.0 s of 600.0 s"), std::string::npos) << page;
  const Finished fast = RunShoal(folder_, {"send", "clock", "warp", "5"});
  EXPECT_EQ(fast.exit_code, 0) << fast.output;
  play.Signal(SIGINT);
  const Finished finished = play.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Played: "), std::string::npos) << finished.output;
  EXPECT_NE(RunShoal(folder_, {"status"}).exit_code, 0) << "it is registered no longer";
}

TEST_F(Play, RefusesWhatCannotBePlayed) {
  const Finished none = RunShoal(folder_, {"play", (folder_ / "none.lcm").string()});
  EXPECT_EQ(none.exit_code, 3) << none.output;
  WriteFile(folder_ / "text.lcm", "no log at all");
  const Finished text = RunShoal(folder_, {"play", (folder_ / "text.lcm").string()});
  EXPECT_EQ(text.exit_code, 3);
  EXPECT_NE(text.output.find("no event that can be played"), std::string::npos) << text.output;
  const Finished late = RunShoal(folder_, {"play", log_, "--from", "601"});
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_NE(late.output.find("has 600.0 s"), std::string::npos) << late.output;
  const Finished speed = RunShoal(folder_, {"play", log_, "--speed", "fast"});
  EXPECT_EQ(speed.exit_code, 2);
  EXPECT_NE(speed.output.find("neither a number"), std::string::npos) << speed.output;
  EXPECT_EQ(RunShoal(folder_, {"play", log_, "--answers", log_}).exit_code, 2);
  const auto refused = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"play", log_});
    const Finished finished = RunShoal(folder_, words);
    EXPECT_EQ(finished.exit_code, 2) << finished.output;
    return finished.output;
  };
  EXPECT_NE(refused({"--participant", "playback"}).find("the playback itself"), std::string::npos);
  EXPECT_NE(refused({"--participant", "my planner"}).find("'my planner' may hold only letters"),
            std::string::npos);
  EXPECT_NE(refused({"--participant", "one", "--participant", "ONE"}).find("'ONE' is there twice"),
            std::string::npos);
  EXPECT_NE(refused({"--channel", "NOPE"}).find("no channel matches 'NOPE'; there are: "),
            std::string::npos);
}

/// A program at a terminal of its own.
class AtTerminal {
 public:
  AtTerminal(const TestFolder& folder, std::vector<std::string> argv) {
    std::vector<char*> pointers;
    for (std::string& each : argv) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    const std::string run_dir = (folder / "run").string();
    pid_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (pid_ != 0) return;
    setenv("SHOAL_RUN_DIR", run_dir.c_str(), 1);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  ~AtTerminal() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
    close(terminal_);
  }
  AtTerminal(const AtTerminal&) = delete;
  AtTerminal& operator=(const AtTerminal&) = delete;

  void Press(std::string_view keys) const {
    EXPECT_EQ(write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  /// Waits until `text` is shown behind what was waited for before.
  bool Shows(const std::string& text) {
    return AwaitThat([&] {
      pollfd input = {.fd = terminal_, .events = POLLIN, .revents = 0};
      std::array<char, 4096> bytes;
      if (poll(&input, 1, 10) > 0) {
        const ssize_t size = read(terminal_, bytes.data(), bytes.size());
        if (size > 0) shown_.append(bytes.data(), static_cast<size_t>(size));
      }
      const size_t at = shown_.find(text);
      if (at == std::string::npos) return false;
      shown_.erase(0, at + text.size());
      return true;
    });
  }
  const std::string& shown() const { return shown_; }
  int ExitCode() {
    int status = 0;
    waitpid(std::exchange(pid_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  int terminal_ = -1;
  pid_t pid_ = -1;
  std::string shown_;
};

TEST_F(Play, ObeysTheKeysOfATerminal) {
  AtTerminal play(folder_, {Program("shoal"), "play", log_, "--from", "100", "--paused"});
  ASSERT_TRUE(play.Shows("paused")) << play.shown();
  play.Press("\033[A\033[C");  // A minute and ten seconds on.
  ASSERT_TRUE(play.Shows("   170.0 of 600.0 s  paused")) << play.shown();
  play.Press(" ");
  ASSERT_TRUE(play.Shows("speed 1")) << play.shown();
  play.Press(" ");
  ASSERT_TRUE(play.Shows("paused")) << play.shown();
  play.Press("\033[H");
  ASSERT_TRUE(play.Shows("     0.0 of 600.0 s  paused")) << play.shown();
  play.Press("+");
  play.Press(" ");
  ASSERT_TRUE(play.Shows("speed 2")) << play.shown();
  play.Press("0");
  ASSERT_TRUE(play.Shows("as fast as the receivers")) << play.shown();
  play.Press("q");
  ASSERT_TRUE(play.Shows("Played: ")) << play.shown();
  EXPECT_EQ(play.ExitCode(), 0);
}

/// A log that nothing lies beside.
TEST_F(Play, AParticipantIsAwaitedWithoutAMissionFile) {
  RunningProcess play(folder_, {Program("shoal"), "play", log_, "--participant", "planner"});
  ASSERT_TRUE(play.WaitFor("waits for planner")) << play.Output();
  EXPECT_NE(play.Output().find("SHOAL_PARTICIPANT=planner "), std::string::npos) << play.Output();
  EXPECT_EQ(play.Output().find("SHOAL_MISSION_FILE"), std::string::npos);
  play.Signal(SIGINT);
  EXPECT_EQ(play.Wait().exit_code, 0);
}

/// A planner beside the recording of a mission in which it took part decides the same again.
TEST(PlayBeside, APlannerItsAnswersGoToASecondLog) {
  const TestFolder folder;
  const std::string dir = (folder / "rec").string();
  ASSERT_EQ(
      RunShoal(folder, {"run", MissionFile("c_planner.toml"), "--warp", "max", "--record", dir})
          .exit_code,
      0);
  const std::string answers = (folder / "answers.lcm").string();
  RunningProcess play(folder, {Program("shoal"), "play", dir, "--speed", "max", "--participant",
                               "c_planner", "--answers", answers});
  ASSERT_TRUE(play.WaitFor("COMMAND\n")) << play.Output();
  // "SHOAL_PORT=... SHOAL_SECRET_FILE=... COMMAND"
  const std::string output = play.Output();
  const size_t begin = output.find("  SHOAL_PORT");
  std::istringstream words(output.substr(begin, output.find(" COMMAND") - begin));
  std::vector<std::string> command = {"/usr/bin/env"};
  for (std::string word; words >> word;) command.push_back(word);
  for (const char* each : {"alpha", "60,40", "120,0", "60,-40"}) command.emplace_back(each);
  command.insert(command.end() - 4, Program("c_planner"));
  RunningProcess planner(folder, command);
  const Finished finished = play.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output << planner.Output();
  const Finished own = RunShoal(
      folder, {"log", "copy", dir, (folder / "own.lcm").string(), "--channels", "ACTUATORS_ALPHA"});
  ASSERT_EQ(own.exit_code, 0) << own.output;
  const Finished diff = RunShoal(folder, {"log", "diff", (folder / "own.lcm").string(), answers});
  EXPECT_EQ(diff.exit_code, 0) << diff.output;
}

}  // namespace shoal::play_test
