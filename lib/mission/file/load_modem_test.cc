#include "lib/mission/file/load_modem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "lib/mission/file/modem_testing.h"
#include "lib/mission/toml/parse.h"

namespace shoal::load_modem_test {

namespace fs = std::filesystem;

constexpr std::string_view kSound = R"(name = "m"
low_khz = 24
high_khz = 32
data_rate_bps = 463
max_packet_bytes = 64
source_level_db = 168
typical_range_m = 2000
modulation = "coherent_psk"
fading = "rayleigh"
code = {block_bits = 127, data_bits = 92, corrected_bits = 5}
[sources]
band = "a"
data_rate_bps = "b"
max_packet_bytes = "c"
source_level_db = "d"
typical_range_m = "e"
modulation = "f"
fading = "g"
code = "h"
)";

std::string With(std::string_view old_text, std::string_view new_text) {
  std::string text(kSound);
  const size_t at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return text.replace(at, old_text.size(), new_text);
}

std::string ErrorsOfModem(std::string_view text) {
  std::string all;
  for (std::string error : LoadModemText(text, "m.toml").errors) {
    if (error.starts_with("m.toml:")) error.erase(0, 7);
    all += error + "\n";
  }
  return all;
}

std::vector<fs::path> Presets() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(SHOAL_SOURCE_DIR "/data/modems")) {
    paths.push_back(entry.path());
  }
  return paths;
}

std::string PageOf(const std::string& name) {
  std::ifstream file(std::string(SHOAL_SOURCE_DIR) + "/docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(LoadModem, ReadsEveryKey) {
  const LoadedModem loaded = LoadModemText(kSound, "m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(loaded.warnings, std::vector<std::string>());
  const ModemPreset& modem = loaded.modem;
  EXPECT_EQ(modem.name, "m");
  EXPECT_EQ(modem.low_khz, 24);
  EXPECT_EQ(modem.high_khz, 32);
  EXPECT_EQ(modem.data_rate_bps, 463);
  EXPECT_EQ(modem.max_packet_bytes, 64);
  EXPECT_EQ(modem.source_level_db, 168);
  EXPECT_EQ(modem.typical_range_m, 2000);
  EXPECT_EQ(modem.modulation, Modulation::kCoherentPsk);
  EXPECT_EQ(modem.fading, Fading::kRayleigh);
  EXPECT_EQ(modem.code, (BlockCode{127, 92, 5}));
  EXPECT_EQ(modem.sources.size(), 8U);
  EXPECT_EQ(modem.sources.at("code"), "h");
}

TEST(LoadModem, ReportsAllThatIsMissing) {
  EXPECT_EQ(
      ErrorsOfModem("fading = \"none\"\n"),
      "1:1: the file lacks 'data_rate_bps'; for example: data_rate_bps = 463\n"
      "1:1: the file lacks 'high_khz'; for example: high_khz = 32\n"
      "1:1: the file lacks 'low_khz'; for example: low_khz = 24\n"
      "1:1: the file lacks 'max_packet_bytes'; for example: max_packet_bytes = 64\n"
      "1:1: the file lacks 'modulation'; for example: modulation = \"noncoherent_fsk\"\n"
      "1:1: the file lacks 'name'; for example: name = \"Nanomodem v3\"\n"
      "1:1: the file lacks 'source_level_db'; for example: source_level_db = 168\n"
      "1:1: the file lacks 'sources'; for example: [sources], followed by band = \"data sheet "
      "of 2020\"\n"
      "1:1: the file lacks 'typical_range_m'; for example: typical_range_m = 2000\n");
}

TEST(LoadModem, ReportsInvalidValues) {
  EXPECT_EQ(ErrorsOfModem(With("high_khz = 32", "high_khz = 20")),
            "3:12: high_khz must be above low_khz\n");
  EXPECT_EQ(
      ErrorsOfModem(With("= 463", "= nan")),
      "4:17: data_rate_bps = nan is out of range; allowed: greater than 0, at most 1000000\n");
  EXPECT_EQ(ErrorsOfModem(With("= 64", "= 0")),
            "5:20: max_packet_bytes = 0 is out of range; allowed: 1 to 1000000\n");
  EXPECT_EQ(ErrorsOfModem(With("= 168", "= 1680")),
            "6:19: source_level_db = 1680 is out of range; allowed: 100 to 250\n");
  EXPECT_EQ(
      ErrorsOfModem(With("= 2000", "= inf")),
      "7:19: typical_range_m = inf is out of range; allowed: greater than 0, at most 1000000\n");
  EXPECT_EQ(ErrorsOfModem(With("coherent_psk", "koherent_psk")),
            "8:14: unknown modulation 'koherent_psk' (did you mean 'coherent_psk'?)\n");
  EXPECT_EQ(
      ErrorsOfModem(With("corrected_bits = 5", "corrected_bits = 8")),
      "10:8: no code of 127 bits with 92 data bits corrects 8 errors: there are 35 check bits, "
      "and distinguishing the error patterns takes 41\n");
  EXPECT_EQ(ErrorsOfModem(With("name = \"m\"", "name = \"m\"\nsped = 1")),
            "2:1: unknown key 'sped'; known here: name, low_khz, high_khz, data_rate_bps, "
            "max_packet_bytes, source_level_db, typical_range_m, modulation, fading, code, "
            "sources\n");
}

TEST(LoadModem, DemandsASourceOfEveryNumber) {
  EXPECT_EQ(
      ErrorsOfModem(With("band = \"a\"\n", "")),
      "11:1: sources lacks 'band'; for example: band = \"data sheet of 2020\", or \"estimate: "
      "why\"\n");
  EXPECT_EQ(
      ErrorsOfModem(With("band = \"a\"", "band = \"\"")),
      "11:1: sources lacks 'band'; for example: band = \"data sheet of 2020\", or \"estimate: "
      "why\"\n");
  EXPECT_EQ(ErrorsOfModem(With("band = \"a\"", "band = \"a\"\nbant = \"b\"")),
            "11:1: a source of 'bant', which no modem has (did you mean 'band'?)\n");
}

TEST(LoadModem, ReportsAMissingFile) {
  const LoadedModem loaded = LoadModem("/nowhere/m.toml");
  ASSERT_EQ(loaded.errors.size(), 1U);
  EXPECT_TRUE(loaded.errors.front().starts_with("/nowhere/m.toml")) << loaded.errors.front();
}

TEST(LoadModem, SurvivesInvalidText) {
  for (const char* nonsense : {"", "\xff", "low_khz = [", "name = {a = 1}", "code = 5",
                               "code = {block_bits = -1}", "sources = 1", "[[sources]]",
                               "[sources]\nband = 5", "low_khz = 1e999", "high_khz = true"}) {
    EXPECT_NE(ErrorsOfModem(nonsense), "") << nonsense;
  }
}

TEST(ModemFile, WritesWhatReadsBackTheSame) {
  const ModemPreset modem = LoadModemText(kSound, "m.toml").modem;
  const LoadedModem again = LoadModemText(ModemFileOf(modem), "again");
  EXPECT_EQ(again.errors, std::vector<std::string>());
  EXPECT_EQ(again.modem, modem);
}

TEST(ModemFile, WritesNoKeyThatTheDocumentationDoesNotHave) {
  const std::string page = PageOf("communication/acoustics_models.md");
  Problems problems("", {});
  const std::optional<Value> root =
      ParseToml(ModemFileOf(LoadModemText(kSound, "m.toml").modem), problems);
  ASSERT_TRUE(root.has_value());
  std::set<std::string> keys = {"block_bits", "data_bits", "corrected_bits"};
  for (const Entry& entry : std::get<Table>(root->data)) keys.insert(entry.key);
  EXPECT_EQ(keys.size(), 14U);
  for (const std::string& key : keys) {
    EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
  }
}

TEST(ModemPresets, AreSoundAndNamedInTheDocumentation) {
  const std::string page = PageOf("communication/acoustics_models.md");
  EXPECT_GE(Presets().size(), 4U);
  for (const fs::path& path : Presets()) {
    EXPECT_EQ(LoadModem(path.string()).errors, std::vector<std::string>()) << path;
    EXPECT_NE(page.find("`data/modems/" + path.filename().string() + "`"), std::string::npos)
        << path;
  }
}

/// Returns the range in m at which `modem` loses half of its longest packets, to a hundred metres.
int Reach(const ModemPreset& modem, const Sea& sea) {
  const LinkModel model(modem, sea);
  double near_m = 0;
  double far_m = 100'000;
  while (far_m - near_m > 0.1) {
    const double range_m = (near_m + far_m) / 2;
    const double loss = PacketErrorRate(model.At(range_m).bit_error_rate,
                                        static_cast<uint64_t>(modem.max_packet_bytes), modem.code);
    (loss < 0.5 ? near_m : far_m) = range_m;
  }
  return static_cast<int>(std::lround(near_m / 100)) * 100;
}

TEST(ModemPresets, ReachAsFarAsTheDocumentationStates) {
  const std::string page = PageOf("communication/acoustics_models.md");
  for (const fs::path& path : Presets()) {
    const ModemPreset modem = LoadModem(path.string()).modem;
    const std::string reach = std::to_string(Reach(modem, {.spreading_exponent = 1.5})) + " | " +
                              std::to_string(Reach(modem, {.spreading_exponent = 2}));
    const size_t row = page.find("`data/modems/" + path.filename().string() + "`");
    ASSERT_NE(row, std::string::npos) << path;
    EXPECT_TRUE(page.substr(row, page.find('\n', row) - row).ends_with("| " + reach + " |"))
        << path << " reaches " << reach;
  }
}

TEST(ModemPresets, ReachTheirTypicalRangeInADeepSea) {
  for (const fs::path& path : Presets()) {
    const ModemPreset modem = LoadModem(path.string()).modem;
    EXPECT_GT(Reach(modem, {.spreading_exponent = 2}), modem.typical_range_m) << path;
  }
}

}  // namespace shoal::load_modem_test
