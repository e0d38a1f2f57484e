#include "apps/shoal_campaign/campaign_setup.h"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <set>

#include "lib/base/check/result.h"
#include "lib/run/command_line/build_id.h"

namespace shoal {

namespace {

std::atomic<bool> campaign_interrupted = false;

/// No line of a reason looks like one of our own.
std::string Indented(const std::string& text) {
  std::string indented;
  for (const char c : text) {
    indented += c;
    if (c == '\n') indented += "    ";
  }
  return indented;
}

int64_t CountOutcomes(const CampaignResults& results, TrialOutcome outcome) {
  return std::count_if(results.rows.begin(), results.rows.end(),
                       [outcome](const TrialRow& row) { return row.result.outcome == outcome; });
}

}  // namespace

void PrintErrors(const std::vector<std::string>& errors) {
  for (const std::string& error : errors) ShowError("{}\n", error);
}

std::optional<int> PrepareCampaign(const std::string& file, PreparedCampaign* prepared) {
  prepared->loaded = LoadCampaign(file);
  PrintErrors(prepared->loaded.errors);
  if (!prepared->loaded.errors.empty()) return kExitUsage;
  prepared->made = MakePlan(prepared->loaded.campaign, BuildId());
  PrintErrors(prepared->made.errors);
  if (!prepared->made.errors.empty()) return kExitUsage;
  PrintErrors(prepared->made.bad_cases);
  return std::nullopt;
}

void CatchCampaignSignals() {
  struct sigaction action = {};
  action.sa_handler = [](int) { campaign_interrupted = true; };
  for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaction(each, &action, nullptr);
  // A worker that died breaks its pipe.
  signal(SIGPIPE, SIG_IGN);
}

bool IsCampaignInterrupted() { return campaign_interrupted; }

std::string CountsText(const CampaignResults& results) {
  std::string text = fmt::format("{} trials", results.rows.size());
  for (size_t i = 0; i < kTrialOutcomeNames.size(); ++i) {
    text += fmt::format("{} {} {}", i == 0 ? ":" : ",",
                        CountOutcomes(results, static_cast<TrialOutcome>(i)),
                        NameOf(static_cast<TrialOutcome>(i)));
  }
  if (results.num_beyond_stop > 0) {
    text += fmt::format("; {} more beyond the look at which their case stopped",
                        results.num_beyond_stop);
  }
  return text;
}

void PrintTroubles(const CampaignResults& results) {
  constexpr int kMax = 5;
  int num_shown = 0;
  std::set<std::string> shown;
  for (const TrialRow& row : results.rows) {
    const bool is_trouble =
        row.result.outcome == TrialOutcome::kError || row.result.outcome == TrialOutcome::kTimeout;
    if (!is_trouble || !shown.insert(row.result.why).second) continue;
    const CampaignCase& each = results.cases[row.case_number];
    ShowError("{} {}: {}: {}\n", TrialName({each.id, row.repetition}),
              CaseText(results.campaign, each), NameOf(row.result.outcome),
              Indented(row.result.why));
    if (++num_shown == kMax) break;
  }
}

bool HasTroubles(const CampaignResults& results) {
  return CountOutcomes(results, TrialOutcome::kError) > 0 ||
         CountOutcomes(results, TrialOutcome::kTimeout) > 0;
}

}  // namespace shoal
