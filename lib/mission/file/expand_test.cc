// Templates, fleets and overrides, as seen through the loader.
#include "lib/mission/file/expand.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "lib/mission/file/load_testing.h"

namespace shoal::expand_test {

constexpr std::string_view kFleet = R"([mission]
duration_s = 60
[template.scout]
length_m = 4
color = "orange"
start = {heading_deg = 45, speed_mps = 1}
[[template.scout.task]]
name = "sweep"
kind = "waypoints"
points_frame = "start"
points = [[0, 10]]
[[vehicle]]
name = "lead"
template = "scout"
color = "red"
start = {x_m = -5}
[[fleet]]
template = "scout"
name = "scout_{n:02}"
count = 5
columns = 2
spacing_m = 30
origin = {x_m = 100, y_m = 10}
)";

Mission LoadFleet(const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded = LoadMissionText(kFleet, "m.toml", overrides);
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  return loaded.mission;
}

TEST(Templates, AreLaidUnderAVehicleKeyByKey) {
  const Mission mission = LoadFleet();
  const Vehicle& lead = mission.vehicles.at(0);
  EXPECT_EQ(lead.name, "lead");
  EXPECT_EQ(lead.length_m, 4);
  EXPECT_EQ(lead.color, "red");
  EXPECT_EQ(lead.start, (StartPose{.x_m = -5, .heading_deg = 45, .speed_mps = 1}));
}

TEST(Templates, LoseTheirTasksToAVehicleWithTasksOfItsOwn) {
  const LoadedMission loaded = LoadMissionText(R"([mission]
duration_s = 60
[[template.scout.task]]
name = "sweep"
kind = "station_keep"
[[vehicle]]
name = "alpha"
template = "scout"
[[vehicle.task]]
name = "own"
kind = "station_keep"
)",
                                               "m.toml");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  ASSERT_EQ(loaded.mission.vehicles.at(0).tasks.size(), 1U);
  EXPECT_EQ(loaded.mission.vehicles.at(0).tasks[0].name, "own");
}

TEST(Templates, ReportAnErrorOnceForAllVehiclesThatInheritIt) {
  EXPECT_EQ(ErrorsAfter("[template.t]\nlenght = 3\n[[fleet]]\ntemplate = \"t\"\ncount = 9\n"),
            "6:1: unknown key 'lenght' (did you mean 'length_m'?)\n");
}

TEST(Templates, AreCheckedEvenWhereNoVehicleUsesThem) {
  EXPECT_EQ(ErrorsAfter("[template.t]\nlength_m = 0\nname = \"a\"\ntemplate = \"u\"\n"),
            "6:12: length_m = 0 is out of range; allowed: greater than 0, at most 500\n"
            "7:8: a template must not have a name; its vehicles have\n"
            "8:12: unknown template 'u'; add a table [template.NAME] with the keys that its "
            "vehicles share\n");
}

TEST(Templates, InheritFromTemplates) {
  const LoadedMission loaded = LoadMissionText(R"([mission]
duration_s = 60
[[vehicle]]
name = "alpha"
template = "diver"
start = {x_m = 5}
[template.diver]
template = "scout"
color = "red"
[template.scout]
template = "base"
start = {speed_mps = 1}
[[template.scout.task]]
name = "own"
kind = "station_keep"
[template.base]
length_m = 7
color = "orange"
start = {heading_deg = 45, speed_mps = 3}
[[template.base.task]]
name = "sweep"
kind = "station_keep"
)",
                                               "m.toml", {"template.base.length_m=8"});
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  const Vehicle& alpha = loaded.mission.vehicles.at(0);
  EXPECT_EQ(alpha.color, "red");
  EXPECT_EQ(alpha.length_m, 8);
  EXPECT_EQ(alpha.start, (StartPose{.x_m = 5, .heading_deg = 45, .speed_mps = 1}));
  ASSERT_EQ(alpha.tasks.size(), 1U);
  EXPECT_EQ(alpha.tasks[0].name, "own");
}

TEST(Templates, ThatInheritFromThemselvesAreRefused) {
  EXPECT_EQ(ErrorsAfter("[template.a]\ntemplate = \"a\"\n"),
            "6:12: a template must not inherit from itself: 'a' from 'a'\n");
  EXPECT_EQ(ErrorsAfter("template = \"c\"\n[template.a]\ntemplate = \"b\"\n"
                        "[template.b]\ntemplate = \"a\"\n[template.c]\ntemplate = \"a\"\n"),
            "7:12: a template must not inherit from itself: 'b' from 'a' from 'b'\n"
            "9:12: a template must not inherit from itself: 'a' from 'b' from 'a'\n");
}

TEST(Templates, ThatInheritFromNoneThatExistsAreRefused) {
  EXPECT_EQ(ErrorsAfter("[template.a]\ntemplate = \"base\"\n[template.bases]\n"),
            "6:12: unknown template 'base' (did you mean 'bases'?)\n");
  EXPECT_EQ(ErrorsAfter("[template.a]\ntemplate = 3\n"),
            "6:12: template must be a string in quotes, not a whole number\n");
}

TEST(Templates, ReportAnErrorOfTheirBaseOnce) {
  EXPECT_EQ(ErrorsAfter("[template.a]\ntemplate = \"b\"\n[template.b]\nlenght = 3\n"),
            "8:1: unknown key 'lenght' (did you mean 'length_m'?)\n");
}

TEST(Templates, CannotMultiplyByInheritance) {
  std::string text = "[[template.t0.task]]\nkind = \"waypoints\"\npoints = [[0,0]";
  for (int i = 0; i < 9000; ++i) text += ",[0,0]";
  text += "]\n";
  for (int i = 1; i < 100; ++i) {
    text += "[template.t" + std::to_string(i) + "]\ntemplate = \"t0\"\n";
  }
  EXPECT_NE(ErrorsAfter(text).find("more than 2000000 values in all templates together"),
            std::string::npos);
  std::string line = "[template.t0]\n";
  for (int i = 1; i < 102; ++i) {
    line +=
        "[template.t" + std::to_string(i) + "]\ntemplate = \"t" + std::to_string(i - 1) + "\"\n";
  }
  EXPECT_NE(ErrorsAfter(line).find("more than 100 templates inherit"), std::string::npos);
}

TEST(Templates, ThatAreUnknownAreReported) {
  EXPECT_EQ(ErrorsAfter("template = \"scuot\"\n[template.scout]\nlength_m = 1\n"),
            "5:12: unknown template 'scuot' (did you mean 'scout'?)\n");
  EXPECT_EQ(ErrorsAfter("template = \"scout\"\n"),
            "5:12: unknown template 'scout'; add a table [template.NAME] with the keys that its "
            "vehicles share\n");
  EXPECT_EQ(ErrorsAfter("template = 3\n"),
            "5:12: template must be a string in quotes, not a whole number\n");
}

TEST(Fleets, StandInRowsFromWestToEastAndSouthToNorth) {
  const Mission mission = LoadFleet();
  ASSERT_EQ(mission.vehicles.size(), 6U);
  const auto start = [&](size_t i) { return mission.vehicles.at(i).start; };
  EXPECT_EQ(mission.vehicles[1].name, "scout_01");
  EXPECT_EQ(mission.vehicles[5].name, "scout_05");
  EXPECT_EQ(start(1), (StartPose{.x_m = 100, .y_m = 10, .heading_deg = 45, .speed_mps = 1}));
  EXPECT_EQ(start(2), (StartPose{.x_m = 130, .y_m = 10, .heading_deg = 45, .speed_mps = 1}));
  EXPECT_EQ(start(5), (StartPose{.x_m = 100, .y_m = 70, .heading_deg = 45, .speed_mps = 1}));
}

TEST(Fleets, GiveEachVehicleItsOwnPoints) {
  const Mission mission = LoadFleet();
  const Vehicle& last = mission.vehicles.at(5);
  EXPECT_EQ(std::get<WaypointsTask>(last.tasks.at(0).what).points_m.at(0),
            Eigen::Vector2d(100, 80));
  EXPECT_EQ(last.return_task.point_m, Eigen::Vector2d(100, 70));
}

TEST(Fleets, StandInOneRowWithoutColumnsAndAreCalledBoatsWithoutAName) {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 1\n[template.t]\n[[fleet]]\ntemplate = \"t\"\ncount = 12\n", "m");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(loaded.mission.vehicles.at(11).name, "boat_12");
  EXPECT_EQ(loaded.mission.vehicles.at(11).start.x_m, 220);
  EXPECT_EQ(loaded.mission.vehicles.at(11).start.y_m, 0);
}

TEST(Fleets, ReportWhatIsWrongWithThem) {
  EXPECT_EQ(ErrorsAfter("[template.t]\n[[fleet]]\ntemplate = \"t\"\nname = \"boat\"\ncount = 3\n"),
            "8:8: the name 'boat' of a fleet must hold its number: boat_{n}, or boat_{n:02} for "
            "boat_01, boat_02, ...\n");
  EXPECT_EQ(ErrorsAfter("[[fleet]]\ncont = 3\n"),
            "5:1: fleet lacks 'count'; for example: count = 10\n"
            "5:1: fleet lacks 'template'; for example: template = \"survey_boat\", together with a "
            "[template.survey_boat]\n"
            "6:1: unknown key 'cont' (did you mean 'count'?)\n");
}

TEST(Fleets, AreLimitedToTenThousandVehicles) {
  const auto with = [](const std::string& count) {
    return ErrorsAfter("[template.t]\n[[fleet]]\ntemplate = \"t\"\ncount = " + count + "\n");
  };
  EXPECT_EQ(with("10000"), "6:1: more than 10000 vehicles, the most that a mission can have\n");
  EXPECT_EQ(with("10001"), "8:9: count = 10001 is out of range; allowed: 1 to 10000\n");
}

TEST(Fleets, CannotMultiplyAGiantTemplate) {
  std::string points = "[0,0]";
  for (int i = 0; i < 1000; ++i) points += ",[0,0]";
  EXPECT_EQ(ErrorsAfter("[[template.t.task]]\nkind = \"waypoints\"\npoints = [" + points +
                        "]\n[[fleet]]\ntemplate = \"t\"\ncount = 9000\n"),
            "8:1: more than 2000000 values in all vehicles together; make the templates smaller or "
            "the fleets fewer\n");
}

TEST(Overrides, ChangeOrAddKeysOfTheFile) {
  const Mission mission =
      LoadFleet({"mission.seed=7", "mission.name=second", "comms.comms_range=nolimit",
                 "environment.current={speed_mps = 0.5}", "fleet.1.count=2",
                 "environment.current.direction_deg=90"});
  EXPECT_EQ(mission.seed, 7U);
  EXPECT_EQ(mission.name, "second");
  EXPECT_EQ(mission.comms.comms_range_m, -1);
  EXPECT_EQ(mission.environment.current.speed_mps, "0.5");
  EXPECT_EQ(mission.environment.current.direction_deg, "90");
  EXPECT_EQ(mission.vehicles.size(), 3U);
}

TEST(Overrides, NameVehiclesByTheirFinalNameAndTasksByTheirs) {
  const Mission mission =
      LoadFleet({"vehicle.SCOUT_03.start.x_m=5", "vehicle.lead.helm=none",
                 "vehicle.lead.task.sweep.speed_mps=2.5", "vehicle.2.length_m=9",
                 "vehicle.lead.reporter.extra.\"A.B\"=\"c d\"", "template.scout.length_m=6"});
  EXPECT_EQ(mission.FindVehicle("scout_03")->start.x_m, 5);
  const Vehicle& lead = mission.vehicles.at(0);
  EXPECT_EQ(lead.helm, Provider::kNone);
  EXPECT_EQ(std::get<WaypointsTask>(lead.tasks.at(0).what).speed_mps, 2.5);
  EXPECT_EQ(lead.reporter_options.extra.at("A.B"), "c d");
  EXPECT_EQ(lead.length_m, 6);
  EXPECT_EQ(mission.vehicles.at(1).length_m, 9);
}

TEST(Overrides, FindATaskOrABehaviorWithoutANameByItsKind) {
  const std::string text = std::string(kShortest) +
                           "[[vehicle.task]]\nkind = \"loiter\"\ncenter = [1, 2]\n"
                           "[[vehicle.task]]\nname = \"loiter_2\"\nkind = \"loiter\"\n"
                           "center = [1, 2]\n"
                           "[[vehicle.behavior]]\nkind = \"max_speed\"\nmax_speed = 2\n";
  const LoadedMission loaded = LoadMissionText(
      text, "m", {"vehicle.alpha.task.loiter.radius_m=7", "vehicle.1.behavior.max_speed.pwt=8"});
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  const Vehicle& vehicle = loaded.mission.vehicles.at(0);
  EXPECT_EQ(std::get<LoiterTask>(vehicle.tasks.at(0).what).radius_m, 7);
  EXPECT_EQ(std::get<LoiterTask>(vehicle.tasks.at(1).what).radius_m, LoiterTask().radius_m);
  EXPECT_EQ(vehicle.behaviors.at(0).pwt, 8);
  EXPECT_EQ(LoadMissionText(text, "m", {"vehicle.alpha.task.loitre.radius_m=7"}).errors.at(0),
            "--set vehicle.alpha.task.loitre.radius_m=7: no task 'loitre' (did you mean "
            "'loiter'?)");
}

TEST(Overrides, CanGiveAVehicleAnotherTemplate) {
  EXPECT_EQ(ErrorsAfter("[template.t]\nlength_m = 7\n", {"vehicle.alpha.template=t"}), "");
  const LoadedMission loaded = LoadMissionText(
      std::string(kShortest) + "[template.t]\nlength_m = 7\n", "m", {"vehicle.alpha.template=t"});
  EXPECT_EQ(loaded.mission.vehicles.at(0).length_m, 7);
}

TEST(Overrides, AreNamedByTheirErrors) {
  EXPECT_EQ(ErrorsAfter("", {"comms.range=5"}),
            "--set comms.range=5: unknown key 'range' (did you mean 'comms_range'?)\n");
  EXPECT_EQ(
      ErrorsAfter("", {"mission.seed=-1"}),
      "--set mission.seed=-1: seed = -1 is out of range; allowed: 0 to 9223372036854775807\n");
  EXPECT_EQ(ErrorsAfter("", {"vehicle.alfa.start.x_m=5"}),
            "--set vehicle.alfa.start.x_m=5: no vehicle 'alfa' (did you mean 'alpha'?)\n");
  EXPECT_EQ(
      ErrorsAfter("", {"vehicle.7.length_m=5"}),
      "--set vehicle.7.length_m=5: no vehicle '7'; the file has 1 of them, numbered from 1\n");
  EXPECT_EQ(ErrorsAfter("", {"event.1.at_s=5"}),
            "--set event.1.at_s=5: there is no [[event]] to change\n");
  EXPECT_EQ(
      ErrorsAfter("", {"mission.duration_s.x=5"}),
      "--set mission.duration_s.x=5: 'duration_s' is a whole number; nothing lies below it\n");
}

TEST(Overrides, OfTemplatesThatAreNotThereAreReported) {
  EXPECT_EQ(ErrorsAfter("[template.scout]\nlength_m = 7\n", {"template.scuot.length_m=5"}),
            "--set template.scuot.length_m=5: no template 'scuot' (did you mean 'scout'?)\n");
  EXPECT_EQ(ErrorsAfter("[template.scout]\nlength_m = 7\n", {"template.kayak.start.x_m=5"}),
            "--set template.kayak.start.x_m=5: no template 'kayak'; the file has scout\n");
  EXPECT_EQ(ErrorsAfter("", {"template.kayak.length_m=5"}),
            "--set template.kayak.length_m=5: no template 'kayak'; the file has no "
            "[template.NAME]\n");
}

TEST(Overrides, WithoutAFormAreReported) {
  const std::string hint =
      ": not of the form key.path=value, such as mission.seed=7 or vehicle.alpha.helm=hand\n";
  for (const std::string bad : {"", "=", "=5", "a", "a.", "a.=5", ".a=5", "a b=5", "\"a=5"}) {
    EXPECT_EQ(ErrorsAfter("", {bad}), "--set " + bad + hint);
  }
  EXPECT_EQ(
      ErrorsAfter("", {"mission.name=my ship"}),
      "--set mission.name=my ship: 'my ship' is not a TOML value; a text with other characters "
      "than letters, digits and _-.:/ needs quotes: 'name=\"...\"'\n");
}

TEST(Overrides, CannotSetMoreThanOneValue) {
  EXPECT_EQ(
      ErrorsAfter("", {"mission.seed=1\n[comms]\ncomms_range=3"}),
      "--set mission.seed=1?[comms]?comms_range=3: '1?[comms]?comms_range=3' is not a TOML value; "
      "a text with other characters than letters, digits and _-.:/ needs quotes: "
      "'seed=\"...\"'\n");
}

TEST(Overrides, ComeAfterTheErrorsOfTheFileInTheirOwnOrder) {
  EXPECT_EQ(ErrorsAfter("lenght = 3\n", {"mission.sed=1", "a=1", "mission.seed=x"}),
            "5:1: unknown key 'lenght' (did you mean 'length_m'?)\n"
            "--set mission.sed=1: unknown key 'sed' (did you mean 'seed'?)\n"
            "--set a=1: unknown key 'a'; known here: mission, environment, comms, acoustics, "
            "medium, obstacle, beacon, "
            "template, vehicle, "
            "fleet, swarm, netsim, event, order, participant, host, expect\n"
            "--set mission.seed=x: seed must be a whole number, or \"random\", not 'x'\n");
}

}  // namespace shoal::expand_test
