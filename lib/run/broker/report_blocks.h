// How the routing of reports is shared out: block by block of vehicles, in order of their names. A
// broker decides about a step's reports in this order, so that several brokers, each of some of
// the blocks, publish together what one publishes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lib/run/broker/broker_setup.h"
#include "shoal/fate_t.hpp"

namespace shoal {

class ReportBlocks {
 public:
  static constexpr size_t kVehiclesPerBlock = 64;

  /// One block where reports need more than their own vehicle's state: over media, or where
  /// gateways forward them.
  explicit ReportBlocks(const BrokerSetup& setup);

  size_t num_blocks() const { return num_blocks_; }
  /// Returns the block of a router's contact; the last one, of any that is not of the mission.
  /// @pre `contact` is of a Router that was made with setup.vehicles, or kNoContact
  size_t BlockOf(int32_t contact) const {
    const bool is_of_mission = contact >= 0 && static_cast<size_t>(contact) < blocks_.size();
    return is_of_mission ? blocks_[static_cast<size_t>(contact)] : num_blocks_ - 1;
  }

 private:
  size_t num_blocks_ = 1;
  std::vector<size_t> blocks_;  ///< By place in the mission, which is the contact's index.
};

/// What one of the brokers of a mission does. Every one of them takes all reports in, since any
/// vehicle may be in range of any other.
struct BrokerShare {
  std::vector<bool> has_block = {};  ///< Routes the reports of these; empty: of all.
  bool has_rest = true;              ///< Routes all but reports, and publishes the rules.
  /// Called with what is published on COMMS_FATES, where given.
  std::function<void(std::span<const fate_t>)> on_fates = {};

  bool Has(size_t block) const { return has_block.empty() || has_block[block]; }
};

}  // namespace shoal
