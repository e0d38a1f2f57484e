// Whole helms, with conditions, flags, modes, updates and spawning, held against runs of MOOS-IvP's
// helm (tests/golden/README.md, helm/). Behaviors are read from the original's own texts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/check/bounds.h"
#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/behaviors/contact_ledger.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/file/behavior_update.h"
#include "tests/closed_loops/kinematic_vessel.h"
#include "tests/golden/read_golden.h"

namespace shoal::whole_helm_test {

using Json = nlohmann::json;

/// Returns a value of the scenario as an update writes it: a list as an array of texts.
std::string TextOfValue(const Json& value) {
  if (!value.is_array()) return value.get<std::string>();
  std::string text;
  for (const Json& each : value)
    text += (text.empty() ? "\"" : ", \"") + each.get<std::string>() + "\"";
  return "[" + text + "]";
}

/// Returns the key of a mission file; empty: it has none.
std::string KeyOf(const std::string& type, const std::string& key) {
  const bool is_waypoint = type == "Waypoint";
  if (key == "nm_radius") return "slip_radius";
  if (key == "radius" && is_waypoint) return "capture_radius";
  if (key == "polygon" && is_waypoint) return "points";
  const bool is_left_out = key == "type" || key == "name" || key == "updates" ||
                           key == "templating" || key == "use_refinery" || key == "contact";
  return is_left_out ? "" : key;
}

BehaviorOptions BehaviorOf(const Json& block) {
  const std::string type = block.at("type").get<std::string>();
  BehaviorOptions options = {.name = block.at("name").get<std::string>()};
  if (type == "Loiter") options.what = LoiterOptions();
  if (type == "AvdColregsV22") options.what = ColregsOptions();
  if (type == "StationKeep") options.what = StationKeepOptions();
  if (type == "OpRegionV24") options.what = OpRegionOptions();
  if (block.contains("updates")) options.updates = block.at("updates").get<std::string>();
  if (block.contains("templating")) options.templating = Templating::kSpawn;
  std::vector<UpdateItem> items;
  for (const auto& [key, value] : block.items()) {
    const std::string own_key = KeyOf(type, key);
    if (!own_key.empty()) items.push_back({own_key, TextOfValue(value)});
  }
  auto read = ReadBehaviorUpdate(options, items, {0, 0});
  EXPECT_TRUE(read.ok()) << options.name << ": " << read.error();
  return read.ok() ? *read : options;
}

HelmSetup SetupOf(const std::string& name, const Json& vehicle) {
  HelmSetup setup = {.vehicle = name, .read_update = ReadBehaviorUpdate};
  for (const auto& [variable, value] : vehicle.at("initialize").items()) {
    setup.variables[variable] = value.get<std::string>();
  }
  for (const Json& mode : vehicle.at("modes")) {
    ModeOptions options = {
        .set = mode.at("variable").get<std::string>() + " = " + mode.at("value").get<std::string>(),
        .condition = mode.at("conditions").get<std::vector<std::string>>()};
    if (mode.contains("else")) options.otherwise = mode.at("else").get<std::string>();
    setup.modes.push_back(options);
  }
  for (const Json& block : vehicle.at("behaviors")) setup.behaviors.push_back(BehaviorOf(block));
  const int num_speeds =
      static_cast<int>(vehicle.at("start").at("speed_domain_points").get<double>());
  setup.domain.speed_mps = {.first = 0, .step = 4.0 / (num_speeds - 1), .count = num_speeds};
  return setup;
}

/// Something that a helm posts, decides or sets off.
struct Happening {
  double time_s = 0;
  std::string vehicle;
  std::string what;
  std::string value;
};

struct Vessel {
  std::string name;
  VesselMotion motion = {};
  KinematicCommand command = {};
  ContactLedger ledger;
  BehaviorSet helm;
  std::map<std::string, VariableValue> posted = {};
  std::vector<std::pair<double, Eigen::Vector2d>> track_m = {};  ///< At 1 Hz.
};

/// Runs a scenario of scenarios.json in the sequence of the golden data.
class Scenario {
 public:
  explicit Scenario(const std::string& name)
      : scenario_(ReadGoldenJson("helm/scenarios.json").at(name)) {
    for (const auto& [vehicle, block] : scenario_.at("vehicles").items()) {
      const Json& start = block.at("start");
      const VesselMotion motion = {
          .position_m = {start.at("x_m").get<double>(), start.at("y_m").get<double>()},
          .heading_deg = start.at("heading_deg").get<double>(),
          .speed_mps = start.at("speed_mps").get<double>()};
      vessels.push_back({.name = vehicle,
                         .motion = motion,
                         .command = {.heading_deg = motion.heading_deg},
                         .ledger = ContactLedger(vehicle),
                         .helm = BehaviorSet(SetupOf(vehicle, block))});
    }
    const auto last =
        static_cast<int>(std::lround(scenario_.at("duration_s").get<double>() / kVesselStep_s));
    for (int step = 0; step <= last; ++step) Advance(step);
  }

  std::vector<std::string> ValuesOf(const std::string& vehicle, const std::string& what) const {
    std::vector<std::string> values;
    for (const Happening& each : happenings) {
      if (each.vehicle == vehicle && each.what == what) values.push_back(each.value);
    }
    return values;
  }
  const Vessel& Of(const std::string& name) const {
    return *std::find_if(vessels.begin(), vessels.end(),
                         [&](const Vessel& vessel) { return vessel.name == name; });
  }

  std::vector<Vessel> vessels;
  std::vector<Happening> happenings;
  double closest_m = kInfinity;

 private:
  void Advance(int step) {
    const double time_s = step * kVesselStep_s;
    if (step % 10 == 0) Report(time_s);
    for (Vessel& vessel : vessels) {
      if (step % 5 == 0) Decide(time_s, &vessel);
      if (step % 20 == 0) vessel.track_m.emplace_back(time_s, vessel.motion.position_m);
    }
    for (Vessel& vessel : vessels) vessel.motion = Step(vessel.motion, vessel.command);
    for (size_t i = 1; i < vessels.size(); ++i) {
      const Eigen::Vector2d apart_m =
          vessels[i].motion.position_m - vessels[i - 1].motion.position_m;
      closest_m = std::min(closest_m, apart_m.norm());
    }
  }

  void Report(double time_s) {
    for (Vessel& receiver : vessels) {
      for (const Vessel& source : vessels) {
        if (source.name == receiver.name) continue;
        const ContactIntake intake = receiver.ledger.Take(
            {.name = source.name, .motion = source.motion, .made_s = time_s, .received_s = time_s},
            receiver.motion.position_m);
        EXPECT_EQ(intake, ContactIntake::kTaken);
      }
    }
  }

  std::vector<ReceivedSetting> SettingsAt(double time_s, const std::string& vehicle) const {
    std::vector<ReceivedSetting> settings;
    for (const Json& post : scenario_.at("timed_posts")) {
      const double at_s = post.at("t_s").get<double>();
      const bool is_for_it = post.at("vehicle") == vehicle || post.at("vehicle") == "*";
      if (!is_for_it || std::abs(at_s - time_s) > kVesselStep_s / 2) continue;
      settings.push_back({post.at("variable").get<std::string>(),
                          ValueIn(post.at("value").get<std::string>()), "scenario"});
    }
    return settings;
  }

  void Decide(double time_s, Vessel* vessel) {
    const HelmOutcome outcome =
        vessel->helm.Iterate({.time_s = time_s,
                              .drives = true,
                              .own = OwnMotion{.motion = vessel->motion},
                              .contacts = &vessel->ledger.At(time_s, vessel->motion.position_m),
                              .settings = SettingsAt(time_s, vessel->name)});
    EXPECT_TRUE(outcome.warnings.empty()) << time_s << " s: " << outcome.warnings.front();
    if (outcome.has_decision) {
      vessel->command = {.heading_deg = outcome.commands.course_deg.value_or(0),
                         .speed_mps = outcome.commands.speed_mps.value_or(0)};
    } else if (!outcome.keeps_last) {
      vessel->command = {.heading_deg = vessel->motion.heading_deg, .speed_mps = 0};
    }
    for (const VariablePost& post : outcome.posts) {
      const auto last = vessel->posted.find(post.variable);
      if (last != vessel->posted.end() && last->second == post.value) continue;
      vessel->posted[post.variable] = post.value;
      happenings.push_back({time_s, vessel->name, post.variable, TextOf(post.value)});
    }
    for (const HelmEvent& event : outcome.events) {
      happenings.push_back({time_s, vessel->name, event.kind, event.text});
    }
  }

  Json scenario_;
};

/// Expects the golden happenings of these sorts, in their order, each within a tick.
void ExpectHappenings(const Scenario& scenario, const std::string& name,
                      const std::map<std::string, std::string>& own_names) {
  std::vector<Happening> golden;
  for (const GoldenRow& row : ReadGoldenCsv("helm/tracks/" + name + ".events.csv")) {
    const auto own = own_names.find(row.at("what"));
    if (own == own_names.end()) continue;
    golden.push_back({Number(row, "t"), row.at("vehicle"), own->second, row.at("value")});
  }
  EXPECT_FALSE(golden.empty());
  for (const auto& [what, own_name] : own_names) {
    std::vector<Happening> expected;
    std::vector<Happening> mine;
    const auto is_of_this_name = [&](const Happening& each) { return each.what == own_name; };
    std::copy_if(golden.begin(), golden.end(), std::back_inserter(expected), is_of_this_name);
    std::copy_if(scenario.happenings.begin(), scenario.happenings.end(), std::back_inserter(mine),
                 is_of_this_name);
    ASSERT_EQ(mine.size(), expected.size()) << what;
    for (size_t i = 0; i < mine.size(); ++i) {
      EXPECT_EQ(mine[i].value, expected[i].value) << what << " at " << mine[i].time_s;
      EXPECT_NEAR(mine[i].time_s, expected[i].time_s, 0.2501) << what;
    }
  }
}

void ExpectTrack(const Scenario& scenario, const std::string& name, double tolerance_m) {
  double farthest_m = 0;
  size_t num_compared = 0;
  for (const GoldenRow& row : ReadGoldenCsv("helm/tracks/" + name + ".csv")) {
    const Vessel& vessel = scenario.Of(row.at("vehicle"));
    const auto second = static_cast<size_t>(std::lround(Number(row, "t")));
    ASSERT_LT(second, vessel.track_m.size());
    const Eigen::Vector2d golden_m(Number(row, "x"), Number(row, "y"));
    farthest_m = std::max(farthest_m, (vessel.track_m[second].second - golden_m).norm());
    ++num_compared;
  }
  EXPECT_GT(num_compared, 100U);
  EXPECT_LE(farthest_m, tolerance_m);
  testing::Test::RecordProperty(name, std::to_string(farthest_m));
}

TEST(WholeHelm, GoesOverFromTheSurveyToTheReturnByFlags) {
  const Scenario scenario("s1_alpha");
  ExpectTrack(scenario, "s1_alpha", 0.5);
  ExpectHappenings(scenario, "s1_alpha",
                   {{"RETURN", "RETURN"}, {"MISSION", "MISSION"}, {"ALLSTOP", "all_stop"}});
}

TEST(WholeHelm, FollowsASquareAsABehaviorOfItsOwn) {
  const Scenario scenario("waypoint_alone");
  ExpectTrack(scenario, "waypoint_alone", 0.5);
  ExpectHappenings(scenario, "waypoint_alone", {{"ALLSTOP", "all_stop"}});
}

TEST(WholeHelm, TurnsBackAtTheBorderOfItsRegion) {
  const Scenario scenario("opregion_v24");
  EXPECT_EQ(scenario.ValuesOf("abe", "SAVE"), std::vector<std::string>{"true"});
  EXPECT_TRUE(scenario.ValuesOf("abe", "BREACH").empty());
}

// Chaotic: which vessel gives way hangs on small things. What must agree are kinds of happenings.
TEST(WholeHelm, KeepsTwoLoiterersApartWhoseCentresAreExchanged) {
  const Scenario scenario("m2_berta");
  EXPECT_GE(scenario.closest_m, 10);
  testing::Test::RecordProperty("closest_m", std::to_string(scenario.closest_m));
  const std::map<std::string, std::pair<std::string, Eigen::Vector2d>> vehicles = {
      {"abe", {"ben", {0, 0}}}, {"ben", {"abe", {40, 0}}}};
  for (const auto& [name, other_and_home] : vehicles) {
    const auto& [other, home_m] = other_and_home;
    EXPECT_EQ(scenario.ValuesOf(name, "mode"),
              (std::vector<std::string>{"MODE = ACTIVE:LOITERING", "MODE = ACTIVE:RETURNING",
                                        "MODE = ACTIVE:STATION-KEEPING"}));
    EXPECT_EQ(scenario.ValuesOf(name, "update").size(), 3U);
    const auto spawned = scenario.ValuesOf(name, "spawn");
    EXPECT_GE(spawned.size(), 3U);
    for (const std::string& each : spawned) EXPECT_EQ(each, "avdcol_" + other);
    EXPECT_LT((scenario.Of(name).motion.position_m - home_m).norm(), 12);
    EXPECT_EQ(scenario.ValuesOf(name, "AVOID"), std::vector<std::string>{"false"});
  }
}

}  // namespace shoal::whole_helm_test
