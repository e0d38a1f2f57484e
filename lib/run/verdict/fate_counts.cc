#include "lib/run/verdict/fate_counts.h"

#include <algorithm>

#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {
/// Far more than there are; causes that an unregistered sender invents share the last one.
constexpr size_t kMaxCauses = 32;
/// More than any part of a mission counts.
constexpr int64_t kMaxOfALink = int64_t{1} << 50;
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
  Add(PlaceOf(source), PlaceOf(destination), count, &FindOrAdd(cause));
}

void FateCounts::Add(size_t from, size_t to, int64_t count, CauseCount* counted) {
  counted->total += count;
  counted->by_source[from] += count;
  counted->by_destination[to] += count;
  counted->by_link[from].At(to) += count;
}

/// Causes; of each, links and their counts.
void FateCounts::AppendTo(std::vector<uint8_t>* bytes) const {
  AppendLittleEndian(static_cast<uint32_t>(counts_.size()), bytes);
  for (const CauseCount& count : counts_) {
    AppendSizedText(count.cause, bytes);
    uint32_t num_links = 0;
    for (const auto& row : count.by_link) row.ForEach([&](size_t, int64_t) { ++num_links; });
    AppendLittleEndian(num_links, bytes);
    for (size_t from = 0; from < count.by_link.size(); ++from) {
      count.by_link[from].ForEach([&](size_t to, int64_t number) {
        AppendLittleEndian(static_cast<uint32_t>(from), bytes);
        AppendLittleEndian(static_cast<uint32_t>(to), bytes);
        AppendLittleEndian(number, bytes);
      });
    }
  }
}

bool FateCounts::AddFrom(LittleEndianReader* reader) {
  uint32_t num_causes = 0;
  if (!reader->Take(&num_causes)) return false;
  for (uint32_t cause = 0; cause < num_causes; ++cause) {
    std::string text;
    uint32_t num_links = 0;
    if (!reader->TakeSizedText(&text) || !reader->Take(&num_links)) return false;
    CauseCount& counted = FindOrAdd(text);
    for (uint32_t link = 0; link < num_links; ++link) {
      uint32_t from = 0;
      uint32_t to = 0;
      int64_t count = 0;
      if (!reader->Take(&from) || !reader->Take(&to) || !reader->Take(&count)) return false;
      if (from >= num_places_ || to >= num_places_ || count < 1 || count > kMaxOfALink)
        return false;
      Add(from, to, count, &counted);
    }
  }
  return true;
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
