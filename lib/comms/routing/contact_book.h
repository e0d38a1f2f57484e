// The contacts of the broker: the mission's vehicles, and others as they report.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/contact.h"

namespace shoal {

class ContactBook {
 public:
  /// Vehicles that are not of the mission are remembered up to this number: made-up names must
  /// neither fill the memory, nor squeeze out the mission's own vehicles, nor make more fates than
  /// a step has time for.
  static constexpr int kMaxUnregistered = 200;

  /// @pre `vehicles`: the mission's, legal names of different keys.
  explicit ContactBook(std::span<const std::string> vehicles);
  ContactBook(const ContactBook&) = delete;
  ContactBook& operator=(const ContactBook&) = delete;

  /// Returns the contact of this name, without regard to case, or nullptr.
  Contact* Find(std::string_view name);
  const Contact* Find(std::string_view name) const;
  /// The same, sooner where this name has the index that it had before.
  Contact* FindAt(int32_t index, std::string_view name);
  /// The same as Find; adds one that is not there, or returns nullptr where there is no room.
  /// @pre a legal name
  Contact* FindOrAdd(std::string_view name);
  /// Returns false where FindOrAdd would return nullptr.
  bool HasRoomFor(std::string_view name) const;

  /// Counts the contact as known from now on.
  void MarkKnown(Contact* contact);
  /// Forgets all of it but counts, numbers and factors.
  void Forget(Contact* contact);

  /// From now on `receiver` wants the next report of each vehicle that is known, or of the mission.
  void WantReports(Contact* receiver);
  /// Returns true where `receiver` wants the next report of `source`.
  static bool Wants(const Contact& receiver, const Contact& source) {
    const auto place = static_cast<size_t>(source.index);
    return receiver.num_wanted > 0 && place < receiver.wants_report_of.size() &&
           receiver.wants_report_of[place] != 0;
  }
  /// Notes that it has been given this report. @pre Wants(*receiver, source)
  void GiveWanted(Contact* receiver, const Contact& source);

  /// Returns the contact of this index, as long as it has not been replaced by another.
  Contact* at(int32_t index) { return by_index_[static_cast<size_t>(index)]; }
  const Contact& at(int32_t index) const { return *by_index_[static_cast<size_t>(index)]; }
  /// All contacts, known or not, in order of keys.
  std::span<Contact* const> all() { return by_rank_; }
  std::span<const Contact* const> all() const { return {by_rank_.data(), by_rank_.size()}; }

  int num_known() const { return num_known_; }
  /// Contacts that want reports.
  int num_wanting() const { return num_wanting_; }

 private:
  bool MakeRoom();
  void RankContacts();

  std::map<std::string, Contact, std::less<>> contacts_;
  std::vector<Contact*> by_index_;
  std::vector<Contact*> by_rank_;
  std::vector<int32_t> free_indices_;
  int num_known_ = 0;
  int num_unregistered_ = 0;          ///< Contacts not of the mission.
  int num_unknown_unregistered_ = 0;  ///< Of these, the ones that are not known.
  int num_wanting_ = 0;               ///< Contacts with num_wanted > 0.
};

}  // namespace shoal
