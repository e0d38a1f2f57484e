// The whole file, and the tables that every mission has once.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/time/seconds.h"
#include "lib/mission/file/background_files.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/model/names.h"
#include "lib/mission/model/providers.h"

namespace shoal {
namespace {

constexpr int64_t kLatestStart_us = 9'000'000'000'000'000;  // In the year 2255.
constexpr size_t kMaxArguments = 100;
constexpr size_t kMaxCorners = 1000;

/// tick_s: whole microseconds, since mission time counts in them.
void DescribeTick(Fields& fields, int64_t& tick_us) {
  double tick_s = Seconds(tick_us);
  fields.Number("tick_s", tick_s, Between(0.001, 10));
  tick_us = Microseconds(tick_s);
  if (std::abs(tick_s * 1e6 - static_cast<double>(tick_us)) > 1e-3) {
    fields.Refuse("tick_s", fmt::format("tick_s = {} is not a whole number of microseconds; the "
                                        "nearest is {}",
                                        tick_s, Seconds(tick_us)));
  }
}

/// duration_s: whole ticks, since a mission consists of them.
void DescribeDuration(Fields& fields, double& duration_s, int64_t tick_us) {
  fields.Require("duration_s", "duration_s = 600");
  fields.Number("duration_s", duration_s, Above(0, kLongest_s));
  const int64_t duration_us = Microseconds(duration_s);
  const bool whole_us = std::abs(duration_s * 1e6 - static_cast<double>(duration_us)) < 0.01;
  if (duration_s <= 0 || (whole_us && duration_us % tick_us == 0)) return;
  const auto seconds = [&](int64_t ticks) { return Seconds(ticks * tick_us); };
  const int64_t ticks = static_cast<int64_t>(duration_s * 1e6) / tick_us;
  const std::string nearest =
      ticks == 0 ? fmt::format("the shortest is {}", seconds(1))
                 : fmt::format("the nearest are {} and {}", seconds(ticks), seconds(ticks + 1));
  fields.Refuse("duration_s",
                fmt::format("duration_s = {} is not a whole number of ticks of {} s; {}",
                            duration_s, seconds(1), nearest));
}

/// A number, or "random": then there is none yet.
void DescribeSeed(Fields& fields, Mission& mission) {
  if (fields.reading()) mission.draws_seed = fields.HoldsText("seed");
  if (mission.draws_seed) {
    std::string word = "random";
    fields.Text("seed", word, {.max_length = 100});
    if (word != "random") {
      fields.Refuse("seed", "seed must be a whole number, or \"random\", not '" + word + "'");
    }
    return;
  }
  auto seed = static_cast<int64_t>(mission.seed);
  fields.Integer("seed", seed, 0, std::numeric_limits<int64_t>::max());
  mission.seed = static_cast<uint64_t>(seed);
}

constexpr std::array<std::pair<std::string_view, OnLoss>, 3> kOnLoss = {{
    {"end", OnLoss::kEnd},
    {"continue", OnLoss::kContinue},
    {"restart", OnLoss::kRestart},
}};

void DescribeRun(Fields& fields, Mission& mission) {
  constexpr std::array<std::pair<std::string_view, CollisionVerdict>, 2> kCollisions = {{
      {"fail", CollisionVerdict::kFail},
      {"allowed", CollisionVerdict::kAllowed},
  }};
  constexpr std::array<std::pair<std::string_view, GroundingVerdict>, 2> kGrounding = {{
      {"fail", GroundingVerdict::kFail},
      {"allowed", GroundingVerdict::kAllowed},
  }};
  fields.Text("name", mission.name, {.min_length = 1, .max_length = 200});
  fields.Text("description", mission.description, {.max_length = 10'000, .many_lines = true});
  DescribeSeed(fields, mission);
  DescribeTick(fields, mission.tick_us);
  DescribeDuration(fields, mission.duration_s, mission.tick_us);
  fields.Integer("start_utime", mission.start_utime, 0, kLatestStart_us);
  fields.Inline("origin", [&](Fields& origin) {
    origin.Require("lat_deg", "lat_deg = 43.8253");
    origin.Number("lat_deg", mission.origin_lat_deg, Between(-90, 90));
    origin.Require("lon_deg", "lon_deg = -70.3304");
    origin.Number("lon_deg", mission.origin_lon_deg, Between(-180, 180));
  });
  fields.Pairs("op_area", mission.op_area_m, Between(-1e6, 1e6), kMaxCorners);
  if (!mission.op_area_m.empty() && mission.op_area_m.size() < 3) {
    fields.Refuse("op_area",
                  "op_area needs three corners or more, like [[0, 0], [400, 0], [400, -300]]");
  }
  constexpr size_t kMaxBackgrounds = 20;
  fields.Texts("backgrounds", mission.backgrounds, kMaxBackgrounds);
  for (const std::string& file : mission.backgrounds) {
    const std::string problem = BackgroundProblem(file);
    if (problem.empty()) continue;
    fields.Refuse("backgrounds", Quoted(file) + ": " + problem);
    break;
  }
  fields.Choice("collisions", mission.collisions, kCollisions);
  fields.Choice("grounding", mission.grounding, kGrounding);
  fields.Choice("on_loss", mission.on_loss, kOnLoss);
  fields.Number("participant_timeout_s", mission.participant_timeout_s, Between(0.1, 3600));
  fields.Choice("shore_broker", mission.broker, kProviders);
}

void DescribeHost(Fields& fields, HostOptions& host) {
  constexpr size_t kLongestPath = 1000;
  fields.Text("name", host.name, {.max_length = 64});
  fields.Require("name", "name = \"lab2\"");
  fields.Text("address", host.address, {.max_length = kLongestPath});
  if (!host.address.empty() && !host.address.starts_with("tcp://")) {
    fields.Refuse("address", "an address has the form tcp://10.0.0.2:7700");
  }
  fields.Text("key", host.key, {.max_length = kLongestPath});
  fields.Texts("vehicles", host.vehicles, kMaxVehicles);
  fields.Texts("participants", host.participants, kMaxVehicles);
  fields.Choice("on_loss", host.on_loss, kOnLoss);
  fields.Number("timeout_s", host.timeout_s, Between(0.1, 3600));
}

void DescribeNetsim(Fields& file, Mission& mission) {
  if (!file.Has("netsim", mission.netsim.has_value())) return;
  if (!mission.netsim) mission.netsim.emplace();
  file.Below("netsim", [&](Fields& fields) { Describe(fields, *mission.netsim); });
}

/// The modem of [acoustics] where that names none: modems of vehicles from outside are to work.
std::string_view DefaultModem(const Mission& mission) {
  if (!mission.netsim) return "";
  for (const NetsimVehicle& vehicle : mission.netsim->vehicles) {
    if (vehicle.modem != NetsimModem::kNone) return "whoi_micromodem";
  }
  return "";
}

}  // namespace

void Describe(Fields& file, Mission& mission) {
  file.Require("mission", "[mission], followed by duration_s = 600");
  file.Below("mission", [&](Fields& fields) { DescribeRun(fields, mission); });
  const double end_s = mission.duration_s > 0 ? mission.duration_s : kLongest_s;
  file.Below("environment", [&](Fields& fields) { Describe(fields, mission.environment); });
  file.Below("comms", [&](Fields& fields) { Describe(fields, mission.comms); });
  if (file.reading()) {
    // What [acoustics] leaves out depends on [netsim]. Errors list tables in the order of a file.
    for (const char* key :
         {"acoustics", "medium", "obstacle", "beacon", "template", "vehicle", "fleet", "swarm"})
      file.Skip(key);
    DescribeNetsim(file, mission);
  }
  if (file.Has("acoustics", mission.acoustics.is_used)) {
    const std::string folder = std::filesystem::path(mission.file).parent_path().string();
    file.Below("acoustics", [&](Fields& fields) {
      Describe(fields, mission.acoustics, folder, DefaultModem(mission));
    });
  }
  file.List("medium", mission.media, [&](Fields& fields, MediumOptions& medium) {
    Describe(fields, medium, std::filesystem::path(mission.file).parent_path().string());
  });
  file.List("obstacle", mission.obstacles,
            [](Fields& fields, Obstacle& obstacle) { Describe(fields, obstacle); });
  file.List("beacon", mission.beacons,
            [](Fields& fields, BeaconOptions& beacon) { Describe(fields, beacon); });
  file.Skip("template");
  file.Require("vehicle", "[[vehicle]], followed by name = \"alpha\"; or a [[fleet]]");
  file.List("vehicle", mission.vehicles, [](Fields& fields, Vehicle& vehicle) {
    Describe(fields, vehicle);
    fields.Require("name", "name = \"alpha\"");
  });
  file.Skip("fleet");
  DescribeSwarms(file, mission.swarms);
  if (!file.reading()) DescribeNetsim(file, mission);
  file.List("event", mission.events,
            [&](Fields& fields, Event& event) { Describe(fields, event, end_s); });
  file.List("order", mission.orders,
            [](Fields& fields, NamedOrder& order) { Describe(fields, order); });
  file.List("participant", mission.participants, [](Fields& fields, Participant& participant) {
    fields.Text("name", participant.name, {.max_length = 1000});
    fields.Require("name", "name = \"my_planner\"");
    fields.Texts("command", participant.command, kMaxArguments);
  });
  file.List("host", mission.hosts, DescribeHost);
  file.List("expect", mission.expectations, [&](Fields& fields, Expectation& expectation) {
    Describe(fields, expectation, end_s);
  });
}

}  // namespace shoal
