#include "lib/tools/view/media_links.h"

#include <algorithm>
#include <numeric>

#include "lib/tools/view/view_limits.h"

namespace shoal {

MediaLinks::MediaLinks(const std::vector<std::string>& media, std::vector<std::string> vehicles)
    : vehicles_(std::move(vehicles)) {
  for (const std::string& medium : media) books_.emplace_back(medium, LinkBook(vehicles_));
}

void MediaLinks::Add(const FateView& fate) {
  if (fate.medium.empty()) return;
  const std::string_view medium = fate.medium.substr(0, kMaxNameBytes);
  auto found = std::ranges::find(books_, medium, [](const auto& each) { return each.first; });
  if (found == books_.end()) {
    if (books_.size() == kMaxMedia) return;
    books_.emplace_back(medium, LinkBook(vehicles_));
    found = books_.end() - 1;
  }
  found->second.Add(fate);
}

std::vector<std::string_view> MediaLinks::Names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, book] : books_) names.push_back(name);
  return names;
}

const LinkBook* MediaLinks::Find(std::string_view medium) const {
  for (const auto& [name, book] : books_) {
    if (name == medium) return &book;
  }
  return nullptr;
}

size_t MediaLinks::num_links() const {
  return std::accumulate(books_.begin(), books_.end(), size_t{0}, [](size_t sum, const auto& each) {
    return sum + each.second.links().size();
  });
}

std::vector<std::string> MediaNamesOf(const Mission& mission) {
  if (!mission.HasMedia()) return {};
  std::vector<std::string> names;
  if (mission.acoustics.is_used) names.emplace_back(kAcousticMedium);
  for (const MediumOptions& medium : mission.media) names.push_back(medium.name);
  const MediaChoice* const choices[] = {&mission.comms.reports_over, &mission.comms.messages_over};
  if (std::ranges::any_of(choices, [](const auto* each) { return each->Has(kDirectMedium); })) {
    names.insert(names.begin(), std::string(kDirectMedium));
  }
  return names;
}

}  // namespace shoal
