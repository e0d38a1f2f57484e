// What a mission file can get wrong about the acoustic network, with the exact texts.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/file/load_comms.h"
#include "lib/mission/file/load_testing.h"

namespace shoal::load_acoustics_errors_test {

/// Returns the errors of kShortest with [acoustics] in line 5 and these keys from line 6 on.
std::string ErrorsOfAcoustics(std::string_view keys) {
  return ErrorsAfter("[acoustics]\n" + std::string(keys));
}

constexpr std::string_view kEightVehicles = R"([mission]
duration_s = 60
[[fleet]]
template = "t"
count = 8
[template.t]
)";

TEST(LoadErrors, ReportAcousticNumbersOutOfTheirRange) {
  EXPECT_EQ(ErrorsOfAcoustics(R"(crc = 1
sound_speed_mps = 0
base_freq_khz = nan
guard_band_khz = -1
packet_loss = 1.5
bit_error_rate = 0.6
snr_slope = inf
broadcast_address = 1.5
half_duplex = "yes"
jitter = "gauss"
packet_loss_model = "sonar"
)"),
            "6:7: crc must be true or false, not a whole number\n"
            "7:19: sound_speed_mps = 0 is out of range; allowed: 1 to 100000\n"
            "8:17: base_freq_khz = nan is out of range; allowed: greater than 0, at most 100000\n"
            "9:18: guard_band_khz = -1 is out of range; allowed: 0 to 100000\n"
            "10:15: packet_loss = 1.5 is out of range; allowed: 0 to 1\n"
            "11:18: bit_error_rate = 0.6 is out of range; allowed: 0 to 0.5\n"
            "12:13: snr_slope = inf is out of range; allowed: 0 to 1000\n"
            "13:21: broadcast_address must be a whole number, not 1.5\n"
            "14:15: half_duplex must be true or false, not the string 'yes'\n"
            "15:10: unknown jitter 'gauss'; one of: uniform, off\n"
            "16:21: unknown packet_loss_model 'sonar' (did you mean 'sonar_simple'?)\n");
}

TEST(LoadErrors, ReportAnInvalidSea) {
  EXPECT_EQ(ErrorsOfAcoustics(R"([acoustics.sea]
temperature_degc = 31
salinity_ppt = -1
depth_m = 9000
ph = 5
shipping = 2
wind_mps = 41
absorption = "torp"
spreading_exponent = 0
temprature_degc = 3
)"),
            "7:20: temperature_degc = 31 is out of range; allowed: -2 to 30\n"
            "8:16: salinity_ppt = -1 is out of range; allowed: 0 to 40\n"
            "9:11: depth_m = 9000 is out of range; allowed: 0 to 8000\n"
            "10:6: ph = 5 is out of range; allowed: 6 to 9\n"
            "11:12: shipping = 2 is out of range; allowed: 0 to 1\n"
            "12:12: wind_mps = 41 is out of range; allowed: 0 to 40\n"
            "13:14: unknown absorption 'torp' (did you mean 'thorp'?)\n"
            "14:22: spreading_exponent = 0 is out of range; allowed: 0.5 to 4\n"
            "15:1: unknown key 'temprature_degc' (did you mean 'temperature_degc'?)\n");
}

TEST(LoadErrors, DemandASoundSpeedForBrackishWater) {
  EXPECT_EQ(ErrorsOfAcoustics("sea = {salinity_ppt = 10}\n"),
            "6:7: no sound speed is known for water of 10 ppt, since Mackenzie's equation begins "
            "at 25: write sound_speed_mps = 1450, or the measured speed, in [acoustics]\n");
  EXPECT_EQ(ErrorsOfAcoustics("sea = {salinity_ppt = 10}\nsound_speed_mps = 1430\n"), "");
}

TEST(LoadErrors, ReportTheArithmeticOfABandThatIsTooNarrow) {
  const std::string fleet(kEightVehicles);
  EXPECT_EQ(ErrorsOf(fleet), "");
  EXPECT_EQ(ErrorsOf("[acoustics]\nbandwidth_khz = 8\n" + fleet),
            "2:17: fdma: 8 nodes need 10.25 kHz (8 x 1 for channels, 9 x 0.25 for guard bands), "
            "bandwidth_khz = 8 holds 6 channels; widen bandwidth_khz, or narrow "
            "channel_bandwidth_khz or guard_band_khz\n");
  EXPECT_EQ(ErrorsOf("[comms]\nreports_over = \"acoustic\"\n" + fleet),
            "2:16: fdma: 8 nodes need 10.25 kHz (8 x 1 for channels, 9 x 0.25 for guard bands), "
            "bandwidth_khz = 10 holds 7 channels; widen bandwidth_khz, or narrow "
            "channel_bandwidth_khz or guard_band_khz (in [acoustics])\n");
  EXPECT_EQ(ErrorsOf("[comms]\nmessages_over = \"acoustic\"\n" + fleet).substr(0, 24),
            "2:17: fdma: 8 nodes need");
  EXPECT_EQ(ErrorsOf("[comms]\nreports_over = \"acoustic\"\n" + fleet +
                     "[acoustics]\nbandwidth_khz = 11\n"),
            "");
}

TEST(LoadErrors, ReportNothingThatFollowsFromAnotherError) {
  EXPECT_EQ(ErrorsOf(std::string(kEightVehicles) + "[acoustics]\nbandwidth_khz = -20\n"),
            "8:17: bandwidth_khz = -20 is out of range; allowed: greater than 0, at most 100000\n");
  EXPECT_EQ(ErrorsOfAcoustics("modem = \"none_such\"\nbit_error_model = \"modem\"\n"),
            "6:9: unknown modem 'none_such'; shoal has evologics_s2cr_18_34, nanomodem_v3, "
            "water_linked_m64, whoi_micromodem, whoi_micromodem2; any other needs a file, named "
            "relative to the "
            "folder of this one\n");
}

TEST(LoadErrors, ReportAMissingModem) {
  EXPECT_EQ(ErrorsOfAcoustics("modem = \"nanomodm_v3\"\n"),
            "6:9: unknown modem 'nanomodm_v3' (did you mean 'nanomodem_v3'?); shoal has "
            "evologics_s2cr_18_34, nanomodem_v3, water_linked_m64, whoi_micromodem, "
            "whoi_micromodem2; any other "
            "needs a file, named relative to the folder of this one\n");
  for (const char* name : {"", ".", "..", "/", "/nowhere/x", "../../data/modems"}) {
    EXPECT_TRUE(ErrorsOfAcoustics("modem = \"" + std::string(name) + "\"\n")
                    .starts_with("6:9: unknown modem '"))
        << name;
  }
  EXPECT_EQ(ErrorsOfAcoustics("modem = 5\n"), "6:9: modem must be a table, not a whole number\n");
  EXPECT_EQ(ErrorsOfAcoustics("modem = \"a\\nb\"\n"),
            "6:9: modem must not hold control characters\n");
}

TEST(LoadErrors, ReportWhatAModemsTableLacks) {
  const std::string errors = ErrorsOfAcoustics("[acoustics.modem]\nname = \"m\"\nlow_khz = 0\n");
  EXPECT_NE(errors.find("6:1: modem lacks 'high_khz'; for example: high_khz = 32\n"),
            std::string::npos)
      << errors;
  EXPECT_NE(errors.find("8:11: low_khz = 0 is out of range"), std::string::npos) << errors;
}

TEST(LoadErrors, ReportModelsThatDoNotGoWithTheModem) {
  EXPECT_EQ(ErrorsOfAcoustics("packet_loss_model = \"modem\"\n"),
            "6:21: packet_loss_model = \"modem\" needs a modem; name one, as in modem = "
            "\"whoi_micromodem2\", or choose another model\n");
  EXPECT_EQ(
      ErrorsOfAcoustics("modem = \"evologics_s2cr_18_34\"\nbit_error_model = \"modem\"\n"),
      "7:19: packet_loss_model = \"modem\" already loses the packets in which bits are wrong: "
      "with bit_error_model = \"modem\" too they would count twice; set one of the two to "
      "\"off\"\n");
  EXPECT_EQ(ErrorsOfAcoustics("modem = \"evologics_s2cr_18_34\"\nbit_error_model = \"modem\"\n"
                              "packet_loss_model = \"off\"\n"),
            "");
  EXPECT_EQ(
      ErrorsOfAcoustics("modem = \"whoi_micromodem2\"\nbit_error_model = \"modem\"\n"
                        "packet_loss_model = \"off\"\n"),
      "7:19: bit_error_model = \"modem\" is for modems without a code, and 'WHOI Micromodem-2, "
      "FH-FSK, 25 kHz' has one that corrects 3 of 24 bits; use packet_loss_model = \"modem\" "
      "and bit_error_model = \"off\"\n");
  EXPECT_EQ(ErrorsOfAcoustics("modem = \"whoi_micromodem2\"\naccess_mode = \"fdma\"\n"
                              "[[vehicle]]\nname = \"bravo\"\n"),
            "5:1: fdma: 2 nodes need 8 kHz (2 x 4 for channels, 3 x 0 for guard bands), "
            "bandwidth_khz = 4 holds 1 channel; widen bandwidth_khz, or narrow "
            "channel_bandwidth_khz or guard_band_khz\n");
}

TEST(LoadErrors, AskTdmaLfForALeader) {
  EXPECT_EQ(ErrorsOfAcoustics("access_mode = \"tdma_lf\"\n"),
            "6:15: tdma_lf needs a leader, and no node is one: no node would receive another; "
            "write acoustic_leader = true in the [[vehicle]] that leads\n");
  EXPECT_EQ(ErrorsAfter("acoustic_leader = true\n[acoustics]\naccess_mode = \"tdma_lf\"\n"), "");
}

TEST(LoadErrors, ReportAcousticAddressesThatSeveralHave) {
  EXPECT_EQ(ErrorsAfter("[[vehicle]]\nname = \"bravo\"\nacoustic_address = 1\n"),
            "7:20: several vehicles have the acoustic_address 1: 'alpha', 'bravo'; give each one "
            "of its own (the default is the vehicle's place in the mission)\n");
  EXPECT_EQ(ErrorsAfter("acoustic_address = 2\n[[vehicle]]\nname = \"bravo\"\n"),
            "6:1: several vehicles have the acoustic_address 2: 'alpha', 'bravo'; give each one "
            "of its own (the default is the vehicle's place in the mission)\n");
  EXPECT_EQ(ErrorsAfter("acoustic_address = 255\n"),
            "5:20: acoustic_address = 255 is the broadcast_address of [acoustics]; choose another "
            "of the two\n");
  EXPECT_EQ(ErrorsAfter("acoustic_address = 255\n[acoustics]\nbroadcast_address = 7\n"), "");
  EXPECT_EQ(ErrorsAfter("acoustic_address = 0\nacoustic_leader = 1\n"),
            "5:20: acoustic_address = 0 is out of range; allowed: 1 to 2147483647\n"
            "6:19: acoustic_leader must be true or false, not a whole number\n");
  EXPECT_EQ(ErrorsOf(std::string(kEightVehicles) + "acoustic_address = 9\n"),
            "7:20: a template must not have an acoustic_address; each vehicle has its own\n"
            "7:20: several vehicles have the acoustic_address 9: 'boat_1', 'boat_2', 'boat_3', "
            "'boat_4', 'boat_5' and 3 more; give each one of its own (the default is the vehicle's "
            "place in the mission)\n");
}

TEST(LoadErrors, ReportUnknownMedia) {
  EXPECT_EQ(ErrorsAfter("[comms]\nreports_over = \"water\"\nmessages_over = 1\n"),
            "6:16: unknown medium 'water'; one of: direct, acoustic\n"
            "7:17: messages_over must be an array of strings, not a whole number\n");
}

TEST(LoadErrors, ReportSharesThatNoLinkCanReach) {
  const auto with = [](std::string_view keys) {
    return ErrorsAfter("[[expect]]\nkind = \"packets\"\n" + std::string(keys));
  };
  EXPECT_EQ(with("at_least_pct = 80\nat_most_pct = 90\nat_least = 3\n"), "");
  EXPECT_EQ(with("cause = \"collision\"\nat_most_pct = 0\n"), "");
  EXPECT_EQ(with(""),
            "5:1: an expectation of packets needs one of at_least, at_most, at_least_pct, "
            "at_most_pct, or several\n");
  EXPECT_EQ(with("at_least_pct = 101\n"),
            "7:16: at_least_pct = 101 is out of range; allowed: 0 to 100\n");
  EXPECT_EQ(with("at_least_pct = 50.5\nat_most_pct = 20\n"),
            "8:15: at_most_pct = 20 is less than at_least_pct = 50.5: this can never hold\n");
  EXPECT_EQ(with("cause = \"too_soon\"\nat_most = 1\n").substr(0, 28),
            "7:9: unknown cause 'too_soon");
  EXPECT_EQ(ErrorsAfter("[comms]\neach_fate_up_to = 0\n[[expect]]\nkind = \"reports\"\n"
                        "to = \"alpha\"\nat_least_pct = 1\n"),
            "9:6: in a fleet of more than each_fate_up_to = 0 vehicles, those that are out of "
            "range are counted together: leave to out, or raise [comms] each_fate_up_to\n");
}

TEST(LoadErrors, ReportReportsThatAModemsPacketsCannotHold) {
  EXPECT_EQ(
      ErrorsAfter("[comms]\nreports_over = \"acoustic\"\n[acoustics]\nmodem = "
                  "\"whoi_micromodem2\"\n"),
      "6:16: a node report takes 37 bytes, and a packet of the WHOI Micromodem-2, FH-FSK, 25 kHz "
      "holds 32: "
      "choose another modem, or reports_over = \"direct\"\n");
}

std::vector<std::string> WarningsOverAcoustics(const std::string& acoustics) {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 60\n[comms]\nreports_over = \"acoustic\"\n[[vehicle]]\nname = "
      "\"alpha\"\n[acoustics]\n" +
          acoustics,
      "m.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return WarningsBesideConduct(loaded);
}

TEST(LoadWarnings, ReportReportsThatOverlapInTransit) {
  EXPECT_EQ(
      WarningsOverAcoustics(""),
      std::vector<std::string>{
          "m.toml:4:16: warning: alpha may report every 0.5 s, and a report of 41 bytes takes "
          "0.328 s at 1000 bit/s, with jitter up to 0.528 s: its own reports are more than "
          "its modem sends, and some will be thrown away; "
          "lower rate_hz in [vehicle.reporter], or raise data_rate_bps"});
  EXPECT_EQ(WarningsOverAcoustics("crc = false\nmax_jitter_s = 0.2").size(), 0U) << "0.296 + 0.2 s";
  EXPECT_EQ(WarningsOverAcoustics("jitter = \"off\"\n").size(), 0U);
  EXPECT_EQ(WarningsOverAcoustics("collisions = \"off\"\n").size(), 0U);
}

TEST(LoadErrors, NameTheKeyForMunetsNames) {
  EXPECT_EQ(ErrorsOfAcoustics("accessMode = \"fdma\"\nPLR = 0.1\ncollType = \"drop\"\n"),
            "6:1: unknown key 'accessMode' (here it is 'access_mode')\n"
            "7:1: unknown key 'PLR' (here it is 'packet_loss')\n"
            "8:1: unknown key 'collType' (here it is 'collisions')\n");
}

TEST(LoadErrors, ReportWhatIsWrongWithAcousticsBesideRulesAlone) {
  const auto errors = LoadCommsText("[comms]\n[acoustics]\nbandwidth_khz = 100\n", "c.toml").errors;
  EXPECT_EQ(errors, std::vector<std::string>{
                        "c.toml:3:17: the band begins at base_freq_khz - bandwidth_khz / 2 = 24 - "
                        "100 / 2 = -26 kHz, below 0"});
}

}  // namespace shoal::load_acoustics_errors_test
