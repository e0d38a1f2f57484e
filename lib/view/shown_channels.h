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

#include "lib/bus/channels.h"
#include "lib/view/json_writer.h"
#include "shoal/desired_t.hpp"
#include "shoal/modem_stats_t.hpp"

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
        .Number("t", static_cast<double>(stats.utime) / 1e6, kMilliseconds)
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

/// The rows, in the order in which frames have them.
using ShownChannels = std::tuple<ShownDesired, ShownModem>;

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
