// How the participants of a mission are shared out over processes: `shoal run --grouping`.
//
//   app       one process per participant
//   vehicle   one process per vehicle: its simulator, helm, node_reporter, acomms and gateway
//   host=N    N processes for all vehicles of this computer, and N on each [[host]], each with
//             neighbours of the mission's order; host: as many as this machine has processors
//
// The broker, the recorder, netsim_manager and the users' own participants have a process each in
// all of them. What a mission results in depends on none of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/run/run/roster.h"

namespace shoal {

struct Grouping {
  enum class Kind { kApp, kVehicle, kHost };
  Kind kind = Kind::kApp;
  int num_processes = 0;  ///< For the vehicles of each computer, of kHost: 1 or more.

  bool operator==(const Grouping&) const = default;
};

/// Reads "app", "vehicle", "host" or "host=N" with N from 1 to 1000. The error states these.
[[nodiscard]] Result<Grouping> ParseGrouping(std::string_view text);
/// Returns the text that ParseGrouping reads as this grouping: "host=2".
std::string Name(const Grouping& grouping);

/// A process that shoal starts, or that a user starts by hand.
struct RosterProcess {
  /// Of its only participant; of several "group-alpha", "group-2" or, on the [[host]] lab2,
  /// "group-lab2-2", which no participant can have.
  std::string name;
  std::vector<RosterEntry> entries;  ///< At least one, all of one computer, in the roster's order.

  bool is_group() const { return entries.size() > 1; }
};

/// Shares out `roster`, in order; only what runs on the same computer shares a process.
/// Participants that a user starts by hand, or of a user's own command, stay alone.
std::vector<RosterProcess> ShareOut(const std::vector<RosterEntry>& roster,
                                    const Grouping& grouping);

}  // namespace shoal
