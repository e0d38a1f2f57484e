// Shoal's helms along the tracks of MOOS-IvP's helm (tests/golden/README.md, helm/): what they
// decide in the same states, and when things happen. Where the decisions differ, the original's
// pieces are the reason: by the exact functions its choice is worse, and by little.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/text/letters.h"
#include "tests/closed_loops/meeting_vessels.h"
#include "tests/golden/read_golden.h"

namespace shoal::along_golden_tracks_test {

const MeetingOptions kFrozen = {
    .contacts = {.max_age_s = 90, .decay_start_s = 0, .decay_end_s = 0}};
const MeetingOptions kExtrapolated = {.contacts = {.max_age_s = 90}};

JudgedMeeting Judge(const std::string& scenario, const MeetingOptions& options = kFrozen) {
  static const nlohmann::json scenarios = ReadGoldenJson("helm/scenarios.json");
  return JudgeAlong(scenarios.at(scenario), ReadGoldenCsv("helm/tracks/" + scenario + ".csv"),
                    options);
}

bool IsSame(const JudgedDecision& decision) {
  return std::abs(Wrap180(*decision.ours.course_deg - *decision.theirs.course_deg)) <= 1 &&
         std::abs(*decision.ours.speed_mps - *decision.theirs.speed_mps) < 0.15;
}

/// Of the utility of ours, in per cent.
double LossOfTheirs(const JudgedDecision& decision) {
  return 100 * (decision.utility - decision.utility_theirs) / decision.utility;
}

/// `limit_pct`: reference 1.8, pieces against exact functions.
void ExpectDecisionsAsGood(const std::string& scenario, const JudgedMeeting& judged,
                           double limit_pct) {
  double worst_pct = 0;
  size_t num_same = 0;
  for (const JudgedDecision& decision : judged.decisions) {
    const double loss_pct = LossOfTheirs(decision);
    EXPECT_GE(loss_pct, -1e-6) << scenario << " " << decision.vessel << " " << decision.time_s;
    worst_pct = std::max(worst_pct, loss_pct);
    num_same += IsSame(decision) ? 1 : 0;
  }
  EXPECT_GE(judged.decisions.size(), 290u) << scenario;
  EXPECT_LE(worst_pct, limit_pct) << scenario;
  EXPECT_GE(static_cast<double>(num_same), 0.9 * static_cast<double>(judged.decisions.size()))
      << scenario;
}

TEST(AlongTheOriginalsTrack, AvoidanceDecidesAsWellOrBetterByAtMostHalfAPerCent) {
  for (const char* scenario :
       {"headon_avoid", "headon_avoid_lost_40s", "headon_avoid_lost_for_good"}) {
    ExpectDecisionsAsGood(scenario, Judge(scenario), 0.5);
  }
  for (const char* scenario :
       {"headon_avoid_lost_40s_extrapolated", "headon_avoid_lost_for_good_extrapolated"}) {
    ExpectDecisionsAsGood(scenario, Judge(scenario, kExtrapolated), 0.5);
  }
}

TEST(AlongTheOriginalsTrack, TheCollisionRegulationsDecideAsWellOrBetterByAtMostOneAndAHalf) {
  for (const char* scenario : {"headon_colregs", "crossing_colregs", "three_vessels_colregs"}) {
    ExpectDecisionsAsGood(scenario, Judge(scenario), 1.5);
  }
}

TEST(AlongTheOriginalsTrack, OvertakingDecidesSoButWhereItChangesTheSide) {
  JudgedMeeting judged = Judge("overtaking_colregs");
  // The original goes back to the port side at 23.75 s, a quarter of a second earlier.
  const size_t num_changes = std::erase_if(judged.decisions, [](const JudgedDecision& decision) {
    return decision.vessel == "abe" && decision.time_s == 24;
  });
  EXPECT_EQ(num_changes, 1u);
  ExpectDecisionsAsGood("overtaking_colregs", judged, 1.5);
}

/// Something that happens, without its time: "role ben" and "head-on".
struct Change {
  double time_s = 0;
  std::string value;
};
/// By what changes: "abe role ben", "abe life avd_ben", "tail REGION".
using Changes = std::map<std::string, std::vector<Change>>;

void Add(const std::string& what, const Change& change, Changes* changes) {
  std::vector<Change>& all = (*changes)[what];
  if (all.empty() || all.back().value != change.value) all.push_back(change);
}

/// Without what lasts for one decision only.
void LeaveOutFlicker(std::vector<Change>* all) {
  std::vector<Change> lasting;
  for (size_t i = 0; i < all->size(); ++i) {
    if (i + 1 < all->size() && (*all)[i + 1].time_s - (*all)[i].time_s < 0.3) continue;
    if (lasting.empty() || lasting.back().value != (*all)[i].value) lasting.push_back((*all)[i]);
  }
  *all = lasting;
}

std::string LowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

Changes GoldenChanges(const std::string& scenario) {
  static const std::map<std::string, std::string> kModes = {{"headon", "head-on"},
                                                            {"giveway", "give-way"},
                                                            {"standon", "stand-on"},
                                                            {"standon_ot", "overtaken"}};
  constexpr std::string_view kMode = "COLREGS_AVOID_MODE_";
  Changes changes;
  for (const GoldenRow& row : ReadGoldenCsv("helm/tracks/" + scenario + ".events.csv")) {
    const std::string& vessel = row.at("vehicle");
    const std::string& what = row.at("what");
    const std::string& value = row.at("value");
    const double time_s = Number(row, "t");
    if (what.starts_with(kMode) && value != "complete") {
      const std::string mode = value.substr(0, value.find(':'));
      const auto known = kModes.find(mode);
      Add(vessel + " role " + LowerCase(what.substr(kMode.size())),
          {time_s, known == kModes.end() ? mode : known->second}, &changes);
    } else if (what == "LIFE") {
      const bool is_spawn = value.starts_with("spawn");
      const std::string name = value.substr(6, value.find(' ', 6) - 6);
      if (name.starts_with("avd_") || !is_spawn) {
        Add(vessel + " life " + name, {time_s, is_spawn ? "spawn" : "end"}, &changes);
      }
    } else if (what == "REGION" || what == "WPT_INDEX") {
      Add(vessel + " " + what, {time_s, LowerCase(value)}, &changes);
    }
  }
  return changes;
}

Changes OurChanges(const Meeting& meeting) {
  Changes changes;
  for (const auto& [time_s, text] : meeting.events) {
    const std::string vessel = text.substr(0, text.find(':'));
    const std::string event = text.substr(text.find(':') + 2);
    const size_t blank = event.find(' ');
    const std::string kind = event.substr(0, blank);
    const std::string rest = event.substr(blank + 1);
    if (kind == "role") {
      if (rest.ends_with(" trail") || rest.ends_with(" avoid")) continue;
      Add(vessel + " role " + rest.substr(0, rest.find(' ')),
          {time_s, rest.substr(rest.find(' ') + 1)}, &changes);
    } else if (kind == "spawn" || kind == "end") {
      Add(vessel + " life " + rest.substr(0, rest.find(':')), {time_s, kind}, &changes);
    } else if (kind == "REGION" || kind == "WPT_INDEX") {
      Add(vessel + " " + kind, {time_s, rest}, &changes);
    }
  }
  return changes;
}

constexpr double kTick_s = 0.2501;

/// The same in the same order, to one tick; to two, what a spawning begins with, as the original's
/// contact manager looks twice a second, and regions, as places between the seconds are guessed.
void ExpectSameChanges(const std::string& scenario, Changes ours, Changes golden) {
  for (auto& [what, changes] : golden) {
    std::vector<Change>& mine = ours[what];
    LeaveOutFlicker(&changes);
    LeaveOutFlicker(&mine);
    ASSERT_EQ(mine.size(), changes.size()) << scenario << ": " << what;
    for (size_t i = 0; i < changes.size(); ++i) {
      const bool is_vague = i == 0 || what.ends_with("REGION");
      EXPECT_EQ(mine[i].value, changes[i].value) << scenario << ": " << what;
      EXPECT_NEAR(mine[i].time_s, changes[i].time_s, is_vague ? 2 * kTick_s : kTick_s)
          << scenario << ": " << what << " " << changes[i].value;
    }
  }
  EXPECT_EQ(ours.size(), golden.size()) << scenario;
}

TEST(AlongTheOriginalsTrack, EverythingHappensWhenItDidThere) {
  for (const char* scenario : {"headon_avoid", "headon_colregs", "crossing_colregs",
                               "headon_avoid_lost_40s", "headon_avoid_lost_for_good", "trail"}) {
    ExpectSameChanges(scenario, OurChanges(Judge(scenario).meeting), GoldenChanges(scenario));
  }
  for (const char* scenario :
       {"headon_avoid_lost_40s_extrapolated", "headon_avoid_lost_for_good_extrapolated"}) {
    ExpectSameChanges(scenario, OurChanges(Judge(scenario, kExtrapolated).meeting),
                      GoldenChanges(scenario));
  }
}

TEST(AlongTheOriginalsTrack, ARoleLastsThreeSecondsLongerWhereTheOriginalDropsItAtOnce) {
  Changes ours = OurChanges(Judge("three_vessels_colregs").meeting);
  Changes golden = GoldenChanges("three_vessels_colregs");
  std::vector<Change>& roles = ours.at("abe role cal");
  const std::vector<Change>& theirs = golden.at("abe role cal");
  ASSERT_EQ(roles.size(), theirs.size());
  ASSERT_EQ(theirs.at(4).value, "cpa");  // Overtaking is over.
  EXPECT_NEAR(roles.at(4).time_s, theirs.at(4).time_s + 3, kTick_s);
  roles.at(4).time_s = theirs.at(4).time_s;
  ExpectSameChanges("three_vessels_colregs", ours, golden);
}

TEST(AlongTheOriginalsTrack, TrailDiffersOnlyWhereManyInterceptionsAreAsGood) {
  const JudgedMeeting judged = Judge("trail");
  ExpectDecisionsAsGood("trail", judged, 0.5);
  const std::vector<Change> regions = OurChanges(judged.meeting).at("tail REGION");
  size_t num_different = 0;
  for (const JudgedDecision& decision : judged.decisions) {
    if (IsSame(decision)) continue;
    ++num_different;
    std::string region;
    for (const Change& change : regions) {
      if (change.time_s <= decision.time_s) region = change.value;
    }
    EXPECT_EQ(decision.vessel + " " + region, "tail outside nm_radius") << decision.time_s;
  }
  EXPECT_GT(num_different, 10u);
}

}  // namespace shoal::along_golden_tracks_test
