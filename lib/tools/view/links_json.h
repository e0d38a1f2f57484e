// Writes what /api/links and /api/link answer.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/tools/view/fate_history.h"
#include "lib/tools/view/link_history.h"
#include "lib/tools/view/scene.h"

namespace shoal {

/// Returns the link matrix at the scene's time.
[[nodiscard]] std::string LinksJson(const Scene& scene);

/// Returns the link matrix of one medium, or an error that lists the mission's media.
[[nodiscard]] Result<std::string> MediumLinksJson(const Scene& scene, std::string_view medium);

/// One link's history.
struct LinkAnswer {
  std::string_view from;
  std::string_view to;
  const LinkCounts* counts = nullptr;  ///< nullptr: it has had no fates.
  std::vector<RatioBin> bins = {};
  std::vector<RangeSample> ranges = {};
  std::vector<const KeptFate*> fates = {};  ///< The newest first.
};
[[nodiscard]] std::string LinkJson(const Scene& scene, const LinkAnswer& answer);

}  // namespace shoal
