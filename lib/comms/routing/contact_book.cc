#include "lib/comms/routing/contact_book.h"

#include <algorithm>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

ContactBook::ContactBook(std::span<const std::string> vehicles) {
  for (const std::string& name : vehicles) {
    const auto [entry, is_new] = contacts_.try_emplace(VehicleKey(name));
    SHOAL_CHECK(is_new && IsLegalVehicleName(name),
                "the vehicles of a mission have legal and unique names");
    Contact& contact = entry->second;
    contact.name = name;
    contact.key = entry->first;
    contact.index = static_cast<int32_t>(by_index_.size());
    contact.of_mission = true;
    by_index_.push_back(&contact);
  }
  RankContacts();
}

const Contact* ContactBook::Find(std::string_view name) const {
  const auto found = contacts_.find(VehicleKey(name));
  return found == contacts_.end() ? nullptr : &found->second;
}

Contact* ContactBook::Find(std::string_view name) {
  return const_cast<Contact*>(std::as_const(*this).Find(name));
}

Contact* ContactBook::FindAt(int32_t index, std::string_view name) {
  const auto place = static_cast<size_t>(index);
  const bool is_there = index >= 0 && place < by_index_.size() && by_index_[place]->name == name;
  return is_there ? by_index_[place] : Find(name);
}

Contact* ContactBook::FindOrAdd(std::string_view name) {
  if (Contact* contact = Find(name)) return contact;
  if (num_unregistered_ == kMaxUnregistered && !MakeRoom()) return nullptr;
  ++num_unregistered_;
  ++num_unknown_unregistered_;
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

bool ContactBook::HasRoomFor(std::string_view name) const {
  return Find(name) != nullptr || num_unregistered_ < kMaxUnregistered ||
         num_unknown_unregistered_ > 0;
}

void ContactBook::MarkKnown(Contact* contact) {
  if (contact->known) return;
  contact->known = true;
  ++num_known_;
  if (!contact->of_mission) --num_unknown_unregistered_;
}

void ContactBook::Forget(Contact* contact) {
  contact->known = false;
  contact->group_key.clear();
  contact->message_utime = kNever;
  contact->last_message_utime = kNever;
  contact->delivered_utime.Clear();
  contact->wants_report_of.clear();
  if (contact->num_wanted > 0) --num_wanting_;
  contact->num_wanted = 0;
  const auto place = static_cast<size_t>(contact->index);
  for (Contact* other : by_rank_) other->delivered_utime.Reset(place);
  --num_known_;
  if (!contact->of_mission) ++num_unknown_unregistered_;
}

void ContactBook::WantReports(Contact* receiver) {
  if (receiver->num_wanted > 0) --num_wanting_;
  receiver->num_wanted = 0;
  receiver->wants_report_of.assign(by_index_.size(), 0);
  for (const Contact* source : by_rank_) {
    if (source == receiver || !(source->of_mission || source->known)) continue;
    receiver->wants_report_of[static_cast<size_t>(source->index)] = 1;
    ++receiver->num_wanted;
  }
  if (receiver->num_wanted > 0) ++num_wanting_;
}

void ContactBook::GiveWanted(Contact* receiver, const Contact& source) {
  receiver->wants_report_of[static_cast<size_t>(source.index)] = 0;
  if (--receiver->num_wanted == 0) --num_wanting_;
}

bool ContactBook::MakeRoom() {
  if (num_unknown_unregistered_ == 0) return false;
  const auto may_go = [](const auto& entry) {
    return !entry.second.of_mission && !entry.second.known;
  };
  // Factors mean that a vehicle is expected: drop one without factors first.
  auto gone = std::find_if(contacts_.begin(), contacts_.end(), [&](const auto& entry) {
    return may_go(entry) && entry.second.factors == LinkFactors();
  });
  if (gone == contacts_.end()) gone = std::find_if(contacts_.begin(), contacts_.end(), may_go);
  for (auto& [key, other] : contacts_) {
    if (Wants(other, gone->second)) GiveWanted(&other, gone->second);
  }
  free_indices_.push_back(gone->second.index);
  contacts_.erase(gone);
  --num_unregistered_;
  --num_unknown_unregistered_;
  RankContacts();
  return true;
}

void ContactBook::RankContacts() {
  by_rank_.clear();
  for (auto& [key, contact] : contacts_) {
    contact.rank = static_cast<int32_t>(by_rank_.size());
    by_rank_.push_back(&contact);
  }
}

}  // namespace shoal
