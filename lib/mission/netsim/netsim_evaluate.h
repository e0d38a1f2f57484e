// What a request changes, and the status that answers it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/netsim/netsim_options.h"
#include "lib/mission/netsim/netsim_request.h"

namespace shoal {

/// An accepted position: of a vehicle of the mission, within its environment, all numbers finite.
struct NetsimPosition {
  std::string vehicle;
  NetsimNav nav;
};

struct NetsimVerdict {
  /// Nothing where the request gets no answer: no status fits.
  std::optional<NetsimStatus> status;
  std::vector<NetsimPosition> positions;  ///< In the request's order.
  std::vector<NetsimReceiveStats> stats;
  std::string problem;  ///< Why not all was accepted, for people.
};

/// Judges a request from a client at `peer_address` (IPv4). Each nav in order: known port? right
/// address? finite, and within the region? The first that is not stops: those before it are
/// accepted, it gives the status, those behind it are not looked at. Stats are always accepted.
/// Of an incomplete request nothing is accepted; its status is found in the same way, with a
/// missing number taken as one that is out of the region.
[[nodiscard]] NetsimVerdict EvaluateRequest(const NetsimRequest& request,
                                            std::string_view peer_address,
                                            const NetsimOptions& options);

}  // namespace shoal
