#include "lib/tools/view/fate_history.h"

#include <algorithm>

#include "lib/comms/routing/vehicle_name.h"
#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

bool IsName(const std::string& name, std::string_view key) {
  return name.size() == key.size() && VehicleKey(name) == key;
}

}  // namespace

FateView KeptFate::view() const {
  return {.facts = facts,
          .source = source,
          .destination = destination,
          .colliders = {colliders.begin(), colliders.end()},
          .medium = medium};
}

void FateHistory::Add(const FateView& fate) {
  kinds_seen_[static_cast<size_t>(fate.facts.kind)] = true;
  causes_seen_[static_cast<size_t>(fate.facts.cause)] = true;
  if (fates_.size() < max_fates_) fates_.emplace_back();
  KeptFate& kept = fates_[next_];
  next_ = next_ + 1 == max_fates_ ? 0 : next_ + 1;
  kept.id = next_id_++;
  kept.facts = fate.facts;
  kept.medium.clear();
  kept.source = fate.source.substr(0, kMaxNameBytes);
  kept.destination = fate.destination.substr(0, kMaxNameBytes);
  const size_t num_colliders = std::min(fate.colliders.size(), kMaxColliders);
  kept.colliders.resize(num_colliders);
  for (size_t i = 0; i < num_colliders; ++i) {
    kept.colliders[i] = fate.colliders[i].substr(0, kMaxNameBytes);
  }
}

void FateHistory::AddMedium(const FateView& medium) {
  constexpr int kMaxSearched = 5000;
  next_medium_id_ = std::max(next_medium_id_, next_id_ - static_cast<int64_t>(fates_.size()));
  while (next_medium_id_ < next_id_ && ById(next_medium_id_).facts.utime < medium.facts.utime) {
    ++next_medium_id_;
  }
  const auto is_same = [&](const KeptFate& fate) {
    return fate.facts.number == medium.facts.number && fate.facts.kind == medium.facts.kind &&
           fate.facts.cause == medium.facts.cause && fate.source == medium.source &&
           fate.destination == medium.destination;
  };
  int num_searched = 0;
  for (int64_t id = next_medium_id_; id < next_id_ && num_searched < kMaxSearched;
       ++id, ++num_searched) {
    KeptFate& fate = ById(id);
    if (!is_same(fate)) continue;
    AddMediumNumbers(medium.facts, &fate.facts);
    fate.medium = medium.medium.substr(0, kMaxNameBytes);
    next_medium_id_ = id + 1;
    return;
  }
}

std::vector<const KeptFate*> FateHistory::Find(const FateQuery& query) const {
  const std::string vehicle = VehicleKey(query.vehicle);
  const auto is_asked_for = [&](const KeptFate& fate) {
    if (query.only_blocked && IsReceived(fate.facts.cause)) return false;
    if (!query.kind.empty() && KindText(fate.facts.kind) != query.kind) return false;
    if (!query.cause.empty() && CauseText(fate.facts.cause) != query.cause) return false;
    return vehicle.empty() || IsName(fate.source, vehicle) || IsName(fate.destination, vehicle);
  };
  const auto limit = static_cast<size_t>(std::clamp(query.limit, 1, kMaxAnswer));
  std::vector<const KeptFate*> found;
  if (query.after < 0) {
    for (size_t i = 0; i < fates_.size() && found.size() < limit; ++i) {
      if (is_asked_for(FromNewest(i))) found.push_back(&FromNewest(i));
    }
    return found;
  }
  const int64_t behind = std::max<int64_t>(next_id_ - 1 - query.after, 0);
  for (size_t i = std::min(fates_.size(), static_cast<size_t>(behind));
       i-- > 0 && found.size() < limit;) {
    if (is_asked_for(FromNewest(i))) found.push_back(&FromNewest(i));
  }
  std::reverse(found.begin(), found.end());
  return found;
}

std::vector<const KeptFate*> FateHistory::OfLink(std::string_view from, std::string_view to,
                                                 size_t limit) const {
  const std::string source = VehicleKey(from);
  const std::string destination = VehicleKey(to);
  std::vector<const KeptFate*> found;
  for (size_t i = 0; i < fates_.size() && found.size() < limit; ++i) {
    const KeptFate& fate = FromNewest(i);
    if (IsName(fate.source, source) && IsName(fate.destination, destination)) {
      found.push_back(&fate);
    }
  }
  return found;
}

int64_t FateHistory::num_forgotten() const {
  return next_id_ - 1 - static_cast<int64_t>(fates_.size());
}

const KeptFate& FateHistory::FromNewest(size_t i) const {
  const size_t size = fates_.size();
  return fates_[(next_ + 2 * size - 1 - i) % size];
}

KeptFate& FateHistory::ById(int64_t id) {
  const size_t size = fates_.size();
  return fates_[(next_ + 2 * size - static_cast<size_t>(next_id_ - id)) % size];
}

}  // namespace shoal
