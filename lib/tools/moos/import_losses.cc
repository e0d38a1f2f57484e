#include "lib/tools/moos/import_losses.h"

#include <fmt/format.h>

#include <utility>

#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/import_settings.h"

namespace shoal {

void ImportLosses::Warn(std::string warning) {
  if (warned_.insert(warning).second) warnings_.push_back(std::move(warning));
}

void ImportLosses::Lose(std::string loss) {
  if (warned_.insert("lost: " + loss).second) lost_.push_back(std::move(loss));
}

void ImportLosses::LoseApp(const std::string& app, const std::string& origin) {
  if (!lost_apps_.insert(AppClass(app)).second) return;
  Lose(fmt::format("{}: app {}: no counterpart in shoal", origin, CleanUtf8(app)));
}

}  // namespace shoal
