#include "lib/tools/analysis/media_tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/bus/record/csv_rows.h"
#include "lib/run/run/status_page.h"
#include "lib/tools/analysis/comms_links.h"
#include "lib/tools/view/fate_text.h"

namespace shoal {

namespace {

constexpr double kLongestMediumDelay_s = 172'800;

double MeanDelay_s(const std::vector<double>& delays_s) {
  return std::accumulate(delays_s.begin(), delays_s.end(), 0.0) /
         static_cast<double>(delays_s.size());
}

void AddTo(const MediumOutcome& from, MediumOutcome* into) {
  into->sent += from.sent;
  into->delivered += from.delivered;
  for (const auto& [cause, count] : from.lost) into->lost[cause] += count;
  into->delays_s.insert(into->delays_s.end(), from.delays_s.begin(), from.delays_s.end());
}

}  // namespace

void MediaTally::Add(const fate_medium_t& fate) {
  MediumOutcome& outcome =
      outcomes_[{fate.kind, fate.medium, fate.hop, fate.source, fate.destination}];
  ++outcome.sent;
  if (std::isfinite(fate.depth_m)) outcome.deepest_m = std::max(outcome.deepest_m, fate.depth_m);
  if (std::isfinite(fate.path_loss_db)) {
    outcome.largest_loss_db = std::max(outcome.largest_loss_db, fate.path_loss_db);
  }
  if (fate.cause != "delivered" && fate.cause != "damaged") {
    ++outcome.lost[fate.cause];
    last_numbers_[{fate.kind, fate.medium, fate.hop}][fate.cause] = DecidingNumbers(fate);
    return;
  }
  ++outcome.delivered;
  if (fate.delay_s >= 0 && fate.delay_s <= kLongestMediumDelay_s) {
    outcome.delays_s.push_back(fate.delay_s);
  }
}

std::string MediaTally::Text() const {
  if (outcomes_.empty()) return {};
  std::map<Line, MediumOutcome> sums;
  for (const auto& [key, outcome] : outcomes_) {
    AddTo(outcome, &sums[{std::get<0>(key), std::get<1>(key), std::get<2>(key)}]);
  }
  std::string text =
      fmt::format("Media\n{:<8} {:<16} {:>4} {:>9} {:>9} {:>9} {:>9}  {}\n", "kind", "medium",
                  "hop", "sent", "delivered", "mean [s]", "95 % [s]", "lost");
  for (const auto& [key, sum] : sums) {
    const auto& [kind, medium, hop] = key;
    std::string delays = fmt::format("{:>9} {:>9}", "-", "-");
    if (!sum.delays_s.empty()) {
      delays = fmt::format("{:>9.3f} {:>9.3f}", MeanDelay_s(sum.delays_s),
                           Percentile(sum.delays_s, 0.95));
    }
    std::string lost;
    for (const auto& [cause, count] : sum.lost) {
      const std::string& numbers = last_numbers_.at(key).at(cause);
      lost += fmt::format("{}{} {}{}", lost.empty() ? "" : ", ", Printable(cause), count,
                          numbers.empty() ? "" : fmt::format(" (last: {})", numbers));
    }
    text += fmt::format("{:<8} {:<16} {:>4} {:>9} {:>9} {}  {}\n", Printable(kind),
                        medium.empty() ? "none" : Printable(medium), hop, sum.sent, sum.delivered,
                        delays, lost.empty() ? "-" : lost);
  }
  return text + "\n";
}

std::string MediaTally::Csv() const {
  std::string rows =
      "kind,medium,hop,source,destination,sent,delivered,mean_delay_s,deepest_m,"
      "largest_path_loss_db\n";
  for (const auto& [key, outcome] : outcomes_) {
    const auto& [kind, medium, hop, source, destination] = key;
    for (const std::string* cell : {&kind, &medium}) {
      AppendCsvCell(*cell, &rows);
      rows += ',';
    }
    rows += fmt::format("{},", hop);
    for (const std::string* cell : {&source, &destination}) {
      AppendCsvCell(*cell, &rows);
      rows += ',';
    }
    rows +=
        fmt::format("{},{},{},{},{}\n", outcome.sent, outcome.delivered,
                    outcome.delays_s.empty() ? std::string()
                                             : fmt::format("{:.6f}", MeanDelay_s(outcome.delays_s)),
                    outcome.deepest_m, outcome.largest_loss_db);
  }
  return rows;
}

}  // namespace shoal
