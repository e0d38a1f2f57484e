#include "lib/routing/fate.h"

namespace shoal {

std::string_view KindText(Kind kind) {
  constexpr std::array<std::string_view, kNumKinds> kTexts = {"report", "message", "ack", "packet"};
  return kTexts.at(static_cast<size_t>(kind));
}

std::string_view CauseText(Cause cause) {
  constexpr std::array<std::string_view, kNumCauses> kTexts = {
      "delivered",   "invalid",        "too_many_vehicles", "ignored_group",  "too_soon",
      "too_long",    "unknown_source", "stale_source",      "no_destination", "unknown_destination",
      "other_group", "stale_receiver", "out_of_range",      "dropped",        "in_transit",
      "no_channel",  "not_listening",  "no_path",           "half_duplex",    "collision",
      "packet_loss", "bit_errors",     "rejected",          "damaged"};
  return kTexts.at(static_cast<size_t>(cause));
}

std::string_view OverrideText(OverrideRule override_rule) {
  constexpr std::array<std::string_view, 3> kTexts = {"", "critical_range", "full_report"};
  return kTexts.at(static_cast<size_t>(override_rule));
}

bool CanHave(Kind kind, Cause cause) {
  switch (cause) {
    case Cause::kIgnoredGroup:
      return kind == Kind::kReport;
    case Cause::kNoDestination:
      return kind == Kind::kMessage || kind == Kind::kPacket;
    case Cause::kUnknownSource:
      return kind != Kind::kReport;
    case Cause::kStaleSource:
    case Cause::kUnknownDestination:
      return kind == Kind::kMessage || kind == Kind::kAck;
    case Cause::kTooSoon:
    case Cause::kTooManyVehicles:
      return kind == Kind::kReport || kind == Kind::kMessage;
    case Cause::kOtherGroup:
    case Cause::kStaleReceiver:
    case Cause::kDropped:
    case Cause::kRejected:
      return kind != Kind::kPacket;
    case Cause::kInTransit:
      return false;
    default:
      return true;
  }
}

}  // namespace shoal
