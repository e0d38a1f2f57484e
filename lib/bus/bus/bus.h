// The bus as apps use it: named channels that carry LCM messages.
//
//   Subscribe(bus, channels::Nav("alpha"), [this](const nav_t& nav) { nav_ = nav; });
//   Publish(bus, channels::Desired("alpha"), desired);
//
// MemoryBus connects the participants of one process, LcmBus connects processes. To an app
// both are the same. Handlers run in the thread that steps the app, never inside Publish.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "lib/base/check/check.h"
#include "lib/bus/bus/message_views.h"
#include "lib/bus/bus/wire_check.h"

namespace shoal {

using Bytes = std::vector<uint8_t>;

/// The places of a step at which a participant that several parts of a mission share publishes.
constexpr uint32_t kNumPlaces = 4096;

/// One message as it comes off the bus. The views live as long as the handler runs.
struct Message {
  std::string_view channel;
  std::string_view publisher;     ///< A participant's name; empty: from outside the step protocol.
  std::span<const uint8_t> data;  ///< An encoded LCM message: fingerprint and members.
  MessageViews* views =
      nullptr;  ///< Shared by the subscribers of one process; nullptr: not shared.
};

/// A channel's name and what it carries.
template <class T>
struct Channel {
  std::string name;
};

/// Counters of a bus. Every message that came in is counted in one of them.
struct BusCounters {
  int64_t published = 0;
  int64_t handled = 0;
  int64_t overload = 0;     ///< Dropped: had waited too long when its turn came.
  int64_t undecodable = 0;  ///< Dropped: the bytes are not a message of the channel's type.
  int64_t forged = 0;       ///< Dropped: sealed by a process that does not know the secret.
  std::map<std::string, int64_t, std::less<>> undecodable_by_channel;
};

class Bus {
 public:
  using Handler = std::function<void(const Message&)>;

  virtual ~Bus() = default;
  Bus() = default;
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// Sends `data`, an encoded LCM message, to all subscribers of `channel`, at the next step.
  /// @pre channel has 1 to 63 characters, letters, digits, '_' and '.'.
  virtual void PublishBytes(std::string_view channel, std::span<const uint8_t> data) = 0;

  /// The same, and returns where views of the message may be left for the subscribers in this
  /// process until the next call; nullptr: there are none.
  virtual MessageViews* PublishShared(std::string_view channel, std::span<const uint8_t> data) {
    PublishBytes(channel, data);
    return nullptr;
  }

  /// Sets the place of the messages that are published from now until the next call or the end of
  /// the step. They come after those that this participant publishes at lower places, in any part
  /// of a mission.
  /// @pre place < kNumPlaces, and more than the one before in this step
  virtual void SetPlace(uint32_t /*place*/) {}

  /// Calls `handler` for every message on `channel`, in the fixed order of the step.
  /// @pre called before the first step.
  virtual void SubscribeBytes(const std::string& channel, Handler handler) = 0;

  /// Calls `handler` for every message on every channel. For recorders and listeners.
  /// @pre the first and only subscription
  virtual void SubscribeAll(Handler handler) = 0;

  const BusCounters& counters() const { return counters_; }
  void CountUndecodable(std::string_view channel);

 protected:
  BusCounters counters_;
};

/// Encodes `message` into `bytes`, whose storage is used again.
template <class T>
void EncodeInto(const T& message, Bytes* bytes) {
  bytes->resize(static_cast<size_t>(message.getEncodedSize()));
  const int written = message.encode(bytes->data(), 0, static_cast<int>(bytes->size()));
  SHOAL_CHECK(written == static_cast<int>(bytes->size()), "a message encodes to its own size");
}

/// Decodes `data`, or returns false for bytes that are not one whole message of type T. Never
/// throws, and never allocates more than the bytes could fill.
template <class T>
[[nodiscard]] bool Decode(std::span<const uint8_t> data, T* message) {
  if (!WireLengthsAreSane(T::getHash(), data)) return false;
  try {
    return message->decode(data.data(), 0, static_cast<int>(data.size())) ==
           static_cast<int>(data.size());
  } catch (const std::exception&) {
    return false;
  }
}

/// A message as its type, if its bytes are one.
template <class T>
struct Decoded {
  bool is_sound = false;
  T message{};
};

template <class T>
void Publish(Bus& bus, const Channel<T>& channel, const T& message) {
  thread_local Bytes bytes;
  EncodeInto(message, &bytes);
  if constexpr (std::is_trivially_copyable_v<T>) {
    // Numbers alone: decoding the bytes would give the same, bit for bit.
    if (MessageViews* views = bus.PublishShared(channel.name, bytes)) {
      *views->Made<Decoded<T>>() = {.is_sound = true, .message = message};
    }
  } else {
    bus.PublishBytes(channel.name, bytes);
  }
}

/// Decodes `data` into an empty message: lcm-gen's decoders leave a list of numbers as it was where
/// the message's own is empty.
template <class T>
void DecodeAfresh(std::span<const uint8_t> data, Decoded<T>* decoded) {
  decoded->message = T{};
  decoded->is_sound = Decode(data, &decoded->message);
}

/// Calls `use(const View&)` with what `make(View*)` makes of a message: once for all subscribers of
/// a process, where the message is shared.
template <class View, class Make, class Use>
void WithView(const Message& raw, Make make, Use use) {
  if (raw.views != nullptr) {
    use(raw.views->Get<View>(make));
  } else {
    View view{};
    make(&view);
    use(view);
  }
}

/// Hands every decodable message on `channel` to `handler(const T&)`; counts the others.
template <class T, class F>
void Subscribe(Bus& bus, const Channel<T>& channel, F handler) {
  bus.SubscribeBytes(channel.name, [&bus, handler = std::move(handler)](const Message& raw) {
    WithView<Decoded<T>>(
        raw, [&](Decoded<T>* decoded) { DecodeAfresh(raw.data, decoded); },
        [&](const Decoded<T>& decoded) {
          if (decoded.is_sound) {
            handler(decoded.message);
          } else {
            bus.CountUndecodable(raw.channel);
          }
        });
  });
}

/// Hands `View(const T&)` of every decodable message on `channel` to `handler(const View&)`; counts
/// the others. Many subscribers of one process share one View of a message.
template <class View, class T, class F>
void SubscribeAs(Bus& bus, const Channel<T>& channel, F handler) {
  bus.SubscribeBytes(channel.name, [&bus, handler = std::move(handler)](const Message& raw) {
    const auto make = [&raw](std::optional<View>* view) {
      WithView<Decoded<T>>(
          raw, [&](Decoded<T>* decoded) { DecodeAfresh(raw.data, decoded); },
          [&](const Decoded<T>& decoded) {
            view->reset();
            if (decoded.is_sound) view->emplace(decoded.message);
          });
    };
    WithView<std::optional<View>>(raw, make, [&](const std::optional<View>& view) {
      if (view) {
        handler(*view);
      } else {
        bus.CountUndecodable(raw.channel);
      }
    });
  });
}

}  // namespace shoal
