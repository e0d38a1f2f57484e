#include "lib/tools/analysis/swarm_tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "lib/bus/record/csv_rows.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

/// More than any mission counts; sums stay numbers.
constexpr int64_t kMaxCounted = 1'000'000'000'000;

bool CanBeCounted(const swarm_t& swarm) {
  const auto can_be = [](int64_t count) { return count >= 0 && count <= kMaxCounted; };
  return can_be(swarm.num_said) &&
         std::all_of(swarm.sources.begin(), swarm.sources.end(),
                     [&](const swarm_source_t& source) {
                       return can_be(source.received) && can_be(source.clean) &&
                              can_be(source.recovered) && can_be(source.rejected);
                     }) &&
         std::all_of(swarm.counts.begin(), swarm.counts.end(),
                     [&](const swarm_count_t& count) { return can_be(count.count); });
}

void AddSource(const SourceCount& more, SourceCount* sum) {
  const auto add = [](int64_t count, int64_t* total) {
    *total = std::min(*total + count, int64_t{1} << 60);
  };
  add(more.received, &sum->received);
  add(more.clean, &sum->clean);
  add(more.recovered, &sum->recovered);
  add(more.rejected, &sum->rejected);
}

double ShareOf(int64_t part, int64_t whole) {
  return static_cast<double>(part) / static_cast<double>(std::max<int64_t>(whole, 1));
}

void AppendRow(const std::string& title, const SourceCount& count, std::string* text) {
  const auto cell = [&](int64_t part) {
    return fmt::format("{:>8} {:>5.1f}%", part, 100 * ShareOf(part, count.received));
  };
  *text += fmt::format("  {:<30} {:>8}  {}  {}  {}\n", title, count.received, cell(count.clean),
                       cell(count.recovered), cell(count.rejected));
}

void AppendCells(std::initializer_list<std::string_view> cells, std::string* text) {
  for (const std::string_view cell : cells) {
    AppendCsvCell(cell, text);
    *text += ',';
  }
}

}  // namespace

void SwarmTally::AddTo(const Counts& counts, Counts* sum) {
  for (const auto& [source, count] : counts.sources) AddSource(count, &sum->sources[source]);
  for (const auto& [event, count] : counts.events) {
    int64_t& total = sum->events[event];
    total = std::min(total + count, int64_t{1} << 60);
  }
}

void SwarmTally::Add(const swarm_t& swarm) {
  if (!CanBeCounted(swarm)) {
    ++num_impossible_;
    return;
  }
  Counts now{.num_published = swarm.num_said, .sources = {}, .events = {}};
  for (const swarm_source_t& source : swarm.sources) {
    AddSource({source.received, source.clean, source.recovered, source.rejected},
              &now.sources[source.name]);
  }
  for (const swarm_count_t& count : swarm.counts) {
    int64_t& total = now.events[{count.outcome, count.field, count.by}];
    total = std::min(total + count.count, int64_t{1} << 60);
  }
  Receiver& receiver = receivers_[swarm.vehicle];
  bool began_again = now.num_published < receiver.last.num_published;
  for (const auto& [source, count] : receiver.last.sources) {
    const auto found = now.sources.find(source);
    began_again |= found == now.sources.end() || found->second.received < count.received;
  }
  if (began_again) AddTo(receiver.last, &receiver.before);
  receiver.last = std::move(now);
}

std::map<SwarmTally::Pair, SourceCount> SwarmTally::Sources() const {
  std::map<Pair, SourceCount> sources;
  for (const auto& [name, receiver] : receivers_) {
    Counts all = receiver.before;
    AddTo(receiver.last, &all);
    for (const auto& [source, count] : all.sources) sources[{name, source}] = count;
  }
  return sources;
}

std::map<SwarmTally::Event, int64_t> SwarmTally::Events() const {
  std::map<Event, int64_t> events;
  for (const auto& [name, receiver] : receivers_) {
    Counts all = receiver.before;
    AddTo(receiver.last, &all);
    for (const auto& [event, count] : all.events) {
      const auto& [outcome, field, by] = event;
      events[{name, outcome, field, by}] = count;
    }
  }
  return events;
}

std::string SwarmTally::Text(size_t max_pairs) const {
  const std::map<Pair, SourceCount> sources = Sources();
  if (sources.empty()) return "";
  SourceCount all;
  std::vector<std::pair<double, Pair>> order;  // Worst first.
  for (const auto& [pair, count] : sources) {
    AddSource(count, &all);
    order.emplace_back(ShareOf(count.clean, count.received), pair);
  }
  std::sort(order.begin(), order.end());
  const size_t num_shown = std::min(max_pairs, order.size());
  std::set<Pair> shown;
  for (size_t i = 0; i < num_shown; ++i) shown.insert(order[i].second);

  std::string text = fmt::format("{:<32} {:>8}  {:>15}  {:>15}  {:>15}\n", "Swarm messages",
                                 "received", "clean", "recovered", "rejected");
  AppendRow("all", all, &text);
  for (const Pair& pair : shown) {
    AppendRow(Printable(pair.first) + " from " + Printable(pair.second), sources.at(pair), &text);
  }
  if (num_shown < order.size()) {
    text += fmt::format("  ({} pairs with more clean messages not shown; --all shows them)\n",
                        order.size() - num_shown);
  }
  std::map<std::tuple<std::string, std::string, std::string>, int64_t> events;
  for (const auto& [event, count] : Events()) {
    const auto& [receiver, outcome, field, by] = event;
    int64_t& total = events[{outcome, field, by}];
    total = std::min(total + count, int64_t{1} << 60);
  }
  if (!events.empty()) {
    text += fmt::format("\n{:<22} {:<18} {:<40} {:>8}\n", "Recovered and rejected", "field", "by",
                        "times");
  }
  for (const auto& [event, count] : events) {
    const auto& [outcome, field, by] = event;
    text += fmt::format("  {:<20} {:<18} {:<40} {:>8}\n", Printable(outcome),
                        field.empty() ? "-" : Printable(field), Printable(by), count);
  }
  return text + '\n';
}

std::string SwarmTally::SourcesCsv() const {
  std::string text = "receiver,source,received,clean,recovered,rejected\n";
  for (const auto& [pair, count] : Sources()) {
    AppendCells({pair.first, pair.second}, &text);
    text +=
        fmt::format("{},{},{},{}\n", count.received, count.clean, count.recovered, count.rejected);
  }
  return text;
}

std::string SwarmTally::EventsCsv() const {
  std::string text = "receiver,outcome,field,by,count\n";
  for (const auto& [event, count] : Events()) {
    const auto& [receiver, outcome, field, by] = event;
    AppendCells({receiver, outcome, field, by}, &text);
    text += fmt::format("{}\n", count);
  }
  return text;
}

}  // namespace shoal
