#include "apps/viewer/page_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace shoal {

namespace {

using Json = nlohmann::json;

/// The messages of one channel as rows over the fields that any of them has.
class SampledChannel {
 public:
  /// Takes what MessageJson answers; a message that was taken already is left out.
  void Take(const Json& message) {
    if (message["t"] == last_) return;
    last_ = message["t"];
    std::map<size_t, std::string> values;
    for (const Json& field : message["fields"]) {
      const std::string path = field["path"];
      const auto [place, is_new] = places_.emplace(path, fields_.size());
      if (is_new) fields_.push_back({path, field["number"]});
      values[place->second] = field["text"];
    }
    num_values_ += values.size();
    rows_.emplace_back(message, std::move(values));
  }
  size_t num_values() const { return num_values_; }

  Json TakeJson(const Json& channel) {
    Json samples = Json::array();
    for (auto& [message, values] : rows_) {
      Json row = Json::array({message["t"], message["bytes"]});
      for (size_t i = 0; i < fields_.size(); ++i) {
        const auto value = values.find(i);
        row.push_back(value == values.end() ? Json() : Json(value->second));
      }
      samples.push_back(std::move(row));
    }
    return {{"name", channel["name"]},   {"type", channel["type"]},
            {"count", channel["count"]}, {"rate_hz", channel["rate_hz"]},
            {"fields", fields_},         {"samples", std::move(samples)}};
  }

 private:
  Json last_;
  std::map<std::string, size_t> places_;
  Json fields_ = Json::array();
  std::vector<std::pair<Json, std::map<size_t, std::string>>> rows_;
  size_t num_values_ = 0;
};

SampledChannel Sampled(ChannelSource& channels, const std::string& name, double begin_s,
                       double end_s, size_t num_samples) {
  SampledChannel sampled;
  for (size_t i = 0; i <= num_samples; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(num_samples);
    const auto message = channels.MessageJson(name, begin_s + part * (end_s - begin_s));
    if (message.ok()) sampled.Take(Json::parse(*message));
  }
  return sampled;
}

}  // namespace

Json ChannelsForPage(ChannelSource& channels, double begin_s, double end_s,
                     const PageChannelsOptions& options, std::vector<std::string>* notes) {
  const Json known = Json::parse(channels.ChannelsJson(end_s))["channels"];
  // The last message of each shows how much one holds.
  size_t num_values = 1;
  for (const Json& channel : known) {
    const auto message = channels.MessageJson(channel["name"], end_s);
    if (message.ok()) num_values += Json::parse(*message)["fields"].size();
  }
  const size_t num_samples = std::clamp<size_t>(options.max_values / num_values, 1,
                                                std::max<size_t>(options.max_samples, 1));
  Json held = Json::array();
  for (const Json& channel : known) {
    SampledChannel sampled = Sampled(channels, channel["name"], begin_s, end_s, num_samples);
    held.push_back(sampled.TakeJson(channel));
  }
  if (!held.empty()) {
    notes->push_back(fmt::format("of each channel it has {} messages at most, {:.2g} s apart",
                                 num_samples + 1,
                                 (end_s - begin_s) / static_cast<double>(num_samples)));
  }
  return held;
}

}  // namespace shoal
