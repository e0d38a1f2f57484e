#include "lib/tools/analysis/comms_links.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/run/run/status_page.h"
#include "lib/tools/analysis/fate_kinds.h"

namespace shoal {

namespace {

constexpr double kLongestDelay_s = 86'400;
/// More than all transmissions of all missions; sums of counts stay numbers.
constexpr int64_t kMaxSent = int64_t{1} << 60;

void AddCount(int64_t more, int64_t* count) { *count = std::min(*count + more, kMaxSent); }

std::string ShownName(std::string_view name) { return name.empty() ? "-" : Printable(name); }

std::string LinkTitle(const LinkStatistics::Key& key) {
  return ShownName(std::get<1>(key)) + " -> " + ShownName(std::get<2>(key));
}

void Merge(const LinkOutcome& from, LinkOutcome* into) {
  AddCount(from.sent, &into->sent);
  AddCount(from.delivered, &into->delivered);
  AddCount(from.damaged, &into->damaged);
  for (const auto& [cause, count] : from.lost) AddCount(count, &into->lost[cause]);
  into->delays_s.insert(into->delays_s.end(), from.delays_s.begin(), from.delays_s.end());
}

double Mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double LostShare(const LinkOutcome& link) {
  return static_cast<double>(link.NumLost()) / static_cast<double>(std::max<int64_t>(link.sent, 1));
}

/// Most of what was lost first.
std::vector<std::pair<std::string, int64_t>> CausesOf(const LinkOutcome& link) {
  std::vector<std::pair<std::string, int64_t>> causes(link.lost.begin(), link.lost.end());
  std::stable_sort(causes.begin(), causes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return causes;
}

void AppendLink(const std::string& title, const LinkOutcome& link, std::string* text) {
  std::string delays = fmt::format("{:>8} {:>8}", "-", "-");
  if (!link.delays_s.empty()) {
    delays = fmt::format("{:>8.3f} {:>8.3f}", Mean(link.delays_s), Percentile(link.delays_s, 0.95));
  }
  const double delivered_pct = 100.0 * static_cast<double>(link.delivered) /
                               static_cast<double>(std::max<int64_t>(link.sent, 1));
  *text += fmt::format("  {:<20} {:>7} {:>7} {:>5.1f}% {:>7} {:>7} {}", title, link.sent,
                       link.delivered, delivered_pct, link.damaged, link.NumLost(), delays);
  const std::string indent(77, ' ');
  bool is_first = true;
  for (const auto& [cause, count] : CausesOf(link)) {
    *text += fmt::format("{}  {} {}", is_first ? "" : "\n" + indent, Printable(cause), count);
    is_first = false;
  }
  *text += '\n';
}

void AppendCsvLink(const LinkStatistics::Key& key, std::string* text) {
  const int kind = std::get<0>(key);
  *text += kind < kNumKinds ? KindText(static_cast<Kind>(kind)) : "other";
  for (const std::string& name : {std::get<1>(key), std::get<2>(key)}) {
    *text += ',';
    AppendCsvCell(name, text);
  }
}

}  // namespace

double Percentile(std::vector<double> values, double share) {
  SHOAL_CHECK(!values.empty() && share > 0 && share <= 1,
              "values are not empty, and 0 < share <= 1");
  const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(std::clamp<size_t>(rank, 1, values.size()) - 1);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

void LinkStatistics::Add(const fate_t& fate) {
  if (fate.count < 1) return;
  LinkOutcome& link = links_[{KindNumber(fate.kind), fate.source, fate.destination}];
  AddCount(fate.count, &link.sent);
  if (fate.cause == CauseText(Cause::kDelivered)) {
    AddCount(fate.count, &link.delivered);
  } else if (fate.cause == CauseText(Cause::kDamaged)) {
    AddCount(fate.count, &link.damaged);
  } else {
    AddCount(fate.count, &link.lost[fate.cause]);
    return;
  }
  for (const acoustic_path_t& path : fate.path) {
    const double delay_s = path.air_s + path.travel_s + path.jitter_s;
    if (delay_s >= 0 && delay_s <= kLongestDelay_s) {
      link.delays_s.push_back(delay_s);
    } else {
      ++num_impossible_;
    }
  }
}

std::string LinkStatistics::Text(size_t max_links) const {
  std::string text;
  for (int kind = 0; kind <= kNumKinds; ++kind) {
    LinkOutcome all;
    std::vector<std::pair<double, const Key*>> order;  // By the share that came, worst first.
    for (const auto& [key, link] : links_) {
      if (std::get<0>(key) != kind) continue;
      Merge(link, &all);
      order.emplace_back(-LostShare(link), &key);
    }
    if (order.empty()) continue;
    const size_t num_left_out = order.size() > max_links ? order.size() - max_links : 0;
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::set<Key> shown;
    for (size_t i = 0; i < order.size() - num_left_out; ++i) shown.insert(*order[i].second);

    text += fmt::format("{:<22} {:>7} {:>14} {:>7} {:>7} {:>8} {:>8}  {}\n", KindTitle(kind),
                        "sent", "delivered", "damaged", "lost", "delay s", "95 %", "lost by");
    AppendLink("all links", all, &text);
    for (const Key& key : shown) AppendLink(LinkTitle(key), links_.at(key), &text);
    if (num_left_out > 0) {
      text +=
          fmt::format("  ({} links that lost less not shown; --all shows them)\n", num_left_out);
    }
    text += '\n';
  }
  return text;
}

std::string LinkStatistics::LinksCsv() const {
  std::string text =
      "kind,source,destination,sent,delivered,damaged,lost,delay_mean_s,delay_95_s\n";
  for (const auto& [key, link] : links_) {
    AppendCsvLink(key, &text);
    text += fmt::format(",{},{},{},{},", link.sent, link.delivered, link.damaged, link.NumLost());
    if (!link.delays_s.empty()) {
      text += fmt::format("{:.6f},{:.6f}", Mean(link.delays_s), Percentile(link.delays_s, 0.95));
    } else {
      text += ',';
    }
    text += '\n';
  }
  return text;
}

std::string LinkStatistics::LossesCsv() const {
  std::string text = "kind,source,destination,cause,count\n";
  for (const auto& [key, link] : links_) {
    for (const auto& [cause, count] : link.lost) {
      AppendCsvLink(key, &text);
      text += ',';
      AppendCsvCell(cause, &text);
      text += fmt::format(",{}\n", count);
    }
  }
  return text;
}

}  // namespace shoal
