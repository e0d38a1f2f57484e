#include "lib/tools/mcap/shown_messages.h"

#include <fmt/format.h>

#include <cmath>

#include "lib/base/schema/text.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/valid_utf8.h"
#include "lib/comms/routing/cause.h"
#include "lib/tools/view/fate_text.h"

namespace shoal {

namespace {

template <class T>
bool DecodeMessage(const RecognisedMessage& message, T* decoded) {
  return message.type->fingerprint == T::getHash() &&
         decoded->decode(message.data.data(), 0, static_cast<int>(message.data.size())) >= 0;
}

/// Returns whether messages of this type are orders, worth a line each.
bool IsOrder(const StructType& type) {
  return type.package == "shoal" && (type.name == "helm_command_t" ||
                                     type.name == "sim_command_t" || type.name == "unc_control_t");
}

std::string TaskWords(const helm_state_t& helm) {
  return helm.task.empty() ? helm.state : fmt::format("{}, task {}", helm.state, helm.task);
}

constexpr char kClear[] = "clear";

}  // namespace

bool McapShownMessages::Add(const LogEvent& event, const RecognisedMessage& message,
                            const Sink& sink) {
  if (const auto vehicle = VehicleOfChannel(event.channel, topics::kNav); !vehicle.empty()) {
    return AddNav(vehicle, message, sink);
  }
  if (event.channel == topics::kCommsFates) return AddFates(event, message, sink);
  if (const auto vehicle = VehicleOfChannel(event.channel, topics::kHelmState); !vehicle.empty()) {
    return AddHelm(event, vehicle, message, sink);
  }
  if (!IsOrder(*message.type)) return true;
  return AddEvent(event, LogLevel::kInfo, event.channel,
                  MessageText(schema_, *message.type, message.data, "utime"), sink);
}

bool McapShownMessages::AddNav(std::string_view vehicle, const RecognisedMessage& message,
                               const Sink& sink) {
  if (!DecodeMessage(message, &nav_)) return true;
  if (std::isfinite(nav_.lat_deg) && std::isfinite(nav_.lon_deg) && std::isfinite(nav_.z_m)) {
    topic_.assign("foxglove/location/").append(vehicle);
    const auto append = [&](std::string* out) { AppendLocationFix(nav_, vehicle, out); };
    if (!sink(ShownKind::kLocation, topic_, append)) return false;
  }
  for (const double value :
       {nav_.x_m, nav_.y_m, nav_.z_m, nav_.roll_deg, nav_.pitch_deg, nav_.heading_deg}) {
    if (!std::isfinite(value)) return true;
  }
  topic_.assign("foxglove/pose/").append(vehicle);
  return sink(ShownKind::kPose, topic_, [&](std::string* out) { AppendPoseInFrame(nav_, out); });
}

bool McapShownMessages::AddFates(const LogEvent& event, const RecognisedMessage& message,
                                 const Sink& sink) {
  if (message.type->fingerprint != comms_fates_t::getHash()) return true;
  if (!ReadFates(message.data, &fates_)) return true;
  for (const FateView& fate : fates_.all()) {
    const LogLevel level = IsReceived(fate.facts.cause) ? LogLevel::kDebug : LogLevel::kInfo;
    const auto append = [&](std::string* out) {
      AppendLog(event.utime, level, ValidUtf8(fate.source), ValidUtf8(FateText(fate)), out);
    };
    if (!sink(ShownKind::kLog, "foxglove/fates", append)) return false;
  }
  return true;
}

bool McapShownMessages::AddHelm(const LogEvent& event, std::string_view vehicle,
                                const RecognisedMessage& message, const Sink& sink) {
  helm_state_t helm{};
  if (!DecodeMessage(message, &helm)) return true;
  const auto [it, is_new] = helms_.try_emplace(std::string(vehicle));
  helm_state_t& last = it->second;
  const bool is_stopped = helm.all_stop != last.all_stop && helm.all_stop != kClear;
  const bool has_changed = is_new || helm.state != last.state || helm.task != last.task;
  bool is_wanted = true;
  if (is_stopped && !helm.all_stop.empty()) {
    is_wanted = AddEvent(event, LogLevel::kWarning, vehicle, "all-stop: " + helm.all_stop, sink);
  } else if (has_changed) {
    is_wanted = AddEvent(event, LogLevel::kInfo, vehicle, TaskWords(helm), sink);
  }
  last = std::move(helm);
  return is_wanted;
}

bool McapShownMessages::AddEvent(const LogEvent& event, LogLevel level, std::string_view name,
                                 const std::string& text, const Sink& sink) {
  return sink(ShownKind::kLog, "foxglove/events", [&](std::string* out) {
    AppendLog(event.utime, level, ValidUtf8(name), ValidUtf8(text), out);
  });
}

}  // namespace shoal
