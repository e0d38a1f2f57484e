// shoal-viewer itself, beside missions that `shoal run` runs.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_transport.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/run_registry.h"
#include "tests/missions/fair_stopwatch.h"
#include "tests/missions/shoal_process.h"
#include "tests/netsim/tcp_client.h"

namespace shoal::viewer_process_test {

using Json = nlohmann::json;

/// A viewer, its address, and a page that watches its stream.
class WatchedViewer {
 public:
  explicit WatchedViewer(const TestFolder& folder, const std::vector<std::string>& more = {})
      : process_(folder, Argv(more)) {
    constexpr const char* kBegin = "viewer: http://127.0.0.1:";
    EXPECT_TRUE(process_.WaitFor("/")) << process_.Output();
    EXPECT_TRUE(process_.Output().starts_with(kBegin)) << process_.Output();
    port_ = std::atoi(process_.Output().c_str() + std::string(kBegin).size());
    const size_t token = process_.Output().find("?token=");
    if (token != std::string::npos) token_ = process_.Output().substr(token + 7, 32);
  }

  RunningProcess& process() { return process_; }
  const std::string& token() const { return token_; }

  /// The newest frame that the stream has brought; opens it, again where it has ended.
  const Json& Frame() {
    if (!stream_ || stream_->has_ended()) {
      stream_ = std::make_unique<TcpClient>(port_);
      stream_->Send("GET /api/stream HTTP/1.1\r\nHost: localhost\r\n\r\n");
    }
    stream_->Receive();
    const std::string& text = stream_->received();
    const size_t end = text.rfind("\n\n");
    const size_t begin = text.rfind("data: ", end);
    if (end != std::string::npos && begin != std::string::npos) {
      const Json frame = Json::parse(text.substr(begin + 6, end - begin - 6), nullptr, false);
      if (frame.is_object()) frame_ = frame;
    }
    return frame_;
  }

  std::string State() {
    const Json& frame = Frame();
    return frame.is_object() ? frame["clock"]["state"].get<std::string>() : "";
  }

  /// The whole answer to a request.
  std::string Ask(const std::string& method, const std::string& path,
                  const std::string& headers = "", const std::string& body = "") const {
    TcpClient client(port_);
    client.Send(method + " " + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" +
                "Content-Length: " + std::to_string(body.size()) + "\r\n" + headers + "\r\n" +
                body);
    EXPECT_TRUE(AwaitThat([&] {
      client.Receive();
      return client.has_ended();
    }));
    return client.received();
  }
  Json AskJson(const std::string& path) const {
    const std::string answer = Ask("GET", path);
    const size_t body = answer.find("\r\n\r\n");
    return body == std::string::npos ? Json()
                                     : Json::parse(answer.substr(body + 4), nullptr, false);
  }

 private:
  static std::vector<std::string> Argv(const std::vector<std::string>& more) {
    std::vector<std::string> argv = {Program("shoal-viewer"), "--http", "0"};
    argv.insert(argv.end(), more.begin(), more.end());
    return argv;
  }

  RunningProcess process_;
  int port_ = 0;
  std::string token_;
  std::unique_ptr<TcpClient> stream_;
  Json frame_;
};

std::vector<std::string> RunArguments(const std::vector<std::string>& more) {
  std::vector<std::string> argv = {Program("shoal"), "run", MissionFile("berta.toml")};
  argv.insert(argv.end(), more.begin(), more.end());
  return argv;
}

/// Where the first vehicle is by this frame, if it shows it.
std::optional<std::pair<double, double>> PlaceOf(const Json& frame) {
  if (!frame.is_object() || frame["vehicles"].empty()) return std::nullopt;
  const Json& nav = frame["vehicles"][0]["nav"];
  if (!nav.is_object()) return std::nullopt;
  return std::pair(nav["x"].get<double>(), nav["y"].get<double>());
}

TEST(Viewer, ShowsVehiclesThatMoveAndTheRulesInForce) {
  const TestFolder folder;
  const RunningProcess mission(
      folder, RunArguments({"--warp", "5", "--set", "comms.comms_range=123.5", "--quiet"}));
  WatchedViewer viewer(folder);
  std::optional<std::pair<double, double>> first;
  ASSERT_TRUE(AwaitThat([&] {
    first = PlaceOf(viewer.Frame());
    return first.has_value();
  })) << viewer.process().Output();
  EXPECT_TRUE(AwaitThat([&] { return PlaceOf(viewer.Frame()) != first; }));
  EXPECT_TRUE(AwaitThat([&] { return viewer.State() == "running"; })) << viewer.State();
  const Json setup = viewer.AskJson("/api/setup");
  EXPECT_EQ(setup["mission"], "berta") << setup;
  EXPECT_EQ(setup["commands"], false);
  EXPECT_EQ(viewer.Frame()["rules"]["comms_range_m"], 123.5) << viewer.Frame()["rules"];
}

TEST(Viewer, ShowsRulesThatWereChangedBeforeItJoined) {
  const TestFolder folder;
  const RunningProcess mission(folder, RunArguments({"--warp", "1", "--quiet"}));
  // A rule that is sent before the first step is of no effect (docs/extending/step_protocol.md).
  AwaitStatus(folder, "shore_broker", {"Known Vehicles: 2"});
  const Finished sent = RunShoal(folder, {"send", "comms_range", "77"});
  ASSERT_EQ(sent.exit_code, 0) << sent.output;
  AwaitStatus(folder, "shore_broker", {"Comms Range: 77\n"});
  WatchedViewer viewer(folder);
  EXPECT_TRUE(AwaitThat([&] {
    const Json& frame = viewer.Frame();
    return frame.is_object() && frame["rules"].is_object() && frame["rules"]["comms_range_m"] == 77;
  })) << viewer.Frame();
}

TEST(Viewer, ChangesNothingOfAMissionAndStaysWhenItHasEnded) {
  const TestFolder folder;
  WatchedViewer viewer(folder);
  ASSERT_TRUE(AwaitThat([&] { return viewer.State() == "waiting"; })) << viewer.Frame();
  const std::string boot = viewer.AskJson("/api/setup")["boot"];
  const std::string log = (folder / "sim.lcm").string();
  ASSERT_EQ(RunShoal(folder, {"sim", MissionFile("berta.toml"), "--log", log}).exit_code, 0);

  const std::string dir = (folder / "recorded").string();
  RunningProcess mission(folder, RunArguments({"--warp", "60", "--record", dir}));
  // A page asks for everything all the time, and tries to send a command.
  EXPECT_TRUE(AwaitThat([&] {
    viewer.AskJson("/api/status");
    viewer.AskJson("/api/links");
    const std::string refused =
        viewer.Ask("POST", "/api/command", "Content-Type: application/json\r\n",
                   R"({"target": "all", "words": ["all_stop"]})");
    EXPECT_TRUE(refused.starts_with("HTTP/1.1 403")) << refused;
    return viewer.State() == "ended";
  })) << viewer.State();
  const Finished finished = mission.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == ReadFile(log));

  const Json setup = viewer.AskJson("/api/setup");
  EXPECT_EQ(setup["mission"], "berta");
  EXPECT_NE(setup["boot"], boot);
  EXPECT_FALSE(viewer.AskJson("/api/status")["pages"].empty());
  EXPECT_GT(viewer.Frame()["t"].get<double>(), 500) << viewer.Frame()["t"];
}

TEST(Viewer, TurnsToTheNextMissionAndShowsWhereALauncherDied) {
  const TestFolder folder;
  WatchedViewer viewer(folder);
  std::string boot;
  {
    RunningProcess mission(folder, RunArguments({"--warp", "1", "--quiet"}));
    ASSERT_TRUE(AwaitThat([&] { return viewer.State() == "running"; })) << viewer.Frame();
    boot = viewer.AskJson("/api/setup")["boot"];
    mission.Signal(SIGKILL);
    mission.Wait();
    ASSERT_TRUE(AwaitThat([&] { return viewer.State() == "lost"; })) << viewer.State();
  }
  RunningProcess next(folder, {Program("shoal"), "run", MissionFile("alpha.toml"), "--quiet"});
  EXPECT_TRUE(AwaitThat([&] { return viewer.State() == "running"; })) << viewer.Frame();
  EXPECT_TRUE(AwaitThat([&] { return viewer.AskJson("/api/setup")["boot"] != boot; }));
  next.Signal(SIGINT);
  EXPECT_TRUE(AwaitThat([&] { return viewer.State() == "ended"; })) << viewer.State();
}

TEST(Viewer, ShowsWhereTheLauncherStandsStill) {
  const TestFolder folder;
  const RunningProcess mission(folder, RunArguments({"--warp", "1", "--quiet"}));
  WatchedViewer viewer(folder);
  // Vehicles may be received before the clock; only the clock states the warp.
  ASSERT_TRUE(AwaitThat([&] {
    const Json& frame = viewer.Frame();
    return frame.is_object() && frame["clock"]["warp"] == 1;
  })) << viewer.Frame();
  mission.Signal(SIGSTOP);
  EXPECT_TRUE(AwaitThat([&] { return viewer.State() == "silent"; })) << viewer.State();
  mission.Signal(SIGCONT);
  EXPECT_TRUE(AwaitThat([&] { return viewer.State() == "running"; })) << viewer.State();
}

/// The viewer receives the ports of vehicles in another way than the shore's.
class ViewerInLayout : public testing::TestWithParam<const char*> {};

TEST_P(ViewerInLayout, ShowsNothingThatIsSealedWithoutTheSecret) {
  const TestFolder folder;
  setenv("SHOAL_RUN_DIR", (folder / "run").c_str(), 1);
  const RunningProcess mission(folder,
                               RunArguments({"--warp", "1", "--quiet", "--layout", GetParam()}));
  WatchedViewer viewer(folder);
  ASSERT_TRUE(AwaitThat([&] { return PlaceOf(viewer.Frame()).has_value(); }));
  ASSERT_EQ(RunShoal(folder, {"send", "clock", "pause"}).exit_code, 0);
  const Result<RunningMission> running = FindRunningMission(0);
  ASSERT_TRUE(running.ok());
  LcmTransport attacker;
  const auto send = [&](const auto& channel, const auto& message, bool is_sealed) {
    Bytes bytes;
    EncodeInto(message, &bytes);
    if (is_sealed) {
      AppendSeal({.publisher = "vehicle_sim_alpha",
                  .mission_id = running->mission_id,
                  .step = 1,
                  .sequence = 0},
                 MissionSecret{}, channel.name, &bytes);
    }
    attacker.Send(running->Ports().PortOf(channel.name), channel.name, bytes);
  };
  // Messages without a seal are shown: they are of programs outside the step protocol.
  nav_t nav{};
  nav.x_m = 777;
  ASSERT_TRUE(AwaitThat([&] {
    send(channels::Nav("alpha"), nav, false);
    const auto place = PlaceOf(viewer.Frame());
    return place && place->first == 777;
  })) << viewer.Frame();
  nav.x_m = 5000;
  send(channels::Nav("alpha"), nav, true);
  // On the same port: what comes after has come when this is shown.
  helm_state_t helm{};
  helm.task = "marker";
  ASSERT_TRUE(AwaitThat([&] {
    send(channels::HelmState("alpha"), helm, false);
    const Json& frame = viewer.Frame();
    return frame.is_object() && frame["vehicles"][0]["helm"].is_object() &&
           frame["vehicles"][0]["helm"]["task"] == "marker";
  })) << viewer.Frame();
  EXPECT_EQ(PlaceOf(viewer.Frame())->first, 777) << viewer.Frame();
}

INSTANTIATE_TEST_SUITE_P(Both, ViewerInLayout, testing::Values("shared", "communities"),
                         [](const auto& layout) { return std::string(layout.param); });

TEST(Viewer, SendsCommandsWithTheToken) {
  const TestFolder folder;
  const RunningProcess mission(folder, RunArguments({"--warp", "2", "--quiet"}));
  WatchedViewer viewer(folder, {"--allow-commands"});
  ASSERT_EQ(viewer.token().size(), 32U) << viewer.process().Output();
  ASSERT_TRUE(AwaitThat([&] { return viewer.State() == "running"; })) << viewer.Frame();
  const std::string body = R"({"target": "all", "words": ["return"]})";
  const std::string json = "Content-Type: application/json\r\n";
  EXPECT_TRUE(viewer.Ask("POST", "/api/command", json, body).starts_with("HTTP/1.1 403"));
  const std::string with_token = json + "X-Shoal-Token: " + viewer.token() + "\r\n";
  EXPECT_TRUE(viewer.Ask("POST", "/api/command", with_token, R"({"target": "x", "words": []})")
                  .starts_with("HTTP/1.1 400"));
  const std::string answer = viewer.Ask("POST", "/api/command", with_token, body);
  ASSERT_TRUE(answer.starts_with("HTTP/1.1 200")) << answer;
  EXPECT_TRUE(AwaitThat([&] {
    const Json& frame = viewer.Frame();
    return !frame["commands"].empty() && frame["commands"].back()["state"] == "taken";
  })) << viewer.Frame()["commands"];
  EXPECT_EQ(viewer.Frame()["commands"].size(), 1U) << viewer.Frame()["commands"];
}

TEST(Viewer, EndsAtOnceWithPagesOpen) {
  const TestFolder folder;
  const RunningProcess mission(folder, RunArguments({"--warp", "1", "--quiet"}));
  WatchedViewer viewer(folder);
  ASSERT_TRUE(AwaitThat([&] { return PlaceOf(viewer.Frame()).has_value(); }));
  const FairStopwatch since_signal;
  viewer.process().Signal(SIGINT);
  EXPECT_EQ(viewer.process().Wait().exit_code, 0);
  EXPECT_LT(since_signal.Seconds(), 1.5);
}

TEST(Viewer, StatesWhatIsWrongWithItsCommandLine) {
  const TestFolder folder;
  const auto run = [&](std::vector<std::string> argv) {
    argv.insert(argv.begin(), Program("shoal-viewer"));
    return RunningProcess(folder, std::move(argv)).Wait();
  };
  EXPECT_EQ(run({"--help"}).exit_code, 0);
  EXPECT_NE(run({"--interface"}).output.find("COMMS_FATES"), std::string::npos);
  EXPECT_EQ(run({"--sped"}).exit_code, 2);
  EXPECT_EQ(run({"--log", "x", "--allow-commands"}).exit_code, 2);
  EXPECT_EQ(run({"--web", "/nowhere"}).exit_code, 2);
  EXPECT_EQ(run({"--log", "/nowhere"}).exit_code, 2);
  const Finished no_address = run({"--listen", "203.0.113.1"});
  EXPECT_EQ(no_address.exit_code, 3);
  EXPECT_NE(no_address.output.find("203.0.113.1"), std::string::npos) << no_address.output;
  EXPECT_NE(no_address.output.find("0.0.0.0 for all"), std::string::npos) << no_address.output;
}

}  // namespace shoal::viewer_process_test
