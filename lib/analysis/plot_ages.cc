#include <algorithm>

#include "lib/analysis/plot_data.h"

namespace shoal {

namespace {

constexpr int64_t kLatestReport_us = 1'000'000'000'000'000'000;  // Differences are numbers still.

}  // namespace

void PlotDataBuilder::AddSwarm(Vehicle* vehicle, const swarm_t& swarm) {
  const auto time_s = TimeOf(swarm.utime);
  if (!time_s || !vehicle->is_selected) return;
  std::optional<int64_t> target_utime, other_utime;
  for (const swarm_contact_t& contact : swarm.contacts) {
    if (!contact.is_heard || !contact.is_known) continue;
    if (contact.report_utime < -kLatestReport_us || contact.report_utime > kLatestReport_us) {
      ++data_.num_impossible;
      continue;
    }
    std::optional<int64_t>& oldest = contact.is_target ? target_utime : other_utime;
    oldest = std::min(oldest.value_or(contact.report_utime), contact.report_utime);
  }
  DrawAge(*time_s, swarm.utime, target_utime, &vehicle->target_report_utime,
          &vehicle->curves.target_age_s);
  DrawAge(*time_s, swarm.utime, other_utime, &vehicle->other_report_utime,
          &vehicle->curves.other_age_s);
}

/// A newer report makes the age fall: the line goes down at once, as the tooth of a saw.
void PlotDataBuilder::DrawAge(double time_s, int64_t utime, std::optional<int64_t> report_utime,
                              std::optional<int64_t>* before, ThinnedCurve* curve) {
  const auto draw = [&](int64_t of_utime) {
    Draw(curve, time_s, std::max(0.0, static_cast<double>(utime - of_utime) / 1e6));
  };
  if (!report_utime) curve->Break();
  if (report_utime && *before && *before != report_utime) draw(**before);
  if (report_utime) draw(*report_utime);
  *before = report_utime;
}

}  // namespace shoal
