#include "lib/tools/rebroker/decision_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/bus.h"
#include "lib/run/run/status_page.h"

namespace shoal {

std::string FateLine(const fate_t& fate) {
  std::string line =
      fmt::format("{} {} {} -> {}: {}", Printable(fate.kind), fate.number, Printable(fate.source),
                  Printable(fate.destination), Printable(fate.cause));
  if (!fate.override_rule.empty()) line += " by " + Printable(fate.override_rule);
  if (fate.count != 1) line += fmt::format(" count={}", fate.count);
  const std::pair<const char*, double> numbers[] = {
      {"range_m", fate.range_m},
      {"limit_m", fate.limit_m},
      {"age_s", fate.age_s},
      {"age_limit_s", fate.age_limit_s},
      {"wait_s", fate.wait_s},
      {"loss_pct", fate.loss_pct},
      {"length_bytes", fate.length_bytes},
      {"length_limit_bytes", fate.length_limit_bytes}};
  for (const auto& [name, number] : numbers) {
    if (number != -1) line += fmt::format(" {}={}", name, number);
  }
  return line;
}

std::string DecisionComparison::KeyOf(const fate_t& fate) const {
  if (same_ == SameDecision::kFateOnly) {
    return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", fate.kind, fate.source, fate.number,
                       fate.destination, fate.cause, fate.override_rule, fate.count);
  }
  fate_t copy = fate;
  if (same_ == SameDecision::kWithoutNumbers) copy.number = 0;
  Bytes bytes;
  EncodeInto(copy, &bytes);
  return {bytes.begin(), bytes.end()};
}

void DecisionComparison::Compare(int64_t utime, std::span<const fate_t> recorded,
                                 std::span<const fate_t> now) {
  num_recorded_ += static_cast<int64_t>(recorded.size());
  num_now_ += static_cast<int64_t>(now.size());
  using Keyed = std::pair<std::string, const fate_t*>;
  const auto keyed = [&](std::span<const fate_t> fates) {
    std::vector<Keyed> made;
    for (const fate_t& fate : fates) made.emplace_back(KeyOf(fate), &fate);
    if (same_ == SameDecision::kFateOnly) std::sort(made.begin(), made.end());
    return made;
  };
  const std::vector<Keyed> then_keys = keyed(recorded);
  const std::vector<Keyed> now_keys = keyed(now);
  const auto same_key = [](const Keyed& a, const Keyed& b) { return a.first == b.first; };
  const auto [then_differs, now_differs] =
      std::mismatch(then_keys.begin(), then_keys.end(), now_keys.begin(), now_keys.end(), same_key);
  if (then_differs == then_keys.end() && now_differs == now_keys.end()) {
    num_reproduced_ += static_cast<int64_t>(recorded.size());
    return;
  }
  if (then_keys.size() == now_keys.size() && same_ != SameDecision::kFateOnly) {
    for (size_t i = 0; i < then_keys.size(); ++i) {
      if (same_key(then_keys[i], now_keys[i])) ++num_reproduced_;
    }
  } else {
    std::map<std::string_view, int64_t> unmatched;
    for (const auto& [key, fate] : then_keys) ++unmatched[key];
    for (const auto& [key, fate] : now_keys) {
      const auto found = unmatched.find(key);
      if (found == unmatched.end() || found->second == 0) continue;
      --found->second;
      ++num_reproduced_;
    }
  }
  if (!first_difference_.empty()) return;
  const auto line_of = [](const std::vector<Keyed>& fates, auto place) {
    return place == fates.end() ? std::string("nothing") : FateLine(*place->second);
  };
  first_difference_ =
      fmt::format("  {:.3f} s, recorded: {}\n  {:.3f} s, now:      {}\n", Seconds(utime),
                  line_of(then_keys, then_differs), Seconds(utime), line_of(now_keys, now_differs));
}

}  // namespace shoal
