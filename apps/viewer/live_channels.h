// The channels of a running mission. Messages are taken only while a page asks for them, since a
// viewer that receives everything would cost a fleet's mission much of its speed; series begin
// then.
//
//   channels.Wants(now_us);                       // should messages come in?
//   channels.Take("NAV_ALPHA", bytes, 12.5);
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "apps/viewer/channel_source.h"

namespace shoal {

class LiveChannels : public ChannelSource {
 public:
  static constexpr int64_t kLookLasts_us = 5'000'000;
  static constexpr size_t kMaxChannels = 5'000;
  static constexpr size_t kMaxSeries = 64;
  static constexpr size_t kMaxKept = 20'000;  ///< Values of a series.

  /// `now_us` returns wall time that never jumps.
  explicit LiveChannels(int64_t (*now_us)()) : now_us_(now_us) {}

  /// True while a page asks, and for some seconds after.
  [[nodiscard]] bool Wants();
  void Take(std::string_view channel, std::span<const uint8_t> data, double t_s);

  std::string ChannelsJson(double t_s) override;
  Result<std::string> MessageJson(const std::string& channel, double t_s) override;
  std::string FieldsJson(const std::string& text, double t_s) override;
  Result<std::string> SeriesJson(const std::string& field, double t_s, double window_s) override;

 private:
  struct Channel {
    int64_t count = 0;
    std::deque<double> times_s;  ///< Of the last messages, for the rate.
    std::vector<uint8_t> last;
  };
  struct Series {
    FieldName name;
    int64_t asked_us = 0;
    std::deque<SeriesPoint> points;
  };

  int64_t (*const now_us_)();
  std::mutex mutex_;
  int64_t asked_us_ = INT64_MIN;
  std::map<std::string, Channel, std::less<>> channels_;
  std::map<std::string, Series> series_;  ///< By the field's name.
};

}  // namespace shoal
