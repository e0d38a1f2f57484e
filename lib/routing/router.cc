#include "lib/routing/router.h"

#include "lib/check/check.h"
#include "lib/routing/decide.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

Router::Router(const RoutingRules& rules, std::span<const std::string> vehicles) : rules_(rules) {
  for (const std::string& name : vehicles) {
    const auto [entry, is_new] = contacts_.try_emplace(VehicleKey(name));
    SHOAL_CHECK(is_new && IsLegalVehicleName(name), "a mission's vehicles have names of their own");
    entry->second.name = name;
    entry->second.index = static_cast<int32_t>(by_index_.size());
    entry->second.of_mission = true;
    by_index_.push_back(&entry->second);
  }
}

Admission Router::Admit(const ReportFacts& report, int64_t utime) {
  if (!IsLegalVehicleName(report.name) || !report.position_m.allFinite()) {
    return Refuse(report.name);
  }
  Contact* contact = FindOrAdd(report.name);
  if (contact == nullptr) return RefuseBecause(Cause::kTooManyVehicles, nullptr);

  if (!contact->known) {
    contact->known = true;
    ++num_known_;
  }
  contact->group = report.group;
  contact->position_m = report.position_m;
  contact->received_utime = utime;
  ++contact->num_admitted;
  ++num_admitted_;
  return {.refused = std::nullopt, .source = contact->index, .number = contact->num_reports++};
}

Admission Router::Refuse(std::string_view name) {
  Contact* source = nullptr;
  if (IsLegalVehicleName(name)) {
    const auto found = contacts_.find(VehicleKey(name));
    if (found != contacts_.end()) source = &found->second;
  }
  return RefuseBecause(Cause::kInvalid, source);
}

Admission Router::RefuseBecause(Cause cause, Contact* source) {
  ++counts_[static_cast<size_t>(cause)];
  if (source == nullptr) {
    return {.refused = cause, .source = kNobody, .number = num_refused_unknown_++};
  }
  return {.refused = cause, .source = source->index, .number = source->num_reports++};
}

void Router::Route(const Admission& admission, const Eigen::Vector3d& position_m, int64_t utime,
                   std::vector<Decision>* decisions) {
  SHOAL_CHECK(!admission.refused, "a refused report goes nowhere");
  for (auto& [key, receiver] : contacts_) {
    if (!receiver.known || receiver.index == admission.source) continue;
    Decision& decision = decisions->emplace_back(DecideReport(rules_, position_m, receiver, utime));
    decision.source = admission.source;
    decision.destination = receiver.index;
    decision.number = admission.number;
    ++counts_[static_cast<size_t>(decision.cause)];
    if (decision.cause == Cause::kDelivered) ++receiver.num_heard;
  }
}

void Router::ForgetSilent(int64_t utime, std::vector<int32_t>* forgotten) {
  if (rules_.stale_forget_s < 0) return;
  for (auto& [key, contact] : contacts_) {
    const double silence_s = static_cast<double>(utime - contact.received_utime) / 1e6;
    if (!contact.known || silence_s < rules_.stale_forget_s) continue;
    contact.known = false;
    --num_known_;
    if (!contact.of_mission) ++num_forgotten_strangers_;
    if (forgotten != nullptr) forgotten->push_back(contact.index);
  }
}

Contact* Router::FindOrAdd(std::string_view name) {
  std::string key = VehicleKey(name);
  const auto found = contacts_.find(key);
  if (found != contacts_.end()) {
    Contact& contact = found->second;
    if (!contact.known && !contact.of_mission) --num_forgotten_strangers_;
    return &contact;
  }
  if (num_strangers_ == kMaxStrangers && !MakeRoomForAStranger()) return nullptr;
  ++num_strangers_;
  Contact& contact = contacts_[std::move(key)];
  contact.name = name;
  if (free_indices_.empty()) {
    contact.index = static_cast<int32_t>(by_index_.size());
    by_index_.push_back(&contact);
  } else {
    contact.index = free_indices_.back();
    free_indices_.pop_back();
    by_index_[static_cast<size_t>(contact.index)] = &contact;
  }
  return &contact;
}

bool Router::MakeRoomForAStranger() {
  if (num_forgotten_strangers_ == 0) return false;
  for (auto entry = contacts_.begin(); entry != contacts_.end(); ++entry) {
    const Contact& contact = entry->second;
    if (contact.of_mission || contact.known) continue;
    free_indices_.push_back(contact.index);
    contacts_.erase(entry);
    --num_strangers_;
    --num_forgotten_strangers_;
    return true;
  }
  return false;
}

}  // namespace shoal
