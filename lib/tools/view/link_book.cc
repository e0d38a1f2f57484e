#include "lib/tools/view/link_book.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

void AddUpTo(uint32_t* counter, uint32_t count) {
  *counter += std::min(count, std::numeric_limits<uint32_t>::max() - *counter);
}

template <class Counters>
uint64_t Sum(const Counters& counters) {
  return std::accumulate(counters.begin(), counters.end(), uint64_t{0});
}

}  // namespace

uint64_t LinkCounts::Offered() const { return Sum(offered); }
uint64_t LinkCounts::Received() const { return Sum(received); }

LinkBook::LinkBook(const std::vector<std::string>& vehicles)
    : names_(std::make_shared<const NameTable>(vehicles)), num_first_(names_->size()) {
  GrowTable();
}

LinkPlace LinkBook::Add(const FateView& fate) {
  const FateFacts& facts = fate.facts;
  num_fates_ += facts.count;
  LinkPlace place;
  if (fate.destination != "*" && !fate.destination.empty()) {
    place.from = PlaceOf(fate.source);
    place.to = PlaceOf(fate.destination);
    if (place.from >= 0 && place.to >= 0) place.link = LinkOf(place.from, place.to);
  }
  if (place.link < 0) {
    num_elsewhere_ += facts.count;
    return {};
  }
  LinkCounts& link = links_[static_cast<size_t>(place.link)];
  const auto count = static_cast<uint32_t>(facts.count);
  const auto kind = static_cast<size_t>(facts.kind);
  AddUpTo(&link.offered[kind], count);
  AddUpTo(&link.by_cause[static_cast<size_t>(facts.cause)], count);
  if (IsReceived(facts.cause)) {
    AddUpTo(&link.received[kind], count);
    link.last_received_utime = facts.utime;
  }
  link.last = facts;
  return place;
}

void LinkBook::AddMedium(const FateView& medium) {
  const int32_t from = names_->Find(medium.source);
  const int32_t to = names_->Find(medium.destination);
  if (Find(from, to) == nullptr) return;
  FateFacts& last = links_[static_cast<size_t>(LinkOf(from, to))].last;
  if (last.utime != medium.facts.utime || last.number != medium.facts.number ||
      last.kind != medium.facts.kind || last.cause != medium.facts.cause) {
    return;
  }
  AddMediumNumbers(medium.facts, &last);
}

const LinkCounts* LinkBook::Find(int32_t from, int32_t to) const {
  const auto width = static_cast<int32_t>(table_width_);
  if (from < 0 || to < 0 || from >= width || to >= width) return nullptr;
  const int32_t link = table_[static_cast<size_t>(from) * table_width_ + static_cast<size_t>(to)];
  return link < 0 ? nullptr : &links_[static_cast<size_t>(link)];
}

int32_t LinkBook::PlaceOf(std::string_view name) {
  const int32_t found = names_->Find(name);
  if (found >= 0) return found;
  if (names_->size() >= num_first_ + kMaxUnregistered || !IsLegalVehicleName(name)) return -1;
  auto names = std::make_shared<NameTable>(*names_);
  const int32_t added = names->Add(name);
  names_ = std::move(names);
  if (names_->size() > table_width_) GrowTable();
  return added;
}

int32_t LinkBook::LinkOf(int32_t from, int32_t to) {
  int32_t& link = table_[static_cast<size_t>(from) * table_width_ + static_cast<size_t>(to)];
  if (link < 0 && links_.size() < kMaxLinks) {
    link = static_cast<int32_t>(links_.size());
    LinkCounts& counts = links_.emplace_back();
    counts.from = from;
    counts.to = to;
  }
  return link;
}

void LinkBook::GrowTable() {
  constexpr size_t kMoreNames = 16;
  table_width_ = names_->size() + (table_width_ == 0 ? 0 : kMoreNames);
  table_.assign(table_width_ * table_width_, -1);
  for (size_t i = 0; i < links_.size(); ++i) {
    table_[static_cast<size_t>(links_[i].from) * table_width_ + static_cast<size_t>(links_[i].to)] =
        static_cast<int32_t>(i);
  }
}

}  // namespace shoal
