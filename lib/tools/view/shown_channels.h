// Channels of a vehicle whose last message a frame shows: one row each. A row is all that a new
// channel needs beside its line in ShownChannels; the scene, live and recorded views and frames
// draw on it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/tools/view/json_writer.h"
#include "shoal/desired_t.hpp"
#include "shoal/guidance_t.hpp"
#include "shoal/helm_decision_t.hpp"
#include "shoal/modem_stats_t.hpp"
#include "shoal/navigation_t.hpp"

namespace shoal {

struct ShownDesired {
  using Message = desired_t;
  static constexpr std::string_view kKey = "desired";  ///< Of a vehicle in a frame.

  static Channel<Message> ChannelOf(std::string_view vehicle) { return channels::Desired(vehicle); }
  /// Bounds what the scene keeps: texts and lists of a message may be of any length.
  static void Bound(Message* /*message*/) {}
  static void Write(const Message& desired, JsonWriter* json) {
    json->BeginObject()
        .Number("heading", desired.heading_deg, kTenths)
        .Number("speed", desired.speed_mps, 2)
        .Number("depth", desired.depth_m, kCentimetres)
        .EndObject();
  }
};

/// What the modem of a vehicle from outside has received last, by its client. One channel carries
/// those of all vehicles: VehicleOf names the message's own.
struct ShownModem {
  using Message = modem_stats_t;
  static constexpr std::string_view kKey = "modem";

  static Channel<Message> ChannelOf(std::string_view /*vehicle*/) { return channels::ModemStats(); }
  static std::string_view VehicleOf(const Message& stats) { return stats.receiver; }
  static void Bound(Message* stats) {
    constexpr size_t kLongestName = 40;
    if (stats->sender.size() > kLongestName) stats->sender.resize(kLongestName);
  }
  static void Write(const Message& stats, JsonWriter* json) {
    json->BeginObject()
        .Number("t", Seconds(stats.utime), kMilliseconds)
        .Text("sender", stats.sender)
        .Boolean("good", stats.is_good != 0)
        .Boolean("has_numbers", stats.has_modem != 0)
        .Integer("rate", stats.rate)
        .Integer("frames", stats.num_frames)
        .Integer("bad_frames", stats.num_bad_frames)
        .Integer("snr", stats.snr_in_db)
        .Integer("equalizer", stats.mse_equalizer_db)
        .EndObject();
  }
};

/// Why the helm of a vehicle with behaviors steers as it does.
struct ShownDecision {
  using Message = helm_decision_t;
  static constexpr std::string_view kKey = "decision";
  static constexpr size_t kMaxAims = 20;

  static Channel<Message> ChannelOf(std::string_view vehicle) {
    return channels::HelmDecision(vehicle);
  }
  static void Bound(Message* decision) {
    if (decision->aims.size() > kMaxAims) decision->aims.resize(kMaxAims);
    decision->num_aims = static_cast<int32_t>(decision->aims.size());
    decision->events.clear();
    decision->num_events = 0;
    for (std::string* text : {&decision->vehicle, &decision->mode, &decision->all_stop}) {
      Shorten(text);
    }
    for (helm_aim_t& aim : decision->aims) {
      for (std::string* text :
           {&aim.name, &aim.kind, &aim.state, &aim.contact, &aim.role, &aim.rule}) {
        Shorten(text);
      }
    }
  }
  static void Write(const Message& decision, JsonWriter* json) {
    json->BeginObject()
        .Number("t", Seconds(decision.utime), kMilliseconds)
        .Text("mode", decision.mode)
        .Text("all_stop", decision.all_stop)
        .Number("course", decision.course_deg, kTenths)
        .Number("speed", decision.speed_mps, 2)
        .Number("depth", decision.depth_m, kTenths)
        .Key("aims")
        .BeginArray();
    for (const helm_aim_t& aim : decision.aims) {
      json->BeginObject()
          .Text("name", aim.name)
          .Text("kind", aim.kind)
          .Text("state", aim.state)
          .Number("weight", aim.weight, kTenths)
          .Number("course", aim.best_course_deg, kTenths)
          .Number("speed", aim.best_speed_mps, 2)
          .Number("value", aim.value, kTenths)
          .Number("loss", aim.weight > 0 ? aim.loss / aim.weight : 0, kTenths)
          .Text("contact", aim.contact)
          .Text("role", aim.role)
          .Text("rule", aim.rule)
          .Number("range", aim.range_m, kTenths)
          .Number("cpa", aim.cpa_m, kTenths)
          .Number("age", aim.age_s, kTenths)
          .EndObject();
    }
    json->EndArray().EndObject();
  }

 private:
  static void Shorten(std::string* text) {
    constexpr size_t kLongestText = 80;
    if (text->size() > kLongestText) text->resize(kLongestText);
  }
};

/// Where a vehicle with [vehicle.navigation] believes to be.
struct ShownNavigation {
  using Message = navigation_t;
  static constexpr std::string_view kKey = "navigation";

  static Channel<Message> ChannelOf(std::string_view vehicle) {
    return channels::Navigation(vehicle);
  }
  static void Bound(Message* navigation) {
    navigation->ranges.clear();
    navigation->num_ranges = 0;
  }
  static void Write(const Message& navigation, JsonWriter* json) {
    json->BeginObject()
        .Number("t", Seconds(navigation.utime), kMilliseconds)
        .Number("x", navigation.x_m, kCentimetres)
        .Number("y", navigation.y_m, kCentimetres)
        .Number("heading", navigation.heading_deg, kTenths)
        .Number("major", navigation.ellipse_major_m, kCentimetres)
        .Number("minor", navigation.ellipse_minor_m, kCentimetres)
        .Number("direction", navigation.ellipse_heading_deg, kTenths)
        .Boolean("lock", navigation.has_dvl_lock != 0)
        .Boolean("fix", navigation.has_gps_fix != 0)
        .Integer("taken", navigation.num_ranges_taken)
        .Integer("rejected", navigation.num_ranges_rejected)
        .EndObject();
  }
};

/// How the task of an underwater vehicle comes to what it asks of the autopilots.
struct ShownGuidance {
  using Message = guidance_t;
  static constexpr std::string_view kKey = "guidance";
  static constexpr size_t kMaxLayers = 10;

  static Channel<Message> ChannelOf(std::string_view vehicle) {
    return channels::Guidance(vehicle);
  }
  static void Bound(Message* guidance) {
    constexpr size_t kLongestText = 80;
    if (guidance->layers.size() > kMaxLayers) guidance->layers.resize(kMaxLayers);
    guidance->num_layers = static_cast<int32_t>(guidance->layers.size());
    const auto shorten = [](std::string* text) {
      if (text->size() > kLongestText) text->resize(kLongestText);
    };
    for (std::string* text : {&guidance->vehicle, &guidance->task, &guidance->task_kind}) {
      shorten(text);
    }
    for (guidance_layer_t& layer : guidance->layers) shorten(&layer.name);
  }
  static void Write(const Message& guidance, JsonWriter* json) {
    json->BeginObject()
        .Number("t", Seconds(guidance.utime), kMilliseconds)
        .Number("pitch", guidance.pitch_deg, kTenths)
        .Number("crab", guidance.crab_deg, kTenths)
        .Key("layers")
        .BeginArray();
    for (const guidance_layer_t& layer : guidance.layers) {
      json->BeginObject()
          .Text("name", layer.name)
          .Number("speed", layer.speed_mps, 2)
          .Number("weight", layer.weight, 3)
          .EndObject();
    }
    json->EndArray().EndObject();
  }
};

/// The rows, in the order in which frames have them.
using ShownChannels =
    std::tuple<ShownDesired, ShownModem, ShownDecision, ShownGuidance, ShownNavigation>;

template <class Rows>
struct LastMessages;
template <class... Row>
struct LastMessages<std::tuple<Row...>> {
  using Type = std::tuple<std::optional<typename Row::Message>...>;
};

/// The last message of each row; absent: none was received.
using ShownMessages = LastMessages<ShownChannels>::Type;

/// Calls `use.operator()<Row, kPlace>()` for each row.
template <class Use>
void ForEachShownChannel(const Use& use) {
  const auto use_all = [&]<size_t... kPlaces>(std::index_sequence<kPlaces...>) {
    (use.template operator()<std::tuple_element_t<kPlaces, ShownChannels>, kPlaces>(), ...);
  };
  use_all(std::make_index_sequence<std::tuple_size_v<ShownChannels>>());
}

/// Returns the last message of `Row`.
template <class Row>
const std::optional<typename Row::Message>& LastOf(const ShownMessages& messages) {
  const std::optional<typename Row::Message>* last = nullptr;
  ForEachShownChannel([&]<class Each, size_t kPlace>() {
    if constexpr (std::is_same_v<Row, Each>) last = &std::get<kPlace>(messages);
  });
  return *last;
}

}  // namespace shoal
