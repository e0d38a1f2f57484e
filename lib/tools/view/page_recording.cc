#include "lib/tools/view/page_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/tools/view/page_backgrounds.h"

namespace shoal {

namespace {

using Json = nlohmann::json;

constexpr int64_t kMaxPageFrames = 2000;
/// Rows of links in all moments together: a fleet's matrix has fewer moments.
constexpr double kMaxLinkRows = 200'000;
constexpr double kLeastLinkStep_s = 1;
constexpr double kLeastSwarmStep_s = 5;
constexpr std::array kPageSteps_s = {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0};

/// The states of something over time, each as its change from the one before.
class Changes {
 public:
  void Add(Json state) {
    if (rows_.empty()) {
      rows_.push_back(state);
    } else {
      rows_.push_back(state == last_ ? Json(0) : ChangeOf(last_, state));
    }
    last_ = std::move(state);
  }
  bool empty() const { return rows_.empty(); }
  Json Take() { return std::move(rows_); }

 private:
  Json rows_ = Json::array();
  Json last_;
};

/// Pulses or packets, which come in several frames each. Of too many every second is left out, then
/// every second of the rest, and so on.
class Transmissions {
 public:
  explicit Transmissions(size_t most) : most_(std::max<size_t>(most, 1)) {}

  void Add(const Json& seen) {
    for (const Json& one : seen) {
      const int64_t id = one.at("id").get<int64_t>();
      if (!known_.insert(id).second) {
        // A packet comes again, whole, when it has arrived elsewhere.
        if (const auto it = places_.find(id); it != places_.end()) kept_[it->second] = one;
        continue;
      }
      if (num_++ % stride_ != 0) continue;
      places_[id] = kept_.size();
      kept_.push_back(one);
      if (kept_.size() > most_) Thin();
    }
  }
  int64_t num_left_out() const { return num_ - static_cast<int64_t>(kept_.size()); }
  Json Take() { return Json(std::move(kept_)); }

 private:
  void Thin() {
    std::vector<Json> rest;
    places_.clear();
    for (size_t i = 0; i < kept_.size(); i += 2) {
      places_[kept_[i].at("id").get<int64_t>()] = rest.size();
      rest.push_back(std::move(kept_[i]));
    }
    kept_ = std::move(rest);
    stride_ *= 2;
  }

  const size_t most_;
  int64_t num_ = 0;
  int64_t stride_ = 1;
  std::vector<Json> kept_;
  std::unordered_map<int64_t, size_t> places_;  ///< In kept_, by id.
  std::unordered_set<int64_t> known_;
};

/// The newest fates of a log, which no answer holds as a whole.
class AllFates {
 public:
  explicit AllFates(size_t most) : most_(std::max<size_t>(most, 1)) {}

  void AddUntil(ViewSource& view, double t_s) {
    for (;;) {
      const Json answer = Json::parse(view.FatesJson(
          {.vehicle = {}, .kind = {}, .cause = {}, .after = last_, .limit = 500}, t_s));
      const Json& fates = answer.at("fates");
      if (fates.empty()) return;
      for (auto fate = fates.rbegin(); fate != fates.rend(); ++fate) {
        last_ = std::max(last_, fate->at("id").get<int64_t>());
        rows_.push_back(RowOf(*fate));
        if (rows_.size() > most_) rows_.pop_front();
      }
    }
  }
  size_t size() const { return rows_.size(); }
  /// All ids begin with 1.
  int64_t num_left_out() const { return last_ - static_cast<int64_t>(rows_.size()); }
  Json Take() { return Json(std::move(rows_)); }

 private:
  static Json RowOf(const Json& fate) {
    Json row = Json::array();
    for (const char* key : {"id", "t", "kind", "source", "destination", "count", "number", "cause",
                            "rule", "text", "range_m", "limit_m", "medium"}) {
      row.push_back(fate.value(key, Json()));
    }
    return row;
  }

  const size_t most_;
  int64_t last_ = 0;
  std::deque<Json> rows_;
};

/// The links of all media together and of each; and what the vehicles know of their swarms.
class SlowStates {
 public:
  SlowStates(ViewSource& view, double step_s, double end_s) : view_(view) {
    const Json links = Json::parse(view.LinksJson(end_s));
    if (links.contains("media")) media_ = links.at("media").get<std::vector<std::string>>();
    const size_t rows = links.at("links").size() * (1 + media_.size());
    const double moments = kMaxLinkRows / std::max(static_cast<double>(rows), 1.0);
    link_step_s_ = std::max({step_s, kLeastLinkStep_s, end_s / std::max(moments, 1.0)});
    swarm_step_s_ = std::max(step_s, kLeastSwarmStep_s);
    const Json setup = Json::parse(view.SetupJson(false));
    for (const Json& vehicle : setup.at("vehicles")) {
      if (vehicle.value("in_swarm", false)) swarms_.push_back({vehicle.at("name"), {}});
    }
    medium_links_.resize(media_.size());
  }

  void AddUntil(double t_s) {
    for (; t_s >= next_links_s_; next_links_s_ += link_step_s_) {
      links_.Add(Json::parse(view_.LinksJson(next_links_s_)));
      for (size_t i = 0; i < media_.size(); ++i) {
        Result<std::string> of_medium = view_.MediumLinksJson(media_[i], next_links_s_);
        medium_links_[i].Add(of_medium.ok() ? Json::parse(*of_medium) : Json::object());
      }
    }
    for (; t_s >= next_swarms_s_; next_swarms_s_ += swarm_step_s_) {
      for (auto& [name, changes] : swarms_) {
        const Result<std::string> vehicle = view_.VehicleJson(name, next_swarms_s_, 1);
        changes.Add(vehicle.ok() ? Json::parse(*vehicle).at("swarm") : Json());
      }
    }
  }
  void Begin(double t_s) { next_links_s_ = next_swarms_s_ = t_s; }
  void TakeInto(Json* all) {
    Json media = Json::array();
    for (size_t i = 0; i < media_.size(); ++i) {
      media.push_back({{"name", media_[i]}, {"states", medium_links_[i].Take()}});
    }
    Json swarms = Json::array();
    for (auto& [name, changes] : swarms_) {
      swarms.push_back({{"name", name}, {"states", changes.Take()}});
    }
    (*all)["links"] = {{"step_s", link_step_s_}, {"states", links_.Take()}};
    (*all)["media"] = std::move(media);
    (*all)["swarms"] = {{"step_s", swarm_step_s_}, {"of", std::move(swarms)}};
  }

 private:
  ViewSource& view_;
  double link_step_s_ = 0;
  double swarm_step_s_ = 0;
  double next_links_s_ = 0;
  double next_swarms_s_ = 0;
  std::vector<std::string> media_;
  Changes links_;
  std::vector<Changes> medium_links_;
  std::vector<std::pair<std::string, Changes>> swarms_;
};

Json TakeOut(const char* key, Json* frame) {
  Json taken = Json::array();
  if (const auto it = frame->find(key); it != frame->end()) {
    taken = std::move(*it);
    frame->erase(it);
  }
  return taken;
}

}  // namespace

double PageStep_s(double length_s) {
  for (const double step_s : kPageSteps_s) {
    if (length_s <= step_s * static_cast<double>(kMaxPageFrames)) return step_s;
  }
  return std::ceil(length_s / static_cast<double>(kMaxPageFrames));
}

Json ChangeOf(const Json& before, const Json& after) {
  Json change = Json::object();
  if (before.is_object() && after.is_object()) {
    for (const auto& [key, value] : after.items()) {
      const auto was = before.find(key);
      if (was == before.end()) {
        change[key] = Json::array({value});
      } else if (*was != value) {
        change[key] = ChangeOf(*was, value);
      }
    }
    for (const auto& [key, value] : before.items()) {
      if (!after.contains(key)) change[key] = 0;
    }
    return change;
  }
  // Of a list that grew, or is as long, its elements; short lists of numbers change as a whole.
  const bool has_parts = before.is_array() && after.is_array() && !before.empty() &&
                         before.size() <= after.size() && before[0].is_structured();
  if (!has_parts) return Json::array({after});
  for (size_t i = 0; i < after.size(); ++i) {
    if (i >= before.size()) {
      change[std::to_string(i)] = Json::array({after[i]});
    } else if (before[i] != after[i]) {
      change[std::to_string(i)] = ChangeOf(before[i], after[i]);
    }
  }
  return change;
}

PageRecording RecordForPage(ViewSource& view, double begin_s, double end_s,
                            const PageRecordingOptions& options) {
  SHOAL_CHECK(std::isfinite(begin_s) && std::isfinite(end_s) && begin_s <= end_s,
              "the times are finite and in order");
  PageRecording recording;
  recording.step_s = options.step_s > 0 ? options.step_s : PageStep_s(end_s - begin_s);
  Changes frames;
  Transmissions pulses(options.max_transmissions);
  Transmissions packets(options.max_transmissions);
  AllFates fates(options.max_fates);
  SlowStates slow(view, recording.step_s, end_s);
  slow.Begin(begin_s);
  const auto add = [&](double t_s) {
    Json frame = Json::parse(view.FrameJson(t_s));
    pulses.Add(TakeOut("pulses", &frame));
    packets.Add(TakeOut("packets", &frame));
    frames.Add(std::move(frame));
    fates.AddUntil(view, t_s);
    slow.AddUntil(t_s);
    ++recording.num_frames;
  };
  const auto num_steps = static_cast<int64_t>(std::floor((end_s - begin_s) / recording.step_s));
  for (int64_t i = 0; i <= num_steps; ++i) {
    add(begin_s + static_cast<double>(i) * recording.step_s);
  }
  // The last frame is that of the end, wherever the steps lead.
  add(end_s);
  recording.num_fates = static_cast<int64_t>(fates.size());
  recording.notes.push_back(fmt::format(
      "a page of its own: what the viewer showed of a recorded mission, in frames {:g} s apart",
      recording.step_s));
  if (fates.num_left_out() > 0) {
    recording.notes.push_back(
        fmt::format("it has the last {} fates; {} before them are only in the counts of the links",
                    fates.size(), fates.num_left_out()));
  }
  if (const int64_t out = pulses.num_left_out() + packets.num_left_out(); out > 0) {
    recording.notes.push_back(fmt::format("{} pulses and packets are left out on the map", out));
  }
  Json backgrounds =
      BackgroundsForPage(view.Backgrounds(), options.max_background_bytes, &recording.notes);
  Json more = Json::object();
  if (options.add_more) options.add_more(&more, &recording.notes);
  Json setup = Json::parse(view.SetupJson(false));
  for (const std::string& note : recording.notes) setup["notes"].push_back(note);
  setup["backgrounds"] = Json::array();
  for (const Json& each : backgrounds) {
    setup["backgrounds"].push_back(
        {{"file", each["file"]}, {"has_world", each["world"] != ""}, {"tiles", nullptr}});
  }
  Json all = {{"version", 2},
              {"backgrounds", std::move(backgrounds)},
              {"setup", std::move(setup)},
              {"trails", Json::parse(view.TrailsJson())},
              {"events", Json::parse(view.EventsJson())},
              {"verdict", Json::parse(view.VerdictJson())},
              {"begin_s", begin_s},
              {"end_s", end_s},
              {"frames", {{"step_s", recording.step_s}, {"states", frames.Take()}}},
              {"pulses", pulses.Take()},
              {"packets", packets.Take()},
              {"fates", fates.Take()}};
  slow.TakeInto(&all);
  all.update(more);
  recording.json = all.dump();
  return recording;
}

}  // namespace shoal
