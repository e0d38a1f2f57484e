// The table [swarm] or the tables [[swarm]], and [vehicle.recovery].
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/slot_timing.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr double kLongestEpisode_s = 1e5;
constexpr size_t kMaxStrategies = kNumRecoveryStrategies;

/// `[swarm.fields]`: what counts as damaged, and what two strategies put in its place.
void DescribeFields(Fields& fields, SwarmOptions& swarm) {
  FieldLimits& limits = swarm.limits;
  fields.Number("max_position_m", limits.max_position_m, Above(0, 1e6));
  fields.Number("max_speed_mps", limits.max_speed_mps, Above(0, 1000));
  fields.Integer("max_id_distance", limits.max_id_distance, 1, std::numeric_limits<int>::max());
  fields.Integer("max_followers", limits.max_followers, 1, kMaxFollowers);
  fields.Number("max_time_s", limits.max_time_s, Above(0, 1e9));
  double tolerance_s = Seconds(limits.future_tolerance_us);
  fields.Number("future_tolerance_s", tolerance_s, Between(0, 1e6));
  limits.future_tolerance_us = Microseconds(tolerance_s);
  fields.NumberOrWord("late_start_s", swarm.late_start_s, 1e6, "auto", -1);
  fields.Triple("neutral_position_m", swarm.neutral.position_m, Between(-1e6, 1e6));
  fields.Triple("neutral_velocity_mps", swarm.neutral.velocity_mps, Between(-1000, 1000));
  fields.Number("sentinel_position_m", swarm.sentinel.position_m, Between(-1e9, 1e9));
  fields.Number("sentinel_speed_mps", swarm.sentinel.speed_mps, Between(-1e9, 1e9));
  struct Bound {
    std::string_view key;
    double value;
    std::string_view limit_key;
    double limit;
  };
  for (const Bound& bound :
       {Bound{"neutral_position_m", swarm.neutral.position_m.cwiseAbs().maxCoeff(),
              "max_position_m", limits.max_position_m},
        Bound{"neutral_velocity_mps", swarm.neutral.velocity_mps.cwiseAbs().maxCoeff(),
              "max_speed_mps", limits.max_speed_mps}}) {
    if (bound.value <= bound.limit) continue;
    fields.Refuse(bound.key, fmt::format("{} must not be beyond {} = {:g}", bound.key,
                                         bound.limit_key, bound.limit));
  }
  for (const Bound& bound : {Bound{"sentinel_position_m", std::abs(swarm.sentinel.position_m),
                                   "max_position_m", limits.max_position_m},
                             Bound{"sentinel_speed_mps", std::abs(swarm.sentinel.speed_mps),
                                   "max_speed_mps", limits.max_speed_mps}}) {
    if (bound.value > bound.limit) continue;
    fields.Refuse(
        bound.key,
        fmt::format("{} must be beyond {} = {:g}: a sentinel is not a value that a member "
                    "can send",
                    bound.key, bound.limit_key, bound.limit));
  }
}

void DescribeSwarm(Fields& fields, SwarmOptions& swarm) {
  constexpr std::array<std::string_view, 4> kSchedulers = {"auto", "fdma_lf", "tdma", "tdma_lf"};
  fields.Require("leader", "leader = \"alpha\"");
  fields.Text("leader", swarm.leader, {.min_length = 1});
  fields.Texts("followers", swarm.followers, static_cast<size_t>(kMaxFollowers));
  fields.Word("scheduler", swarm.scheduler, kSchedulers);
  fields.NumberOrWord("episode_s", swarm.episode_s, kLongestEpisode_s, "auto", -1);
  fields.NumberOrWord("offset_s", swarm.offset_s, kLongestEpisode_s, "auto", -1);
  fields.NumberOrWord("broadcast_s", swarm.broadcast_s, kLongestEpisode_s, "auto", -1);
  fields.NumberOrWord("response_s", swarm.response_s, kLongestEpisode_s, "auto", -1);
  fields.Number("max_distance_m", swarm.max_distance_m, Above(0, 1e6));
  fields.Flag("frames", swarm.frames);
  fields.Text("group_id", swarm.group_id, {.min_length = 1, .max_length = 1});
  fields.Number("silent_after_s", swarm.silent_after_s, Above(0, kLongest_s));
  DescribeMedia(fields, "over", swarm.over);
  fields.Below("fields", [&](Fields& table) { DescribeFields(table, swarm); });
  if (!swarm.group_id.empty() && !IsLetter(swarm.group_id[0]) && !IsDigit(swarm.group_id[0])) {
    fields.Refuse("group_id", "group_id must be a letter or a digit");
  }
}

/// One of several. Only [[swarm]] has a name, and other ways than followers to name its members.
void DescribeOneOfMany(Fields& fields, SwarmOptions& swarm) {
  fields.Text("name", swarm.name, {.min_length = 1, .max_length = 32});
  fields.Require("name", "name = \"north\"");
  int num_lists = fields.reading() && fields.Has("followers", false) ? 1 : 0;
  if (fields.Has("members", !swarm.members.empty())) {
    fields.Texts("members", swarm.members, static_cast<size_t>(kMaxFollowers) + 1);
    ++num_lists;
  }
  if (fields.Has("group", !swarm.group.empty())) {
    fields.Text("group", swarm.group, {.min_length = 1});
    ++num_lists;
  }
  DescribeSwarm(fields, swarm);
  if (num_lists > 1) {
    fields.Refuse("name", "members, group and followers all name the members: write one of them");
  }
}

}  // namespace

void DescribeSwarms(Fields& file, std::vector<SwarmOptions>& swarms) {
  const bool are_many =
      file.reading() ? file.HoldsArray("swarm") : !swarms.empty() && !swarms.front().name.empty();
  if (are_many) {
    file.List("swarm", swarms, DescribeOneOfMany);
  } else if (file.Has("swarm", !swarms.empty())) {
    if (swarms.empty()) swarms.emplace_back();
    file.Below("swarm", [&](Fields& fields) { DescribeSwarm(fields, swarms.front()); });
  }
}

void Describe(Fields& fields, RecoveryPlan& plan) {
  for (size_t i = 0; i < kNumSwarmFields; ++i) {
    const std::string_view key = kSwarmFieldNames.At(i);
    std::vector<std::string> words;
    for (const RecoveryStrategy strategy : plan.by_field[i]) words.emplace_back(NameOf(strategy));
    fields.Texts(key, words, kMaxStrategies);
    RecoveryOrder order;
    for (const std::string& word : words) {
      if (const auto strategy = RecoveryStrategyOf(word)) {
        order.push_back(*strategy);
      } else {
        fields.Refuse(key, "unknown strategy " + Quoted(word) +
                               DidYouMean(word, kRecoveryStrategyNames) +
                               "; there are: " + Joined(kRecoveryStrategyNames));
      }
    }
    plan.by_field[i] = order;
  }
}

}  // namespace shoal
