#include "apps/viewer/rules_of_page.h"

#include <charconv>
#include <cmath>
#include <string>

#include "lib/routing/vehicle_name.h"

namespace shoal {

namespace {

constexpr double kNoLimit = -1;
constexpr size_t kMostFactors = 1000;

std::optional<double> NumberAt(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

/// "ALPHA: stealth 0.5, earange 2", as the page has vehicles that have not 1 and 1.
void TakeFactors(std::string_view line, comms_rules_t* rules) {
  constexpr std::string_view kStealth = ": stealth ";
  constexpr std::string_view kEarange = ", earange ";
  const size_t stealth = line.find(kStealth);
  const size_t earange = line.find(kEarange);
  if (stealth == std::string_view::npos || earange == std::string_view::npos ||
      stealth + kStealth.size() > earange || rules->factors.size() >= kMostFactors) {
    return;
  }
  const auto first = stealth + kStealth.size();
  const std::optional<double> of_stealth = NumberAt(line.substr(first, earange - first));
  const std::optional<double> of_earange = NumberAt(line.substr(earange + kEarange.size()));
  if (!of_stealth || !of_earange || !IsLegalVehicleName(line.substr(0, stealth))) return;
  rules->factors.push_back({.vehicle = std::string(line.substr(0, stealth)),
                            .stealth = *of_stealth,
                            .earange = *of_earange});
}

}  // namespace

std::optional<comms_rules_t> RulesOfPage(std::string_view text) {
  constexpr std::string_view kIndent = "    ";
  constexpr std::string_view kTitle = "Configuration:\n";
  const size_t title = text.find(kTitle);
  if (title == std::string_view::npos) return std::nullopt;
  text.remove_prefix(title + kTitle.size());
  std::optional<double> range_m;
  std::optional<double> critical_m;
  std::optional<double> stale_s;
  std::optional<double> drop;
  comms_rules_t rules{};
  while (text.starts_with(kIndent)) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line.remove_prefix(kIndent.size());
    const auto take = [&line](std::string_view name, std::string_view unlimited,
                              std::optional<double>* value) {
      if (!line.starts_with(name)) return;
      const std::string_view word = line.substr(name.size());
      *value = !unlimited.empty() && word == unlimited ? kNoLimit : NumberAt(word);
    };
    take("Comms Range: ", "nolimit", &range_m);
    take("Critical Range: ", "", &critical_m);
    take("Stale Drop: ", "never", &stale_s);
    take("Drop Percentage: ", "", &drop);
    TakeFactors(line, &rules);
  }
  if (!range_m || !critical_m || !stale_s || !drop) return std::nullopt;
  rules.comms_range_m = *range_m;
  rules.critical_range_m = *critical_m;
  rules.stale_time_s = *stale_s;
  rules.drop_percentage = *drop;
  rules.num_factors = static_cast<int32_t>(rules.factors.size());
  return rules;
}

}  // namespace shoal
