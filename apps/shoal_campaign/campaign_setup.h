// What the subcommands of `shoal campaign` have in common: the campaign's file, signals, and how
// results are stated.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/text/terminal_text.h"
#include "lib/tools/campaign/load_campaign.h"
#include "lib/tools/campaign/plan.h"
#include "lib/tools/campaign/results.h"

namespace shoal {

/// Prints as fmt::print does, for a terminal: names, values and reasons are of a folder or mission
/// that may have come from elsewhere.
template <class... Args>
void Show(fmt::format_string<Args...> form, Args&&... args) {
  fmt::print("{}", TerminalText(fmt::format(form, std::forward<Args>(args)...)));
}
template <class... Args>
void ShowError(fmt::format_string<Args...> form, Args&&... args) {
  fmt::print(stderr, "{}", TerminalText(fmt::format(form, std::forward<Args>(args)...)));
}

void PrintErrors(const std::vector<std::string>& errors);

struct PreparedCampaign {
  LoadedCampaign loaded;
  MadePlan made;
};

/// Loads file and missions, and prints what is wrong. Returns an exit code where it cannot be run.
std::optional<int> PrepareCampaign(const std::string& file, PreparedCampaign* prepared);

/// Ctrl-C and its like make IsCampaignInterrupted true, and break off what waits.
void CatchCampaignSignals();
bool IsCampaignInterrupted();

/// "1000 trials: 986 pass, 14 fail, 0 error, 0 timeout"
std::string CountsText(const CampaignResults& results);

/// Names the first trials that are errors or ran out of time.
void PrintTroubles(const CampaignResults& results);
/// True where there are such trials.
bool HasTroubles(const CampaignResults& results);

}  // namespace shoal
