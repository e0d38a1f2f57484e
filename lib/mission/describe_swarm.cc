// The table [swarm], and [vehicle.recovery].
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/describe.h"
#include "lib/mission/suggest.h"
#include "lib/swarm/slot_timing.h"

namespace shoal {
namespace {

constexpr double kLongestEpisode_s = 1e5;
constexpr size_t kMostStrategies = kNumRecoveryStrategies;

}  // namespace

void Describe(Fields& fields, SwarmOptions& swarm) {
  constexpr std::array<std::string_view, 4> kSchedulers = {"auto", "fdma_lf", "tdma", "tdma_lf"};
  swarm.exists = true;
  fields.Require("leader", "leader = \"alpha\"");
  fields.Text("leader", swarm.leader, {.min_length = 1});
  fields.Texts("followers", swarm.followers, static_cast<size_t>(kMostFollowers));
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
  if (!swarm.group_id.empty() && !std::isalnum(static_cast<unsigned char>(swarm.group_id[0]))) {
    fields.Refuse("group_id", "group_id must be a letter or a digit");
  }
}

void Describe(Fields& fields, RecoveryPlan& plan) {
  for (size_t i = 0; i < kNumSwarmFields; ++i) {
    const std::string_view key = kSwarmFieldNames[i];
    std::vector<std::string> words;
    for (const RecoveryStrategy strategy : plan.by_field[i]) words.emplace_back(NameOf(strategy));
    fields.Texts(key, words, kMostStrategies);
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
