// missions/micromodem.toml, with hosts that hold the dialogue which Goby's driver had with two
// other modems.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "lib/base/codec/base64.h"
#include "tests/golden/micromodem_lines.h"
#include "tests/golden/read_golden.h"
#include "tests/missions/shoal_process.h"
#include "tests/netsim/tcp_client.h"

namespace shoal::micromodem_test {

constexpr double kAbeLat_deg = 43.825;
constexpr double kBenLat_deg = 43.8304;
constexpr double kLon_deg = -70.33;
constexpr double kApart_m = (kBenLat_deg - kAbeLat_deg) * 111'110;

void AppendVarint(uint64_t value, std::vector<uint8_t>* bytes) {
  for (; value >= 0x80; value >>= 7) bytes->push_back(static_cast<uint8_t>(value | 0x80));
  bytes->push_back(static_cast<uint8_t>(value));
}

/// Returns a NetSimManagerRequest with one position, as a client writes it: id = 1, nav = 2 with
/// modem_tcp_port = 1, then time, lat, lon, depth, speed and heading.
std::string PositionLine(int modem_port, double lat_deg) {
  std::vector<uint8_t> nav = {1 << 3};
  AppendVarint(static_cast<uint64_t>(modem_port), &nav);
  const double values[] = {0, lat_deg, kLon_deg, 10, 1, 90};
  for (size_t i = 0; i < std::size(values); ++i) {
    nav.push_back(static_cast<uint8_t>((i + 2) << 3 | 1));
    std::array<uint8_t, sizeof(double)> bytes;
    std::memcpy(bytes.data(), &values[i], sizeof(double));  // Little-endian, as this machine is.
    nav.insert(nav.end(), bytes.begin(), bytes.end());
  }
  std::vector<uint8_t> request = {1 << 3, 1, 2 << 3 | 2};
  AppendVarint(nav.size(), &request);
  request.insert(request.end(), nav.begin(), nav.end());
  return "NETSIM|netsim.protobuf.NetSimManagerRequest|" + Base64(request) + "\n";
}

/// The host of one modem.
class Host {
 public:
  explicit Host(int port) : client_(port) {}

  void Give(const std::string& body) { client_.Send(NmeaSentence(body)); }
  /// Returns all that the modem has written so far: bodies, in the order of the lines.
  const std::vector<std::string>& Lines() {
    client_.Receive();
    const std::string& received = client_.received();
    for (size_t end; (end = received.find("\r\n", begin_)) != std::string::npos; begin_ = end + 2) {
      const std::string line = received.substr(begin_, end - begin_);
      lines_.push_back(line.substr(1, line.find('*') - 1));
    }
    return lines_;
  }

 private:
  TcpClient client_;
  size_t begin_ = 0;
  std::vector<std::string> lines_;
};

/// Returns what must be the same in the recording and in this mission: there are no transponders
/// here, and the modems are elsewhere.
std::string Comparable(const std::string& body) {
  if (body.starts_with("SNTTA")) return "SNTTA";
  const std::string line = ComparableLine(body);
  return line.starts_with("CAMPR") ? line.substr(0, line.rfind(',')) : line;
}

std::vector<std::string> ComparableLines(const std::vector<std::string>& bodies) {
  std::vector<std::string> lines;
  for (const std::string& body : bodies) lines.push_back(Comparable(body));
  return lines;
}

/// Waits until the mission listens there.
std::unique_ptr<TcpClient> ConnectTo(int port) {
  std::unique_ptr<TcpClient> client;
  AwaitThat([&] {
    client = std::make_unique<TcpClient>(port);
    return client->is_open();
  });
  return client;
}

TEST(MicroModemMission, HoldsTheRecordedDialogueWithTwoHosts) {
  const TestFolder folder;
  const int first = FreeTcpPorts(3);
  const std::string abe = std::to_string(first + 1);
  const std::string ben = std::to_string(first + 2);
  // Faster than the wall's clock, and as long as this test likes: nothing here depends on either.
  RunningProcess mission(
      folder,
      {Program("shoal"), "run", MissionFile("micromodem.toml"), "--warp", "10", "--set",
       "netsim.allow_warp=true", "--set", "mission.duration_s=100000", "--set",
       "netsim.port=" + std::to_string(first), "--set", "netsim.vehicle.abe.modem_tcp_port=" + abe,
       "--set", "netsim.vehicle.ben.modem_tcp_port=" + ben});
  ASSERT_TRUE(mission.WaitFor("x real time")) << mission.Output();
  const auto positions = ConnectTo(first);
  ASSERT_TRUE(positions->is_open()) << mission.Output();
  positions->Send(PositionLine(first + 1, kAbeLat_deg) + PositionLine(first + 2, kBenLat_deg));
  ASSERT_TRUE(AwaitThat([&] {
    positions->Receive();
    return std::ranges::count(positions->received(), '\n') == 2;
  }));
  // Once a step has passed, the broker knows them.
  EXPECT_NE(AwaitStatus(folder, "shore_broker", {"ABE: ", "BEN: "}), "");

  Host hosts[] = {Host(first + 1), Host(first + 2)};
  std::vector<std::string> expected[2];
  // As a vehicle simulator does: the broker forgets a vehicle that has been silent for 100 s.
  const std::string where =
      PositionLine(first + 1, kAbeLat_deg) + PositionLine(first + 2, kBenLat_deg);
  const auto answered = [&] {
    return AwaitThat([&] {
      positions->Send(where);
      positions->Receive();
      return hosts[0].Lines().size() >= expected[0].size() &&
             hosts[1].Lines().size() >= expected[1].size();
    });
  };
  bool has_patience = false;
  const auto recording = ReadGoldenJson("netsim/micromodem_mm1.json");
  for (const auto& row : recording["lines"]) {
    const int port = row["modem_port"].get<int>() == kRecordedPorts[0] ? 0 : 1;
    const std::string body = RecordedBody(row);
    if (row["dir"] == "modem>host") {
      expected[port].push_back(Comparable(body));
      continue;
    }
    ASSERT_TRUE(answered()) << "before " << body << "; the last lines: " << hosts[0].Lines().back()
                            << " and " << hosts[1].Lines().back() << "\n"
                            << mission.Output();
    if (body.starts_with("CCCYC") && !has_patience) {
      // A busy machine may be slower with frames than the modem's 2 s.
      for (int i : {0, 1}) {
        for (const char* key : {"CFG,DTO,3600", "CFG,PTO,3600"}) {
          hosts[i].Give(std::string("CC") + key);
          expected[i].push_back(std::string("CA") + key);
        }
      }
      has_patience = true;
      ASSERT_TRUE(answered()) << mission.Output();
    }
    hosts[port].Give(body);
  }
  ASSERT_TRUE(answered()) << mission.Output();
  for (int i : {0, 1}) EXPECT_EQ(ComparableLines(hosts[i].Lines()), expected[i]);
  for (const std::string& line : hosts[0].Lines()) {
    if (!line.starts_with("CAMPR")) continue;
    const double travel_s = std::strtod(line.substr(line.rfind(',') + 1).c_str(), nullptr);
    EXPECT_NEAR(travel_s, kApart_m / 1490, 0.01) << line;
  }
  mission.Signal(SIGINT);
  mission.Wait();
}

}  // namespace shoal::micromodem_test
