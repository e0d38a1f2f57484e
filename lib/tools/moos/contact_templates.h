// Templates of behaviors about contacts, where shoal spawns other than MOOS-IvP.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "lib/tools/moos/bhv_file.h"

namespace shoal {

/// Returns true for a template of a kind that does not keep clear and asks for alerts.
[[nodiscard]] bool AsksForAlerts(const BhvBlock& block);

/// Returns true for such a template where MOOS-IvP has no range for its alerts.
[[nodiscard]] bool NeedsOneForEach(const BhvBlock& block);

/// Returns a template as one behavior for each contact, instead of one that is spawned.
[[nodiscard]] std::vector<BhvBlock> OneForEach(const BhvBlock& block,
                                               const std::vector<std::string>& contacts);

/// Adds the variables of conditions with $[CONTACT], of each contact.
void CollectVariablesOfContacts(const BhvBlock& block, const std::vector<std::string>& contacts,
                                std::set<std::string, std::less<>>* variables);

}  // namespace shoal
