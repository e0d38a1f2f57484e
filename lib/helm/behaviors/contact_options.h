// What all behaviors that are about a contact have in common.
#pragma once

#include <string>
#include <vector>

namespace shoal {

/// Keys of every contact behavior.
struct ContactOptions {
  std::string contact = {};      ///< Its name; of a recipe: filled in when one is spawned.
  bool on_no_contact_ok = true;  ///< False: an all-stop while the contact is not known.
  std::vector<std::string> match_name = {};  ///< Spawned for these contacts only; empty: all.
  std::vector<std::string> ignore_name = {};
  std::vector<std::string> match_group = {};
  std::vector<std::string> ignore_group = {};
  std::vector<std::string> match_type = {};
  std::vector<std::string> ignore_type = {};
  /// m; a recipe makes one for each contact that comes so near; -1: by updates alone. Of kinds that
  /// do not keep clear.
  double alert_range = -1;
  /// m; farther above or below, the contact needs no keeping clear of; -1: depth does not count.
  double vertical_separation = 10;
  bool exit_on_filter_group = false;   ///< Ends when the contact's group no longer passes.
  bool post_per_contact_info = false;  ///< Posts range, closing speed and role with its name.
  /// "@cpa VAR = value", "@os_passes_cn ...": docs/vehicles/modes.md lists the moments.
  std::vector<std::string> cnflag = {};

  bool operator==(const ContactOptions&) const = default;
};

}  // namespace shoal
