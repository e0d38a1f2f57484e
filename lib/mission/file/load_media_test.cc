// Media and gateways in mission files: what is filled in, and what is refused, with the texts.
#include "lib/mission/file/load_media.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/mission/file/load_testing.h"

namespace shoal::load_media_test {

constexpr std::string_view kSea = R"([mission]
duration_s = 60
[comms]
reports_over = ["vhf", "acoustic"]
messages_over = "acoustic"
[[medium]]
name = "vhf"
kind = "radio"
range_m = "nolimit"
[[vehicle]]
name = "ship"
[[vehicle]]
name = "auv"
model = "remus100"
)";

using Names = std::vector<std::string>;

LoadedMission LoadSea(const std::string& more) {
  return LoadMissionText(std::string(kSea) + more, "m.toml");
}

/// Returns the errors of the sea with more, without the name of the file, one per line.
std::string ErrorsWith(const std::string& more) {
  std::string all;
  for (const std::string& error : LoadSea(more).errors) {
    all += error.substr(error.find(' ') + 1) + "\n";
  }
  return all;
}

TEST(Media, AreWhatTheTypeOfAVehicleHas) {
  const LoadedMission loaded = LoadSea("");
  ASSERT_EQ(loaded.errors, Names());
  const Mission& mission = loaded.mission;
  EXPECT_EQ(mission.comms.reports_over, Over("vhf,acoustic"));
  EXPECT_EQ(mission.comms.messages_over, Over("acoustic"));
  EXPECT_EQ(mission.media.at(0).radio.range_m, -1);
  EXPECT_EQ(mission.vehicles.at(0).media.names, (Names{"direct", "vhf"}));
  EXPECT_EQ(mission.vehicles.at(1).media.names, (Names{"direct", "acoustic", "vhf"}));
  EXPECT_TRUE(mission.acoustics.is_used);
}

TEST(Media, OfAGatewayAreWhatItForwardsFromAndTo) {
  const LoadedMission loaded = LoadSea(
      "[[vehicle]]\nname = \"buoy\"\nmodel = \"buoy\"\n"
      "gateway = {from = [\"acoustic\"], to = [\"vhf\"]}\n");
  ASSERT_EQ(loaded.errors, Names());
  const Vehicle& buoy = loaded.mission.vehicles.at(2);
  EXPECT_EQ(buoy.media.names, (Names{"direct", "vhf", "acoustic"}));
  EXPECT_TRUE(buoy.media.gateway.exists);
  EXPECT_EQ(buoy.type, "buoy");
  EXPECT_EQ(buoy.helm, Provider::kNone);
}

TEST(Media, AreThereForNoneWhereTheMissionHasNoneOfItsOwn) {
  const LoadedMission loaded = LoadMissionText(std::string(kShortest), "m.toml");
  EXPECT_FALSE(loaded.mission.HasMedia());
  EXPECT_TRUE(MediaOf(loaded.mission).of_vehicles.empty());
  EXPECT_TRUE(loaded.mission.vehicles.at(0).HasMedium("acoustic"));
}

TEST(Media, GoIntoALogAndComeBack) {
  const LoadedMission loaded = LoadSea(
      "[[vehicle]]\nname = \"buoy\"\nantenna_height_m = 6\n"
      "gateway = {from = [\"acoustic\"], to = [\"vhf\", \"direct\"], queue = 7}\n"
      "[[medium]]\nname = \"deep\"\nkind = \"acoustic\"\nsound_speed_mps = 1480\n");
  ASSERT_EQ(loaded.errors, Names());
  const MediaSetup setup = MediaOf(loaded.mission);
  const LoadedMedia again = LoadMediaText(ExplainMedia(setup), "log");
  EXPECT_EQ(again.errors, Names());
  EXPECT_EQ(again.setup, setup);
  EXPECT_EQ(setup.Names(), (Names{"direct", "acoustic", "vhf", "deep"}));
}

TEST(Media, TakeNamesOfTheirOwn) {
  EXPECT_EQ(
      ErrorsWith("[[medium]]\nname = \"direct\"\nkind = \"radio\"\n"),
      "every mission has a medium 'direct' (at once and without loss): choose another name\n");
  EXPECT_EQ(ErrorsWith("[[medium]]\nname = \"vhf\"\nkind = \"radio\"\n"),
            "a medium 'vhf' exists already; give each a name of its own\n");
  EXPECT_EQ(ErrorsWith("[[medium]]\nname = \"a+b\"\nkind = \"radio\"\n"),
            "'a+b' is not a name: a medium's has letters, digits and '_'\n");
}

TEST(Media, AreRefusedWhereThereAreNone) {
  EXPECT_EQ(ErrorsWith("media = [\"vfh\"]\n"),
            "unknown medium 'vfh' (did you mean 'vhf'?); one of: direct, acoustic, vhf\n");
  EXPECT_EQ(ErrorsWith("media = []\n"), "media names none; write media = [\"direct\"]\n");
}

TEST(Gateway, ForwardsBetweenMediaThatItHas) {
  EXPECT_EQ(ErrorsWith("media = [\"vhf\"]\ngateway = {from = [\"acoustic\"], to = [\"vhf\"]}\n"),
            "the gateway has no acoustic: write media = [\"vhf\", \"acoustic\"] in its "
            "[[vehicle]]\n");
  EXPECT_EQ(ErrorsWith("gateway = {from = [\"direct\"], to = [\"vhf\"]}\n"),
            "what comes by direct has reached everywhere already: leave it out\n");
  EXPECT_EQ(ErrorsWith("gateway = {from = [], to = [\"vhf\"]}\n"),
            "from names no medium; one of: direct, acoustic, vhf\n");
  EXPECT_EQ(ErrorsWith("node_reporter = \"none\"\n"
                       "gateway = {from = [\"acoustic\"], to = [\"vhf\"]}\n"),
            "the broker must know where a gateway is: let it have shoal's node_reporter\n");
}

TEST(Buoy, HasNoHelmAndNoTasks) {
  const std::string why = "a vehicle of model \"buoy\" is moored and has no helm: leave it out\n";
  const std::string buoy = "[[vehicle]]\nname = \"b\"\nmodel = \"buoy\"\n";
  EXPECT_EQ(ErrorsWith(buoy + "helm = \"shoal\"\n"), why);
  EXPECT_EQ(ErrorsWith(buoy + "helm = \"none\"\n"), "");
  EXPECT_EQ(ErrorsWith(buoy + "[[vehicle.task]]\nkind = \"station_keep\"\n"), why);
}

TEST(Direct, IsWarnedOfWhereVehiclesDive) {
  std::string text(kSea);
  const auto warnings = [](const std::string& mission) {
    std::string all;
    for (const std::string& warning : LoadMissionText(mission, "m.toml").warnings) {
      if (warning.find("by direct") != std::string::npos) all += warning + "\n";
    }
    return all;
  };
  EXPECT_EQ(warnings(text), "");
  text.replace(text.find("[\"vhf\", \"acoustic\"]"), 19, "\"direct\"");
  EXPECT_EQ(warnings(text),
            "m.toml:4:16: warning: auv receives reports by direct, at once and without loss, "
            "however deep it is; write reports_over = \"acoustic\", or a list of media without "
            "direct\n");
}

}  // namespace shoal::load_media_test
