#include "lib/mission/file/load_modem.h"

#include <algorithm>
#include <array>
#include <optional>

#include "lib/bus/os/read_file.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_reader.h"

namespace shoal {
namespace {

/// What a modem's file must name a source of.
constexpr std::array<std::string_view, 8> kSourced = {"band",
                                                      "data_rate_bps",
                                                      "max_packet_bytes",
                                                      "source_level_db",
                                                      "typical_range_m",
                                                      "modulation",
                                                      "fading",
                                                      "code"};

void DescribeCode(Fields& fields, BlockCode& code) {
  fields.SmallInteger("block_bits", code.block_bits, 1, kMaxBlockBits);
  fields.SmallInteger("data_bits", code.data_bits, 1, kMaxBlockBits);
  fields.SmallInteger("corrected_bits", code.corrected_bits, 0, kMaxBlockBits);
}

void CheckSources(Fields& file, const ModemPreset& modem) {
  for (const std::string_view key : kSourced) {
    const auto found = modem.sources.find(std::string(key));
    if (found != modem.sources.end() && !found->second.empty()) continue;
    file.Refuse("sources", "sources lacks " + Quoted(key) + "; for example: " + std::string(key) +
                               " = \"data sheet of 2020\", or \"estimate: why\"");
  }
  for (const auto& [key, source] : modem.sources) {
    if (std::find(kSourced.begin(), kSourced.end(), key) != kSourced.end()) continue;
    std::string hint = DidYouMean(key, kSourced);
    if (hint.empty()) hint = "; known: " + Joined(kSourced);
    file.Refuse("sources", "a source of " + Quoted(key) + ", which no modem has" + hint);
  }
}

}  // namespace

void Describe(Fields& file, ModemPreset& modem) {
  file.Require("name", "name = \"Nanomodem v3\"");
  file.Text("name", modem.name, {.min_length = 1, .max_length = 100});
  file.Require("low_khz", "low_khz = 24");
  file.Number("low_khz", modem.low_khz, Above(0, kMaxFrequency_khz));
  file.Require("high_khz", "high_khz = 32");
  file.Number("high_khz", modem.high_khz, Above(0, kMaxFrequency_khz));
  if (file.reading() && modem.low_khz > 0 && modem.high_khz > 0 &&
      modem.low_khz >= modem.high_khz) {
    file.Refuse("high_khz", "high_khz must be above low_khz");
  }
  file.Require("data_rate_bps", "data_rate_bps = 463");
  file.Number("data_rate_bps", modem.data_rate_bps, Above(0, 1e6));
  file.Require("max_packet_bytes", "max_packet_bytes = 64");
  file.Integer("max_packet_bytes", modem.max_packet_bytes, 1, 1'000'000);
  file.Require("source_level_db", "source_level_db = 168");
  file.Number("source_level_db", modem.source_level_db, Between(100, 250));
  file.Require("typical_range_m", "typical_range_m = 2000");
  file.Number("typical_range_m", modem.typical_range_m, Above(0, 1e6));
  file.Require("modulation", "modulation = \"noncoherent_fsk\"");
  file.Choice("modulation", modem.modulation, kModulations);
  file.Choice("fading", modem.fading, kFadings);
  file.Inline("code", [&](Fields& fields) { DescribeCode(fields, modem.code); });
  if (file.reading()) {
    const std::string problem = ProblemOf(modem.code);
    if (!problem.empty()) {
      file.Refuse("code", problem);
      modem.code = {};
    }
  }
  file.Require("sources", "[sources], followed by band = \"data sheet of 2020\"");
  file.TextMap("sources", modem.sources, 32);
  if (file.reading() && file.Has("sources", true)) CheckSources(file, modem);
}

LoadedModem LoadModemText(std::string_view text, const std::string& name) {
  LoadedModem loaded;
  Problems problems(name, {});
  if (const std::optional<Value> root = ParseToml(text, problems)) {
    TableReader file(*root, "the file", problems);
    Describe(file, loaded.modem);
  }
  loaded.errors = problems.InOrder();
  if (loaded.errors.empty()) loaded.warnings = problems.WarningsInOrder();
  return loaded;
}

LoadedModem LoadModem(const std::string& path) {
  const FileText read = ReadRegularFile(path);
  if (read.problem.empty()) return LoadModemText(read.text, path);
  Problems problems(path, {});
  problems.Add({}, read.problem);
  return {.modem = {}, .errors = problems.InOrder(), .warnings = {}};
}

}  // namespace shoal
