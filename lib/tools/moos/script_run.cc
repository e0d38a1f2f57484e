#include "lib/tools/moos/script_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

#include "lib/base/random/stream.h"
#include "lib/mission/toml/table_writer.h"

namespace shoal {
namespace {

class ScriptRun {
 public:
  ScriptRun(const MoosScript& script, std::string_view vehicle, const ConvertPost& convert)
      : script_(script),
        vehicle_(vehicle),
        convert_(convert),
        variables_(script.variables),
        stream_(1, "uTimerScript", vehicle) {}

  void Run(TimerScript* result) {
    for (RandomVariable& variable : variables_) Draw(&variable, &stream_);
    // What a mission without an end lasts (import.cc), and as many events as a person still reads.
    constexpr double kLongest_s = 600;
    constexpr size_t kMostEvents = 500;
    double begin_s = 0;
    for (int round = 0; round <= script_.num_resets; ++round) {
      round_ = round;
      if (round == 0 || script_.shuffles) DrawTimes();
      if (round > 0) {
        for (RandomVariable& variable : variables_) {
          if (variable.key == "at_reset") Draw(&variable, &stream_);
        }
      }
      const double warp = DrawTime(script_.warp, &stream_);
      const TimeRange& delay = round == 0 ? script_.delay_start : script_.delay_reset;
      const double last_s = Round(begin_s, DrawTime(delay, &stream_), warp, result);
      const double length_s = script_.reset_s ? *script_.reset_s : last_s;
      begin_s += length_s / warp;
      const bool goes_on = round < script_.num_resets && !result->events.empty();
      if (!goes_on || !(length_s > 0)) return;
      if (begin_s <= kLongest_s && result->events.size() < kMostEvents) continue;
      if (!IsAnyTaken(*result)) return;  // Its events are lost anyway.
      result->losses.emplace_back(
          script_.reset_line,
          fmt::format("the script is repeated: its {} rounds that begin within {:.0f} s are taken",
                      round + 1, std::min(begin_s, kLongest_s)));
      return;
    }
  }

 private:
  /// One post of a line.
  struct Post {
    const ScriptLine* event = nullptr;
    int index = 0;
    double time_s = 0;  ///< Of the script's own clock, without its delay.
  };

  void DrawTimes() {
    posts_.clear();
    for (const ScriptLine& event : script_.events) {
      for (int i = 0; i < event.amount; ++i) {
        posts_.push_back({.event = &event,
                          .index = event.first_index + i,
                          .time_s = DrawTime(event.time, &stream_)});
      }
    }
    std::stable_sort(posts_.begin(), posts_.end(),
                     [](const Post& a, const Post& b) { return a.time_s < b.time_s; });
  }

  /// Adds the events of a round; returns when the last is posted, by the script's clock.
  double Round(double begin_s, double delay_s, double warp, TimerScript* result) {
    double last_s = 0;
    int count = 0;
    for (const Post& post : posts_) {
      const double clock_s = delay_s + post.time_s;
      if (script_.reset_s && script_.num_resets > 0 && clock_s > *script_.reset_s) continue;
      last_s = std::max(last_s, clock_s);
      TimerEvent event{
          .line = post.event->line, .origin = post.event->origin, .text = post.event->text};
      event.round = round_;
      event.at_s = TimerRounded(begin_s + clock_s / warp);
      event.reason = post.event->problem;
      event.is_needless = post.event->is_needless;
      if (event.reason.empty()) AddEvent(post, count, &event);
      if (post.event->problem.empty()) {
        ++count;
        ++total_;
      }
      result->events.push_back(std::move(event));
    }
    return last_s;
  }

  void AddEvent(const Post& post, int count, TimerEvent* event) {
    std::string value = post.event->value;
    std::string variable = post.event->variable;
    bool is_drawn = post.event->time.low_s != post.event->time.high_s;
    const std::string plain = value;
    for (RandomVariable& random : variables_) {
      if (value.find("$[" + random.name + "]") == value.npos &&
          value.find("$(" + random.name + ")") == value.npos) {
        continue;
      }
      if (random.key == "at_post") Draw(&random, &stream_);
      ReplaceTimerMacro(&value, random.name, TomlNumber(random.value));
      is_drawn = true;
    }
    ReplaceTimerMacro(&value, "COUNT", std::to_string(count));
    ReplaceTimerMacro(&value, "TCOUNT", std::to_string(total_));
    ReplaceTimerMacro(&value, "IDX", fmt::format("{:03}", post.index));
    ReplaceTimerMacro(&value, "VNAME", vehicle_.empty() ? "shoreside" : std::string(vehicle_));
    uint64_t limit = 1;
    for (int digits = 1; digits <= 9; ++digits) {
      limit *= 10;
      const std::string macro = std::to_string(digits);
      if (value.find("$(" + macro + ")") == value.npos) continue;
      ReplaceTimerMacro(&value, macro, std::to_string(stream_.UniformInt(limit)));
      is_drawn = true;
    }
    if (value != plain || value.starts_with('{')) value = WithTimerSums(std::move(value));
    if (HasTimerMacro(value) || HasTimerMacro(variable)) {
      event->reason = "holds a macro, which has no value here: write an [[event]] by hand";
      return;
    }
    if (is_drawn) event->assumed = "drawn as uTimerScript draws it, once for all runs";
    ConvertedEvent converted = convert_(variable, value);
    if (auto* keys = std::get_if<EventKeys>(&converted)) {
      event->keys = std::move(*keys);
    } else if (const auto* point = std::get_if<TrackedPoint>(&converted)) {
      event->point = *point;
      event->reason = "[[obstacle]]";
      event->is_needless = true;
    } else if (const auto* drift = std::get_if<DriftChange>(&converted)) {
      event->drift = *drift;
    } else {
      event->reason = std::get<std::string>(converted);
      event->is_needless = event->reason == kOnlyDraws || event->reason == kOnlySounds ||
                           event->reason == kNothingReads;
    }
  }

  const MoosScript& script_;
  std::string_view vehicle_;
  const ConvertPost& convert_;
  std::vector<RandomVariable> variables_;
  Stream stream_;
  std::vector<Post> posts_;
  int round_ = 0;
  int total_ = 0;
};

}  // namespace

bool IsAnyTaken(const TimerScript& script) {
  return std::any_of(script.events.begin(), script.events.end(), [](const TimerEvent& event) {
    return !event.keys.empty() || event.point || event.drift;
  });
}

void RunScript(const MoosScript& script, std::string_view vehicle, const ConvertPost& convert,
               TimerScript* result) {
  ScriptRun(script, vehicle, convert).Run(result);
}

}  // namespace shoal
