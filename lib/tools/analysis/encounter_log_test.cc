#include "lib/tools/analysis/encounter_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace shoal::encounter_log_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

nav_t NavAt(double time_s, double x_m, double y_m, double heading_deg) {
  nav_t nav{};
  nav.utime = static_cast<int64_t>(time_s * 1e6 + 0.5);
  nav.x_m = x_m;
  nav.y_m = y_m;
  nav.heading_deg = heading_deg;
  nav.speed_mps = 3;
  return nav;
}

node_report_t ReportOf(const std::string& name, double length_m) {
  node_report_t report{};
  report.name = name;
  report.length_m = length_m;
  return report;
}

helm_decision_t DecisionAt(double time_s, const std::string& contact, const std::string& role) {
  helm_decision_t decision{};
  decision.utime = static_cast<int64_t>(time_s * 1e6);
  helm_aim_t aim{};
  aim.contact = contact;
  aim.role = role;
  decision.aims = {aim};
  decision.num_aims = 1;
  return decision;
}

/// Two vessels head-on, 300 m apart, `aside_m` beside each other; 100 s.
void AddHeadOn(EncounterLog* log, double aside_m) {
  for (int step = 0; step <= 1000; ++step) {
    const double time_s = 0.1 * step;
    log->Add("ALPHA", NavAt(time_s, 0, 3 * time_s, 0));
    log->Add("BRAVO", NavAt(time_s, aside_m, 300 - 3 * time_s, 180));
    if (step == 0) log->Add(ReportOf("Alpha", 3));
  }
}

TEST(EncounterLog, HasALineForEachVesselOfAnEncounter) {
  EncounterLog log({});
  AddHeadOn(&log, 20);
  log.Finish();
  EXPECT_EQ(log.num_encounters(), 1U);
  const std::string text = log.Text(SIZE_MAX);
  EXPECT_NE(
      text.find("\n   25.3  Alpha        bravo        head-on     -               14      20.0"
                "     50.0  starboard to starboard"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("  bravo        Alpha        head-on "), std::string::npos) << text;
  EXPECT_EQ(text.find("collision"), std::string::npos) << text;
}

TEST(EncounterLog, ShowsACollisionByTheLengthsOfTheVessels) {
  for (const double length_m : {3.0, 5.0}) {
    EncounterLog log({});
    log.Add("BRAVO", NavAt(0, 3.5, 300, 180));
    log.Add(ReportOf("bravo", length_m));
    AddHeadOn(&log, 3.5);  // Between 3 m and the mean of 5 and 3.
    log.Finish();
    const bool has_collided = log.Text(SIZE_MAX).find("collision") != std::string::npos;
    EXPECT_EQ(has_collided, length_m > 4);
  }
}

TEST(EncounterLog, ShowsWhatTheHelmJudged) {
  EncounterLog log({});
  log.Add("ALPHA", DecisionAt(20, "bravo", "cpa"));
  log.Add("ALPHA", DecisionAt(27, "bravo", "give-way:stern"));
  log.Add("ALPHA", DecisionAt(40, "bravo", "cpa"));
  AddHeadOn(&log, 20);
  log.Finish();
  EXPECT_NE(log.Text(SIZE_MAX).find("head-on     give-way "), std::string::npos)
      << log.Text(SIZE_MAX);
}

TEST(EncounterLog, CountsWhatCannotBeAndGoesOn) {
  EncounterLog log({});
  nav_t late = NavAt(0, 0, 0, 0);
  log.Add("ALPHA", NavAt(1, kNan, 0, 0));
  log.Add("ALPHA", NavAt(1, 0, 1e300, 0));
  log.Add("ALPHA", NavAt(1, 0, 0, kNan));
  nav_t never = NavAt(1, 0, 0, 0);
  never.utime = std::numeric_limits<int64_t>::max();
  log.Add("ALPHA", never);
  never.utime = -1;
  log.Add("ALPHA", never);
  EXPECT_EQ(log.num_impossible(), 5);
  log.Add("ALPHA", NavAt(5, 0, 0, 0));
  log.Add("ALPHA", late);
  EXPECT_EQ(log.num_late(), 1);
  log.Finish();
  EXPECT_EQ(log.num_encounters(), 0U);
}

TEST(EncounterLog, LeavesOutVehiclesBeyondItsBound) {
  EncounterLog log({});
  for (size_t i = 0; i < EncounterLog::kMaxVehicles + 3; ++i) {
    log.Add("V" + std::to_string(i), NavAt(0, 1000.0 * static_cast<double>(i), 0, 0));
  }
  log.Finish();
  EXPECT_EQ(log.num_vehicles_left_out(), 3);
}

TEST(EncounterLog, ShowsTheLowestScoresWhereThereAreMany) {
  EncounterLog log({});
  for (int step = 0; step <= 1000; ++step) {
    const double time_s = 0.1 * step;
    for (int pair = 0; pair < 3; ++pair) {
      const std::string number = std::to_string(pair);
      log.Add("A" + number, NavAt(time_s, 1000 * pair, 3 * time_s, 0));
      log.Add("B" + number, NavAt(time_s, 1000 * pair - 6 - 9 * (2 - pair), 300 - 3 * time_s, 180));
    }
  }
  log.Finish();
  EXPECT_EQ(log.num_encounters(), 3U);
  const std::string text = log.Text(1);
  EXPECT_NE(text.find(" a2 "), std::string::npos) << text;
  EXPECT_EQ(text.find(" a0 "), std::string::npos) << text;
  EXPECT_NE(text.find("1 of 3 encounters"), std::string::npos) << text;
}

TEST(EncounterLog, HasAsManyCellsInEveryLineOfItsCsv) {
  EncounterLog log({});
  AddHeadOn(&log, 20);
  log.Finish();
  const std::string csv = log.Csv();
  std::vector<int64_t> counts;
  for (size_t begin = 0; begin < csv.size();) {
    const size_t end = csv.find('\n', begin);
    counts.push_back(std::count(csv.begin() + static_cast<std::ptrdiff_t>(begin),
                                csv.begin() + static_cast<std::ptrdiff_t>(end), ','));
    begin = end + 1;
  }
  EXPECT_EQ(counts, (std::vector<int64_t>{35, 35, 35}));
}

TEST(EncounterLog, ExplainsAScoreInNumbers) {
  EncounterLog log({});
  AddHeadOn(&log, 20);
  log.Finish();
  const std::string text = log.Explanation(SIZE_MAX);
  for (const char* part :
       {"Alpha toward bravo, from 25.3 to 59.9 s\n", "holding on: 20.0 m in 24.",
        "altered first: none", "rules 8: 0, 13: -, 14: 0", "range 0.87, pose 1.00"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

}  // namespace shoal::encounter_log_test
