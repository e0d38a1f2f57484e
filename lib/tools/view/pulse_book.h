// Comms pulses that a viewer still draws.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace shoal {

/// One delivery as it is drawn.
struct ViewPulse {
  int64_t id = 0;     ///< Of label and time: the same in live and recorded views. Below 2^53.
  int64_t order = 0;  ///< Counts what was added to the book.
  int64_t utime = 0;
  float sx_m = 0;  ///< From here ...
  float sy_m = 0;
  float tx_m = 0;  ///< ... to here.
  float ty_m = 0;
  float width_m = 0;
  float duration_s = 0;
  float fill = 0;
  bool of_message = false;
  int64_t streamed = 0;  ///< When TakeForStream returned it last; 0: never.
  std::string label;
  std::string color;
};

class PulseBook {
 public:
  static constexpr size_t kMaxPulses = 4000;

  /// Takes an encoded comms_pulse_columns_t or comms_pulses_t; each pulse replaces that of its
  /// label. Returns false, and takes nothing, for bytes that are not one whole such message. Where
  /// there is no room, messages replace reports.
  [[nodiscard]] bool Add(std::span<const uint8_t> data);

  /// Returns those that are not over at `utime`, the oldest first.
  std::vector<const ViewPulse*> NotOver(int64_t utime) const;
  /// Returns those of NotOver with an order > `order`, at most `most`: messages first, then those
  /// of the labels that it returned the longest ago, the newest first. So each link is seen now and
  /// then where there are too many.
  std::vector<const ViewPulse*> TakeForStream(int64_t order, int64_t utime, size_t most,
                                              int64_t* num_left_out);

  /// The order of the last one added, 0 before the first.
  int64_t last_order() const { return last_order_; }
  /// Pulses for which there was no room.
  int64_t num_left_out() const { return num_left_out_; }
  /// The time of the last message.
  int64_t last_utime() const { return last_utime_; }

 private:
  struct TextHash {
    using is_transparent = void;
    size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };

  /// Returns the pulse to write a new one into, or nullptr.
  ViewPulse* PlaceFor(std::string_view label, bool of_message, int64_t utime);
  void DropOver(int64_t utime);

  std::vector<ViewPulse> pulses_;
  std::unordered_map<std::string, size_t, TextHash, std::equal_to<>> places_;  ///< By label.
  size_t next_to_replace_ = 0;
  int64_t full_until_utime_ = 0;  ///< Nothing will be over before.
  int64_t dropped_utime_ = 0;     ///< When those that were over were dropped.
  int64_t last_order_ = 0;
  int64_t last_utime_ = 0;
  int64_t num_streamed_ = 0;
  int64_t num_left_out_ = 0;
};

}  // namespace shoal
