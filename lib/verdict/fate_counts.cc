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
  counted.by_link[PlaceOf(source) * num_places_ + PlaceOf(destination)] += count;
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
                     .total = 0,
                     .by_link = std::vector<int64_t>(num_places_ * num_places_)});
  return counts_.back();
}

int64_t FateCounts::Sum(const CauseCount& count, int source, int destination) const {
  if (source == kAll && destination == kAll) return count.total;
  const auto range = [this](int vehicle) {
    const auto place = static_cast<size_t>(vehicle);
    return vehicle == kAll ? std::pair(size_t{0}, num_places_) : std::pair(place, place + 1);
  };
  const auto [first_source, end_source] = range(source);
  const auto [first_destination, end_destination] = range(destination);
  int64_t sum = 0;
  for (size_t from = first_source; from < end_source; ++from) {
    for (size_t to = first_destination; to < end_destination; ++to) {
      sum += count.by_link[from * num_places_ + to];
    }
  }
  return sum;
}

}  // namespace shoal
