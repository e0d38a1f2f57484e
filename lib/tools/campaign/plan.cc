#include "lib/tools/campaign/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "lib/base/arithmetic/arithmetic_id.h"
#include "lib/base/text/terminal_text.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/file/data_files.h"
#include "lib/mission/file/load.h"
#include "lib/mission/toml/problems.h"
#include "lib/tools/campaign/digest.h"
#include "lib/tools/campaign/samples.h"
#include "lib/tools/campaign/toml_text.h"
#include "lib/tools/metrics/read_metrics.h"
#include "lib/tools/metrics/trial_watch.h"

namespace shoal {

namespace {

constexpr size_t kCaseDigits = 10;
constexpr size_t kIdentityDigits = 32;

/// All sweep points under all policies, the last axis fastest, policies faster still.
std::vector<CampaignCase> MakeCases(const Campaign& campaign) {
  std::vector<std::vector<std::string>> points = {{}};
  for (const SweepAxis& axis : campaign.sweep) {
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& point : points) {
      for (const std::vector<std::string>& step : axis.values) {
        longer.push_back(point);
        longer.back().insert(longer.back().end(), step.begin(), step.end());
      }
    }
    points = std::move(longer);
  }
  std::vector<CampaignCase> cases;
  for (const std::vector<std::string>& point : points) {
    for (const Policy& policy : campaign.policies) {
      cases.push_back({.id = {}, .values = point, .policy = policy.name});
    }
  }
  return cases;
}

std::vector<std::string> SettingsOf(const Campaign& campaign, const CampaignCase& each) {
  std::vector<std::string> overrides;
  for (const Setting& setting : campaign.settings) overrides.push_back(setting.AsOverride());
  const std::vector<std::string> keys = SweepKeys(campaign);
  for (size_t i = 0; i < keys.size(); ++i) overrides.push_back(keys[i] + "=" + each.values[i]);
  for (const Policy& policy : campaign.policies) {
    if (policy.name != each.policy) continue;
    for (const Setting& setting : policy.settings) overrides.push_back(setting.AsOverride());
  }
  return overrides;
}

std::vector<std::string> WithRepetition(const Campaign& campaign,
                                        std::vector<std::string> overrides, int64_t repetition) {
  const std::vector<std::string> samples = SamplesOf(campaign, repetition);
  for (size_t i = 0; i < samples.size(); ++i) {
    overrides.push_back(campaign.samples[i].key + "=" + samples[i]);
  }
  overrides.push_back(fmt::format("mission.seed={}", SeedOf(campaign, repetition)));
  return overrides;
}

/// What draws the samples: every trial depends on it.
void AddSampling(const Campaign& campaign, Digest* digest) {
  digest->Add(fmt::format("{} {}", campaign.seed, campaign.latin_hypercube));
  for (const SampledKey& key : campaign.samples) {
    digest->Add(key.key).Add(fmt::format("{} {} {} {}", static_cast<int>(key.kind), key.first,
                                         key.second, key.is_integer));
    for (const std::string& choice : key.choices) digest->Add(choice);
  }
}

/// A mission's files of data: with others the same mission is another one.
void AddDataFiles(const Mission& mission, Digest* digest) {
  const auto folder = std::filesystem::path(mission.file).parent_path();
  for (const std::string& file : DataFilesOf(mission)) {
    digest->Add(ReadRegularFile((folder / file).string()).text);
  }
}

}  // namespace

std::vector<std::string> ProgramsOf(const Mission& mission) {
  std::vector<std::string> programs;
  // They are shown, and the mission may come from elsewhere.
  for (const Participant& each : mission.participants) {
    if (each.command.empty()) continue;
    programs.push_back(
        TerminalLine(fmt::format("{}: {}", each.name, fmt::join(each.command, " "))));
  }
  if (mission.netsim) {
    std::string text = "netsim: TCP ports";
    for (const NetsimVehicle& vehicle : mission.netsim->vehicles) {
      if (!vehicle.gps.path.empty()) text += "; positions to " + vehicle.gps.path;
    }
    programs.push_back(TerminalLine(text));
  }
  return programs;
}

std::vector<std::string> SweepKeys(const Campaign& campaign) {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : campaign.sweep) {
    keys.insert(keys.end(), axis.keys.begin(), axis.keys.end());
  }
  return keys;
}

std::string CaseText(const Campaign& campaign, const CampaignCase& each) {
  std::string text;
  const std::vector<std::string> keys = SweepKeys(campaign);
  for (size_t i = 0; i < keys.size(); ++i) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", keys[i], TerminalLine(each.values[i]));
  }
  if (!each.policy.empty()) {
    text += fmt::format("{}policy={}", text.empty() ? "" : ", ", TerminalLine(each.policy));
  }
  return text.empty() ? "all" : text;
}

MadePlan MakePlan(const Campaign& campaign, const std::string& build) {
  MadePlan made;
  Plan& plan = made.plan;
  const FileText file = ReadRegularFile(campaign.mission_file);
  if (!file.problem.empty()) {
    made.errors.push_back(
        fmt::format("{}: its mission {}: {}", campaign.file, campaign.mission_file, file.problem));
    return made;
  }
  plan.mission_text = file.text;
  plan.build = build;
  plan.arithmetic = ArithmeticId();
  plan.cases = MakeCases(campaign);

  Digest identity;
  identity.Add(build);
  AddSampling(campaign, &identity);
  // Results with other metrics have other columns.
  identity.Add(TomlText(campaign.metrics_table));
  std::vector<std::string> first_errors;
  bool is_first = true;
  std::set<std::string> ids;
  for (CampaignCase& each : plan.cases) {
    const std::vector<std::string> settings = SettingsOf(campaign, each);
    const LoadedMission loaded = LoadMissionText(plan.mission_text, campaign.mission_file,
                                                 WithRepetition(campaign, settings, 1));
    Digest digest = identity;
    digest.Add(each.policy);
    for (const std::string& setting : settings) digest.Add(setting);
    if (loaded.errors.empty()) {
      digest.Add(Explain(loaded.mission));
      AddDataFiles(loaded.mission, &digest);
      for (std::string& program : ProgramsOf(loaded.mission)) {
        if (std::ranges::find(made.programs, program) == made.programs.end()) {
          made.programs.push_back(std::move(program));
        }
      }
    } else {
      digest.Add(plan.mission_text);
      std::string text = fmt::format("case {}:", CaseText(campaign, each));
      for (const std::string& error : loaded.errors) text += "\n  " + error;
      made.bad_cases.push_back(std::move(text));
      if (first_errors.empty()) first_errors = loaded.errors;
    }
    each.id = digest.Hex(kCaseDigits);
    if (!ids.insert(each.id).second) {
      made.errors.push_back(fmt::format("{}: the case {} is in the sweep twice", campaign.file,
                                        CaseText(campaign, each)));
    }
    if (!loaded.errors.empty() || !is_first) continue;
    is_first = false;
    Problems problems(campaign.file, {});
    plan.metric_specs = campaign.metrics;
    CheckMetrics(campaign.metrics_table, loaded.mission, problems, &plan.metric_specs);
    const std::vector<std::string> errors = problems.InOrder();
    made.errors.insert(made.errors.end(), errors.begin(), errors.end());
    if (errors.empty()) plan.metrics = TrialWatch::Names(loaded.mission, plan.metric_specs);
  }
  if (is_first) made.errors.insert(made.errors.end(), first_errors.begin(), first_errors.end());
  if (made.errors.empty() && campaign.stop && campaign.stop->metric != "pass" &&
      std::none_of(plan.metrics.begin(), plan.metrics.end(), [&](const MetricName& metric) {
        return metric.name == campaign.stop->metric;
      })) {
    made.errors.push_back(
        fmt::format("{}: [stop] metric = \"{}\" is neither \"pass\" nor a metric "
                    "of this campaign",
                    campaign.file, campaign.stop->metric));
  }
  plan.identity = identity.Hex(kIdentityDigits);
  return made;
}

std::vector<std::string> OverridesOf(const Campaign& campaign, const Plan& plan, size_t case_number,
                                     int64_t repetition) {
  return WithRepetition(campaign, SettingsOf(campaign, plan.cases[case_number]), repetition);
}

}  // namespace shoal
