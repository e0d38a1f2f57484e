// netsim_manager between real sockets and a bus in memory: what a client sends reaches the mission,
// and what the water brings reaches the client.
#include <gtest/gtest.h>
#include <poll.h>

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/netsim_manager/netsim_manager_app.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/sea/modem/micromodem_packet.h"
#include "tests/netsim/tcp_client.h"

namespace shoal::netsim_manager_test {

constexpr int64_t kTick_us = 100'000;
/// The request of netsim's documentation: port 62003 at 71.17647, -142.40124, 0.3 m, 0.0011 m/s,
/// heading 15.
constexpr std::string_view kDocumented =
    "NETSIM|netsim.protobuf.NetSimManagerRequest|CEISOgiz5AMRQ4tUIbbq10EZQUDRT0vLUUAhQylH7tbMYcAp"
    "MzMzMzMz0z8x65lyHNEpUj85AAAAAAAALkA=\n";
/// Its answer: request 66, accepted.
constexpr std::string_view kAccepted = "NETSIM|netsim.protobuf.NetSimManagerResponse|CEIQAQ==\n";
constexpr std::string_view kOutOfRegion = "NETSIM|netsim.protobuf.NetSimManagerResponse|CEIQBA==\n";

Mission OutsideMission(NetsimModem modem) {
  Mission mission;
  mission.origin_lat_deg = 71.17;
  mission.origin_lon_deg = -142.4;
  mission.acoustics.is_used = true;
  mission.acoustics.crc = false;
  Vehicle vehicle;
  vehicle.name = "outsider";
  vehicle.type = "ship";
  vehicle.acoustic_address = 5;
  mission.vehicles = {vehicle};
  NetsimOptions netsim;
  netsim.port = 0;
  netsim.environments = {{.name = "arctic",
                          .lat_min_deg = 71,
                          .lat_max_deg = 72,
                          .lon_min_deg = -143,
                          .lon_max_deg = -142,
                          .depth_max_m = 100}};
  NetsimVehicle outsider;
  outsider.name = "outsider";
  outsider.environment = "arctic";
  outsider.modem = modem;
  // With a modem, its port is one that the system finds; the documented request is for 62003.
  outsider.modem_tcp_port = modem == NetsimModem::kNone ? 62'003 : 0;
  netsim.vehicles = {outsider};
  mission.netsim = netsim;
  return mission;
}

/// What this test sets of an acoustic_path_t.
struct Path {
  int64_t packet = 0;
  double air_s = 0;
  double snr_db = 0;
};

/// netsim_manager on a bus with a test that subscribes to what it publishes.
class Manager {
 public:
  explicit Manager(const Mission& mission) : app_(mission, hub_.Join("netsim_manager")) {
    EXPECT_EQ(app_.Fault(), "");
    Subscribe(test_bus_, channels::NodeReportFromOutside(),
              [this](const node_report_t& report) { reports_.push_back(report); });
    Subscribe(test_bus_, channels::ModemTx(),
              [this](const modem_tx_t& packet) { packets_.push_back(packet); });
    Subscribe(test_bus_, channels::ModemStats(),
              [this](const modem_stats_t& stats) { stats_.push_back(stats); });
    Step();
  }

  void Step() {
    hub_.NextStep();
    hub_.HandleAll();
    app_.Tick(utime_);
    Serve(kTick_us);
    hub_.NextStep();
    hub_.HandleAll();
    utime_ += kTick_us;
  }
  /// Serves between two steps, or after a stall, when `passed_us` have passed on the wall's clock.
  void Serve(int64_t passed_us) {
    wall_us_ += passed_us;
    utc_us_ += passed_us;
    app_.Serve(wall_us_, utc_us_);
  }
  /// Steps until `is_done`; false where that does not come.
  bool StepUntil(const std::function<bool()>& is_done) {
    for (int i = 0; i < 1000; ++i) {
      Step();
      if (is_done()) return true;
      pollfd served{.fd = app_.ServedFd(), .events = POLLIN, .revents = 0};
      poll(&served, 1, 1);
    }
    return false;
  }
  /// Steps until the client has received `num_bytes`.
  bool Receive(TcpClient* client, size_t num_bytes) {
    return StepUntil([&] {
      client->Receive();
      return client->received().size() >= num_bytes;
    });
  }
  /// Lets packet 7 of alpha arrive and, if `snr_db` is given, with it the fates of this step.
  void SendAcoustically(const std::vector<uint8_t>& bytes, int64_t travel_us,
                        std::optional<double> snr_db = std::nullopt, int bps = 1000) {
    acoustic_rx_t packet{};
    packet.utime = utime_;
    packet.source = "alpha";
    packet.number = 7;
    packet.sent_utime = utime_;
    packet.payload = bytes;
    packet.num_bytes = static_cast<int32_t>(bytes.size());
    packet.arrived_utime = packet.sent_utime + travel_us + packet.num_bytes * 8'000'000 / bps;
    Publish(test_bus_, channels::AcousticRx("outsider"), packet);
    if (!snr_db) return;
    // Reports and messages count apart, and the network counts all of them: 7 is its number of a
    // message, and packet 7 its ninth.
    comms_fates_t fates{};
    AddFate("packet", 7, {.packet = 9, .air_s = packet.num_bytes * 8.0 / bps, .snr_db = *snr_db},
            &fates);
    AddFate("report", 7, {.packet = 8, .air_s = 0.3, .snr_db = -4}, &fates);
    AddFate("message", 1, {.packet = 7, .air_s = 0.2, .snr_db = -6}, &fates);
    Publish(test_bus_, channels::CommsFates(), fates);
  }

  NetsimManagerApp& app() { return app_; }
  std::vector<node_report_t> reports_;
  std::vector<modem_tx_t> packets_;
  std::vector<modem_stats_t> stats_;

 private:
  static void AddFate(const std::string& kind, int64_t number, const Path& numbers,
                      comms_fates_t* fates) {
    fate_t fate{};
    fate.kind = kind;
    fate.source = "alpha";
    fate.destination = "outsider";
    fate.number = number;
    acoustic_path_t path{};
    path.packet = numbers.packet;
    path.air_s = numbers.air_s;
    path.snr_db = numbers.snr_db;
    fate.path = {path};
    fate.num_paths = 1;
    fates->fates.push_back(fate);
    ++fates->num_fates;
  }

  MemoryBus hub_;
  NetsimManagerApp app_;
  Bus& test_bus_ = hub_.Join("test");
  int64_t utime_ = 0;
  int64_t wall_us_ = 1'000'000'000;
  int64_t utc_us_ = 1'795'000'000'000'000;
};

TEST(NetsimManager, PublishesWhereAVehicleIs) {
  Manager manager(OutsideMission(NetsimModem::kNone));
  TcpClient client(manager.app().port());
  client.Send(kDocumented);
  ASSERT_TRUE(manager.Receive(&client, kAccepted.size()));
  EXPECT_EQ(client.received(), kAccepted);
  ASSERT_TRUE(manager.StepUntil([&] { return !manager.reports_.empty(); }));
  const node_report_t& report = manager.reports_[0];
  EXPECT_EQ(report.name, "outsider");
  EXPECT_EQ(report.type, "ship");
  EXPECT_NEAR(report.lat_deg, 71.17647, 1e-5);
  EXPECT_NEAR(report.y_m, 0.00647 * 111'580, 2) << "a degree of latitude is that long there";
  EXPECT_NEAR(report.x_m, -0.00124 * 36'060, 1);
  EXPECT_NEAR(report.depth_m, 0.3, 1e-12);
  EXPECT_NEAR(report.speed_mps, 0.0011, 1e-4);
  EXPECT_EQ(report.heading_deg, 15);
  EXPECT_EQ(report.mode, "NETSIM");
  manager.Step();
  EXPECT_EQ(manager.reports_.size(), 1U) << "each position once";
}

TEST(NetsimManager, LetsNoPositionPassThatIsRefused) {
  Mission mission = OutsideMission(NetsimModem::kNone);
  mission.netsim->environments[0].depth_max_m = 0.2;
  Manager manager(mission);
  TcpClient client(manager.app().port());
  client.Send(kDocumented);
  ASSERT_TRUE(manager.Receive(&client, kOutOfRegion.size()));
  EXPECT_EQ(client.received(), kOutOfRegion);
  for (int i = 0; i < 5; ++i) manager.Step();
  EXPECT_TRUE(manager.reports_.empty());
  EXPECT_NE(manager.app().Status().text.find("out of defined region: 1"), std::string::npos)
      << manager.app().Status().text;
}

TEST(NetsimManager, StatesTheWholeReasonOfARefusal) {
  Mission mission = OutsideMission(NetsimModem::kNone);
  mission.netsim->environments[0].name = "the water north of Utqiagvik and its lagoons";
  mission.netsim->vehicles[0].environment = mission.netsim->environments[0].name;
  mission.netsim->environments[0].depth_max_m = 0.2;
  Manager manager(mission);
  TcpClient client(manager.app().port());
  client.Send(kDocumented);
  ASSERT_TRUE(manager.Receive(&client, kOutOfRegion.size()));
  EXPECT_NE(manager.app().Status().text.find(
                "127.0.0.1: outsider: depth 0.3 is not from 0 to 0.2 (environment 'the water north "
                "of Utqiagvik and its lagoons')\n"),
            std::string::npos)
      << manager.app().Status().text;
}

TEST(NetsimManager, LetsNoPositionPassFromAnotherAddress) {
  Mission mission = OutsideMission(NetsimModem::kNone);
  mission.netsim->vehicles[0].address = "10.0.0.7";
  Manager manager(mission);
  TcpClient client(manager.app().port());
  client.Send(kDocumented);
  ASSERT_TRUE(manager.Receive(&client, kAccepted.size()));
  EXPECT_EQ(client.received(), "NETSIM|netsim.protobuf.NetSimManagerResponse|CEIQAw==\n");
  for (int i = 0; i < 5; ++i) manager.Step();
  EXPECT_TRUE(manager.reports_.empty());
}

TEST(NetsimManager, CarriesRawPayloadsThroughTheWaterBothWays) {
  Manager manager(OutsideMission(NetsimModem::kRaw));
  TcpClient modem(manager.app().ModemPortOf("outsider"));
  modem.Send(std::string("\0\5hello\0\3", 9));
  modem.Send("bye");
  ASSERT_TRUE(manager.StepUntil([&] { return manager.packets_.size() == 2; }));
  EXPECT_EQ(manager.packets_[0].source, "outsider");
  EXPECT_EQ(std::string(manager.packets_[0].payload.begin(), manager.packets_[0].payload.end()),
            "hello");
  const std::string welcome = "welcome";
  manager.SendAcoustically({welcome.begin(), welcome.end()}, 500'000);
  ASSERT_TRUE(manager.Receive(&modem, 9));
  EXPECT_EQ(modem.received(), std::string("\0\7welcome", 9));
}

TEST(NetsimManager, SendsThePiecesOfARawModemOneAfterTheOther) {
  Manager manager(OutsideMission(NetsimModem::kRaw));
  TcpClient modem(manager.app().ModemPortOf("outsider"));
  for (int i = 0; i < 2; ++i) modem.Send(std::string("\0\175", 2) + std::string(125, 'a'));
  ASSERT_TRUE(manager.StepUntil([&] { return manager.packets_.size() == 2; }));
  EXPECT_GT(manager.packets_[1].utime - manager.packets_[0].utime, 1'000'000) << "at 1000 bit/s";
}

TEST(NetsimManager, DropsWhatARawClientHadSentWhenItGoes) {
  Manager manager(OutsideMission(NetsimModem::kRaw));
  {
    TcpClient first(manager.app().ModemPortOf("outsider"));
    for (int i = 0; i < 20; ++i) first.Send(std::string("\0\175", 2) + std::string(125, 'a'));
    ASSERT_TRUE(manager.StepUntil([&] { return !manager.packets_.empty(); }));
  }
  const size_t num_sent = manager.packets_.size();
  EXPECT_LT(num_sent, 20U) << "each takes a second at 1000 bit/s";
  ASSERT_TRUE(manager.StepUntil(
      [&] { return manager.app().Status().text.find("no client") != std::string::npos; }));
  TcpClient second(manager.app().ModemPortOf("outsider"));
  second.Send(std::string("\0\1b", 3));
  ASSERT_TRUE(manager.StepUntil(
      [&] { return !manager.packets_.empty() && manager.packets_.back().num_bytes == 1; }));
  EXPECT_LE(manager.packets_.size(), num_sent + 2) << "the first client's are gone";
}

TEST(NetsimManager, HasOneClientForAModem) {
  Manager manager(OutsideMission(NetsimModem::kRaw));
  TcpClient first(manager.app().ModemPortOf("outsider"));
  manager.Step();
  TcpClient second(manager.app().ModemPortOf("outsider"));
  EXPECT_TRUE(manager.StepUntil([&] {
    second.Receive();
    return second.has_ended();
  }));
  first.Receive();
  EXPECT_FALSE(first.has_ended());
  const std::string page = manager.app().Status().text;
  EXPECT_NE(page.find("outsider: a second host at 127.0.0.1 was refused, one client per port\n"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("client at 127.0.0.1, 1 refused, 0 stalled"), std::string::npos) << page;
}

TEST(NetsimManager, KeepsTheCountsOfARawModemForItsNextClient) {
  Manager manager(OutsideMission(NetsimModem::kRaw));
  const auto shows = [&](std::string_view text) {
    return manager.StepUntil(
        [&] { return manager.app().Status().text.find(text) != std::string::npos; });
  };
  {
    TcpClient first(manager.app().ModemPortOf("outsider"));
    first.Send(std::string("\0\5hello\0\5he", 11));
    ASSERT_TRUE(shows("2 payloads taken"));
  }
  ASSERT_TRUE(shows("no client"));
  TcpClient second(manager.app().ModemPortOf("outsider"));
  ASSERT_TRUE(shows("client at"));
  EXPECT_TRUE(shows("1 payloads taken, 0 empty, 0 too long, 1 cut off"))
      << manager.app().Status().text;
  second.Send(std::string("\0\3bye", 5));
  EXPECT_TRUE(shows("2 payloads taken, 0 empty, 0 too long, 1 cut off"))
      << manager.app().Status().text;
}

TEST(NetsimManager, AnswersTheHostOfAMicroModemAndPings) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem));
  TcpClient host(manager.app().ModemPortOf("outsider"));
  host.Send("$CCCFG,SRC,5\r\n$CCMPC,5,9\r\n");
  ASSERT_TRUE(manager.StepUntil([&] { return !manager.packets_.empty(); }));
  host.Receive();
  EXPECT_NE(host.received().find("$CACFG,SRC,5"), std::string::npos) << host.received();
  EXPECT_NE(host.received().find("$CAMPC,5,9"), std::string::npos) << host.received();
  ASSERT_EQ(manager.packets_.size(), 1U);
  EXPECT_EQ(manager.packets_[0].data_rate_bps, 80);
  EXPECT_EQ(manager.packets_[0].num_bytes, 9) << "not filled up";
}

TEST(NetsimManager, ShowsHowFarTheModemsClocksAreBehindTheWall) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem));
  manager.Step();
  EXPECT_NE(manager.app().Status().text.find("Clocks of Micro-Modems: 0.0 s behind"),
            std::string::npos)
      << manager.app().Status().text;
  manager.Serve(400'000);
  manager.Step();
  EXPECT_TRUE(manager.app().Status().run_warnings.empty());
  manager.Serve(400'000);
  manager.Step();
  EXPECT_NE(manager.app().Status().text.find("Clocks of Micro-Modems: 0.8 s behind"),
            std::string::npos)
      << manager.app().Status().text;
  ASSERT_EQ(manager.app().Status().run_warnings.size(), 1U);
  EXPECT_NE(manager.app().Status().run_warnings[0].find("CCCLK"), std::string::npos);
}

TEST(NetsimManager, ReportsTravelTimeAndNoiseOfReceivedPacketsToTheHost) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem));
  TcpClient host(manager.app().ModemPortOf("outsider"));
  host.Send("$CCCFG,SRC,5\r\n$CCMPC,5,9\r\n");
  ASSERT_TRUE(manager.StepUntil([&] { return !manager.packets_.empty(); }));
  const MicroModemPacket reply = {
      .kind = MicroModemKind::kPingReply, .source = 9, .destination = 5};
  manager.SendAcoustically(EncodeMicroModemPacket(reply), 750'000, 23.0);
  EXPECT_TRUE(manager.StepUntil([&] {
    host.Receive();
    return host.received().find("$CACST") != std::string::npos;
  }));
  EXPECT_NE(host.received().find("$CAMPR,9,5,0.7500"), std::string::npos) << host.received();
  const std::string statistics = host.received().substr(host.received().find("$CACST"));
  EXPECT_NE(statistics.find(",23,"), std::string::npos) << statistics;
}

TEST(NetsimManager, FindsThePathOfAPacketByItsNumberAmongPackets) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem));
  TcpClient host(manager.app().ModemPortOf("outsider"));
  host.Send("$CCMPC,5,9\r\n");
  ASSERT_TRUE(manager.StepUntil([&] { return !manager.packets_.empty(); }));
  const MicroModemPacket reply = {
      .kind = MicroModemKind::kPingReply, .source = 9, .destination = 5};
  manager.SendAcoustically(EncodeMicroModemPacket(reply), 67'500, 23.0, 80);
  EXPECT_TRUE(manager.StepUntil([&] {
    host.Receive();
    return host.received().find("$CACST") != std::string::npos;
  }));
  EXPECT_NE(host.received().find("$CAMPR,9,5,0.0675"), std::string::npos) << host.received();
  const std::string statistics = host.received().substr(host.received().find("$CACST"));
  EXPECT_NE(statistics.find(",23,"), std::string::npos) << statistics;
  EXPECT_EQ(manager.app().Status().text.find("no fate"), std::string::npos);
}

TEST(NetsimManager, ShowsWhereAPacketHasNoFate) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem));
  const MicroModemPacket mini = {.kind = MicroModemKind::kMini, .source = 9, .destination = 5};
  manager.SendAcoustically(EncodeMicroModemPacket(mini), 67'500);
  for (int i = 0; i < 2; ++i) manager.Step();
  EXPECT_NE(manager.app().Status().text.find(
                "outsider: packet 7 of alpha has no fate in COMMS_FATES: its times assume 1000 "
                "bit/s, and its SNR is not known\n"),
            std::string::npos)
      << manager.app().Status().text;
}

TEST(NetsimManager, SendsThePacketsOfAMicroModemOneAfterTheOther) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem2));
  TcpClient host(manager.app().ModemPortOf("outsider"));
  const std::string flexible = "$CCTDP,9,5,0,0," + std::string(200, 'a') + "\r\n";
  host.Send(flexible + flexible + "$CCMUC,5,9,0001\r\n" + flexible);
  // Others' bytes have it served between steps, at any time. All packets are shorter than a step,
  // or no whole number of steps.
  for (int i = 0; i < 400 && manager.packets_.size() < 4; ++i) {
    manager.Step();
    for (int part = 0; part < 6; ++part) manager.Serve(15'000);
    pollfd served{.fd = manager.app().ServedFd(), .events = POLLIN, .revents = 0};
    poll(&served, 1, 1);
  }
  ASSERT_EQ(manager.packets_.size(), 4U);
  for (size_t i = 1; i < 4; ++i) {
    const modem_tx_t& before = manager.packets_[i - 1];
    const double air_us = 8e6 * before.num_bytes / before.data_rate_bps;
    // Nor in the very microsecond in which the one before has left: they would touch at a receiver.
    EXPECT_GT(static_cast<double>(manager.packets_[i].utime - before.utime), air_us) << i;
  }
}

TEST(NetsimManager, ForgetsTheHalfLineOfAHostThatHasGone) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem));
  {
    TcpClient first(manager.app().ModemPortOf("outsider"));
    first.Send("$CCCFG,SRC");
    for (int i = 0; i < 5; ++i) manager.Step();
  }
  for (int i = 0; i < 5; ++i) manager.Step();
  TcpClient second(manager.app().ModemPortOf("outsider"));
  second.Send("$CCCFQ,SRC\r\n");
  EXPECT_TRUE(manager.StepUntil([&] {
    second.Receive();
    return second.received().find("$CACFG,SRC,") != std::string::npos;
  })) << second.received();
}

TEST(NetsimManager, PassesOverTimesThatCannotBe) {
  Manager manager(OutsideMission(NetsimModem::kRaw));
  manager.SendAcoustically({1, 2, 3}, std::numeric_limits<int64_t>::min() / 2);
  for (int i = 0; i < 5; ++i) manager.Step();
  EXPECT_FALSE(manager.app().Status().run_warnings.empty());
}

TEST(NetsimManager, NamesThePortThatItCannotHave) {
  Manager manager(OutsideMission(NetsimModem::kNone));
  Mission mission = OutsideMission(NetsimModem::kNone);
  mission.netsim->port = manager.app().port();
  MemoryBus hub;
  const NetsimManagerApp second(mission, hub.Join("netsim_manager"));
  EXPECT_NE(second.Fault().find(std::to_string(manager.app().port())), std::string::npos)
      << second.Fault();
}

TEST(NetsimManager, OutlivesBytesThatAreNoLines) {
  Manager manager(OutsideMission(NetsimModem::kMicromodem));
  TcpClient client(manager.app().port());
  TcpClient host(manager.app().ModemPortOf("outsider"));
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>((i * 131) ^ (i >> 3));
  client.Send(bytes);
  host.Send(bytes);
  for (int i = 0; i < 20; ++i) manager.Step();
  EXPECT_TRUE(manager.reports_.empty());
  EXPECT_TRUE(manager.packets_.empty());
  EXPECT_EQ(manager.app().Fault(), "");
}

}  // namespace shoal::netsim_manager_test
