#include "lib/tools/view/page_backgrounds.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lib/base/check/result.h"
#include "lib/tools/page/base64.h"

namespace shoal {

nlohmann::json BackgroundsForPage(const BackgroundFolder& backgrounds, size_t max_bytes,
                                  std::vector<std::string>* notes) {
  nlohmann::json held = nlohmann::json::array();
  for (size_t i = 0; i < backgrounds.files.size(); ++i) {
    const std::string& file = backgrounds.files[i];
    if (KindOfBackground(file) != BackgroundKind::kFile) {
      notes->push_back(
          fmt::format("the tiles {} are not in the page: drop them onto the map", file));
      continue;
    }
    const Result<std::string> bytes = backgrounds.Read(i, false);
    if (!bytes.ok()) {
      notes->push_back(bytes.error());
      continue;
    }
    if (bytes->size() > max_bytes) {
      notes->push_back(fmt::format(
          "the background {} ({:.1f} MB) is too large for the page: drop it onto the map", file,
          static_cast<double>(bytes->size()) / 1e6));
      continue;
    }
    max_bytes -= bytes->size();
    const Result<std::string> world =
        backgrounds.HasWorld(i) ? backgrounds.Read(i, true) : Result<std::string>(std::string());
    held.push_back({{"file", file},
                    {"bytes", Base64(*bytes)},
                    {"world", world.ok() ? Base64(*world) : std::string()}});
  }
  return held;
}

}  // namespace shoal
