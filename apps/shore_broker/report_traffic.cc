#include "apps/shore_broker/report_traffic.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/shore_broker/air_text.h"
#include "apps/shore_broker/message_checks.h"
#include "apps/shore_broker/pulse_writer.h"
#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

void ReportTraffic::Route(int64_t utime) {
  reports_.clear();
  for (const BrokerInbox::Item& item : parts_.inbox.reports()) {
    Report report{.raw = item};
    if (TakeIn(utime, &report)) reports_.push_back(std::move(report));
  }
  if (blocks_.num_blocks() == 1) return RouteBlock(utime, reports_);

  std::ranges::stable_sort(reports_, {}, &Report::block);
  const std::span<const Report> all = reports_;
  for (size_t begin = 0; begin < all.size();) {
    const size_t block = all[begin].block;
    size_t end = begin;
    while (end < all.size() && all[end].block == block) ++end;
    parts_.bus.SetPlace(static_cast<uint32_t>(1 + block));
    RouteBlock(utime, all.subspan(begin, end - begin));
    parts_.delivery.Flush(utime);
    begin = end;
  }
  parts_.bus.SetPlace(kNumPlaces - 1);
}

/// Returns false for what is undecodable, or of a block that another broker routes.
bool ReportTraffic::TakeIn(int64_t utime, Report* report) {
  if (!parts_.inbox.Read(report->raw,
                         report->raw.from_outside ? channels::NodeReportFromOutside()
                                                  : channels::NodeReportLocal(),
                         &report_)) {
    return false;
  }
  report->made_utime = report_.utime;
  Router& router = parts_.router;
  const int num_known = router.num_known();
  report->admission =
      AllNumbersAreFinite(report_)
          ? router.Admit({.name = report_.name,
                          .group = report_.group,
                          .position_m = {report_.x_m, report_.y_m, report_.depth_m}},
                         utime)
          : router.Refuse(report_.name);
  if (router.num_known() > num_known) {
    parts_.log.Event(utime, fmt::format("{} is known now", report_.name));
  }
  const std::optional<Cause>& refused = report->admission.refused;
  if (!refused) {
    parts_.traffic.Place(report_.name, report->admission.position_m);
  } else {
    report->refused_name = LegalOrEmpty(report_.name);
  }
  if (refused == Cause::kInvalid) {
    parts_.log.Warn("invalid node report refused: illegal name or impossible number");
  } else if (refused == Cause::kTooManyVehicles) {
    parts_.log.Warn("node report refused: too many vehicles that are not of the mission");
  }
  report->block = blocks_.BlockOf(report->admission.source);
  return parts_.share.Has(report->block);
}

/// Of one block: the fates of what is refused come first.
void ReportTraffic::RouteBlock(int64_t utime, std::span<const Report> reports) {
  for (const Report& report : reports) {
    const Admission& admission = report.admission;
    if (!admission.refused) continue;
    parts_.delivery.Refuse(
        utime,
        {.source = admission.source, .number = admission.number, .cause = *admission.refused},
        report.refused_name);
  }
  for (const Report& report : reports) {
    if (!report.admission.refused) RouteOne(utime, report);
  }
}

void ReportTraffic::RouteOne(int64_t utime, const Report& report) {
  Router& router = parts_.router;
  decisions_.clear();
  router.Route(report.admission, utime, &decisions_);
  const Contact& source = router.contact(report.admission.source);
  const std::span<const uint8_t> raw = parts_.inbox.BytesOf(report.raw);
  parts_.delivery.Conclude(
      utime, {.decisions = decisions_,
              .written_source = source.name,
              .raw = raw,
              .from_m = report.admission.position_m,
              .has_pulses = router.rules().view_node_rpt_pulses,
              .color = ReportColor(source.index),
              .air_bytes =
                  [&] {
                    SHOAL_CHECK(Decode(raw, &report_),
                                "a report that was decoded on arrival decodes again");
                    return AirBytes(report_,
                                    parts_.traffic.acoustic().AddressOf(source.name).value_or(0),
                                    parts_.setup.start_utime);
                  },
              .over = &parts_.setup.rules.reports_over,
              .provenance = {.origin = {}, .number = 0, .made_utime = report.made_utime}});
  Share(utime, report);
}

/// Publishes NODE_REPORT_UNC at a limited rate, for displays.
void ReportTraffic::Share(int64_t utime, const Report& report) {
  const double interval_s = parts_.router.rules().shared_node_reports_s;
  if (interval_s < 0) return;
  const auto place = static_cast<size_t>(report.admission.source);
  const std::string& name = parts_.router.contact(report.admission.source).name;
  if (place >= shared_utimes_.size()) shared_utimes_.resize(place + 1, {"", kNever});
  auto& [whose, shared_utime] = shared_utimes_[place];
  const bool is_due = whose != name || shared_utime == kNever ||
                      SecondsBetween(shared_utime, utime) >= interval_s * warp_;
  if (!is_due) return;
  whose = name;
  shared_utime = utime;
  ++num_shared_;
  parts_.bus.PublishBytes(channels::NodeReportUnc().name, parts_.inbox.BytesOf(report.raw));
}

}  // namespace shoal
