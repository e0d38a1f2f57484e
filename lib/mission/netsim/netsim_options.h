// `[netsim]` of a mission file: which hosts may connect from outside, as which vehicle, and where
// it may be. docs/communication/netsim.md
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace shoal {

/// An operation area. All bounds belong to it; longitudes are not wrapped (190 is not -170).
struct NetsimEnvironment {
  std::string name;
  double lat_min_deg = -90;
  double lat_max_deg = 90;
  double lon_min_deg = -180;
  double lon_max_deg = 180;
  double depth_min_m = 0;
  double depth_max_m = 0;

  bool operator==(const NetsimEnvironment&) const = default;
};

/// The protocol of a vehicle's modem port.
enum class NetsimModem {
  kRaw,          ///< Bytes behind their length.
  kMicromodem,   ///< The sentences of a WHOI Micro-Modem.
  kMicromodem2,  ///< Those of a Micro-Modem 2 too.
  kNone,         ///< The port is only the vehicle's number.
};

/// Where $GPRMC of a vehicle goes; nowhere by default. Both are possible.
struct NetsimGps {
  int tcp_port = 0;       ///< All clients that connect to it get the sentences. 0: none.
  std::string path = {};  ///< A file, or a serial line or pseudo-terminal. Empty: none.

  bool operator==(const NetsimGps&) const = default;
};

/// A vehicle that is simulated elsewhere.
struct NetsimVehicle {
  std::string name;
  int modem_tcp_port = 0;       ///< Its number in every message.
  std::string address = "any";  ///< IPv4, of the only host that may set its position.
  std::string environment;
  NetsimModem modem = NetsimModem::kNone;
  NetsimGps gps = {};

  bool operator==(const NetsimVehicle&) const = default;
};

struct NetsimOptions {
  int port = 61999;
  std::string address = "127.0.0.1";  ///< IPv4, to listen on; "0.0.0.0": on all of this machine.
  int max_connections = 128;
  int max_line_bytes = 1 << 20;  ///< Longer lines are dropped, their connection stays.
  double idle_timeout_s = 3600;  ///< Without a byte from a client; 0: for ever.
  bool allow_warp = false;       ///< For clients that do not compare their clock with mission time.
  std::vector<NetsimEnvironment> environments;
  std::vector<NetsimVehicle> vehicles;

  bool operator==(const NetsimOptions&) const = default;
};

/// An invalid setting in NetsimOptions, and how to fix it.
struct NetsimProblem {
  std::string where;    ///< "netsim", "netsim.environment 'bay'", "netsim.vehicle 'alpha'"
  std::string key;      ///< Of that table.
  std::string message;  ///< "must be from 1 to 65535, not 0"

  bool operator==(const NetsimProblem&) const = default;
};

/// Returns all that is wrong; empty: nothing.
[[nodiscard]] std::vector<NetsimProblem> FindNetsimProblems(const NetsimOptions& options);

/// True for dotted decimal without leading zeros: as the addresses of clients are compared.
[[nodiscard]] bool IsIpv4Address(const std::string& text);

}  // namespace shoal
