// [vehicle.autopilot] by the vehicle's model, and keys and tables that would have no effect.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load_testing.h"

namespace shoal::load_autopilot_test {

constexpr char kAuv[] = "model = \"remus100\"\n";

Remus100Options OptionsOf(const std::string& more) {
  const LoadedMission loaded = LoadMissionText(std::string(kShortest) + kAuv + more, "m.toml");
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  return std::get<Remus100Options>(loaded.mission.vehicles.at(0).model);
}

std::vector<std::string> WarningsOf(const std::string& text) {
  const LoadedMission loaded = LoadMissionText(text, "m.toml");
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  return WarningsBesideConduct(loaded);
}

/// A short mission of an AUV with these ticks.
std::string AuvWithTicks(const std::string& tick_s, const std::string& more) {
  return "[mission]\nduration_s = 60\ntick_s = " + tick_s +
         "\n[[vehicle]]\nname = \"alpha\"\nmodel = \"remus100\"\n" + more;
}

TEST(AutopilotOfARemus100, HasTheSetThatSuitsItsParameters) {
  EXPECT_EQ(GainsOf(OptionsOf("")), Remus100GainsNamed("default"));
  EXPECT_EQ(GainsOf(OptionsOf("remus100 = {parameters = \"munet\"}\n")),
            Remus100GainsNamed("munet"));
  EXPECT_EQ(GainsOf(OptionsOf("remus100 = {parameters = \"fossen\"}\n")),
            Remus100GainsNamed("default"))
      << "Fossen's own need ticks of 0.05 s or less";
}

TEST(AutopilotOfARemus100, TakesASetByNameAndSingleGainsOverIt) {
  const Remus100Options options =
      OptionsOf("[vehicle.autopilot]\ngains = \"fossen\"\nheading_kd = 3\nmax_pitch_deg = 12.5\n");
  Remus100Gains expected = Remus100GainsNamed("fossen");
  expected.heading_kd = 3;
  expected.max_pitch_deg = 12.5;
  EXPECT_EQ(GainsOf(options), expected);
}

TEST(AutopilotOfARemus100, IsTheSameAfterItWasExplained) {
  for (const std::string more :
       {"", "remus100 = {parameters = \"munet\"}\n", "autopilot = {gains = \"fossen\"}\n",
        "autopilot = {heading_kp = 2}\n"}) {
    const LoadedMission loaded = LoadMissionText(std::string(kShortest) + kAuv + more, "m.toml");
    const LoadedMission again = LoadMissionText(Explain(loaded.mission), "m.toml");
    ASSERT_TRUE(again.errors.empty()) << again.errors.front();
    EXPECT_EQ(again.mission.vehicles, loaded.mission.vehicles) << more;
  }
}

TEST(SetsOfGains, AreThoseOfTheirSources) {
  const Remus100Gains munet = Remus100GainsNamed("munet");
  EXPECT_EQ(munet.heading_kp, 7.5);
  EXPECT_EQ(munet.heading_ki, 0.75);
  EXPECT_EQ(munet.heading_kd, 15);
  EXPECT_EQ(munet.pitch_kp, 0.36);
  EXPECT_EQ(munet.depth_kp, 0.054);
  EXPECT_EQ(munet.depth_ki, 0.00216);
  EXPECT_EQ(munet.max_fin_deg, 30);
  EXPECT_EQ(munet.heave_kd, 0);
  const Remus100Gains fossen = Remus100GainsNamed("fossen");
  EXPECT_NEAR(fossen.heading_kp, 1.64, 1e-12);
  EXPECT_NEAR(fossen.heading_ki, 0.08, 1e-12);
  EXPECT_NEAR(fossen.heading_kd, 4.8, 1e-12);
  EXPECT_EQ(fossen.pitch_kp, 5);
  EXPECT_EQ(fossen.heave_kd, 5);
  EXPECT_NEAR(fossen.depth_ki, 0.001, 1e-15);
  EXPECT_EQ(Remus100GainsNamed("default").max_fin_deg, 15);
}

TEST(AutopilotOfARemus100, RefusesKeysOfSurfaceCraft) {
  const std::string errors = ErrorsAfter(std::string(kAuv) +
                                         "[vehicle.autopilot]\nheading_integral_limit_deg = 9\n"
                                         "speed_kp = 1\nspeed_ki = 1\n"
                                         "speed_integral_limit_pct = 1\n");
  const std::string refused = " (a key of surface craft, and this is a remus100: leave it out; ";
  const std::string speed = "its propeller turns as propeller_rpm or speed_mps take)\n";
  EXPECT_EQ(errors, "7:1: unknown key 'heading_integral_limit_deg'" + refused +
                        "max_fin_deg limits the whole deflection)\n" +
                        "8:1: unknown key 'speed_kp'" + refused + speed +
                        "9:1: unknown key 'speed_ki'" + refused + speed +
                        "10:1: unknown key 'speed_integral_limit_pct'" + refused + speed);
}

TEST(AutopilotOfASurfaceCraft, RefusesEachKeyOfARemus100) {
  for (const std::string key :
       {"heading_observer_hz", "pitch_kp", "pitch_ki", "pitch_kd", "heave_kd", "depth_kp",
        "depth_ki", "max_pitch_deg", "max_fin_deg"}) {
    EXPECT_EQ(ErrorsAfter("[vehicle.autopilot]\n" + key + " = 1\n"),
              "6:1: unknown key '" + key +
                  "' (a key of model = \"remus100\", and this is a surface craft: write that "
                  "model, or leave it out)\n");
    EXPECT_EQ(ErrorsAfter(std::string(kAuv) + "[vehicle.autopilot]\n" + key + " = 1\n"), "");
  }
  EXPECT_NE(ErrorsAfter("[vehicle.autopilot]\ngains = \"munet\"\n"), "");
}

TEST(AutopilotOfARemus100, RefusesGainsThatCannotBe) {
  const std::string table = std::string(kAuv) + "[vehicle.autopilot]\n";
  EXPECT_EQ(ErrorsAfter(table + "gains = \"muNet\"\nheading_kp = -1\nmax_fin_deg = 0\n"),
            "7:9: unknown gains 'muNet' (did you mean 'munet'?)\n"
            "8:14: heading_kp = -1 is out of range; allowed: 0 to 1000\n"
            "9:15: max_fin_deg = 0 is out of range; allowed: greater than 0, at most 80\n");
  EXPECT_EQ(ErrorsAfter(table + "pitch_kd = 0\nheave_kd = 1\n"),
            "8:12: heave_kd is damping beside pitch_kd: write pitch_kd = 0.1 or more\n");
}

TEST(Gains, ThatSwingTheFinsAtTheMissionsTicksAreWarnedOf) {
  const std::string munet = "remus100 = {parameters = \"munet\"}\n";
  EXPECT_TRUE(WarningsOf(AuvWithTicks("0.02", munet)).empty());
  const std::vector<std::string> warnings = WarningsOf(AuvWithTicks("0.1", munet));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("in ticks of 0.1 s these gains swing the rudder by up to 30 degrees: "
                             "write tick_s = 0.02 in [mission], or heading_kp = 2, heading_ki = "
                             "0.1, heading_kd = 4 in [vehicle.autopilot]"),
            std::string::npos)
      << warnings[0];
  const std::string weaker =
      "[vehicle.autopilot]\nheading_kp = 2\nheading_ki = 0.1\nheading_kd = 4\n";
  EXPECT_TRUE(WarningsOf(AuvWithTicks("0.1", munet + weaker)).empty());
  const std::string fossen = "[vehicle.autopilot]\ngains = \"fossen\"\n";
  EXPECT_TRUE(WarningsOf(AuvWithTicks("0.02", fossen)).empty());
  EXPECT_EQ(WarningsOf(AuvWithTicks("0.1", fossen)).size(), 1U);
  EXPECT_EQ(WarningsOf(AuvWithTicks("0.02", munet + fossen)).size(), 1U);
  EXPECT_TRUE(WarningsOf(AuvWithTicks("0.1", "")).empty());
}

TEST(TablesOfAnotherModel, AreWarnedOfInAVehicleAndFineInATemplateOfSeveralModels) {
  const std::vector<std::string> warnings =
      WarningsOf(std::string(kShortest) + "[vehicle.remus100]\nmax_depth_m = 30\n");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("[vehicle.remus100] has no effect, as the vehicle is a surface_craft: "
                             "write model = \"remus100\" in it, or leave the table out"),
            std::string::npos)
      << warnings[0];
  EXPECT_EQ(
      WarningsOf(std::string(kShortest) + kAuv + "surface_craft = {reverse_ratio = 1}\n").size(),
      1U);
  EXPECT_TRUE(WarningsOf("[mission]\nduration_s = 60\n[template.any]\nremus100 = {max_depth_m = "
                         "30}\nsurface_craft = {reverse_ratio = 1}\n[[vehicle]]\nname = \"a\"\n"
                         "template = \"any\"\n[[vehicle]]\nname = \"b\"\ntemplate = \"any\"\n"
                         "model = \"remus100\"\n")
                  .empty());
}

TEST(KeysOfATrack, ThatHaveNoEffectAreWarnedOf) {
  const auto warnings_of = [](const std::string& keys) {
    return WarningsOf(
        "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"b\"\nmodel = \"remus100\"\n[[vehicle]]\n"
        "name = \"a\"\nmodel = \"remus100\"\n[[vehicle.task]]\nkind = \"target_track\"\ntarget = "
        "\"b\"\n" +
        keys);
  };
  EXPECT_TRUE(warnings_of("r_safe_m = 9\nr_avoid_m = 41\nr_inner_m = 81\n").empty());
  EXPECT_EQ(warnings_of("on_silence = \"surface\"\n").size(), 1U);
  EXPECT_EQ(warnings_of("r_sonar_m = 30\n").size(), 1U);
  EXPECT_EQ(warnings_of("layers = [\"feed_forward\"]\nr_safe_m = 9\nr_avoid_m = 41\nr_inner_m = "
                        "81\nr_follow_m = 101\n")
                .size(),
            4U);
}

TEST(RecoveryOfMessages, IsWarnedOfWhereNoneAreReceived) {
  const std::vector<std::string> warnings =
      WarningsOf(std::string(kShortest) + "[vehicle.recovery]\ntime_stamp = [\"skip\"]\n");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("[vehicle.recovery] has no effect, as alpha is not in an acoustic "
                             "swarm"),
            std::string::npos)
      << warnings[0];
}

TEST(AutopilotOfARemus100, IsWarnedOfWhereLittleRudderTurnsItWiderThanItKeepsRoomFor) {
  const auto warnings = [](const std::string& fin_deg, const std::string& more) {
    std::string text;
    for (const std::string& each : WarningsOf(
             "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"bravo\"\nmodel = \"remus100\"\n"
             "[[vehicle]]\nname = \"alpha\"\nmodel = \"remus100\"\nsonar = {}\n"
             "autopilot = {max_fin_deg = " +
             fin_deg +
             "}\n"
             "[[vehicle.task]]\nkind = \"target_track\"\nname = \"follow\"\ntarget = \"bravo\"\n" +
             more)) {
      if (each.find("rudder it turns") != each.npos) text += each;
    }
    return text;
  };
  const std::string sonar = "layers = [\"sonar\", \"feed_forward\"]\n";
  EXPECT_EQ(warnings("15", sonar), "");
  EXPECT_EQ(warnings("14", ""), "") << "without echoes nothing is limited";
  EXPECT_EQ(warnings("14", sonar + "speed_along_bow = false\n"), "");
  EXPECT_EQ(warnings("14", sonar),
            "m.toml:10:28: warning: with 14 degrees of rudder it turns on a wider circle than the "
            "task 'follow' leaves room for before obstacles: write 15 or more, or keep its leader "
            "far from them");
}

}  // namespace shoal::load_autopilot_test
