#include "lib/routing/router.h"

#include <algorithm>
#include <utility>

#include "lib/check/check.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

Router::Router(const RoutingRules& rules, uint64_t seed, std::span<const std::string> vehicles)
    : seed_(seed) {
  SetRules(rules);
  for (const std::string& name : vehicles) {
    const auto [entry, is_new] = contacts_.try_emplace(VehicleKey(name));
    SHOAL_CHECK(is_new && IsLegalVehicleName(name), "a mission's vehicles have names of their own");
    Contact& contact = entry->second;
    contact.name = name;
    contact.key = entry->first;
    contact.index = static_cast<int32_t>(by_index_.size());
    contact.of_mission = true;
    by_index_.push_back(&contact);
  }
  RankContacts();
}

void Router::SetRules(const RoutingRules& rules) {
  rules_ = rules;
  ignored_group_key_ = VehicleKey(rules.ignore_group);
  grid_is_valid_ = false;
  num_stale_utime_ = kNever;
}

std::optional<LinkFactors> Router::FindFactors(std::string_view name) const {
  if (!IsLegalVehicleName(name)) return std::nullopt;
  if (const Contact* contact = Find(name)) return contact->factors;
  if (num_strangers_ == kMaxStrangers && num_unknown_strangers_ == 0) return std::nullopt;
  return LinkFactors();
}

bool Router::SetFactors(std::string_view name, const LinkFactors& factors) {
  Contact* contact = IsLegalVehicleName(name) ? FindOrAdd(name) : nullptr;
  if (contact == nullptr) return false;
  contact->factors = factors;
  grid_is_valid_ = false;
  return true;
}

bool Router::RequestFullReports(std::string_view name) {
  Contact* receiver = Find(name);
  if (receiver == nullptr || !(receiver->of_mission || receiver->known)) return false;
  if (receiver->num_wanted > 0) --num_wanting_;
  receiver->num_wanted = 0;
  receiver->wants_report_of.assign(by_index_.size(), 0);
  for (const Contact* source : by_rank_) {
    if (source == receiver || !(source->of_mission || source->known)) continue;
    receiver->wants_report_of[static_cast<size_t>(source->index)] = 1;
    ++receiver->num_wanted;
  }
  if (receiver->num_wanted > 0) ++num_wanting_;
  return true;
}

Admission Router::Admit(const ReportFacts& report, int64_t utime) {
  if (!IsLegalVehicleName(report.name) || !report.position_m.allFinite()) {
    return Refuse(report.name);
  }
  std::string group_key = VehicleKey(report.group);
  if (!ignored_group_key_.empty() && group_key == ignored_group_key_) {
    return RefuseBecause(Cause::kIgnoredGroup, Find(report.name));
  }
  Contact* contact = FindOrAdd(report.name);
  if (contact == nullptr) return RefuseBecause(Cause::kTooManyVehicles, nullptr);

  if (!contact->known) {
    contact->known = true;
    ++num_known_;
    if (!contact->of_mission) --num_unknown_strangers_;
  }
  contact->group_key = group_key;
  contact->position_m = report.position_m;
  contact->received_utime = utime;
  ++contact->num_admitted;
  ++num_admitted_;
  if (grid_is_valid_) grid_.Put(contact->index, contact->position_m);
  num_stale_utime_ = kNever;
  return {.refused = std::nullopt,
          .source = contact->index,
          .number = TakeNumber(Kind::kReport, contact),
          .position_m = report.position_m,
          .group_key = std::move(group_key)};
}

Admission Router::Refuse(std::string_view name) {
  return RefuseBecause(Cause::kInvalid, IsLegalVehicleName(name) ? Find(name) : nullptr);
}

Admission Router::RefuseBecause(Cause cause, Contact* source) {
  ++counts_[static_cast<size_t>(Kind::kReport)][static_cast<size_t>(cause)];
  if (source != nullptr) {
    ++source->sent[static_cast<size_t>(Kind::kReport)][static_cast<size_t>(cause)];
  }
  return {.refused = cause,
          .source = source == nullptr ? kNobody : source->index,
          .number = TakeNumber(Kind::kReport, source),
          .position_m = Eigen::Vector3d::Zero(),
          .group_key = {}};
}

int64_t Router::TakeNumber(Kind kind, Contact* source) {
  const auto place = static_cast<size_t>(kind);
  ++num_offered_[place];
  return source == nullptr ? num_of_nobody_[place]++ : source->num_sent[place]++;
}

Transmission Router::MakeTransmission(Kind kind, int64_t number, const Contact& source) const {
  Transmission sent = {.kind = kind,
                       .number = number,
                       .position_m = source.position_m,
                       .group_key = source.group_key,
                       .stealth = source.factors.stealth,
                       .link_key = std::nullopt};
  if (rules_.drop_percentage > 0) sent.link_key = DropKey(seed_, kind, source.key);
  return sent;
}

void Router::Record(const Decision& decision, Contact* source, Contact* receiver,
                    std::vector<Decision>* decisions) {
  Decision& recorded = decisions->emplace_back(decision);
  if (decision.cause == Cause::kDelivered && MediumOf(rules_, decision.kind) == Medium::kAcoustic) {
    recorded.cause = Cause::kInTransit;
  }
  const auto kind = static_cast<size_t>(recorded.kind);
  const auto cause = static_cast<size_t>(recorded.cause);
  counts_[kind][cause] += decision.count;
  if (source != nullptr) {
    recorded.source = source->index;
    source->sent[kind][cause] += decision.count;
  }
  if (receiver != nullptr) {
    recorded.destination = receiver->index;
    receiver->heard[kind][cause] += decision.count;
  }
}

Decision Router::Conclude(const Decision& pending, std::string_view source,
                          std::string_view destination, Cause cause) {
  SHOAL_CHECK(pending.cause == Cause::kInTransit, "only what is in transit has no fate yet");
  const auto kind = static_cast<size_t>(pending.kind);
  const auto move = [&](CauseCounts* counts) {
    int64_t& num_in_transit = (*counts)[static_cast<size_t>(Cause::kInTransit)];
    if (num_in_transit == 0) return;  // Another vehicle, that has taken the name.
    --num_in_transit;
    ++(*counts)[static_cast<size_t>(cause)];
  };
  move(&counts_[kind]);
  if (Contact* contact = Find(source)) move(&contact->sent[kind]);
  if (Contact* contact = Find(destination)) move(&contact->heard[kind]);
  Decision concluded = pending;
  concluded.cause = cause;
  return concluded;
}

int64_t Router::NumInTransit() const {
  int64_t sum = 0;
  for (const CauseCounts& counts : counts_) sum += counts[static_cast<size_t>(Cause::kInTransit)];
  return sum;
}

void Router::ForgetSilent(int64_t utime, std::vector<int32_t>* forgotten) {
  if (rules_.stale_forget_s < 0) return;
  for (Contact* contact : by_rank_) {
    if (!contact->known) continue;
    if (SecondsBetween(contact->received_utime, utime) < rules_.stale_forget_s) continue;
    contact->known = false;
    contact->group_key.clear();
    contact->message_utime = kNever;
    contact->last_message_utime = kNever;
    contact->delivered_utime.clear();
    contact->wants_report_of.clear();
    if (contact->num_wanted > 0) --num_wanting_;
    contact->num_wanted = 0;
    for (Contact* other : by_rank_) {
      const auto place = static_cast<size_t>(contact->index);
      if (place < other->delivered_utime.size()) other->delivered_utime[place] = kNever;
    }
    --num_known_;
    if (!contact->of_mission) ++num_unknown_strangers_;
    if (grid_is_valid_) grid_.Remove(contact->index);
    num_stale_utime_ = kNever;
    if (forgotten != nullptr) forgotten->push_back(contact->index);
  }
}

int Router::NumStale(int64_t utime) const {
  if (num_stale_utime_ == utime) return num_stale_;
  num_stale_ = 0;
  for (const Contact* contact : by_rank_) {
    if (contact->known && IsStale(rules_, contact->received_utime, utime)) ++num_stale_;
  }
  num_stale_utime_ = utime;
  return num_stale_;
}

const Contact* Router::Find(std::string_view name) const {
  const auto found = contacts_.find(VehicleKey(name));
  return found == contacts_.end() ? nullptr : &found->second;
}

Contact* Router::Find(std::string_view name) {
  return const_cast<Contact*>(std::as_const(*this).Find(name));
}

Contact* Router::FindOrAdd(std::string_view name) {
  if (Contact* contact = Find(name)) return contact;
  if (num_strangers_ == kMaxStrangers && !MakeRoomForAStranger()) return nullptr;
  ++num_strangers_;
  ++num_unknown_strangers_;
  const auto entry = contacts_.try_emplace(VehicleKey(name)).first;
  Contact& contact = entry->second;
  contact.name = name;
  contact.key = entry->first;
  if (free_indices_.empty()) {
    contact.index = static_cast<int32_t>(by_index_.size());
    by_index_.push_back(&contact);
  } else {
    contact.index = free_indices_.back();
    free_indices_.pop_back();
    by_index_[static_cast<size_t>(contact.index)] = &contact;
  }
  RankContacts();
  return &contact;
}

bool Router::MakeRoomForAStranger() {
  if (num_unknown_strangers_ == 0) return false;
  const auto may_go = [](const auto& entry) {
    return !entry.second.of_mission && !entry.second.known;
  };
  // Who was given factors is expected; rather lose one that was not.
  auto gone = std::find_if(contacts_.begin(), contacts_.end(), [&](const auto& entry) {
    return may_go(entry) && entry.second.factors == LinkFactors();
  });
  if (gone == contacts_.end()) gone = std::find_if(contacts_.begin(), contacts_.end(), may_go);
  const auto place = static_cast<size_t>(gone->second.index);
  for (auto& [key, other] : contacts_) {
    if (place < other.wants_report_of.size() && other.wants_report_of[place] != 0) {
      other.wants_report_of[place] = 0;
      if (--other.num_wanted == 0) --num_wanting_;
    }
  }
  free_indices_.push_back(gone->second.index);
  contacts_.erase(gone);
  --num_strangers_;
  --num_unknown_strangers_;
  RankContacts();
  return true;
}

void Router::RankContacts() {
  by_rank_.clear();
  for (auto& [key, contact] : contacts_) {
    contact.rank = static_cast<int32_t>(by_rank_.size());
    by_rank_.push_back(&contact);
  }
}

}  // namespace shoal
