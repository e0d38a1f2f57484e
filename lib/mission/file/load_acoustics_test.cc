// The keys of the acoustic network in a mission file, and their defaults.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/file/load_comms.h"
#include "lib/mission/file/load_media.h"
#include "lib/mission/file/load_testing.h"
#include "lib/mission/file/mission_testing.h"
#include "lib/mission/file/modem_testing.h"
#include "lib/sea/acoustics/acoustic_network.h"

namespace shoal::load_acoustics_test {

namespace fs = std::filesystem;

Mission LoadAfter(std::string_view more, const std::string& name = "m.toml",
                  const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded =
      LoadMissionText(std::string(kShortest) + std::string(more), name, overrides);
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  return loaded.mission;
}

ModemPreset Modem(const std::string& name) {
  return LoadModem(std::string(SHOAL_SOURCE_DIR) + "/data/modems/" + name + ".toml").modem;
}

TEST(LoadAcoustics, LeavesTheNetworkUnusedWithoutItsTable) {
  EXPECT_EQ(LoadAfter("").acoustics, Acoustics());
  EXPECT_TRUE(LoadAfter("[acoustics]\n").acoustics.is_used);
  EXPECT_TRUE(LoadAfter("[comms]\nreports_over = \"acoustic\"\n").acoustics.is_used);
  EXPECT_TRUE(LoadAfter("[comms]\nmessages_over = \"acoustic\"\n").acoustics.is_used);
  EXPECT_FALSE(LoadAfter("[comms]\nreports_over = \"direct\"\n").acoustics.is_used);
}

TEST(LoadAcoustics, HasMunetsDefaultsWithoutAModem) {
  EXPECT_EQ(LoadAfter("[acoustics]\n").acoustics.options, AcousticOptions());
  EXPECT_TRUE(LoadAfter("[acoustics]\n").acoustics.crc);
}

TEST(LoadAcoustics, TakesDefaultsFromTheModem) {
  const ModemPreset modem = Modem("whoi_micromodem2");
  AcousticOptions expected;
  expected.access_mode = AccessMode::kShared;
  expected.packet_loss_model = PacketLossModel::kModem;
  expected.bit_error_model = BitErrorModel::kOff;
  expected.half_duplex = true;
  expected.sound_speed_mps = *SoundSpeed({});
  expected.base_freq_khz = 25;
  expected.bandwidth_khz = 4;
  expected.guard_band_khz = 0;
  expected.channel_bandwidth_khz = 4;
  expected.data_rate_bps = 80;
  expected.modem = modem;
  EXPECT_EQ(LoadAfter("[acoustics]\nmodem = \"whoi_micromodem2\"\n").acoustics.options, expected);
}

TEST(LoadAcoustics, LetsTheFileWinOverTheModem) {
  const AcousticOptions options = LoadAfter(R"([acoustics]
access_mode = "fdma"
half_duplex = false
bandwidth_khz = 3
guard_band_khz = 0.25
channel_bandwidth_khz = 0.5
data_rate_bps = 100
sound_speed_mps = 1480
packet_loss_model = "uniform"
bit_error_model = "poisson"
modem = "whoi_micromodem2"
)")
                                      .acoustics.options;
  EXPECT_EQ(options.access_mode, AccessMode::kFdma);
  EXPECT_FALSE(options.half_duplex);
  EXPECT_EQ(options.bandwidth_khz, 3);
  EXPECT_EQ(options.guard_band_khz, 0.25);
  EXPECT_EQ(options.channel_bandwidth_khz, 0.5);
  EXPECT_EQ(options.data_rate_bps, 100);
  EXPECT_EQ(options.sound_speed_mps, 1480);
  EXPECT_EQ(options.packet_loss_model, PacketLossModel::kUniform);
  EXPECT_EQ(options.bit_error_model, BitErrorModel::kPoisson);
}

TEST(LoadAcoustics, MakesTheChannelAsWideAsTheBandThatTheFileNames) {
  const std::string modem = "[acoustics]\nmodem = \"whoi_micromodem2\"\n";
  EXPECT_EQ(LoadAfter(modem + "bandwidth_khz = 3\n").acoustics.options.channel_bandwidth_khz, 3);
}

TEST(LoadAcoustics, TakesTheSoundSpeedFromTheSea) {
  const auto speed = [](std::string_view more) {
    return LoadAfter("[acoustics]\n" + std::string(more)).acoustics.options.sound_speed_mps;
  };
  EXPECT_EQ(speed(""), 1500);
  EXPECT_EQ(speed("sea = {}\n"), *SoundSpeed({}));
  EXPECT_EQ(speed("[acoustics.sea]\ntemperature_degc = 20\nsalinity_ppt = 38\ndepth_m = 100\n"),
            *SoundSpeed({.temperature_degc = 20, .salinity_ppt = 38, .depth_m = 100}));
  EXPECT_EQ(speed("sound_speed_mps = 1420\nsea = {salinity_ppt = 5}\n"), 1420);
}

TEST(LoadAcoustics, ReadsTheWholeSea) {
  const Sea sea = LoadAfter(R"([acoustics.sea]
temperature_degc = 4
salinity_ppt = 34
depth_m = 1000
ph = 7.9
shipping = 0.1
wind_mps = 12
absorption = "thorp"
spreading_exponent = 2
)")
                      .acoustics.options.sea;
  EXPECT_EQ(sea, (Sea{.water = {4, 34, 1000, 7.9},
                      .noise = {.shipping = 0.1, .wind_mps = 12},
                      .absorption = AbsorptionModel::kThorp,
                      .spreading_exponent = 2}));
}

/// A folder of its own below the temporary one, gone at the end of the test.
class ModemFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Writes a modem with this source level.
  void Write(const std::string& file, double source_level_db) {
    ModemPreset modem = Modem("nanomodem_v3");
    modem.source_level_db = source_level_db;
    std::ofstream(folder_ / file) << ModemFileOf(modem);
  }
  /// Returns the source level of the modem that a mission in the folder names.
  double LevelOf(const std::string& name) {
    const Mission mission =
        LoadAfter("[acoustics]\nmodem = \"" + name + "\"\n", (folder_ / "m.toml").string());
    return mission.acoustics.options.modem.value_or(ModemPreset()).source_level_db;
  }

  fs::path folder_;
};

TEST_F(ModemFolder, OfTheMissionComesBeforeThatOfShoal) {
  EXPECT_EQ(LevelOf("nanomodem_v3"), 168);
  EXPECT_EQ(LevelOf("nanomodem_v3.toml"), 168);
  Write("nanomodem_v3.toml", 150);
  EXPECT_EQ(LevelOf("nanomodem_v3"), 150);
}

TEST_F(ModemFolder, MayHaveFoldersBelow) {
  fs::create_directories(folder_ / "own");
  Write("own/loud.toml", 199);
  EXPECT_EQ(LevelOf("own/loud"), 199);
  EXPECT_EQ(LevelOf("own/loud.toml"), 199);
  EXPECT_EQ(LevelOf("./own/../own/loud"), 199);
}

TEST_F(ModemFolder, ReportsWhatIsWrongWithAModemOfItsOwn) {
  std::ofstream(folder_ / "odd.toml") << "name = 5\n";
  const std::string file = (folder_ / "m.toml").string();
  const LoadedMission loaded =
      LoadMissionText(std::string(kShortest) + "[acoustics]\nmodem = \"odd\"\n", file);
  ASSERT_FALSE(loaded.errors.empty());
  EXPECT_EQ(loaded.errors.back(), file + ":6:9: modem 'odd': " + (folder_ / "odd.toml").string() +
                                      ":1:8: name must be a string in quotes, not a whole number");
}

TEST(LoadAcoustics, TakesAModemAsATableAndFromAnOverride) {
  const Mission named = LoadAfter("[acoustics]\nmodem = \"nanomodem_v3\"\n");
  EXPECT_EQ(LoadAfter("", "m.toml", {"acoustics.modem=nanomodem_v3"}).acoustics, named.acoustics);
  const Mission again = LoadMissionText(Explain(named), "m.toml").mission;
  EXPECT_EQ(again.acoustics, named.acoustics);
  EXPECT_EQ(again.acoustics.options.modem, Modem("nanomodem_v3"));
}

TEST(LoadAcoustics, NumbersVehiclesByTheirPlace) {
  const Mission mission = LoadAfter(R"([[vehicle]]
name = "bravo"
acoustic_address = 77
acoustic_leader = true
[[fleet]]
template = "t"
count = 3
[acoustics]
broadcast_address = 4
access_mode = "tdma_lf"
[template.t]
)");
  const auto address = [&](size_t i) { return mission.vehicles.at(i).acoustic_address; };
  EXPECT_EQ(address(0), 1);
  EXPECT_EQ(address(1), 77);
  EXPECT_EQ(address(2), 3);
  EXPECT_EQ(address(3), 5) << "4 is the broadcast address";
  EXPECT_EQ(address(4), 6);
  EXPECT_FALSE(mission.vehicles[0].acoustic_leader);
  EXPECT_TRUE(mission.vehicles[1].acoustic_leader);
}

TEST(LoadAcoustics, AcceptsALargeFleetThatDoesNotUseTheNetwork) {
  const Mission mission = LoadAfter("[[fleet]]\ntemplate = \"t\"\ncount = 300\n[template.t]\n");
  EXPECT_EQ(mission.vehicles.at(253).acoustic_address, 254);
  EXPECT_EQ(mission.vehicles.at(254).acoustic_address, 256);
  EXPECT_EQ(mission.vehicles.at(300).acoustic_address, 302);
}

TEST(LoadMediaText, IsSelfContained) {
  const Acoustics acoustics = LoadAfter("[acoustics]\nmodem = \"nanomodem_v3\"\n").acoustics;
  const std::string text = ExplainMedia({.acoustics = acoustics});
  EXPECT_TRUE(text.starts_with("[acoustics]\n")) << text;
  const LoadedMedia loaded = LoadMediaText(text, "COMMS_RULES");
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(loaded.setup.acoustics, acoustics);
}

TEST(LoadMediaText, OpensNoFile) {
  EXPECT_EQ(
      LoadMediaText("[acoustics]\nmodem = \"nanomodem_v3\"\n", "log").errors,
      std::vector<std::string>{"log:2:9: modem must be a table, not the string 'nanomodem_v3'"});
  EXPECT_EQ(LoadMediaText("", "log").errors,
            std::vector<std::string>{"log:1:1: the text lacks 'acoustics'; for example: "
                                     "[acoustics], followed by crc = true"});
  EXPECT_EQ(LoadMediaText("[acoustics\n", "log").errors.size(), 1U);
}

TEST(LoadMediaText, KnowsNoNumberOfNodes) {
  EXPECT_EQ(LoadMediaText("[acoustics]\naccess_mode = \"tdma_lf\"\n", "log").errors,
            std::vector<std::string>());
}

/// Returns a text of random acoustics in which one value is another one.
std::string Edited(uint64_t seed) {
  constexpr std::array<std::string_view, 10> kValues = {"nan", "-1",  "0",       "1e-300", "1e300",
                                                        "5",   "1.5", "\"off\"", "{}",     "true"};
  std::mt19937_64 random(seed);
  std::string text = ExplainMedia({.acoustics = MissionDraw(seed).DrawAcoustics()});
  const size_t value = text.find("= ", random() % text.size());
  if (value == std::string::npos) return text;
  const size_t end = text.find_first_of(",}\n", value);
  return text.replace(value + 2, end - value - 2, kValues.at(random() % kValues.size()));
}

RC_GTEST_PROP(LoadMediaText, LoadsNothingThatTheNetworkCannotDo, (uint64_t seed)) {
  const LoadedMedia loaded = LoadMediaText(Edited(seed), "log");
  for (const std::string& error : loaded.errors) RC_ASSERT(error.starts_with("log:"));
  if (!loaded.errors.empty()) return;
  RC_ASSERT(LoadMediaText(ExplainMedia(loaded.setup), "log").setup == loaded.setup);
  AcousticNetwork network(loaded.setup.acoustics.options, 1, AnyNode());
  if (!network.AddNode({.name = "another", .address = 2}).ok()) return;
  const std::vector<Eigen::Vector3d> positions_m = {{0, 0, 0}, {1000, 0, 0}};
  const std::vector<int> receivers = {1};
  network.Transmit(0, 0, positions_m, std::vector<uint8_t>(37), receivers);
  RC_ASSERT(network.Deliver(1e12).size() == 1U);
}

TEST(LoadComms, ReadsTheAcousticsBesideTheRules) {
  const std::string rules = "[comms]\nreports_over = \"acoustic\"\n";
  const LoadedComms without = LoadCommsText(rules, "c.toml");
  EXPECT_EQ(without.errors, std::vector<std::string>());
  EXPECT_EQ(without.rules.reports_over, Over("acoustic"));
  EXPECT_FALSE(without.acoustics.has_value());
  const LoadedComms with =
      LoadCommsText(rules + "[acoustics]\ncrc = false\nmodem = \"nanomodem_v3\"\n", "c.toml");
  EXPECT_EQ(with.errors, std::vector<std::string>());
  ASSERT_TRUE(with.acoustics.has_value());
  EXPECT_TRUE(with.acoustics->is_used);
  EXPECT_FALSE(with.acoustics->crc);
  EXPECT_EQ(with.acoustics->options.modem, Modem("nanomodem_v3"));
}

TEST(LoadComms, TakesTheAcousticsOfAWholeMission) {
  const std::string mission(kShortest);
  EXPECT_EQ(LoadCommsText(mission, "m.toml").acoustics, Acoustics());
  EXPECT_TRUE(LoadCommsText(mission + "[acoustics]\n", "m.toml").acoustics->is_used);
}

}  // namespace shoal::load_acoustics_test
