// netsim's protocol over a real socket, compared with what the original program answered and
// published.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "lib/mission/netsim/netsim_answer.h"
#include "tests/golden/read_golden.h"
#include "tests/netsim/served_clients.h"

namespace shoal::netsim_vectors_test {

using Json = nlohmann::json;
using Lines = std::vector<std::string>;

std::string EnvironmentName(const Json& id) {
  return "environment " + std::to_string(id.get<int>());
}

NetsimOptions OptionsOf(const Json& config) {
  NetsimOptions options;
  for (const Json& bounds : config["env_bounds"]) {
    options.environments.push_back({.name = EnvironmentName(bounds["environment_id"]),
                                    .lat_min_deg = bounds["lat_min"],
                                    .lat_max_deg = bounds["lat_max"],
                                    .lon_min_deg = bounds["lon_min"],
                                    .lon_max_deg = bounds["lon_max"],
                                    .depth_min_m = bounds.value("depth_min", 0.0),
                                    .depth_max_m = bounds["depth_max"]});
  }
  for (const Json& pair : config["sim_env_pair"]) {
    options.vehicles.push_back({.name = "vehicle",
                                .modem_tcp_port = pair["modem_tcp_port"],
                                .address = pair["endpoint_ip_address"],
                                .environment = EnvironmentName(pair["environment_id"])});
  }
  return options;
}

/// netsim_manager as a mission would run it, and what it let in.
struct Manager {
  NetsimOptions options;
  std::vector<NetsimPosition> positions = {};
  std::vector<NetsimReceiveStats> stats = {};
  NetsimCounts counts = {};
  int64_t now_us = 0;
  std::unique_ptr<LineServer> server = {};

  explicit Manager(const NetsimOptions& given) : options(given) {
    server = ListenOrFail(
        {.idle_timeout_us = static_cast<int64_t>(options.idle_timeout_s * 1e6)},
        static_cast<size_t>(options.max_line_bytes), [this](const auto& address, auto line) {
          NetsimReply reply = AnswerLine(line, address, options);
          counts.Add(reply.outcome);
          positions.insert(positions.end(), reply.positions.begin(), reply.positions.end());
          stats.insert(stats.end(), reply.stats.begin(), reply.stats.end());
          return reply.answer;
        });
  }
};

const Json& Golden() {
  static const Json golden = ReadGoldenJson("netsim/vectors.json");
  return golden;
}

std::string BytesOf(const Json& hex) {
  const std::vector<uint8_t> bytes = FromHex(hex);
  return {bytes.begin(), bytes.end()};
}

void SendStep(const Json& step, Manager* manager, TcpClient* client) {
  const std::string bytes = BytesOf(step["send_hex"]);
  if (!step.value("one_byte_segments", false)) {
    EXPECT_EQ(client->Send(bytes), bytes.size());
    return;
  }
  for (const char byte : bytes) {
    client->Send(std::string(1, byte));
    manager->server->Serve(manager->now_us);
  }
}

/// Plays a recorded connection; returns all that the server sent on it, or nothing where the
/// client went without listening.
std::string Play(const Json& connection, Manager* manager) {
  TcpClient client(manager->server->port(), connection["source_ip"]);
  EXPECT_TRUE(client.is_open());
  for (const Json& step : connection["steps"]) {
    if (step.contains("send_hex")) SendStep(step, manager, &client);
    const double pause_s = step.value("expect_silence_s", step.value("wait_s", 0.0));
    manager->now_us += static_cast<int64_t>(pause_s * 1e6);
    manager->server->Serve(manager->now_us);
    if (step.value("do", "") == "close") client.Close();
    if (step.value("do", "") == "close_with_RST") client.Reset();
  }
  const std::string received =
      client.is_open() ? ReceiveAll(manager->server.get(), manager->now_us, &client) : "";
  EXPECT_TRUE(ServeUntil(manager->server.get(), manager->now_us,
                         [&] { return manager->server->num_clients() == 0; }));
  return received;
}

Lines PlayAll(const Json& vector, Manager* manager) {
  Lines received;
  for (const Json& connection : vector["connections"]) {
    received.push_back(Play(connection, manager));
  }
  return received;
}

Lines RecordedAnswers(const Json& vector) {
  Lines all;
  for (const Json& connection : vector["connections"]) {
    std::string expected;
    for (const Json& step : connection["steps"]) {
      if (!step.contains("expect_lines")) continue;
      for (const std::string line : step["expect_lines"]) expected += line + "\n";
    }
    all.push_back(expected);
  }
  return all;
}

/// Compares with "... nav { modem_tcp_port: 62000 time: 0 lat: 41.5 ... }".
void ExpectPublished(const NetsimPosition& position, const std::string& recorded) {
  const auto number = [&](const std::string& name) {
    std::smatch match;
    EXPECT_TRUE(std::regex_search(recorded, match, std::regex(" " + name + R"(: (\S+))")))
        << name << " in " << recorded;
    return std::stod(match[1]);
  };
  EXPECT_EQ(position.nav.modem_tcp_port, number("modem_tcp_port")) << recorded;
  EXPECT_DOUBLE_EQ(position.nav.time_s, number("time")) << recorded;
  EXPECT_DOUBLE_EQ(position.nav.lat_deg, number("lat")) << recorded;
  EXPECT_DOUBLE_EQ(position.nav.lon_deg, number("lon")) << recorded;
  EXPECT_DOUBLE_EQ(position.nav.depth_m, number("depth")) << recorded;
  EXPECT_DOUBLE_EQ(position.nav.speed_mps, number("speed")) << recorded;
  EXPECT_DOUBLE_EQ(position.nav.heading_deg, number("heading")) << recorded;
}

TEST(NetsimVectors, AreAnsweredByteForByteWhereTheOriginalIsRight) {
  int num_vectors = 0;
  for (const Json& vector : Golden()["vectors"]) {
    if (vector["class"] != "conform") continue;
    SCOPED_TRACE(vector["name"].get<std::string>());
    ++num_vectors;
    Manager manager(OptionsOf(Golden()["config"]));
    EXPECT_EQ(PlayAll(vector, &manager), RecordedAnswers(vector));
    ASSERT_EQ(manager.positions.size(), vector["published"].size());
    for (size_t i = 0; i < manager.positions.size(); ++i) {
      ExpectPublished(manager.positions[i], vector["published"][i]);
    }
  }
  EXPECT_EQ(num_vectors, 29);
}

/// Responses: an id and a status, in base64.
std::string Responses(const Lines& base64) {
  std::string text;
  for (const std::string& each : base64) {
    text += "NETSIM|netsim.protobuf.NetSimManagerResponse|" + each + "\n";
  }
  return text;
}

/// What shoal answers where the original is wrong.
struct Advised {
  Lines responses;
  size_t num_positions;
};

const std::map<std::string, Advised> kAdvised = {
    {"accepted_id_over_32_bits", {{"CAUQAQ=="}, 1}},
    // Missing fields of stats: there is no status for this.
    {"stats_missing_required", {{}, 0}},
    {"stats_mm_stats_incomplete", {{}, 0}},
    // Strictly by line.
    {"one_pipe_then_good_same_segment", {{"CAUQAQ==", "CAUQAQ=="}, 2}},
    {"name_line_without_data_pipe_then_good", {{"CAUQAQ==", "CAYQAQ=="}, 2}},
    {"no_pipes_plus_half_request", {{"CAUQAQ=="}, 1}},
    {"wrapped_b64_request", {{"CAUQAQ=="}, 1}},
    // What cannot be decoded has no id to answer to.
    {"b64_empty", {{}, 0}},
    {"b64_truncated", {{}, 0}},
    {"b64_cut_one_char", {{}, 0}},
    {"b64_junk_inside", {{}, 0}},
    {"b64_wrapped_high_bytes", {{}, 0}},
    {"missing_id", {{}, 0}},
    {"preamble_ignored", {{}, 0}},
    // Nothing of an incomplete request is applied, and the answer shows where it failed.
    {"nav_missing_lat", {{"CG8QBA=="}, 0}},
    {"nav_missing_port", {{"CHAQAg=="}, 0}},
    {"nav_missing_heading_then_good", {{"CHEQBA=="}, 0}},
    {"region_nan_inf",
     {{"CFoQBA==", "CFsQBA==", "CFwQBA==", "CF0QBA==", "CF4QBA==", "CF8QBA=="}, 0}},
};

const Json& VectorOf(const std::string& name) {
  for (const Json& vector : Golden()["vectors"]) {
    if (vector["name"] == name) return vector;
  }
  ADD_FAILURE() << "no vector " << name;
  return Golden();
}

/// The server is as it was: a request is answered, and its position let in.
void ExpectUnharmed(Manager* manager) {
  const size_t num_positions = manager->positions.size();
  EXPECT_EQ(PlayAll(VectorOf("accepted_single"), manager), Lines{Responses({"CAcQAQ=="})});
  EXPECT_EQ(manager->positions.size(), num_positions + 1);
}

TEST(NetsimVectors, AreAnsweredAsAdvisedWhereTheOriginalIsWrong) {
  for (const auto& [name, advised] : kAdvised) {
    SCOPED_TRACE(name);
    const Json& vector = VectorOf(name);
    EXPECT_EQ(vector["class"], "quirk");
    Manager manager(OptionsOf(Golden()["config"]));
    EXPECT_EQ(PlayAll(vector, &manager), Lines{Responses(advised.responses)});
    EXPECT_EQ(manager.positions.size(), advised.num_positions);
    EXPECT_TRUE(manager.stats.empty());
    ExpectUnharmed(&manager);
  }
}

TEST(NetsimVectors, DoNoHarmByReset) {
  for (const char* name : {"rst_right_after_request", "rst_right_after_connect"}) {
    SCOPED_TRACE(name);
    Manager manager(OptionsOf(Golden()["config"]));
    PlayAll(VectorOf(name), &manager);
    EXPECT_LE(manager.positions.size(), 1U);
    ExpectUnharmed(&manager);
  }
}

TEST(NetsimVectors, AreAllHeldAgainstSomething) {
  size_t num_quirks = 0;
  for (const Json& vector : Golden()["vectors"]) num_quirks += vector["class"] == "quirk" ? 1 : 0;
  EXPECT_EQ(num_quirks, kAdvised.size() + 2);
}

TEST(NetsimVectors, AreAnsweredInAnyPieces) {
  const Json& vector = VectorOf("prec_first_failure_wins");
  for (const size_t size : {1U, 2U, 7U, 100U}) {
    Manager manager(OptionsOf(Golden()["config"]));
    TcpClient client(manager.server->port());
    const std::string bytes = BytesOf(vector["connections"][0]["steps"][0]["send_hex"]);
    for (size_t begin = 0; begin < bytes.size(); begin += size) {
      client.Send(std::string_view(bytes).substr(begin, size));
      manager.server->Serve(0);
    }
    EXPECT_EQ(Lines{ReceiveAll(manager.server.get(), 0, &client)}, RecordedAnswers(vector));
    EXPECT_EQ(manager.positions.size(), 1U);
  }
}

}  // namespace shoal::netsim_vectors_test
