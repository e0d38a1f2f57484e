// For tests: one report or message at one receiver, without a router.
#pragma once

#include "lib/comms/routing/decide.h"

namespace shoal {

inline Decision DecideReport(const RoutingRules& rules, const Transmission& report,
                             const Contact& receiver, int64_t delivered_utime, bool is_wanted,
                             int64_t utime) {
  return DecideAt(Kind::kReport, {.rules = rules,
                                  .sent = report,
                                  .receiver = receiver,
                                  .utime = utime,
                                  .delivered_utime = delivered_utime,
                                  .is_wanted = is_wanted});
}

inline Decision DecideMessage(const RoutingRules& rules, const Transmission& message,
                              const Contact& receiver, int64_t utime) {
  return DecideAt(Kind::kMessage,
                  {.rules = rules, .sent = message, .receiver = receiver, .utime = utime});
}

}  // namespace shoal
