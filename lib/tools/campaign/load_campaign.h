// Reads campaign files. docs/campaigns/campaigns.md documents each key.
//
//   LoadedCampaign loaded = LoadCampaign("campaigns/crossing.toml");
//   if (!loaded.errors.empty()) { print them; exit 2; }
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/campaign/campaign.h"

namespace shoal {

struct LoadedCampaign {
  Campaign campaign;                ///< Usable only where `errors` is empty.
  std::vector<std::string> errors;  ///< "file:line:column: what is wrong and how to fix it".
  std::string text;                 ///< Of the file.
};

/// Reads the file `path`. Its mission is not opened: lib/tools/campaign/plan.h does that.
[[nodiscard]] LoadedCampaign LoadCampaign(const std::string& path);

/// The same for text in memory; `name` stands for the file in messages. The mission's path is
/// relative to `folder`.
[[nodiscard]] LoadedCampaign LoadCampaignText(std::string_view text, const std::string& name,
                                              const std::string& folder);

}  // namespace shoal
