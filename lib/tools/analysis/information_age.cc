#include "lib/tools/analysis/information_age.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

bool IsMissionTime(int64_t utime) { return utime >= -kLatest_us && utime <= kLatest_us; }

}  // namespace

void InformationAge::EndTooth(int64_t utime, Knowledge* knowledge) {
  knowledge->teeth.push_back({.taken_utime = knowledge->taken_utime,
                              .begin_us = knowledge->begin_us,
                              .length_us = utime - knowledge->taken_utime});
  knowledge->report_utime.reset();
}

void InformationAge::ReportAge(const swarm_t& swarm, const std::string& name,
                               const Knowledge& knowledge) const {
  if (!on_point_) return;
  on_point_({.utime = swarm.utime,
             .vehicle = swarm.vehicle,
             .contact = name,
             .is_target = knowledge.is_target,
             .age_s = Seconds(knowledge.begin_us + swarm.utime - knowledge.taken_utime)});
}

void InformationAge::AddContact(const swarm_t& swarm, const swarm_contact_t& contact,
                                Observer* observer) {
  if (!contact.is_heard || !contact.is_known) {
    const auto found = observer->contacts.find(contact.name);
    if (found == observer->contacts.end() || !found->second.report_utime) return;
    EndTooth(observer->last_utime, &found->second);  // Nothing yet, or nothing that can be used.
    return;
  }
  if (!IsMissionTime(contact.report_utime)) {
    ++num_impossible_;
    return;
  }
  Knowledge& knowledge = observer->contacts[contact.name];
  knowledge.is_target = contact.is_target;
  if (knowledge.report_utime == contact.report_utime) {
    ReportAge(swarm, contact.name, knowledge);
    return;
  }
  if (knowledge.report_utime) {
    ReportAge(swarm, contact.name, knowledge);
    EndTooth(swarm.utime, &knowledge);
  }
  if (contact.report_utime > swarm.utime) ++num_future_;
  if (knowledge.num_reports++ == 0) knowledge.first_utime = swarm.utime;
  knowledge.report_utime = contact.report_utime;
  knowledge.taken_utime = swarm.utime;
  knowledge.begin_us = std::max<int64_t>(swarm.utime - contact.report_utime, 0);
  ReportAge(swarm, contact.name, knowledge);
}

void InformationAge::Add(const swarm_t& swarm) {
  if (!IsMissionTime(swarm.utime)) {
    ++num_impossible_;
    return;
  }
  const auto [place, is_new] = observers_.try_emplace(swarm.vehicle);
  Observer& observer = place->second;
  if (!is_new && swarm.utime < observer.last_utime) {
    ++num_impossible_;
    return;
  }
  if (is_new) observer.last_utime = swarm.utime;
  for (const swarm_contact_t& contact : swarm.contacts) AddContact(swarm, contact, &observer);
  observer.last_utime = swarm.utime;
}

std::vector<AgeTooth> InformationAge::TeethOf(const Knowledge& knowledge, int64_t last_utime) {
  Knowledge ended = knowledge;
  if (ended.report_utime) EndTooth(last_utime, &ended);
  return std::move(ended.teeth);
}

AgeSummary InformationAge::Summarize(const Knowledge& knowledge, int64_t last_utime) {
  constexpr double kShare = 0.95;
  const std::vector<AgeTooth> teeth = TeethOf(knowledge, last_utime);
  return {.is_target = knowledge.is_target,
          .num_reports = knowledge.num_reports,
          .first_report_s = Seconds(knowledge.first_utime),
          .mean_s = MeanAge_s(teeth),
          .age_95_s = AgePercentile_s(teeth, kShare),
          .max_s = MaxAge_s(teeth)};
}

std::map<InformationAge::Pair, std::vector<AgeTooth>> InformationAge::Teeth() const {
  std::map<Pair, std::vector<AgeTooth>> teeth;
  for (const auto& [vehicle, observer] : observers_) {
    for (const auto& [contact, knowledge] : observer.contacts) {
      teeth[{vehicle, contact}] = TeethOf(knowledge, observer.last_utime);
    }
  }
  return teeth;
}

std::map<InformationAge::Pair, AgeSummary> InformationAge::Summaries() const {
  std::map<Pair, AgeSummary> summaries;
  for (const auto& [vehicle, observer] : observers_) {
    for (const auto& [contact, knowledge] : observer.contacts) {
      summaries[{vehicle, contact}] = Summarize(knowledge, observer.last_utime);
    }
  }
  return summaries;
}

std::string InformationAge::Text(size_t max_pairs) const {
  const std::map<Pair, AgeSummary> summaries = Summaries();
  if (summaries.empty()) return "";
  const bool has_target = std::any_of(summaries.begin(), summaries.end(),
                                      [](const auto& row) { return row.second.is_target; });
  const bool targets_only = summaries.size() > max_pairs && has_target;
  std::string text =
      fmt::format("{:<32} {:>8} {:>12} {:>10} {:>10} {:>10}\n", "Age of information [s]", "reports",
                  "first report", "mean", "95 %", "max");
  size_t num_left_out = 0;
  for (const auto& [pair, summary] : summaries) {
    if (targets_only && !summary.is_target) {
      ++num_left_out;
      continue;
    }
    const std::string title = Printable(pair.first) + " of " + Printable(pair.second) +
                              (summary.is_target ? ", its target" : "");
    text += fmt::format("  {:<30} {:>8} {:>12.1f} {:>10.3f} {:>10.3f} {:>10.3f}\n", title,
                        summary.num_reports, summary.first_report_s, summary.mean_s,
                        summary.age_95_s, summary.max_s);
  }
  if (num_left_out > 0) {
    text += fmt::format("  ({} contacts that are not targets not shown; --all shows them)\n",
                        num_left_out);
  }
  return text + '\n';
}

std::string InformationAge::Csv() const {
  std::string text =
      "vehicle,contact,is_target,num_reports,first_heard_s,age_mean_s,age_95_s,age_max_s\n";
  for (const auto& [pair, summary] : Summaries()) {
    AppendCsvCell(pair.first, &text);
    text += ',';
    AppendCsvCell(pair.second, &text);
    text += fmt::format(",{},{},{:.6f},{:.6f},{:.6f},{:.6f}\n", summary.is_target ? 1 : 0,
                        summary.num_reports, summary.first_report_s, summary.mean_s,
                        summary.age_95_s, summary.max_s);
  }
  return text;
}

}  // namespace shoal
