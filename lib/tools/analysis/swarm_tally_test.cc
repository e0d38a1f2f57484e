#include "lib/tools/analysis/swarm_tally.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "lib/tools/analysis/swarm_testing.h"

namespace shoal::swarm_tally_test {

swarm_t Bravo(int64_t num_said, int64_t clean, int64_t recovered, int64_t rejected) {
  swarm_t swarm = SwarmAt(0, "bravo", {});
  swarm.num_said = num_said;
  AddSourceTo(&swarm, "alpha", clean, recovered, rejected);
  return swarm;
}

TEST(SwarmTally, KeepsTheLastCountsOfEachReceiver) {
  SwarmTally tally;
  tally.Add(Bravo(1, 3, 1, 0));
  tally.Add(Bravo(2, 7, 2, 1));
  EXPECT_EQ(tally.Sources().at({"bravo", "alpha"}), (SourceCount{10, 7, 2, 1}));
}

TEST(SwarmTally, GoesOnWhereAProcessWasStartedAgain) {
  SwarmTally tally;
  tally.Add(Bravo(5, 7, 2, 1));
  tally.Add(Bravo(0, 1, 0, 0));
  tally.Add(Bravo(1, 2, 0, 1));
  EXPECT_EQ(tally.Sources().at({"bravo", "alpha"}), (SourceCount{13, 9, 2, 2}));
  tally.Add(SwarmAt(0, "bravo", {}));
  EXPECT_EQ(tally.Sources().at({"bravo", "alpha"}), (SourceCount{13, 9, 2, 2}));
  // The same count of published messages, but fewer received.
  swarm_t restarted = Bravo(0, 2, 0, 0);
  tally.Add(Bravo(0, 4, 0, 0));
  tally.Add(restarted);
  EXPECT_EQ(tally.Sources().at({"bravo", "alpha"}), (SourceCount{19, 15, 2, 2}));
}

TEST(SwarmTally, RecognizesARestartByTheCountOfPublishedMessagesWhereMoreWereReceivedSince) {
  SwarmTally tally;
  tally.Add(Bravo(5, 1, 0, 0));
  tally.Add(Bravo(0, 3, 0, 0));
  EXPECT_EQ(tally.Sources().at({"bravo", "alpha"}), (SourceCount{4, 4, 0, 0}));
}

TEST(SwarmTally, ShowsSharesAndWhatWasRepairedHow) {
  SwarmTally tally;
  swarm_t swarm = Bravo(1, 90, 8, 2);
  AddCountTo(&swarm, "recovered", "reporter_pos", "predict", 8);
  AddCountTo(&swarm, "rejected", "", "of another group", 2);
  tally.Add(swarm);
  swarm_t other = SwarmAt(0, "charlie", {});
  AddSourceTo(&other, "alpha", 0, 1, 0);
  AddCountTo(&other, "recovered", "reporter_pos", "predict", 1);
  tally.Add(other);
  EXPECT_EQ(
      tally.Text(50),
      R"(Swarm messages                   received            clean        recovered         rejected
  all                                 101        90  89.1%         9   8.9%         2   2.0%
  bravo from alpha                    100        90  90.0%         8   8.0%         2   2.0%
  charlie from alpha                    1         0   0.0%         1 100.0%         0   0.0%

Recovered and rejected field              by                                          times
  recovered            reporter_pos       predict                                         9
  rejected             -                  of another group                                2

)");
}

TEST(SwarmTally, ShowsTheWorstPairsWhereThereAreMany) {
  SwarmTally tally;
  tally.Add(Bravo(1, 10, 0, 0));
  swarm_t other = SwarmAt(0, "charlie", {});
  AddSourceTo(&other, "alpha", 1, 9, 0);
  tally.Add(other);
  const std::string text = tally.Text(1);
  EXPECT_NE(text.find("charlie from alpha"), std::string::npos) << text;
  EXPECT_EQ(text.find("bravo from alpha"), std::string::npos) << text;
  EXPECT_NE(text.find("(1 pairs with more clean"), std::string::npos) << text;
  EXPECT_EQ(SwarmTally().Text(50), "");
}

TEST(SwarmTally, IsATableForOtherPrograms) {
  SwarmTally tally;
  swarm_t swarm = Bravo(1, 3, 1, 0);
  AddCountTo(&swarm, "recovered", "time_stamp", "previous", 1);
  tally.Add(swarm);
  EXPECT_EQ(tally.SourcesCsv(),
            "receiver,source,received,clean,recovered,rejected\nbravo,alpha,4,3,1,0\n");
  EXPECT_EQ(tally.EventsCsv(),
            "receiver,outcome,field,by,count\nbravo,recovered,time_stamp,previous,1\n");
}

TEST(SwarmTally, LeavesOutCountsThatCannotBe) {
  SwarmTally tally;
  tally.Add(Bravo(-1, 1, 0, 0));
  tally.Add(Bravo(1, -1, 0, 0));
  tally.Add(Bravo(1, 0, std::numeric_limits<int64_t>::max() / 2, 0));
  EXPECT_EQ(tally.num_impossible(), 3);
  EXPECT_TRUE(tally.Sources().empty());
}

}  // namespace shoal::swarm_tally_test
