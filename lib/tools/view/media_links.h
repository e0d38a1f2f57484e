// The link matrix of each medium, from COMMS_MEDIA.
//
//   MediaLinks media(MediaNamesOf(mission), vehicles);
//   media.Add(fate);                          // with fate.medium
//   const LinkBook* vhf = media.Find("vhf");
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/tools/view/link_book.h"

namespace shoal {

class MediaLinks {
 public:
  /// Fates of more media are not kept.
  static constexpr size_t kMaxMedia = 32;

  MediaLinks() = default;
  /// Begins with these media, all of whose links are empty.
  MediaLinks(const std::vector<std::string>& media, std::vector<std::string> vehicles);

  /// Counts a fate for its medium; one without is not counted.
  void Add(const FateView& fate);

  /// In order of the mission, then of appearance.
  std::vector<std::string_view> Names() const;
  /// Returns the links of a medium, or nullptr where nothing is known of one of this name.
  const LinkBook* Find(std::string_view medium) const;
  /// Links of all media that have had fates.
  size_t num_links() const;

 private:
  friend class IndexArchive;  ///< kept_index.cc, which writes and reads all of it.

  std::vector<std::string> vehicles_;
  std::vector<std::pair<std::string, LinkBook>> books_;
};

/// Returns what a mission names as carriers of its traffic; empty for one without media of its own.
[[nodiscard]] std::vector<std::string> MediaNamesOf(const Mission& mission);

}  // namespace shoal
