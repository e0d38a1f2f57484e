// Which LCM port carries which channel.
//
//   base      TICK, RESEND, APPCAST_REQ: every participant receives them; COMMS_RULES_REQ,
//             CLOCK_STATE
//   base + 1  STEP_DONE, STEP_DONES, CLOCK_COMMAND: only the clock receives them
//   base + 2  the shore; in the `shared` layout every other channel too
//   base + 3  in the `communities` layout: the first vehicle's community, and so on
//
// In LCM 1.3.1 a port isolates and a multicast address does not, so all use LCM's own address. The
// default base puts the shore on LCM's default port 7667, where a plain `lcm-spy` looks.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

enum class Layout { kShared, kCommunities };

/// Returns "shared" or "communities".
std::string_view Name(Layout layout);

class PortPlan {
 public:
  static constexpr int kDefaultBase = 7665;
  /// A process of all vehicles has some six descriptors per port, and 1,024 by default, so vehicles
  /// beyond this many share communities, round robin.
  static constexpr int kMaxCommunities = 128;

  /// `vehicles` in mission order, any case.
  /// @pre 1024 <= base <= 65535 - num_ports
  PortPlan(int base, Layout layout, const std::vector<std::string>& vehicles);

  int base() const { return base_; }
  Layout layout() const { return layout_; }
  int tick_port() const { return base_; }
  int done_port() const { return base_ + 1; }
  int shore_port() const { return base_ + 2; }
  int num_ports() const { return NumPorts(layout_, num_vehicles_); }

  /// Returns the port that carries `channel`.
  int PortOf(std::string_view channel) const;
  /// Returns the ports of the shore and of all communities, each once.
  std::vector<int> DataPorts() const;

  /// Returns how many consecutive ports a mission needs.
  static int NumPorts(Layout layout, int num_vehicles);
  /// Returns the layout that suits a mission: communities from ten vehicles on.
  static Layout Suggest(int num_vehicles);

 private:
  int base_;
  Layout layout_;
  int num_vehicles_;
  std::map<std::string, int, std::less<>> community_ports_;  ///< By upper-case vehicle name.
};

/// All of shoal's ports are of this multicast group, LCM's own.
inline constexpr char kLcmGroup[] = "239.255.76.67";

/// Bytes: it holds some 10,000 small messages, a fifth of a second of the most that one process can
/// take.
inline constexpr int kWantedReceiveBuffer = 4 * 1024 * 1024;

/// Returns the LCM URL of a port: multicast that stays on this machine (ttl=0), with as large a
/// receive buffer as the kernel allows, up to kWantedReceiveBuffer.
std::string LcmUrl(int port);

/// Returns net.core.rmem_max in bytes, or 212992, the kernel's default, where it cannot be read.
int ReceiveBufferLimit();

}  // namespace shoal
