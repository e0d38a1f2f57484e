// What comes from a vehicle's simulator, and the answers to it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace shoal {

inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

/// Where a vehicle is, as its simulator reports. What was not given is 0 (the port) or kNotGiven.
struct NetsimNav {
  int32_t modem_tcp_port = 0;
  double time_s = kNotGiven;  ///< Since 1970, by the client's clock: not for ordering or dating.
  double lat_deg = kNotGiven;
  double lon_deg = kNotGiven;
  double depth_m = kNotGiven;
  double speed_mps = kNotGiven;
  double heading_deg = kNotGiven;  ///< From true North; may lie outside of 0 to 360.
};

/// What a Micro-Modem reported of a packet that it received (CACST).
struct NetsimModemStats {
  int32_t mode = 0;  ///< 0 good, 1 bad CRC, 2 timeout.
  int32_t rate = 0;
  int32_t source = 0;  ///< Modem ids.
  int32_t destination = 0;
  int32_t num_frames = 0;
  int32_t num_bad_frames = 0;
  int32_t snr_in_db = 0;
  int32_t snr_out_db = 0;
  int32_t mse_equalizer_db = 0;
};

/// What became of a packet, for people to look at.
struct NetsimReceiveStats {
  int32_t modem_tcp_port = 0;     ///< The receiver.
  int32_t tx_modem_tcp_port = 0;  ///< The sender.
  bool packet_success = false;
  std::optional<NetsimModemStats> modem;
};

struct NetsimRequest {
  int32_t id = 0;
  std::vector<NetsimNav> navs;
  std::vector<NetsimReceiveStats> stats;
  bool is_whole = true;  ///< False: a required field is missing somewhere below.
};

/// The numbers are the protocol's.
enum class NetsimStatus {
  kAccepted = 1,
  kInvalidModemTcpPort = 2,
  kInvalidSourceAddress = 3,
  kOutOfDefinedRegion = 4,
};

}  // namespace shoal
