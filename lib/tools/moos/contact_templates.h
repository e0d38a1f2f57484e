// Templates of behaviors about contacts, where shoal spawns other than MOOS-IvP.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "lib/tools/moos/bhv_file.h"

namespace shoal {

/// True for a template whose behaviors shoal does not spawn as MOOS-IvP does: with alerts for a
/// kind that is spawned by updates alone.
[[nodiscard]] bool NeedsOneForEach(const BhvBlock& block);

/// Returns a template as one behavior for each contact, instead of one that is spawned.
[[nodiscard]] std::vector<BhvBlock> OneForEach(const BhvBlock& block,
                                               const std::vector<std::string>& contacts);

/// Adds the variables of conditions with $[CONTACT], of each contact.
void CollectVariablesOfContacts(const BhvBlock& block, const std::vector<std::string>& contacts,
                                std::set<std::string, std::less<>>* variables);

}  // namespace shoal
