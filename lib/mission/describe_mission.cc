// The whole file, and the tables that every mission has once.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "lib/mission/describe.h"
#include "lib/mission/names.h"
#include "lib/mission/providers.h"
#include "lib/mission/suggest.h"

namespace shoal {
namespace {

constexpr int64_t kLatestStart_us = 9'000'000'000'000'000;  // In the year 2255.
constexpr size_t kMostArguments = 100;
constexpr size_t kMostCorners = 1000;

/// tick_s: whole microseconds, since mission time counts in them.
void DescribeTick(Fields& fields, int64_t& tick_us) {
  double tick_s = static_cast<double>(tick_us) / 1e6;
  fields.Number("tick_s", tick_s, Between(0.001, 10));
  tick_us = std::llround(tick_s * 1e6);
  if (std::abs(tick_s * 1e6 - static_cast<double>(tick_us)) > 1e-3) {
    fields.Refuse("tick_s", fmt::format("tick_s = {} is not a whole number of microseconds; the "
                                        "nearest is {}",
                                        tick_s, static_cast<double>(tick_us) / 1e6));
  }
}

/// duration_s: whole ticks, since a mission consists of them.
void DescribeDuration(Fields& fields, double& duration_s, int64_t tick_us) {
  fields.Require("duration_s", "duration_s = 600");
  fields.Number("duration_s", duration_s, Above(0, kLongest_s));
  const int64_t duration_us = std::llround(duration_s * 1e6);
  const bool whole_us = std::abs(duration_s * 1e6 - static_cast<double>(duration_us)) < 0.01;
  if (duration_s <= 0 || (whole_us && duration_us % tick_us == 0)) return;
  const auto seconds = [&](int64_t ticks) { return static_cast<double>(ticks * tick_us) / 1e6; };
  const int64_t ticks = static_cast<int64_t>(duration_s * 1e6) / tick_us;
  const std::string nearest =
      ticks == 0 ? fmt::format("the shortest is {}", seconds(1))
                 : fmt::format("the nearest are {} and {}", seconds(ticks), seconds(ticks + 1));
  fields.Refuse("duration_s",
                fmt::format("duration_s = {} is not a whole number of ticks of {} s; {}",
                            duration_s, seconds(1), nearest));
}

void DescribeRun(Fields& fields, Mission& mission) {
  constexpr std::array<std::pair<std::string_view, OnLoss>, 3> kOnLoss = {{
      {"end", OnLoss::kEnd},
      {"continue", OnLoss::kContinue},
      {"restart", OnLoss::kRestart},
  }};
  fields.Text("name", mission.name, {.min_length = 1, .max_length = 200});
  fields.Text("description", mission.description, {.max_length = 10'000, .many_lines = true});
  auto seed = static_cast<int64_t>(mission.seed);
  fields.Integer("seed", seed, 0, std::numeric_limits<int64_t>::max());
  mission.seed = static_cast<uint64_t>(seed);
  DescribeTick(fields, mission.tick_us);
  DescribeDuration(fields, mission.duration_s, mission.tick_us);
  fields.Integer("start_utime", mission.start_utime, 0, kLatestStart_us);
  fields.Inline("origin", [&](Fields& origin) {
    origin.Require("lat_deg", "lat_deg = 43.8253");
    origin.Number("lat_deg", mission.origin_lat_deg, Between(-90, 90));
    origin.Require("lon_deg", "lon_deg = -70.3304");
    origin.Number("lon_deg", mission.origin_lon_deg, Between(-180, 180));
  });
  fields.Pairs("op_area", mission.op_area_m, Between(-1e6, 1e6), kMostCorners);
  if (!mission.op_area_m.empty() && mission.op_area_m.size() < 3) {
    fields.Refuse("op_area",
                  "op_area needs three corners or more, like [[0, 0], [400, 0], [400, -300]]");
  }
  fields.Choice("on_loss", mission.on_loss, kOnLoss);
  fields.Number("participant_timeout_s", mission.participant_timeout_s, Between(0.1, 3600));
  fields.Choice("shore_broker", mission.broker, kProviders);
}

/// A group that nobody has is most likely misspelt.
void CheckIgnoredGroup(Fields& fields, const Mission& mission) {
  const std::string ignored = LowerCase(mission.comms.ignore_group);
  if (!fields.reading() || ignored.empty()) return;
  std::vector<std::string_view> groups;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (LowerCase(vehicle.group) == ignored) return;
    if (!vehicle.group.empty()) groups.push_back(vehicle.group);
  }
  fields.Warn("ignore_group", fmt::format("no vehicle of the mission is of group {}{}",
                                          Quoted(mission.comms.ignore_group),
                                          DidYouMean(mission.comms.ignore_group, groups)));
}

/// The names of a mission's vehicles: legal, and unique without regard to case.
class VehicleNames {
 public:
  void Check(Fields& fields, const std::string& name) {
    fields.Require("name", "name = \"alpha\"");
    if (!fields.Has("name", true)) return;
    const std::string problem = NameProblem(name);
    if (!problem.empty()) {
      fields.Refuse("name", problem);
    } else if (const auto [at, is_new] = first_.emplace(LowerCase(name), name); !is_new) {
      fields.Refuse("name", "a vehicle " + Quoted(at->second) +
                                " exists already; names must differ in more than case");
    }
  }

 private:
  std::map<std::string, std::string> first_;  ///< By lower case, as first written.
};

/// The names of participants, which must not be those of shoal's own processes.
class ParticipantNames {
 public:
  explicit ParticipantNames(const Mission& mission) : mission_(mission) {}

  void Check(Fields& fields, const std::string& name) {
    fields.Require("name", "name = \"my_planner\"");
    if (!fields.Has("name", true)) return;
    const std::string_view vehicle = VehicleOfProcess(name);
    const std::string problem = NameProblem(name);
    if (!problem.empty()) {
      fields.Refuse("name", problem);
    } else if (IsOwnProcess(name) || mission_.FindVehicle(vehicle) != nullptr) {
      fields.Refuse("name", "the name " + Quoted(name) + " is shoal's own: choose another");
    } else if (!taken_.insert(LowerCase(name)).second) {
      fields.Refuse("name", "a participant " + Quoted(name) +
                                " exists already; names must differ in more than case");
    }
  }

 private:
  const Mission& mission_;
  std::set<std::string> taken_;
};

}  // namespace

void ResolveVehicle(Fields& fields, std::string_view key, std::string& name, const Mission& mission,
                    bool or_all) {
  if (!fields.reading() || name.empty()) return;
  if (or_all && LowerCase(name) == "all") {
    name = "all";
    return;
  }
  if (const Vehicle* vehicle = mission.FindVehicle(name)) {
    name = vehicle->name;
    return;
  }
  std::vector<std::string_view> names;
  for (const Vehicle& vehicle : mission.vehicles) names.push_back(vehicle.name);
  std::string hint = DidYouMean(name, names);
  if (hint.empty()) {
    names.resize(std::min(names.size(), size_t{5}));
    hint = "; the mission has " + Joined(names) + (mission.vehicles.size() > 5 ? ", ..." : "");
    if (or_all) hint += ", or \"all\"";
  }
  fields.Refuse(key, "unknown vehicle " + Quoted(name) + hint);
}

std::vector<const Vehicle*> VehiclesNamed(const Mission& mission, std::string_view name_or_all) {
  std::vector<const Vehicle*> found;
  if (name_or_all != "all") {
    if (const Vehicle* vehicle = mission.FindVehicle(name_or_all)) found.push_back(vehicle);
    return found;
  }
  for (const Vehicle& vehicle : mission.vehicles) found.push_back(&vehicle);
  return found;
}

void Describe(Fields& file, Mission& mission) {
  file.Require("mission", "[mission], followed by duration_s = 600");
  file.Below("mission", [&](Fields& fields) { DescribeRun(fields, mission); });
  DescribeEnvironment(file, mission);
  const auto describe_comms = [&] {
    file.Below("comms", [&](Fields& fields) {
      Describe(fields, mission.comms);
      CheckIgnoredGroup(fields, mission);
      const bool has_acoustics = file.Has("acoustics", mission.acoustics.is_used);
      if (fields.reading() && !has_acoustics) CheckTrafficOverWater(fields, mission);
    });
  };
  file.Skip("comms");
  file.Skip("acoustics");
  if (!file.reading()) {
    describe_comms();
    DescribeAcoustics(file, mission);
  }

  file.Skip("template");
  file.Require("vehicle", "[[vehicle]], followed by name = \"alpha\"; or a [[fleet]]");
  VehicleNames vehicle_names;
  file.List("vehicle", mission.vehicles, [&](Fields& fields, Vehicle& vehicle) {
    Describe(fields, vehicle);
    vehicle_names.Check(fields, vehicle.name);
  });
  file.Skip("fleet");
  if (file.reading()) {  // These name groups of the vehicles, and ask how many they are.
    MarkSwarmLeader(file, mission);
    describe_comms();
    DescribeAcoustics(file, mission);
    CheckAcousticAddresses(file, mission);
    CheckReportsOverWater(file, mission);
    DescribeSwarm(file, mission);
    DescribeNetsim(file, mission);
    CheckUnderwaterTasks(file, mission);
  }

  if (!file.reading()) {
    DescribeSwarm(file, mission);
    DescribeNetsim(file, mission);
  }
  file.List("event", mission.events,
            [&](Fields& fields, Event& event) { Describe(fields, event, mission); });
  std::stable_sort(mission.events.begin(), mission.events.end(),
                   [](const Event& a, const Event& b) { return a.at_s < b.at_s; });
  WarnOfIdleTasks(file, mission);

  ParticipantNames participant_names(mission);
  file.List("participant", mission.participants, [&](Fields& fields, Participant& participant) {
    fields.Text("name", participant.name, {.max_length = 1000});
    fields.Texts("command", participant.command, kMostArguments);
    participant_names.Check(fields, participant.name);
  });

  file.List("expect", mission.expectations, [&](Fields& fields, Expectation& expectation) {
    Describe(fields, expectation, mission);
  });
}

}  // namespace shoal
