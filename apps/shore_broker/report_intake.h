// Node reports as they arrive: decoded, admitted by the router, and the place of their vehicle
// noted.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "apps/shore_broker/broker_inbox.h"
#include "apps/shore_broker/media_traffic.h"
#include "lib/comms/routing/router.h"
#include "lib/run/run/status_page.h"

namespace shoal {

/// A report of this step.
struct TakenReport {
  std::span<const uint8_t> raw;  ///< The message; the inbox's, until it is cleared.
  int64_t made_utime = 0;
  Admission admission = {};
  std::string refused_name = {};  ///< If it is refused.
};

class ReportIntake {
 public:
  /// All four outlive this.
  ReportIntake(BrokerInbox& inbox, Router& router, MediaTraffic& media, StatusLog& log)
      : inbox_(inbox), router_(router), media_(media), log_(log) {}

  /// Takes in what the inbox has, so that every vehicle is where it is now. Returns it in the order
  /// in which it came, refused reports included, undecodable ones left out; valid until the next
  /// call.
  std::vector<TakenReport>& TakeAll(int64_t utime);

 private:
  void Admit(int64_t utime, TakenReport* report);

  BrokerInbox& inbox_;
  Router& router_;
  MediaTraffic& media_;
  StatusLog& log_;
  std::vector<TakenReport> taken_;
  node_report_t report_;  ///< Decoded into; keeps its strings' memory.
};

}  // namespace shoal
