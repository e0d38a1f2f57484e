#include "lib/tools/rebroker/link_table.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "lib/run/run/status_page.h"
#include "lib/tools/analysis/fate_kinds.h"

namespace shoal {

namespace {

std::string Shown(std::string_view name) { return name.empty() ? "-" : Printable(name); }

/// The rows of one link, or of a kind's totals.
struct Block {
  std::string title;
  std::vector<std::pair<std::string, LinkTable::Change>> rows;

  bool HasDifference() const {
    for (const auto& [cause, change] : rows) {
      if (change.recorded != change.now) return true;
    }
    return false;
  }
};

void Append(const Block& block, bool has_recorded, std::string* text) {
  std::string title = block.title;
  for (const auto& [cause, change] : block.rows) {
    if (!has_recorded) {
      *text += fmt::format("  {:<26} {:<20} {:>10}\n", title, cause, change.now);
    } else if (change.recorded == change.now) {
      *text +=
          fmt::format("  {:<26} {:<20} {:>10} {:>10}\n", title, cause, change.recorded, change.now);
    } else {
      *text += fmt::format("* {:<26} {:<20} {:>10} {:>10} {:>+10}\n", title, cause, change.recorded,
                           change.now, change.now - change.recorded);
    }
    title.clear();
  }
}

}  // namespace

LinkTable::Change& LinkTable::Find(const fate_t& fate) {
  return changes_[Key(KindNumber(fate.kind), fate.source, fate.destination, fate.cause)];
}

void LinkTable::AddRecorded(const fate_t& fate) {
  if (fate.count > 0) Find(fate).recorded += fate.count;
}

void LinkTable::AddNow(const fate_t& fate) {
  if (fate.count > 0) Find(fate).now += fate.count;
}

LinkTable::Change LinkTable::Of(std::string_view kind, std::string_view source,
                                std::string_view destination, std::string_view cause) const {
  const auto found = changes_.find(Key(KindNumber(kind), source, destination, cause));
  return found == changes_.end() ? Change() : found->second;
}

std::string LinkTable::Text(size_t max_links, bool has_recorded) const {
  std::string text;
  for (int kind = 0; kind <= kNumKinds; ++kind) {
    Block all{.title = "all links", .rows = {}};
    std::map<std::string, Change> totals;
    std::vector<Block> links;
    for (const auto& [key, change] : changes_) {
      const auto& [its_kind, source, destination, cause] = key;
      if (its_kind != kind) continue;
      std::string title = Shown(source) + " -> " + Shown(destination);
      if (links.empty() || links.back().title != title) links.push_back({std::move(title), {}});
      links.back().rows.emplace_back(Shown(cause), change);
      Change& total = totals[Shown(cause)];
      total.recorded += change.recorded;
      total.now += change.now;
    }
    if (links.empty()) continue;
    all.rows.assign(totals.begin(), totals.end());
    text += has_recorded ? fmt::format("{:<49} {:>10} {:>10}\n", KindTitle(kind), "recorded", "now")
                         : fmt::format("{:<49} {:>10}\n", KindTitle(kind), "now");
    Append(all, has_recorded, &text);
    size_t num_left_out = 0;
    for (const Block& link : links) {
      if (links.size() > max_links && !(has_recorded && link.HasDifference())) {
        ++num_left_out;
      } else {
        Append(link, has_recorded, &text);
      }
    }
    if (num_left_out > 0) {
      text += fmt::format("  ({} links{} not shown; --all shows them)\n", num_left_out,
                          has_recorded ? " without a difference" : "");
    }
    text += "\n";
  }
  return text;
}

}  // namespace shoal
