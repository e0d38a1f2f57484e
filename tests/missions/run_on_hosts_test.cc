// Vehicles on other computers: `shoal host` agents on loopback, and what goes wrong with them.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sodium.h>
#include <sys/socket.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#include "lib/base/arithmetic/arithmetic_id.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/mission/file/load.h"
#include "lib/run/command_line/build_facts.h"
#include "lib/run/hosts/curve_link.h"
#include "lib/run/hosts/host_offer.h"
#include "tests/missions/delaying_proxy.h"
#include "tests/missions/fair_stopwatch.h"
#include "tests/missions/host_farm.h"

namespace shoal::run_on_hosts_test {

TEST(Hosts, GiveTheLogOfShoalSim) {
  HostFarm farm(2);
  const std::string mission = farm.Placed("berta.toml", {"\"alpha\"", "\"bravo\""}, kPatient);
  const std::string dir = (farm.folder / "rec").string();
  const Finished finished = farm.Run(mission, {"--record", dir});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("Host host2: 6001 steps"), std::string::npos) << finished.output;
  EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == LogOfSim(farm.folder, mission));
}

TEST(Hosts, HaveTheGridsOfTheMissionSentToThem) {
#ifndef SHOAL_HAS_NETCDF
  GTEST_SKIP() << "no libnetcdf: scripts/setup installs it";
#else
  HostFarm farm(1);
  const std::string mission = farm.Placed("tidal_channel.toml", {"\"alpha\", \"bravo\""}, kPatient);
  const std::string dir = (farm.folder / "rec").string();
  const Finished finished = farm.Run(mission, {"--record", dir});
  EXPECT_EQ(finished.exit_code, 0) << finished.output << farm.hosts[0].process->Output();
  EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == LogOfSim(farm.folder, mission));
#endif
}

TEST(Hosts, HaveWhereTheVehiclesOfOthersAreThatTheirOwnFollow) {
  HostFarm farm(1);
  const std::string mission = farm.Placed("swarm_direct.toml", {"\"bravo\""}, kPatient);
  const std::string dir = (farm.folder / "rec").string();
  Shorten(mission, 60);
  const Finished finished = farm.Run(mission, {"--record", dir});
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == LogOfSim(farm.folder, mission));
}

/// A mission on hosts, its participants in shared processes.
struct Shared {
  std::string name;
  std::string mission;
  std::vector<std::string> vehicles;  ///< Of each host.
  std::string grouping;
  std::string in_processes;  ///< As the summary has it.
};

class InGroups : public testing::TestWithParam<Shared> {};

TEST_P(InGroups, GiveTheLogOfShoalSim) {
  HostFarm farm(GetParam().vehicles.size());
  const std::string mission = farm.Placed(GetParam().mission, GetParam().vehicles, kPatient);
  const std::string dir = (farm.folder / "rec").string();
  const Finished finished = farm.Run(mission, {"--record", dir, "--grouping", GetParam().grouping});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find(GetParam().in_processes), std::string::npos) << finished.output;
  EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == LogOfSim(farm.folder, mission));
}

INSTANTIATE_TEST_SUITE_P(
    Hosts, InGroups,
    testing::Values(Shared{"BertaByVehicle",
                           "berta.toml",
                           {"\"alpha\"", "\"bravo\""},
                           "vehicle",
                           "9 participants in 5 processes"},
                    Shared{"BertaInOneProcess",
                           "berta.toml",
                           {"\"alpha\", \"bravo\""},
                           "host=1",
                           "9 participants in 4 processes"},
                    Shared{
                        "FleetByVehicle",
                        "fleet.toml",
                        {"\"scout_01\", \"scout_02\", \"scout_03\"",
                         "\"scout_04\", \"scout_05\", \"scout_06\"", "\"scout_07\", \"scout_08\""},
                        "vehicle",
                        "33 participants in 13 processes"},
                    Shared{"FleetInTwoProcessesEach",
                           "fleet.toml",
                           {"\"scout_01\", \"scout_02\", \"scout_03\", \"scout_04\"",
                            "\"scout_05\", \"scout_06\", \"scout_07\", \"scout_08\""},
                           "host=2",
                           "33 participants in 9 processes"}),
    [](const auto& each) { return each.param.name; });

TEST(Hosts, RunOneMissionAfterTheOther) {
  HostFarm farm(1);
  const std::string mission = farm.Placed("alpha.toml", {"\"alpha\""}, kPatient);
  TakeOutWhatComesLater(mission);
  for (int i = 0; i < 2; ++i) {
    const Finished finished = farm.Run(mission, {"--set", "mission.duration_s=20"});
    EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos)
        << finished.output << farm.hosts[0].process->Output();
    ASSERT_TRUE(farm.hosts[0].process->WaitFor("has ended after step"));
  }
}

TEST(Hosts, TakeVehiclesFromTheCommandLine) {
  HostFarm farm(1);
  const std::string mission = farm.Placed("berta.toml", {""}, kPatient);
  TakeOutWhatComesLater(mission);
  const Finished finished =
      farm.Run(mission, {"--on", "host1=bravo", "--set", "mission.duration_s=20"});
  EXPECT_NE(finished.output.find("Host host1: 201 steps"), std::string::npos) << finished.output;
  EXPECT_NE(farm.hosts[0].process->Output().find("helm_bravo"), std::string::npos);
  EXPECT_EQ(farm.hosts[0].process->Output().find("helm_alpha"), std::string::npos);
}

TEST(LostHost, IsNamedWithinASecondWhenItIsKilledAndTheMissionEnds) {
  MissionUnderWay under(kPatient);
  const auto participants = under.farm.hosts[0].process->Participants();
  EXPECT_TRUE(participants.contains("helm_bravo"));
  const FairStopwatch since_kill;
  under.farm.hosts[0].process->Signal(SIGKILL);
  ASSERT_TRUE(under.process->WaitFor("LOST: host host1")) << under.process->Output();
  EXPECT_LT(since_kill.Seconds(), 1.0);
  const Finished finished = under.process->Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_TRUE(AllGone(participants)) << "a host's processes die with it";
  EXPECT_GE(under.NumEvents(), 200) << "the log must stay whole";
}

TEST(LostHost, IsNamedAfterItsTimeOutWhenItHangs) {
  MissionUnderWay under(kAttentive);
  const FairStopwatch since_stop;
  under.farm.hosts[0].process->Signal(SIGSTOP);
  ASSERT_TRUE(under.process->WaitFor("gave no sign of life for 3 s")) << under.process->Output();
  EXPECT_LT(since_stop.Seconds(), kAttentive_s + 0.2);
  EXPECT_EQ(under.process->Wait().exit_code, 3);
  EXPECT_GE(under.NumEvents(), 200);
  under.farm.hosts[0].process->Signal(SIGCONT);
}

TEST(LostHost, IsDoneWithoutWhereTheMissionShallGoOn) {
  MissionUnderWay under(std::string(kPatient) + "on_loss = \"continue\"\n");
  under.farm.hosts[0].process->Signal(SIGKILL);
  ASSERT_TRUE(under.process->WaitFor("the mission goes on without host1"))
      << under.process->Output();
  const int64_t before = under.NumEvents();
  EXPECT_TRUE(AwaitThat([&] { return under.NumEvents() > before; }));
  under.process->Signal(SIGINT);
  EXPECT_NE(under.process->Wait().output.find("Reproducible: no"), std::string::npos);
}

TEST(LostHost, JoinsAtAStepWhenItIsBack) {
  MissionUnderWay under(std::string(kPatient) + "on_loss = \"restart\"\n");
  under.farm.hosts[0].process->Signal(SIGKILL);
  ASSERT_TRUE(under.process->WaitFor("until it is back")) << under.process->Output();
  under.farm.Start(0);
  ASSERT_TRUE(under.process->WaitFor("is there again")) << under.process->Output();
  const std::string page = AwaitPage(under.farm.folder, "helm_bravo", [](const std::string& each) {
    return each.find("helm_bravo") != each.npos;
  });
  EXPECT_NE(page.find("helm_bravo"), std::string::npos) << under.process->Output();
  under.process->Signal(SIGINT);
  EXPECT_EQ(under.process->Wait().exit_code, 1);
}

TEST(LostHost, IsTakenBackWhenItStoodStillForLongerThanItsTimeOut) {
  MissionUnderWay under(std::string(kAttentive) + "on_loss = \"restart\"\n");
  under.farm.hosts[0].process->Signal(SIGSTOP);
  ASSERT_TRUE(under.process->WaitFor("gave no sign of life for 3 s")) << under.process->Output();
  under.farm.hosts[0].process->Signal(SIGCONT);
  ASSERT_TRUE(under.process->WaitFor("is there again; its participants join"))
      << under.process->Output() << under.farm.hosts[0].process->Output();
  under.process->Signal(SIGINT);
  EXPECT_EQ(under.process->Wait().exit_code, 1);
}

TEST(LostHome, EndsTheProcessesOfTheHostWhichThenTakesTheNextMission) {
  MissionUnderWay under(kAttentive);
  const auto participants = under.farm.hosts[0].process->Participants();
  under.process->Signal(SIGKILL);
  TestHost& host = under.farm.hosts[0];
  ASSERT_TRUE(host.process->WaitFor("LOST: home gave no sign of life")) << host.process->Output();
  ASSERT_TRUE(host.process->WaitFor("has ended after step")) << host.process->Output();
  EXPECT_TRUE(AllGone(participants));
  TakeOutWhatComesLater(under.mission);
  const Finished next = under.farm.Run(under.mission, {"--set", "mission.duration_s=10"});
  EXPECT_NE(next.output.find("Host host1: 101 steps"), std::string::npos) << next.output;
}

TEST(LostParticipant, OfAHostIsNamedAndStartedAgain) {
  HostFarm farm(1);
  const std::string mission = farm.Placed("berta.toml", {"\"bravo\""}, kPatient);
  RunningProcess process(
      farm.folder, farm.RunCommand(mission, {"--warp", "20", "--set", "mission.on_loss=restart",
                                             "--set", "mission.participant_timeout_s=60"}));
  ASSERT_TRUE(AwaitThat([&] { return farm.hosts[0].process->Participants().size() == 3; }));
  AwaitPage(farm.folder, "helm_bravo",
            [](const std::string& page) { return page.find("Bus: ") != page.npos; });
  const auto before = farm.hosts[0].process->Participants();
  kill(before.at("helm_bravo"), SIGKILL);
  ASSERT_TRUE(process.WaitFor("LOST: helm_bravo (pid")) << process.Output();
  ASSERT_TRUE(process.WaitFor("helm_bravo starts again")) << process.Output();
  EXPECT_TRUE(AwaitThat([&] {
    const auto now = farm.hosts[0].process->Participants();
    return now.contains("helm_bravo") && now.at("helm_bravo") != before.at("helm_bravo");
  }));
  process.Signal(SIGINT);
  EXPECT_EQ(process.Wait().exit_code, 1);
}

/// Berta in processes of a vehicle each, bravo's on a host.
struct GroupOnHost {
  explicit GroupOnHost(const std::vector<std::string>& settings) : farm(1) {
    std::vector<std::string> options = {"--warp", "20", "--grouping", "vehicle"};
    for (const std::string& each : settings) options.insert(options.end(), {"--set", each});
    process = std::make_unique<RunningProcess>(
        farm.folder, farm.RunCommand(farm.Placed("berta.toml", {"\"bravo\""}, kPatient), options));
    AwaitStatus(farm.folder, "helm_bravo", {"Bus: "});
    group = farm.hosts[0].process->Participants().at("group-bravo");
  }

  HostFarm farm;
  std::unique_ptr<RunningProcess> process;
  pid_t group = 0;
};

TEST(LostGroup, OfAHostIsNamedWithItsParticipantsAndStartedAgain) {
  GroupOnHost on_host({"mission.on_loss=restart", "mission.participant_timeout_s=60"});
  kill(on_host.group, SIGKILL);
  ASSERT_TRUE(on_host.process->WaitFor("group-bravo starts again")) << on_host.process->Output();
  EXPECT_NE(on_host.process->Output().find(
                "was killed by signal 9 (Killed), and with it vehicle_sim_bravo, helm_bravo, "
                "node_reporter_bravo\n"),
            std::string::npos)
      << on_host.process->Output();
  EXPECT_TRUE(AwaitThat([&] {
    const auto now = on_host.farm.hosts[0].process->Participants();
    return now.contains("group-bravo") && now.at("group-bravo") != on_host.group;
  }));
  AwaitStatus(on_host.farm.folder, "node_reporter_bravo", {"Bus: "});
  on_host.process->Signal(SIGINT);
  const Finished finished = on_host.process->Wait();
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_EQ(finished.output.find("LOST"), finished.output.rfind("LOST")) << finished.output;
}

TEST(LostGroup, OfAHostIsNamedWhereItHangs) {
  GroupOnHost on_host({"mission.participant_timeout_s=3"});
  kill(on_host.group, SIGSTOP);
  ASSERT_TRUE(on_host.process->WaitFor("LOST: group-bravo has not answered"))
      << on_host.process->Output();
  EXPECT_EQ(on_host.process->Wait().exit_code, 3);
  EXPECT_TRUE(AllGone({{"group-bravo", on_host.group}}));
}

TEST(RefusedHost, NamesTheKeyThatItDoesNotKnow) {
  HostFarm farm(1);
  const std::string mission = farm.Placed("berta.toml", {"\"bravo\""});
  const std::string other = (farm.folder / "other").string();
  ASSERT_EQ(RunShoal(farm.folder, {"host", "keygen", "--out", other}).exit_code, 0);
  farm.home_key = other;
  const Finished finished = farm.Run(mission);
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_NE(finished.output.find("does not accept this computer's key"), std::string::npos)
      << finished.output;
  EXPECT_NE(farm.hosts[0].process->Output().find("refused: a computer with the public key"),
            std::string::npos)
      << farm.hosts[0].process->Output();
}

TEST(RefusedHost, IsNamedWhereItDoesNotProveItsKey) {
  HostFarm farm(1);
  const std::string mission = farm.Placed("berta.toml", {"\"bravo\""});
  std::filesystem::remove(farm.folder / "host1.pub");
  std::filesystem::copy(farm.home_key + ".pub", farm.folder / "host1.pub");
  const Finished finished = farm.Run(mission);
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_NE(finished.output.find("does not prove the key"), std::string::npos) << finished.output;
}

TEST(RefusedHost, RunsNoProgramsOfAMissionUnlessItMay) {
  HostFarm farm(1);
  std::string mission = farm.Placed("berta.toml", {"\"bravo\""});
  WriteFile(mission, ReadFile(mission) +
                         "participants = [\"mine\"]\n[[participant]]\nname = \"mine\"\n"
                         "command = [\"/bin/false\"]\n");
  const Finished finished = farm.Run(mission);
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_NE(finished.output.find("only where it was started with --allow-programs"),
            std::string::npos)
      << finished.output;
}

TEST(RefusedHost, IsToBeReachable) {
  HostFarm farm(1);
  const std::string mission = farm.Placed("berta.toml", {"\"bravo\""}, "", {"tcp://127.0.0.1:9"});
  const Finished finished = farm.Run(mission);
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_NE(finished.output.find("cannot be reached within 10 s"), std::string::npos)
      << finished.output;
}

/// Plays home towards an agent.
class PlayedHome {
 public:
  explicit PlayedHome(const HostFarm& farm)
      : link_(farm.hosts[0].address, *FindPublicKey(farm.hosts[0].public_key_file, ""),
              *ReadHostKey(farm.home_key + ".key")) {}

  /// Refuses messages of other missions, as home does.
  void set_mission_id(int64_t mission_id) { intake_.set_mission_id(mission_id); }
  void Send(const LinkMessage& message) { Send(message, next_sequence_++); }
  void Send(const LinkMessage& message, uint64_t sequence) {
    const Bytes bytes = EncodeLinkMessage(message, sequence);
    EXPECT_TRUE(AwaitThat([&] {
      link_.Receive();
      return link_.Send(bytes);
    }));
  }
  /// Returns the next message that is more than a sign of life.
  LinkMessage Await() {
    LinkMessage answer;
    EXPECT_TRUE(AwaitThat([&] {
      const auto bytes = link_.Receive();
      const auto message = bytes ? intake_.Take(*bytes) : Result<LinkMessage>(Error{""});
      if (message.ok()) answer = *message;
      return message.ok() && answer.kind != LinkKind::kAlive;
    }));
    return answer;
  }

  HomeLink& link() { return link_; }
  uint64_t next_sequence() const { return next_sequence_; }
  /// Counts a message that was sent over link().
  void Count() { ++next_sequence_; }

 private:
  HomeLink link_;
  LinkIntake intake_;
  uint64_t next_sequence_ = 0;
};

/// Returns the offer of alpha's helm as home makes it.
LinkMessage HelmOffer(HostFarm* farm, int64_t mission_id) {
  const std::string mission = farm->Placed("alpha.toml", {"\"alpha\""});
  const auto files = FilesOfMission(mission, {});
  EXPECT_TRUE(files.ok());
  // Another build than that of `shoal`: version and arithmetic are the same.
  return ToLinkMessage({.build = OwnBuild(),
                        .host = "host1",
                        .files = *files,
                        .digest = MissionDigest(LoadMission(mission).mission, *files),
                        .participants = {"helm_alpha"},
                        .secret = {},
                        .timeout_s = 60},
                       mission_id);
}

TEST(RefusedHome, IsGivenTheCauseWhereAnotherMissionRuns) {
  HostFarm farm(1);
  PlayedHome first(farm);
  first.Send(HelmOffer(&farm, 5));
  ASSERT_EQ(first.Await().kind, LinkKind::kAccept) << farm.hosts[0].process->Output();
  PlayedHome second(farm);
  second.set_mission_id(6);
  second.Send(HelmOffer(&farm, 6));
  const LinkMessage answer = second.Await();
  EXPECT_EQ(answer.kind, LinkKind::kRefuse);
  EXPECT_EQ(answer.TextOf("why"), "it runs another mission now, alpha: wait until that has ended");
  PlayedHome broken(farm);
  broken.set_mission_id(7);
  broken.Send({.kind = LinkKind::kOffer, .mission_id = 7});
  EXPECT_EQ(broken.Await().kind, LinkKind::kRefuse);
}

TEST(RefusedHome, IsTakenOnceItsFormerPartHasEndedWhereItConnectsAnew) {
  HostFarm farm(1);
  const LinkMessage offer = HelmOffer(&farm, 5);
  PlayedHome first(farm);
  first.Send(offer);
  ASSERT_EQ(first.Await().kind, LinkKind::kAccept) << farm.hosts[0].process->Output();
  PlayedHome again(farm);
  again.set_mission_id(5);
  EXPECT_TRUE(AwaitThat([&] {
    again.Send(offer);
    return again.Await().kind == LinkKind::kAccept;
  })) << farm.hosts[0].process->Output();
  EXPECT_NE(farm.hosts[0].process->Output().find("LOST: home has connected again"),
            std::string::npos);
}

TEST(RefusedHome, StartsWhatRuns) {
  HostFarm farm(1);
  PlayedHome home(farm);
  home.Send(HelmOffer(&farm, 5));
  ASSERT_EQ(home.Await().kind, LinkKind::kAccept) << farm.hosts[0].process->Output();
  const auto before = farm.hosts[0].process->Participants();
  LinkMessage start{.kind = LinkKind::kStart, .mission_id = 5};
  start.AddText("name", "helm_alpha");
  home.Send(start);
  EXPECT_TRUE(
      farm.hosts[0].process->WaitFor("home sent a start of helm_alpha, which runs; refused"))
      << farm.hosts[0].process->Output();
  EXPECT_EQ(farm.hosts[0].process->Participants(), before);
}

/// Returns the host's answer to an offer of a home of this build.
std::string RefusalOfBuild(const BuildFacts& build) {
  HostFarm farm(1);
  PlayedHome home(farm);
  home.Send(ToLinkMessage(HostOffer{.build = build,
                                    .files = {{.path = "m.toml", .text = ""}},
                                    .participants = {"helm_alpha"},
                                    .secret = {},
                                    .timeout_s = 60},
                          5),
            0);
  const LinkMessage answer = home.Await();
  EXPECT_EQ(answer.kind, LinkKind::kRefuse);
  return answer.TextOf("why");
}

TEST(RefusedHome, HasAnotherVersionOrAnotherArithmetic) {
  EXPECT_EQ(RefusalOfBuild({.version = "9.9.9", .build = "b", .arithmetic = ArithmeticId()}),
            fmt::format("its shoal is {}, not 9.9.9: install the same version on both",
                        OwnBuild().version));
  BuildFacts other = OwnBuild();
  other.arithmetic = "0123456789abcdef";
  const std::string why = RefusalOfBuild(other);
  EXPECT_TRUE(why.starts_with("its arithmetic is " + ArithmeticId() + ", not 0123456789abcdef"))
      << why;
}

TEST(RefusedHome, SendsABatchTwice) {
  HostFarm farm(1);
  PlayedHome home(farm);
  home.Send({.kind = LinkKind::kPing}, 0);
  EXPECT_EQ(home.Await().kind, LinkKind::kPong);
  home.Send({.kind = LinkKind::kPing}, 0);
  ASSERT_TRUE(farm.hosts[0].process->WaitFor("sent a replayed batch: number 0, where 1 is next"))
      << farm.hosts[0].process->Output();
  home.Send({.kind = LinkKind::kPing}, 1);
  EXPECT_EQ(home.Await().kind, LinkKind::kPong) << "the link goes on";
}

/// Messages of many parts, each under a number and digest of its own: they cost more to read than
/// to make.
class Flood {
 public:
  explicit Flood(const LinkMessage& message) : bytes_(EncodeLinkMessage(message, 0)) {}

  static LinkMessage OfParts(LinkKind kind, int64_t mission_id) {
    LinkMessage message{.kind = kind, .mission_id = mission_id};
    message.parts.resize(100'000);
    return message;
  }
  const Bytes& Next(uint64_t sequence) {
    constexpr size_t kSequenceAt = 4 + 1 + 8 + 8;
    constexpr size_t kDigestSize = 32;
    for (size_t i = 0; i < 8; ++i) {
      bytes_[kSequenceAt + i] = static_cast<uint8_t>(sequence >> (8 * (7 - i)));
    }
    const size_t size = bytes_.size() - kDigestSize;
    crypto_generichash(bytes_.data() + size, kDigestSize, bytes_.data(), size, nullptr, 0);
    return bytes_;
  }

 private:
  Bytes bytes_;
};

/// With this under way the other end always has more to read.
constexpr size_t kUnderWay_bytes = size_t{8} << 20;

TEST(FloodOfHome, KeepsAHostFromNeitherItsSignalsNorItsBounds) {
  HostFarm farm(1);
  PlayedHome home(farm);
  home.Send(LinkMessage{.kind = LinkKind::kPing});
  ASSERT_EQ(home.Await().kind, LinkKind::kPong);
  std::atomic<bool> stops = false;
  std::thread flood([&] {
    Flood pings(Flood::OfParts(LinkKind::kPing, 0));
    while (!stops) {
      home.link().Receive();
      if (home.link().outbox().waiting_bytes() > kUnderWay_bytes) continue;
      if (home.link().Send(pings.Next(home.next_sequence()))) home.Count();
    }
  });
  EXPECT_TRUE(farm.hosts[0].process->WaitFor("a batch of kind 12 with 100000 messages", 20))
      << farm.hosts[0].process->Output();
  farm.hosts[0].process->Signal(SIGTERM);
  EXPECT_EQ(farm.hosts[0].process->Wait(20).exit_code, 0);
  stops = true;
  flood.join();
}

TEST(Link, HoldsBackWhatTheOtherEndDoesNotReadAndLosesNoneOfIt) {
  HostFarm farm(1);
  const HostKey host_key = *ReadHostKey((farm.folder / "host1.key").string());
  const HostKey home_key = *ReadHostKey(farm.home_key + ".key");
  const std::string address = "tcp://127.0.0.1:" + std::to_string(FreeTcpPorts(1));
  HostDoor door;
  ASSERT_TRUE(door.Open(address, host_key, {home_key.public_key}).ok());
  HomeLink link(address, host_key.public_key, home_key);
  ASSERT_TRUE(AwaitThat([&] {
    door.Receive();
    link.Receive();
    return link.state() == HomeLink::State::kOpen;
  }));
  constexpr size_t kNum = 100;
  constexpr size_t kEach_bytes = size_t{1} << 20;
  for (size_t i = 0; i < kNum; ++i) {
    ASSERT_TRUE(link.Send(Bytes(kEach_bytes, static_cast<uint8_t>(i))));
  }
  SleepSeconds(0.2);  // ZeroMQ takes what it takes.
  link.Receive();
  EXPECT_GT(link.outbox().waiting_bytes(), kNum * kEach_bytes / 2);
  std::vector<uint8_t> taken;
  EXPECT_TRUE(AwaitThat([&] {
    link.Receive();
    if (const auto arrival = door.Receive()) taken.push_back(arrival->bytes.front());
    return taken.size() == kNum;
  }));
  for (size_t i = 0; i < taken.size(); ++i) EXPECT_EQ(taken[i], i);
  EXPECT_TRUE(link.outbox().IsIdle());
}

TEST(Connections, ThatProveNoKeyAreEndedAndNamedAsThat) {
  HostFarm farm(1);
  std::vector<FileDescriptor> connections;
  for (int i = 0; i < 5; ++i) {
    FileDescriptor& each = connections.emplace_back(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(farm.PortOf(0)));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(connect(each.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ASSERT_TRUE(farm.hosts[0].process->WaitFor("connections so far that proved no key within 3 s"))
      << farm.hosts[0].process->Output();
  PlayedHome home(farm);
  home.Send({.kind = LinkKind::kPing});
  EXPECT_EQ(home.Await().kind, LinkKind::kPong);
}

/// Plays a host towards `shoal run`: accepts what it is offered, and then sends what it should not.
class PlayedHost {
 public:
  explicit PlayedHost(HostFarm* farm) {
    address_ = "tcp://127.0.0.1:" + std::to_string(FreeTcpPorts(1));
    const Result<bool> opened =
        door_.Open(address_, *ReadHostKey((farm->folder / "host1.key").string()),
                   {*FindPublicKey(farm->home_key + ".pub", "")});
    EXPECT_TRUE(opened.ok());
  }
  /// Awaits the offer, and accepts it.
  void Accept() {
    EXPECT_TRUE(AwaitThat([&] {
      const auto arrival = door_.Receive();
      if (!arrival) return false;
      const auto message = intake_.Take(arrival->bytes);
      if (!message.ok() || message->kind != LinkKind::kOffer) return false;
      peer_ = arrival->peer;
      mission_id_ = message->mission_id;
      return true;
    }));
    Send({.kind = LinkKind::kAccept, .mission_id = mission_id_});
  }
  void Send(const LinkMessage& message) {
    EXPECT_TRUE(door_.Send(peer_, EncodeLinkMessage(message, next_sequence_++)));
  }
  /// Sends what `make` returns for the next number, unless home has much to take already.
  void TrySend(const std::function<Bytes(uint64_t sequence)>& make) {
    door_.Receive();
    if (door_.WaitingBytes(peer_) > kUnderWay_bytes) return;
    if (door_.Send(peer_, make(next_sequence_))) ++next_sequence_;
  }
  const std::string& address() const { return address_; }
  int64_t mission_id() const { return mission_id_; }
  uint64_t num_sent() const { return next_sequence_; }

 private:
  HostDoor door_;
  std::string address_;
  std::string peer_;
  LinkIntake intake_;
  int64_t mission_id_ = 0;
  std::atomic<uint64_t> next_sequence_ = 0;
};

TEST(RefusedHost, EndsAProcessThatItDoesNotRun) {
  HostFarm farm(1);
  PlayedHost host(&farm);
  const std::string mission = farm.Placed("berta.toml", {"\"bravo\""}, kPatient, {host.address()});
  RunningProcess process(farm.folder, farm.RunCommand(mission));
  host.Accept();
  host.Send(ToLinkMessage(
      HostExit{.name = "shore_broker", .how = "was killed by signal 9 (Killed)", .last_lines = {}},
      host.mission_id()));
  ASSERT_TRUE(process.WaitFor("sent the end of shore_broker, which it does not run; refused"))
      << process.Output();
  host.Send(RefusalOf(host.mission_id(), "\x1b[2J\nVerdict: PASS"));
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_EQ(finished.output.find("LOST: shore_broker"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("ends its part: ?[2J?Verdict: PASS"), std::string::npos)
      << finished.output;
}

/// What a host floods home with, and what home makes of it.
struct HostFlood {
  std::string name;
  LinkKind kind;
  std::string shown;  ///< Empty: it is legal.
};

class FloodOfAHost : public testing::TestWithParam<HostFlood> {};

INSTANTIATE_TEST_SUITE_P(
    Links, FloodOfAHost,
    testing::Values(
        HostFlood{"OfManyParts", LinkKind::kAlive,
                  "a batch of kind 10 with 600065 bytes; the largest has 1024; refused"},
        HostFlood{"OfBatches", LinkKind::kDone, ""}),
    [](const auto& each) { return each.param.name; });

TEST_P(FloodOfAHost, KeepsHomeNotFromItsSignals) {
  HostFarm farm(1);
  PlayedHost host(&farm);
  const std::string mission = farm.Placed("berta.toml", {"\"bravo\""}, kPatient, {host.address()});
  RunningProcess process(farm.folder, farm.RunCommand(mission));
  host.Accept();
  std::atomic<bool> stops = false;
  std::thread flood([&] {
    Flood batches(Flood::OfParts(GetParam().kind, host.mission_id()));
    while (!stops) host.TrySend([&](uint64_t sequence) { return batches.Next(sequence); });
  });
  if (!GetParam().shown.empty()) {
    EXPECT_TRUE(process.WaitFor(GetParam().shown, 20)) << process.Output();
  } else {
    EXPECT_TRUE(AwaitThat([&] { return host.num_sent() > 60; }));
  }
  process.Signal(SIGINT);
  const Finished finished = process.Wait(20);
  EXPECT_GT(finished.exit_code, 0) << "a verdict, not a kill: " << finished.output;
  stops = true;
  flood.join();
}

TEST(HostDoctor, MeasuresTheWay) {
  HostFarm farm(1);
  const DelayingProxy proxy(farm.PortOf(0), 0.010);
  const Finished finished = RunShoal(
      farm.folder, {"doctor", "--host", "tcp://127.0.0.1:" + std::to_string(proxy.port()),
                    "--host-key", farm.hosts[0].public_key_file, "--key", farm.home_key + ".key"});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  const size_t at = finished.output.find("round trip: ");
  ASSERT_NE(at, std::string::npos) << finished.output;
  EXPECT_GE(std::atof(finished.output.c_str() + at + 12), 20.0) << finished.output;
  EXPECT_NE(finished.output.find("throughput: "), std::string::npos);
}

TEST(HostKeys, AreNeededToListen) {
  const TestFolder folder;
  const Finished bare = RunShoal(folder, {"host", "--once"});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_NE(bare.output.find("nothing listens without being asked to"), std::string::npos);
  const Finished missing =
      RunShoal(folder, {"host", "--listen", "tcp://127.0.0.1:1", "--key",
                        (folder / "none.key").string(), "--allow", (folder / "none.pub").string()});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_NE(missing.output.find("`shoal host keygen` makes one"), std::string::npos)
      << missing.output;
}

TEST(FarHost, StepsAlmostOncePerRoundTrip) {
  HostFarm farm(1);
  const DelayingProxy proxy(farm.PortOf(0), 0.010);
  const std::string mission = farm.Placed("alpha.toml", {"\"alpha\""}, kPatient,
                                          {"tcp://127.0.0.1:" + std::to_string(proxy.port())});
  Shorten(mission, 60);
  const std::string dir = (farm.folder / "rec").string();
  const Finished finished = farm.Run(mission, {"--record", dir});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == LogOfSim(farm.folder, mission));
  const size_t at = finished.output.find("answers after ");
  ASSERT_NE(at, std::string::npos) << finished.output;
  EXPECT_GE(std::atof(finished.output.c_str() + at + 14), 20.0) << finished.output;
}

}  // namespace shoal::run_on_hosts_test
