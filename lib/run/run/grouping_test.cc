#include "lib/run/run/grouping.h"

#include <gtest/gtest.h>

namespace shoal::grouping_test {

/// Three vehicles of two apps each, one of them started by hand, among others of the mission.
std::vector<RosterEntry> ARoster() {
  const auto of = [](const std::string& app, const std::string& vehicle) {
    return RosterEntry{.name = ParticipantName(app, vehicle), .app = app, .vehicle = vehicle};
  };
  RosterEntry by_hand = of("helm", "bravo");
  by_hand.provider = Provider::kHand;
  return {{.name = "recorder", .app = "recorder"},
          {.name = "shore_broker", .app = "shore_broker"},
          of("vehicle_sim", "alpha"),
          of("helm", "alpha"),
          of("vehicle_sim", "bravo"),
          by_hand,
          of("vehicle_sim", "cesar"),
          of("helm", "cesar"),
          {.name = "referee", .command = {"referee"}}};
}

/// Returns "group-alpha: vehicle_sim_alpha helm_alpha" for each process.
std::vector<std::string> Shares(const std::string& grouping,
                                const std::vector<RosterEntry>& roster = ARoster()) {
  std::vector<std::string> shares;
  for (const RosterProcess& process : ShareOut(roster, *ParseGrouping(grouping))) {
    std::string share = process.name + ":";
    for (const RosterEntry& entry : process.entries) share += " " + entry.name;
    shares.push_back(share);
  }
  return shares;
}

TEST(Grouping, GivesEachParticipantAProcess) {
  const std::vector<std::string> shares = Shares("app");
  ASSERT_EQ(shares.size(), ARoster().size());
  EXPECT_EQ(shares[2], "vehicle_sim_alpha: vehicle_sim_alpha");
}

TEST(Grouping, GivesEachVehicleAProcessAndLeavesAloneWhatIsNotShoalsOwn) {
  EXPECT_EQ(
      Shares("vehicle"),
      (std::vector<std::string>{"recorder: recorder", "shore_broker: shore_broker",
                                "group-alpha: vehicle_sim_alpha helm_alpha",
                                "vehicle_sim_bravo: vehicle_sim_bravo", "helm_bravo: helm_bravo",
                                "group-cesar: vehicle_sim_cesar helm_cesar", "referee: referee"}));
}

TEST(Grouping, SharesNeighboursOutOverAGivenNumberOfProcesses) {
  EXPECT_EQ(Shares("host=2"),
            (std::vector<std::string>{
                "recorder: recorder", "shore_broker: shore_broker",
                "group-1: vehicle_sim_alpha helm_alpha vehicle_sim_bravo", "helm_bravo: helm_bravo",
                "group-2: vehicle_sim_cesar helm_cesar", "referee: referee"}));
  EXPECT_EQ(Shares("host=9").size(), Shares("vehicle").size());
}

TEST(Grouping, SharesOutWhatRunsOnAHostAmongItself) {
  std::vector<RosterEntry> roster = ARoster();
  for (RosterEntry& entry : roster) {
    if (entry.vehicle == "alpha" || entry.vehicle == "cesar") entry.host = "lab2";
  }
  EXPECT_EQ(
      Shares("host=1", roster),
      (std::vector<std::string>{
          "recorder: recorder", "shore_broker: shore_broker",
          "group-lab2-1: vehicle_sim_alpha helm_alpha vehicle_sim_cesar helm_cesar",
          "vehicle_sim_bravo: vehicle_sim_bravo", "helm_bravo: helm_bravo", "referee: referee"}));
  EXPECT_EQ(Shares("vehicle", roster), Shares("vehicle"));
}

TEST(Grouping, IsReadAsItIsWritten) {
  for (const std::string text : {"app", "vehicle", "host=1", "host=1000"}) {
    const Result<Grouping> grouping = ParseGrouping(text);
    ASSERT_TRUE(grouping.ok()) << text;
    EXPECT_EQ(Name(*grouping), text);
  }
  EXPECT_GE(ParseGrouping("host")->num_processes, 1);
}

TEST(Grouping, RefusesWhatIsNone) {
  for (const std::string text : {"", "vehicles", "host=", "host=0", "host=1001", "host=2x", "4"}) {
    const Result<Grouping> grouping = ParseGrouping(text);
    ASSERT_FALSE(grouping.ok()) << text;
    EXPECT_EQ(grouping.error(),
              "'" + text +
                  "' is not a grouping: app (a process per participant), vehicle (a process per "
                  "vehicle), host=N (N processes for all vehicles of a computer, 1 to 1000) or "
                  "host (as many as there are processors)");
  }
}

}  // namespace shoal::grouping_test
