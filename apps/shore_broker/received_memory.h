// What each vehicle has received, where gateways bring it more than once.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "lib/comms/routing/kind.h"

namespace shoal {

class ReceivedMemory {
 public:
  /// The number of transmissions that are remembered, the last ones.
  static constexpr size_t kRemembered = 20'000;

  /// Remembers that `receiver` receives transmission `number` of `origin`. Returns false where it
  /// has it already: this one, or of reports that a gateway has forwarded a later one.
  bool Take(Kind kind, std::string_view origin, int64_t number, std::string_view receiver,
            bool is_forwarded);

 private:
  using Transmitted = std::tuple<Kind, std::string, int64_t, std::string>;

  std::map<std::pair<std::string, std::string>, int64_t> last_reports_;  ///< By origin, receiver.
  std::deque<Transmitted> recent_;                                       ///< Oldest first.
  std::set<Transmitted> seen_;                                           ///< The same.
};

}  // namespace shoal
