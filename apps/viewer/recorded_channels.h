// The channels of a log. Its index, where each message stands, is made at the first question.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "apps/viewer/channel_source.h"
#include "lib/tools/view/recorded_log.h"

namespace shoal {

class RecordedChannels : public ChannelSource {
 public:
  /// Places of messages that are kept; of a log with more, of every second message, or every
  /// fourth, ...
  static constexpr size_t kMaxPlaces = 4'000'000;
  static constexpr size_t kMaxChannels = 20'000;

  /// As RecordedView::Open. A log that cannot be read has no channels.
  explicit RecordedChannels(std::string path, std::string mission_file,
                            size_t max_places = kMaxPlaces)
      : path_(std::move(path)),
        mission_file_(std::move(mission_file)),
        max_places_(std::max<size_t>(max_places, 16)) {}

  std::string ChannelsJson(double t_s) override;
  Result<std::string> MessageJson(const std::string& channel, double t_s) override;
  std::string FieldsJson(const std::string& text, double t_s) override;
  Result<std::string> SeriesJson(const std::string& field, double t_s, double window_s) override;

 private:
  struct Place {
    int64_t line_us = 0;
    uint64_t offset = 0;
  };
  /// Messages of one channel, in order; of every `stride_`th.
  struct Places {
    std::vector<Place> places;
    int64_t num = 0;
  };

  // With mutex_ locked.
  void Index();
  void Thin();
  /// Returns the number of places that are not later.
  static size_t CountUntil(const Places& channel, double t_s);
  std::optional<ShownMessage> Read(const std::string& channel, const Place& place);
  Result<const Places*> Find(const std::string& channel);

  const std::string path_;
  const std::string mission_file_;
  const size_t max_places_;
  std::mutex mutex_;
  std::optional<LogReader> reader_;
  bool is_indexed_ = false;
  size_t num_places_ = 0;
  int64_t stride_ = 1;
  std::map<std::string, Places, std::less<>> channels_;
};

}  // namespace shoal
