#include "lib/tools/view/fate_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

/// What acoustic_path_t holds without a modem.
constexpr float kNoSnr_db = -998;

std::string Joined(std::string_view first, std::string_view second) {
  if (first.empty() || second.empty()) return fmt::format("{}{}", first, second);
  return fmt::format("{}, {}", first, second);
}

std::string_view ShortName(std::string_view name) { return name.substr(0, kMaxNameBytes); }

std::string RangeText(const FateFacts& facts) {
  if (!(facts.range_m >= 0)) return {};
  if (!(facts.limit_m >= 0)) return fmt::format("{:.1f} m, no limit", facts.range_m);
  return fmt::format("{:.1f} m of {:.1f} m", facts.range_m, facts.limit_m);
}

std::string AgeText(const FateFacts& facts) {
  if (!(facts.age_s >= 0)) return {};
  if (!(facts.age_limit_s >= 0)) return fmt::format("{:.1f} s", facts.age_s);
  return fmt::format("{:.1f} s of {:.1f} s", facts.age_s, facts.age_limit_s);
}

std::string LengthText(const FateFacts& facts) {
  if (facts.length_bytes < 0) return {};
  return fmt::format("{} bytes of {}", facts.length_bytes, facts.length_limit_bytes);
}

std::string DepthText(const FateFacts& facts) {
  if (!(facts.depth_m >= 0) || !(facts.depth_limit_m >= 0)) return {};
  return fmt::format("{:.2f} m of {:.2f} m", facts.depth_m, facts.depth_limit_m);
}

std::string PathLossText(const FateFacts& facts) {
  if (!(facts.path_loss_db >= 0)) return {};
  return fmt::format("{:.1f} dB of {:.1f} dB (margin {:.1f} dB)", facts.path_loss_db,
                     facts.path_loss_limit_db, facts.path_loss_limit_db - facts.path_loss_db);
}

std::string OverrideWords(const FateFacts& facts) {
  switch (facts.override_rule) {
    case OverrideRule::kCriticalRange:
      return "critical_range";
    case OverrideRule::kFullReport:
      return "a full report request";
    case OverrideRule::kNone:
      break;
  }
  return {};
}

std::string CollidersText(const FateFacts& facts, std::span<const std::string_view> colliders) {
  if (!facts.has_path || facts.num_colliders < 1) return {};
  constexpr size_t kMaxNamed = 3;
  const size_t num_named = std::min(colliders.size(), kMaxNamed);
  std::string text;
  for (size_t i = 0; i < num_named; ++i) {
    text += fmt::format("{}{}", i > 0 ? ", " : "", ShortName(colliders[i]));
  }
  const int64_t others = facts.num_colliders - static_cast<int64_t>(num_named);
  if (others > 0) {
    text += fmt::format("{}{} {}", num_named > 0 ? " and " : "", others,
                        others == 1 ? "other" : "others");
  }
  return text;
}

using Colliders = std::span<const std::string_view>;

/// Writes the numbers that `name` of a CauseRow::text stands for; empty where they were not used.
struct NumberRow {
  FateNumber number;
  std::string (*text)(const FateFacts& facts, Colliders colliders);
};

constexpr std::array kNumbers = {
    NumberRow{{"range", "range_m limit_m"},
              [](const FateFacts& facts, Colliders) { return RangeText(facts); }},
    NumberRow{{"age", "age_s age_limit_s"},
              [](const FateFacts& facts, Colliders) { return AgeText(facts); }},
    NumberRow{{"wait", "wait_s"},
              [](const FateFacts& facts, Colliders) {
                return facts.wait_s >= 0 ? fmt::format("{:.1f} s", facts.wait_s) : std::string();
              }},
    NumberRow{{"length", "length_bytes length_limit_bytes"},
              [](const FateFacts& facts, Colliders) { return LengthText(facts); }},
    NumberRow{{"loss", "loss_pct"},
              [](const FateFacts& facts, Colliders) {
                return facts.loss_pct >= 0 ? fmt::format("{:.4g} %", facts.loss_pct)
                                           : std::string();
              }},
    NumberRow{{"override", "override_rule"},
              [](const FateFacts& facts, Colliders) { return OverrideWords(facts); }},
    NumberRow{{"delay", "travel_s jitter_s air_s"},
              [](const FateFacts& facts, Colliders) {
                return facts.has_path
                           ? fmt::format("{:.2f} s", facts.travel_s + facts.jitter_s + facts.air_s)
                           : std::string();
              }},
    NumberRow{{"channel", "channel"},
              [](const FateFacts& facts, Colliders) {
                return facts.has_path ? fmt::format("{}", facts.channel) : std::string();
              }},
    NumberRow{{"own_packet", "own_packet"},
              [](const FateFacts& facts, Colliders) {
                return facts.has_path && facts.own_packet >= 0 ? fmt::format("{}", facts.own_packet)
                                                               : std::string();
              }},
    NumberRow{{"colliders", "colliders"}, CollidersText},
    NumberRow{{"loss_probability", "loss_probability"},
              [](const FateFacts& facts, Colliders) {
                return facts.loss_probability >= 0 ? fmt::format("{:.3g}", facts.loss_probability)
                                                   : std::string();
              }},
    NumberRow{{"snr", "snr_db"},
              [](const FateFacts& facts, Colliders) {
                return facts.has_path && facts.snr_db > kNoSnr_db
                           ? fmt::format("{:.1f} dB", facts.snr_db)
                           : std::string();
              }},
    NumberRow{{"bits", "bits_flipped"},
              [](const FateFacts& facts, Colliders) {
                return facts.has_path && facts.bits_flipped >= 0
                           ? fmt::format("{} {}", facts.bits_flipped,
                                         facts.bits_flipped == 1 ? "bit" : "bits")
                           : std::string();
              }},
    NumberRow{{"bit_error_probability", "bit_error_probability"},
              [](const FateFacts& facts, Colliders) {
                return facts.has_path && facts.bit_error_probability > 0
                           ? fmt::format("{:.3g}", facts.bit_error_probability)
                           : std::string();
              }},
    NumberRow{{"depth", "depth_m depth_limit_m"},
              [](const FateFacts& facts, Colliders) { return DepthText(facts); }},
    NumberRow{{"path_loss", "path_loss_db path_loss_limit_db"},
              [](const FateFacts& facts, Colliders) { return PathLossText(facts); }},
    NumberRow{{"horizon", "horizon_m"},
              [](const FateFacts& facts, Colliders) {
                return facts.horizon_m >= 0 ? fmt::format("{:.1f} m", facts.horizon_m)
                                            : std::string();
              }},
    NumberRow{{"radio_delay", "delay_s"},
              [](const FateFacts& facts, Colliders) {
                return facts.radio_delay_s >= 0 ? fmt::format("{:.2f} s", facts.radio_delay_s)
                                                : std::string();
              }},
};

/// Returns the next part of a template, and removes it and the comma behind it.
std::string_view TakePart(std::string_view* text) {
  const size_t comma = std::min(text->find(", "), text->size());
  const std::string_view part = text->substr(0, comma);
  text->remove_prefix(std::min(comma + 2, text->size()));
  return part;
}

/// Returns a part of a template with its numbers; empty where one of them was not used.
std::string Filled(std::string_view part, const FateFacts& facts, Colliders colliders) {
  const size_t begin = part.find('{');
  const size_t end = part.find('}');
  const std::string_view name = part.substr(begin + 1, end - begin - 1);
  const auto row =
      std::ranges::find(kNumbers, name, [](const NumberRow& each) { return each.number.name; });
  if (row == kNumbers.end()) return {};
  const std::string number = row->text(facts, colliders);
  if (number.empty()) return {};
  return fmt::format("{}{}{}", part.substr(0, begin), number, part.substr(end + 1));
}

std::string NumbersOf(const FateFacts& facts, Colliders colliders) {
  std::string_view rest = RowOf(facts.cause).text;
  TakePart(&rest);
  std::string text;
  while (!rest.empty()) text = Joined(text, Filled(TakePart(&rest), facts, colliders));
  return text;
}

/// Returns "over vhf", with the hop behind the first; empty where no medium is known.
std::string MediumWords(const FateView& fate) {
  if (fate.medium.empty()) return {};
  const std::string words = fmt::format("over {}", ShortName(fate.medium));
  return fate.facts.hop > 0 ? fmt::format("{}, hop {}", words, fate.facts.hop) : words;
}

std::string Ends(std::string_view source, std::string_view destination, int64_t count) {
  if (destination.empty()) return std::string(ShortName(source));
  if (destination != "*") {
    return fmt::format("{} to {}", ShortName(source), ShortName(destination));
  }
  return fmt::format("{} to {} {}", ShortName(source), count, count == 1 ? "other" : "others");
}

}  // namespace

std::vector<FateNumber> FateNumbers() {
  std::vector<FateNumber> numbers;
  numbers.reserve(std::size(kNumbers));
  for (const NumberRow& row : kNumbers) numbers.push_back(row.number);
  return numbers;
}

std::string_view CauseWords(Cause cause) {
  std::string_view text = RowOf(cause).text;
  return TakePart(&text);
}

std::string DecidingNumbers(const FateView& fate) { return NumbersOf(fate.facts, fate.colliders); }

std::string DecidingNumbers(const FateFacts& facts) { return NumbersOf(facts, {}); }

std::string FateText(const FateView& fate) {
  return fmt::format(
      "{}: {}", Ends(fate.source, fate.destination, fate.facts.count),
      Joined(Joined(CauseWords(fate.facts.cause), DecidingNumbers(fate)), MediumWords(fate)));
}

std::string FateText(const fate_t& fate) {
  FateView view;
  if (ViewOf(fate, 0, &view)) return FateText(view);
  return fmt::format("{}: {}", Ends(fate.source, fate.destination, fate.count),
                     ShortName(fate.cause));
}

std::string DecidingNumbers(const fate_medium_t& fate) {
  FateView view;
  return ViewOf(fate, 0, &view) ? DecidingNumbers(view) : std::string();
}

}  // namespace shoal
