#include "apps/shore_broker/shared_reports.h"

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

void SharedReports::Offer(int64_t utime, int source, std::span<const uint8_t> report) {
  const double interval_s = router_.rules().shared_node_reports_s;
  if (interval_s < 0) return;
  const auto place = static_cast<size_t>(source);
  const std::string& name = router_.contact(source).name;
  if (place >= published_utimes_.size()) published_utimes_.resize(place + 1, {"", kNever});
  auto& [whose, published_utime] = published_utimes_[place];
  const bool is_due = whose != name || published_utime == kNever ||
                      SecondsBetween(published_utime, utime) >= interval_s * warp_;
  if (!is_due) return;
  whose = name;
  published_utime = utime;
  ++num_published_;
  bus_.PublishBytes(channels::NodeReportUnc().name, report);
}

}  // namespace shoal
