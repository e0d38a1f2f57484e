// What a host sets with CCCFG and asks for with CCCFQ.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shoal {

struct MicroModemSettings {
  /// Unknown keys that are kept, and the longest with its value.
  static constexpr size_t kMaxOtherKeys = 32;
  static constexpr size_t kMaxTextBytes = 40;

  // The names are the modem's keys. Those marked with a star have an effect here, the others are
  // kept and shown.
  int src = 0;  ///< * This modem's address.
  int cst = 1;  ///< * Whether it writes CACST.
  int xst = 0;
  int rev = 1;  ///< * Whether it writes CAREV.
  int rxp = 1;  ///< * Whether it writes CARXP.
  int tat = 50;
  int bnd = 1;
  int cto = 10;
  int dto = 2;   ///< * Seconds that it waits for CCTXD.
  int pto = 14;  ///< * Seconds that it waits for the data after a cycle packet.
  int agc = 250;
  int agn = 250;
  int txp = 1;                                     ///< * Whether it writes CATXP.
  int txf = 1;                                     ///< * Whether it writes CATXF.
  std::map<std::string, std::string> others = {};  ///< By key.
};

/// Sets one key. Returns what is wrong with the request, in words without a comma, or nothing.
/// "ALL" takes only 0: everything but `src` is as it was at first, `src` is `first_address`.
[[nodiscard]] std::string SetMicroModemKey(std::string_view key, std::string_view value,
                                           int first_address, MicroModemSettings* settings);

/// Returns the keys that are asked for, with their values, in the modem's order: one; or all for
/// "ALL" and "TOP"; or none where the key is not known.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> FindMicroModemKeys(
    std::string_view key, const MicroModemSettings& settings);

}  // namespace shoal
