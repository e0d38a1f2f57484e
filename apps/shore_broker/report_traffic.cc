#include "apps/shore_broker/report_traffic.h"

#include <algorithm>

#include "apps/shore_broker/air_text.h"
#include "apps/shore_broker/pulse_writer.h"
#include "lib/base/check/check.h"

namespace shoal {

void ReportTraffic::Route(int64_t utime, std::vector<TakenReport>& reports) {
  std::erase_if(reports, [&](const TakenReport& report) { return !share_.Has(BlockOf(report)); });
  if (blocks_.num_blocks() == 1) return RouteBlock(utime, reports);

  std::ranges::stable_sort(reports, {}, [&](const TakenReport& report) { return BlockOf(report); });
  const std::span<const TakenReport> all = reports;
  for (size_t begin = 0; begin < all.size();) {
    const size_t block = BlockOf(all[begin]);
    size_t end = begin;
    while (end < all.size() && BlockOf(all[end]) == block) ++end;
    bus_.SetPlace(static_cast<uint32_t>(1 + block));
    RouteBlock(utime, all.subspan(begin, end - begin));
    carriers_.delivery.Flush(utime);
    begin = end;
  }
  bus_.SetPlace(kNumPlaces - 1);
}

/// Of one block: the fates of what is refused come first.
void ReportTraffic::RouteBlock(int64_t utime, std::span<const TakenReport> reports) {
  for (const TakenReport& report : reports) {
    const Admission& admission = report.admission;
    if (!admission.refused) continue;
    carriers_.delivery.Refuse(
        utime,
        {.source = admission.source, .number = admission.number, .cause = *admission.refused},
        report.refused_name);
  }
  for (const TakenReport& report : reports) {
    if (!report.admission.refused) RouteOne(utime, report);
  }
}

void ReportTraffic::RouteOne(int64_t utime, const TakenReport& report) {
  Router& router = carriers_.router;
  decisions_.clear();
  router.Route(report.admission, utime, &decisions_);
  const Contact& source = router.contact(report.admission.source);
  carriers_.delivery.Conclude(
      utime, {.decisions = decisions_,
              .written_source = source.name,
              .raw = report.raw,
              .from_m = report.admission.position_m,
              .has_pulses = router.rules().view_node_rpt_pulses,
              .color = ReportColor(source.index),
              .air_bytes =
                  [&] {
                    SHOAL_CHECK(Decode(report.raw, &report_),
                                "a report that was decoded on arrival decodes again");
                    return AirBytes(report_,
                                    carriers_.media.acoustic().AddressOf(source.name).value_or(0),
                                    setup_.start_utime);
                  },
              .over = &setup_.rules.reports_over,
              .provenance = {.origin = {}, .number = 0, .made_utime = report.made_utime}});
  shared_.Offer(utime, report.admission.source, report.raw);
}

}  // namespace shoal
