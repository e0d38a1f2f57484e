// Mission, modem and campaign files, types, and lines of results, that were damaged: each is read,
// or refused with its place. The same mutations in every run.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "lib/base/schema/schema.h"
#include "lib/mission/file/load.h"
#include "lib/mission/file/load_modem.h"
#include "lib/tools/campaign/load_campaign.h"
#include "lib/tools/trials/trial_line.h"
#include "tests/fuzz/mutation.h"

namespace shoal::mutated_missions_test {

constexpr int kNumMutations = 5000;
constexpr int64_t kMaxMemory_kB = 512 << 10;

std::string TextOf(const std::string& path) {
  std::ifstream file(std::string(SHOAL_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

constexpr std::array<std::string_view, 18> kWords = {
    "nan",      "-1e308",      "99999999999999999999",
    "\xFF\xFE", "[[vehicle]]", "]]",
    "= {",      "-",           "\"",
    "inf",      "0",           "1e-320",
    "[",        "true",        "\n",
    "''''",     "\r",          "a.b.c = 1\n"};

/// What came of the mutants of one form.
struct Count {
  int read = 0;
  int refused = 0;
  std::string fault = {};  ///< The first mutant, or error, that is not as it must be.
};

/// Returns the first error that names no place in `name`, or could not be shown on a terminal.
std::string BadError(const std::vector<std::string>& errors, const std::string& name) {
  for (const std::string& error : errors) {
    const bool is_text = std::ranges::none_of(
        error, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; });
    if (!error.starts_with(name) || error.size() > 2000 || !is_text) return error;
  }
  return {};
}

/// `read` returns the errors of a text, and sets `fault` where what it has read is not right.
using Read = std::function<std::vector<std::string>(const std::string& text, std::string* fault)>;

Count ReadMutants(const std::vector<std::string>& files, const std::string& name,
                  const Read& read) {
  std::vector<std::string> texts;
  for (const std::string& file : files) texts.push_back(TextOf(file));
  std::mt19937_64 generator(32);
  Count count;
  for (int i = 0; i < kNumMutations; ++i) {
    const std::string text =
        Mutated(texts[static_cast<size_t>(i) % texts.size()], kWords, generator);
    std::string fault;
    const std::vector<std::string> errors = read(text, &fault);
    ++(errors.empty() ? count.read : count.refused);
    if (fault.empty()) fault = BadError(errors, name);
    if (count.fault.empty()) count.fault = fault;
  }
  return count;
}

void ExpectReadOrRefused(const std::vector<std::string>& files, const std::string& name,
                         const Read& read) {
  const Count count = ReadMutants(files, name, read);
  EXPECT_EQ(count.fault, "");
  EXPECT_GT(count.read, kNumMutations / 50) << "some mutants must reach beyond the first check";
  EXPECT_GT(count.refused, kNumMutations / 50);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, kMaxMemory_kB);
#endif
}

TEST(MutatedMissions, AreReadWithFiniteStartsAndTimesOrRefusedWithTheirPlace) {
  ExpectReadOrRefused(
      {"missions/alpha.toml", "missions/berta.toml", "missions/acoustic.toml", "missions/lbl.toml",
       "missions/search_gateway.toml", "missions/track_replay.toml"},
      "m.toml", [](const std::string& text, std::string* fault) {
        const LoadedMission loaded = LoadMissionText(text, "m.toml");
        if (loaded.errors.empty()) {
          bool is_sound = loaded.mission.duration_s > 0 && loaded.mission.tick_us > 0;
          for (const Vehicle& vehicle : loaded.mission.vehicles) {
            is_sound = is_sound && !vehicle.name.empty() &&
                       std::isfinite(vehicle.start.x_m + vehicle.start.y_m + vehicle.start.depth_m);
          }
          if (!is_sound) *fault = text;
        }
        return loaded.errors;
      });
}

TEST(MutatedModems, AreReadWithPositiveNumbersOrRefusedWithTheirPlace) {
  ExpectReadOrRefused({"data/modems/nanomodem_v3.toml", "data/modems/whoi_micromodem2.toml"},
                      "modem.toml", [](const std::string& text, std::string* fault) {
                        const LoadedModem loaded = LoadModemText(text, "modem.toml");
                        const ModemPreset& modem = loaded.modem;
                        const bool is_sound = modem.max_packet_bytes > 0 &&
                                              modem.data_rate_bps > 0 &&
                                              std::isfinite(modem.data_rate_bps);
                        if (loaded.errors.empty() && !is_sound) *fault = text;
                        return loaded.errors;
                      });
}

TEST(MutatedCampaigns, AreReadOrRefusedWithTheirPlace) {
  ExpectReadOrRefused(
      {"campaigns/crossing_loiters.toml", "campaigns/lossy_swarm.toml", "campaigns/range.toml"},
      "c.toml", [](const std::string& text, std::string*) {
        return LoadCampaignText(text, "c.toml", "/nowhere").errors;
      });
}

TEST(MutatedTypes, AreReadOrRefusedWithTheirPlace) {
  ExpectReadOrRefused({"lcmtypes/shoal_nav_t.lcm", "lcmtypes/shoal_comms_fates_t.lcm",
                       "lcmtypes/shoal_node_report_t.lcm"},
                      "t.lcm", [](const std::string& text, std::string*) {
                        const Result<std::vector<StructType>> types =
                            ParseLcm({.file = "t.lcm", .text = text});
                        if (types.ok()) return std::vector<std::string>();
                        return std::vector<std::string>{types.error()};
                      });
}

TEST(MutatedTrialLines, AreReadWithFiniteMeasuresOrTakenForTorn) {
  const std::vector<MetricName> metrics = {{"range", "m", ""}, {"age", "s", ""}};
  const FinishedTrial trial = {.key = {"4f2a91c3e0", 17},
                               .result = {.outcome = TrialOutcome::kFail,
                                          .why = "missed",
                                          .metrics = {7.25, TrialResult::kNoValue}},
                               .wall_s = 0.0213,
                               .attempt = 2};
  const std::string whole = TrialLine(trial, metrics);
  ASSERT_TRUE(ParseTrialLine(whole, metrics));
  std::mt19937_64 generator(32);
  int num_read = 0;
  for (int i = 0; i < kNumMutations; ++i) {
    const std::string line = Mutated(whole, kWords, generator);
    const auto parsed = ParseTrialLine(line, metrics);
    if (!parsed) continue;
    ++num_read;
    EXPECT_TRUE(std::isfinite(parsed->wall_s)) << line;
    EXPECT_TRUE(parsed->result.metrics.empty() || parsed->result.metrics.size() == metrics.size());
    EXPECT_TRUE(std::ranges::none_of(parsed->result.metrics, [](double x) {
      return std::isinf(x);
    })) << line;
  }
  EXPECT_GT(num_read, kNumMutations / 50);
}

}  // namespace shoal::mutated_missions_test
