#include "apps/shore_broker/report_intake.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "apps/shore_broker/message_checks.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

std::vector<TakenReport>& ReportIntake::TakeAll(int64_t utime) {
  taken_.clear();
  for (const BrokerInbox::Item& item : inbox_.reports()) {
    const bool is_decoded = inbox_.Read(
        item, item.from_outside ? channels::NodeReportFromOutside() : channels::NodeReportLocal(),
        &report_);
    if (!is_decoded) continue;
    TakenReport report{.raw = inbox_.BytesOf(item), .made_utime = report_.utime};
    Admit(utime, &report);
    taken_.push_back(std::move(report));
  }
  return taken_;
}

void ReportIntake::Admit(int64_t utime, TakenReport* report) {
  const int num_known = router_.num_known();
  report->admission =
      AllNumbersAreFinite(report_)
          ? router_.Admit({.name = report_.name,
                           .group = report_.group,
                           .position_m = {report_.x_m, report_.y_m, report_.depth_m}},
                          utime)
          : router_.Refuse(report_.name);
  if (router_.num_known() > num_known) {
    log_.Event(utime, fmt::format("{} is known now", report_.name));
  }
  const std::optional<Cause>& refused = report->admission.refused;
  if (!refused) {
    media_.Place(report_.name, report->admission.position_m);
  } else {
    report->refused_name = LegalOrEmpty(report_.name);
  }
  if (refused == Cause::kInvalid) {
    log_.Warn("invalid node report refused: illegal name or impossible number");
  } else if (refused == Cause::kTooManyVehicles) {
    log_.Warn("node report refused: too many vehicles that are not of the mission");
  }
}

}  // namespace shoal
