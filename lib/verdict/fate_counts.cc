#include "lib/verdict/fate_counts.h"

#include <algorithm>

#include "lib/routing/vehicle_name.h"

namespace shoal {

namespace {
/// Far more than there are; causes that an unregistered sender invents share the last one.
constexpr size_t kMaxCauses = 32;
}  // namespace

FateCounts::FateCounts(const std::vector<std::string>& vehicles)
    : num_places_(vehicles.size() + 1) {
  for (size_t i = 0; i < vehicles.size(); ++i) {
    places_[vehicles[i]] = i;
    places_[VehicleKey(vehicles[i])] = i;
  }
}

void FateCounts::Add(std::string_view source, std::string_view destination, std::string_view cause,
                     int32_t count) {
  if (count < 1) return;
  CauseCount& counted = FindOrAdd(cause);
  counted.total += count;
  const size_t from = PlaceOf(source);
  const size_t to = PlaceOf(destination);
  counted.by_source[from] += count;
  counted.by_destination[to] += count;
  counted.by_link[from].At(to) += count;
}

int64_t FateCounts::Count(int source, int destination, std::string_view cause) const {
  for (const CauseCount& count : counts_) {
    if (count.cause == cause) return Sum(count, source, destination);
  }
  return 0;
}

int64_t FateCounts::CountOffered(int source, int destination) const {
  int64_t offered = 0;
  for (const CauseCount& count : counts_) offered += Sum(count, source, destination);
  return offered;
}

std::map<std::string, int64_t> FateCounts::Totals() const {
  std::map<std::string, int64_t> totals;
  for (const CauseCount& count : counts_) totals[count.cause] = count.total;
  return totals;
}

size_t FateCounts::PlaceOf(std::string_view name) const {
  auto place = places_.find(name);  // Nearly always spelled as the mission spells it.
  if (place == places_.end()) place = places_.find(VehicleKey(name));
  return place == places_.end() ? num_places_ - 1 : place->second;
}

FateCounts::CauseCount& FateCounts::FindOrAdd(std::string_view cause) {
  for (CauseCount& count : counts_) {
    if (count.cause == cause) return count;
  }
  if (counts_.size() == kMaxCauses) return counts_.back();
  const bool is_last = counts_.size() == kMaxCauses - 1;
  counts_.push_back({.cause = is_last ? "other" : std::string(cause.substr(0, 64)),
                     .by_source = std::vector<int64_t>(num_places_),
                     .by_destination = std::vector<int64_t>(num_places_)});
  counts_.back().by_link.resize(num_places_);
  return counts_.back();
}

int64_t FateCounts::Sum(const CauseCount& count, int source, int destination) const {
  const auto from = static_cast<size_t>(source);
  const auto to = static_cast<size_t>(destination);
  if (source == kAll) return destination == kAll ? count.total : count.by_destination[to];
  return destination == kAll ? count.by_source[from] : count.by_link[from].Get(to);
}

}  // namespace shoal
