#include "lib/view/fate_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "lib/view/view_limits.h"

namespace shoal {

namespace {

/// What acoustic_path_t says without a modem.
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

std::string SilenceText(const FateFacts& facts) {
  if (!(facts.age_s >= 0)) return {};
  if (!(facts.age_limit_s >= 0)) return fmt::format("silent for {:.1f} s", facts.age_s);
  return fmt::format("silent for {:.1f} s of {:.1f} s", facts.age_s, facts.age_limit_s);
}

std::string LengthText(const FateFacts& facts) {
  if (facts.length_bytes < 0) return {};
  return fmt::format("{} bytes of {}", facts.length_bytes, facts.length_limit_bytes);
}

std::string WaterText(const FateFacts& facts) {
  if (!facts.has_path) return {};
  return fmt::format("{:.2f} s through the water", facts.travel_s + facts.jitter_s + facts.air_s);
}

std::string_view OverrideWords(OverrideRule rule) {
  switch (rule) {
    case OverrideRule::kCriticalRange:
      return "by critical_range";
    case OverrideRule::kFullReport:
      return "by a full report request";
    case OverrideRule::kNone:
      break;
  }
  return {};
}

std::string CollidersText(const FateFacts& facts, std::span<const std::string_view> colliders) {
  if (!facts.has_path || facts.num_colliders < 1) return {};
  constexpr size_t kMaxNamed = 3;
  const size_t num_named = std::min(colliders.size(), kMaxNamed);
  std::string text = "with ";
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

std::string BitsText(const FateFacts& facts) {
  if (!facts.has_path || facts.bits_flipped < 0) return {};
  return fmt::format("{} {} flipped", facts.bits_flipped, facts.bits_flipped == 1 ? "bit" : "bits");
}

std::string LossText(const FateFacts& facts) {
  if (!facts.has_path || !(facts.loss_probability >= 0)) return {};
  std::string text = fmt::format("probability {:.3g}", facts.loss_probability);
  if (facts.snr_db > kNoSnr_db) text += fmt::format(", SNR {:.1f} dB", facts.snr_db);
  return text;
}

std::string BitErrorText(const FateFacts& facts) {
  if (!facts.has_path || !(facts.bit_error_probability > 0)) return {};
  return fmt::format("each with probability {:.3g}", facts.bit_error_probability);
}

std::string NumbersOf(const FateFacts& facts, std::span<const std::string_view> colliders) {
  switch (facts.cause) {
    case Cause::kDelivered:
      return Joined(Joined(RangeText(facts), OverrideWords(facts.override_rule)), WaterText(facts));
    case Cause::kTooSoon:
      return facts.wait_s >= 0 ? fmt::format("{:.1f} s too early", facts.wait_s) : std::string();
    case Cause::kTooLong:
      return LengthText(facts);
    case Cause::kStaleSource:
    case Cause::kStaleReceiver:
      return SilenceText(facts);
    case Cause::kOutOfRange:
      return RangeText(facts);
    case Cause::kDropped:
      return facts.loss_pct >= 0 ? fmt::format("{:.4g} % are", facts.loss_pct) : std::string();
    case Cause::kNotListening:
      return facts.has_path ? fmt::format("channel {}", facts.channel) : std::string();
    case Cause::kHalfDuplex:
      return facts.has_path && facts.own_packet >= 0
                 ? fmt::format("its own packet {}", facts.own_packet)
                 : std::string();
    case Cause::kCollision:
      return CollidersText(facts, colliders);
    case Cause::kPacketLoss:
      return LossText(facts);
    case Cause::kBitErrors:
      return Joined(BitsText(facts), BitErrorText(facts));
    case Cause::kRejected:
    case Cause::kDamaged:
      return Joined(BitsText(facts), CollidersText(facts, colliders));
    case Cause::kInvalid:
    case Cause::kTooManyVehicles:
    case Cause::kIgnoredGroup:
    case Cause::kUnknownSource:
    case Cause::kNoDestination:
    case Cause::kUnknownDestination:
    case Cause::kOtherGroup:
    case Cause::kInTransit:
    case Cause::kNoChannel:
    case Cause::kNoPath:
      break;
  }
  return {};
}

std::string Ends(std::string_view source, std::string_view destination, int64_t count) {
  if (destination.empty()) return std::string(ShortName(source));
  if (destination != "*") {
    return fmt::format("{} to {}", ShortName(source), ShortName(destination));
  }
  return fmt::format("{} to {} {}", ShortName(source), count, count == 1 ? "other" : "others");
}

}  // namespace

std::string_view CauseWords(Cause cause) {
  constexpr std::array<std::string_view, kNumCauses> kWords = {"delivered",
                                                               "invalid",
                                                               "too many vehicles",
                                                               "of the ignored group",
                                                               "too soon",
                                                               "too long",
                                                               "unknown source",
                                                               "stale source",
                                                               "no destination",
                                                               "unknown destination",
                                                               "other group",
                                                               "stale receiver",
                                                               "out of range",
                                                               "dropped at random",
                                                               "in the water",
                                                               "no acoustic channel",
                                                               "receiver not listening",
                                                               "farther than sound comes",
                                                               "receiver was sending",
                                                               "collision",
                                                               "packet loss",
                                                               "bit errors",
                                                               "rejected as damaged",
                                                               "delivered damaged"};
  return kWords.at(static_cast<size_t>(cause));
}

std::string DecidingNumbers(const FateView& fate) { return NumbersOf(fate.facts, fate.colliders); }

std::string DecidingNumbers(const FateFacts& facts) { return NumbersOf(facts, {}); }

std::string FateText(const FateView& fate) {
  return fmt::format("{}: {}", Ends(fate.source, fate.destination, fate.facts.count),
                     Joined(CauseWords(fate.facts.cause), DecidingNumbers(fate)));
}

std::string FateText(const fate_t& fate) {
  FateView view;
  if (ViewOf(fate, 0, &view)) return FateText(view);
  return fmt::format("{}: {}", Ends(fate.source, fate.destination, fate.count),
                     ShortName(fate.cause));
}

}  // namespace shoal
