#include "lib/tools/trials/campaign_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "lib/base/text/json_bounds.h"
#include "lib/base/text/terminal_text.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/plain_folder.h"
#include "lib/bus/os/read_file.h"
#include "lib/bus/os/replace_file.h"
#include "lib/run/command_line/version.h"
#include "lib/tools/campaign/samples.h"

namespace shoal {

namespace {

using Json = nlohmann::ordered_json;

constexpr char kFacts[] = "campaign.json";
constexpr char kCampaign[] = "campaign.toml";
/// Of kFacts: 100,000 cases of some 45 values each.
constexpr JsonBounds kFactBounds = {.depth = 8, .num_values = 5'000'000};

std::string JsonOf(const LoadedCampaign& loaded, const Plan& plan) {
  Json json;
  json["shoal_campaign"] = 1;
  json["version"] = kVersion;
  json["build"] = plan.build;
  json["arithmetic"] = plan.arithmetic;
  json["identity"] = plan.identity;
  const auto absolute = [](const std::string& path) {
    std::error_code ignored;
    return std::filesystem::absolute(path, ignored).lexically_normal().string();
  };
  json["campaign_file"] = absolute(loaded.campaign.file);
  json["mission_file"] = absolute(loaded.campaign.mission_file);
  json["repetitions"] = loaded.campaign.repetitions;
  for (const CampaignCase& each : plan.cases) {
    json["cases"].push_back({{"id", each.id}, {"values", each.values}, {"policy", each.policy}});
  }
  json["metrics"] = Json::array();
  for (const MetricName& metric : plan.metrics) {
    json["metrics"].push_back(
        {{"name", metric.name}, {"unit", metric.unit}, {"text", metric.text}});
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool IsCaseId(const std::string& text) {
  return !text.empty() && text.size() <= 64 &&
         text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Throws what nlohmann::json throws.
std::string ReadFacts(const std::string& text, CampaignFolder* folder) {
  const auto json = nlohmann::json::parse(text);
  if (json.at("shoal_campaign").get<int>() != 1) return "it is of a newer version of shoal";
  Plan& plan = folder->plan;
  plan.build = json.at("build").get<std::string>();
  plan.arithmetic = json.value("arithmetic", std::string());
  plan.identity = json.at("identity").get<std::string>();
  folder->campaign.mission_file = json.at("mission_file").get<std::string>();
  const size_t num_keys = SweepKeys(folder->campaign).size();
  std::set<std::string> ids;
  for (const auto& each : json.at("cases")) {
    CampaignCase one{.id = each.at("id").get<std::string>(),
                     .values = each.at("values").get<std::vector<std::string>>(),
                     .policy = each.at("policy").get<std::string>()};
    if (!IsCaseId(one.id) || !ids.insert(one.id).second) return "its cases are damaged";
    if (one.values.size() != num_keys) return "its cases are not those of campaign.toml";
    plan.cases.push_back(std::move(one));
  }
  if (plan.cases.empty()) return "it has no case";
  for (const auto& each : json.at("metrics")) {
    plan.metrics.push_back({.name = each.at("name").get<std::string>(),
                            .unit = each.at("unit").get<std::string>(),
                            .text = each.at("text").get<std::string>()});
  }
  return {};
}

/// Returns why results of `plan` cannot be beside those of `folder`; empty: they can.
std::string WhyNotTheSame(const CampaignFolder& folder, const Campaign& campaign,
                          const Plan& plan) {
  if (folder.plan.build != plan.build) {
    return fmt::format(
        "it holds results of another build of shoal ({}; this one is {}): results of "
        "two builds are not mixed",
        TerminalLine(folder.plan.build), plan.build);
  }
  if (SweepKeys(folder.campaign) != SweepKeys(campaign)) {
    return "its campaign sweeps other keys";
  }
  if (folder.plan.identity != plan.identity) {
    return "its campaign has another seed, other samples or other metrics";
  }
  for (const CampaignCase& each : folder.plan.cases) {
    const auto same = std::find_if(plan.cases.begin(), plan.cases.end(), [&](const auto& other) {
      return other.values == each.values && other.policy == each.policy;
    });
    if (same == plan.cases.end()) {
      return fmt::format(
          "it has the case {}, which the campaign file has no more: its results would "
          "be dropped",
          CaseText(folder.campaign, each));
    }
    if (same->id != each.id) {
      return fmt::format(
          "it holds results of another text of the mission {} or of the policy (case "
          "{})",
          campaign.mission_file, CaseText(campaign, each));
    }
  }
  if (campaign.repetitions < folder.campaign.repetitions) {
    return fmt::format(
        "it was made with {} repetitions, the campaign file has {} now: results would "
        "be dropped",
        folder.campaign.repetitions, campaign.repetitions);
  }
  return {};
}

/// True where two lines state the same: NaN is equal to NaN here.
bool AreSame(const TrialResult& a, const TrialResult& b) {
  return a.outcome == b.outcome && a.why == b.why &&
         std::equal(a.metrics.begin(), a.metrics.end(), b.metrics.begin(), b.metrics.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

void AddTrial(FinishedTrial trial, std::map<int64_t, FinishedTrial>* trials,
              std::vector<TrialKey>* differing) {
  const int64_t repetition = trial.key.repetition;
  const auto [there, is_new] = trials->try_emplace(repetition, trial);
  if (is_new || there->second.attempt > trial.attempt) return;
  // A trial that ran out of wall time here may have ended there.
  const bool is_timed = trial.result.outcome == TrialOutcome::kTimeout ||
                        there->second.result.outcome == TrialOutcome::kTimeout;
  if (there->second.attempt == trial.attempt && !is_timed &&
      !AreSame(there->second.result, trial.result)) {
    differing->push_back(trial.key);
  }
  const bool is_better = there->second.result.outcome == TrialOutcome::kTimeout;
  if (there->second.attempt < trial.attempt || is_better) there->second = std::move(trial);
}

}  // namespace

int64_t StoredTrials::size() const {
  int64_t count = 0;
  for (const auto& trials : by_case) count += static_cast<int64_t>(trials.size());
  return count;
}

Result<CampaignFolder> ReadCampaignFolder(const std::string& path) {
  const std::filesystem::path folder_path(path);
  const auto plain = PlainFolder::Open(path);
  if (!plain.ok() || !plain->Has(kFacts)) {
    return Error{
        fmt::format("{}: is not a campaign's folder: it holds no {}; `shoal campaign run FILE "
                    "--out {}` makes one",
                    path, kFacts, path)};
  }
  CampaignFolder folder;
  folder.path = path;
  const FileText text = plain->ReadText(kCampaign);
  if (!text.problem.empty()) return Error{fmt::format("{}/{}: {}", path, kCampaign, text.problem)};
  LoadedCampaign loaded =
      LoadCampaignText(text.text, (folder_path / kCampaign).string(), folder_path.string());
  if (!loaded.errors.empty()) return Error{fmt::format("{}", fmt::join(loaded.errors, "\n"))};
  folder.campaign = std::move(loaded.campaign);
  const FileText facts = plain->ReadText(kFacts);
  std::string problem = facts.problem;
  if (problem.empty()) problem = WhyNotWithin(facts.text, kFactBounds);
  if (problem.empty()) {
    try {
      problem = ReadFacts(facts.text, &folder);
    } catch (const nlohmann::json::exception& error) {
      problem = fmt::format("not what shoal writes ({})", TerminalLine(error.what(), 200));
    }
  }
  if (!problem.empty()) {
    return Error{
        fmt::format("{}/{}: {}; take the file from a copy, or run the campaign into a new "
                    "folder",
                    path, kFacts, problem)};
  }
  return folder;
}

std::string MakeCampaignFolder(const std::string& path) {
  const std::filesystem::path shards = std::filesystem::path(path) / "shards";
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error) {
    const auto folder = PlainFolder::Open(path);
    if (!folder.ok()) return fmt::format("{}; give --out another folder", folder.error());
    const auto below = folder->Below("shards");
    if (!below.ok()) return fmt::format("{}; or give --out another folder", below.error());
  }
  if (!error && access(path.c_str(), W_OK) == 0 && access(shards.c_str(), W_OK) == 0) return {};
  return fmt::format("{}: cannot be made or written: {}; give --out another folder", path,
                     error ? error.message() : ErrnoText(errno));
}

Result<CampaignFolder> OpenCampaignFolder(const std::string& path, const LoadedCampaign& loaded,
                                          const Plan& plan) {
  const std::filesystem::path folder_path(path);
  std::error_code error;
  if (std::string problem = MakeCampaignFolder(path); !problem.empty()) return Error{problem};
  // One at a time: shards may start together.
  const auto plain = PlainFolder::Open(path);
  if (!plain.ok()) return Error{plain.error()};
  const Result<FileDescriptor> lock = plain->OpenFile("lock", 0);
  if (!lock.ok()) return Error{lock.error()};
  if (flock(lock->get(), LOCK_EX) != 0) {
    return Error{fmt::format("{}/lock: cannot be locked: {}", path, ErrnoText(errno))};
  }
  if (plain->Has(kFacts)) {
    Result<CampaignFolder> there = ReadCampaignFolder(path);
    if (!there.ok()) return there;
    const std::string why = WhyNotTheSame(*there, loaded.campaign, plan);
    if (!why.empty()) {
      return Error{fmt::format("{}: {}; give --out another folder", path, why)};
    }
  } else {
    for (const auto& entry : std::filesystem::directory_iterator(folder_path, error)) {
      const std::string name = entry.path().filename().string();
      if (name == "shards" || name == "lock") continue;
      return Error{fmt::format(
          "{}: holds other files ({}) and no campaign: give --out a new folder", path, name)};
    }
  }
  const std::string facts = JsonOf(loaded, plan);
  const std::pair<const char*, const std::string*> files[] = {{kCampaign, &loaded.text},
                                                              {kFacts, &facts}};
  for (const auto& [name, text] : files) {
    const std::string file = (folder_path / name).string();
    if (plain->ReadText(name).text == *text) continue;
    if (std::string problem = ReplaceFile(file, *text); !problem.empty()) return Error{problem};
  }
  return CampaignFolder{.path = path, .campaign = loaded.campaign, .plan = plan};
}

Result<std::string> NewTrialFolder(const std::string& path) {
  const std::filesystem::path trial(path);
  const std::filesystem::path kind = trial.parent_path();
  const auto folder = PlainFolder::Open(kind.parent_path().string());
  if (!folder.ok()) return Error{folder.error()};
  const auto below = folder->Below(kind.filename().string());
  if (!below.ok()) return Error{below.error()};
  if (std::string problem = below->Remove(trial.filename().string()); !problem.empty()) {
    return Error{std::move(problem)};
  }
  const auto made = below->Below(trial.filename().string());
  if (!made.ok()) return Error{made.error()};
  return path;
}

Result<StoredTrials> ReadShards(const CampaignFolder& folder) {
  StoredTrials stored;
  const std::vector<CampaignCase>& cases = folder.plan.cases;
  stored.by_case.resize(cases.size());
  std::map<std::string, size_t, std::less<>> numbers;
  for (size_t i = 0; i < cases.size(); ++i) numbers[cases[i].id] = i;
  const auto plain = PlainFolder::Open(folder.path);
  if (!plain.ok()) return Error{plain.error()};
  const auto shards = plain->Existing("shards");
  if (!shards.ok()) return Error{shards.error()};
  for (const std::string& name : shards->Names()) {
    if (!name.ends_with(".jsonl")) continue;
    const std::string file = fmt::format("{}/{}", shards->path(), TerminalLine(name));
    const Result<FileDescriptor> open = shards->FileToRead(name);
    if (!open.ok()) return Error{fmt::format("{}: {}", file, open.error())};
    // The file that is open, whatever bears its name by now.
    std::ifstream in(fmt::format("/proc/self/fd/{}", open->get()), std::ios::binary);
    if (!in) return Error{fmt::format("{}: cannot be read", file)};
    std::string line;
    line.resize(kLongestTrialLine_bytes + 2);
    while (in.getline(line.data(), static_cast<std::streamsize>(line.size())) || in.gcount() > 0) {
      const std::string_view text(line.data());
      if (in.fail() && !in.eof()) {  // Longer than any trial's line.
        in.clear();
        in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        ++stored.num_torn;
        continue;
      }
      if (text.empty()) continue;
      auto trial = ParseTrialLine(text, folder.plan.metrics);
      if (!trial) {
        ++stored.num_torn;
        continue;
      }
      const auto number = numbers.find(trial->key.case_id);
      if (number == numbers.end() || trial->key.repetition > folder.campaign.repetitions) {
        ++stored.num_foreign;
        continue;
      }
      if (!trial->arithmetic.empty() && trial->arithmetic != folder.plan.arithmetic) {
        stored.of_other_arithmetic.try_emplace(TerminalLine(name), trial->arithmetic);
      }
      AddTrial(*std::move(trial), &stored.by_case[number->second], &stored.differing);
    }
    if (in.bad()) return Error{fmt::format("{}: cannot be read to its end", file)};
  }
  return stored;
}

Result<TrialKey> FindTrial(const CampaignFolder& folder, const std::string& text) {
  const size_t dash = text.find('-');
  const std::string digits = text.substr(0, dash);
  TrialKey key;
  std::vector<const CampaignCase*> found;
  for (const CampaignCase& each : folder.plan.cases) {
    if (!digits.empty() && each.id.starts_with(digits)) found.push_back(&each);
  }
  if (dash != std::string::npos) {
    std::from_chars(text.data() + dash + 1, text.data() + text.size(), key.repetition);
  }
  if (found.size() == 1 && key.repetition >= 1 && key.repetition <= folder.campaign.repetitions) {
    key.case_id = found.front()->id;
    return key;
  }
  constexpr size_t kMaxShown = 20;
  std::string message = fmt::format(
      "no trial '{}': a trial is CASE-REPETITION, with a repetition from 1 to {}; the cases are:",
      text, folder.campaign.repetitions);
  for (size_t i = 0; i < std::min(kMaxShown, folder.plan.cases.size()); ++i) {
    const CampaignCase& each = folder.plan.cases[i];
    message += fmt::format("\n  {}  {}", each.id, CaseText(folder.campaign, each));
  }
  if (folder.plan.cases.size() > kMaxShown) message += "\n  ... (campaign.json lists all)";
  return Error{message};
}

}  // namespace shoal
