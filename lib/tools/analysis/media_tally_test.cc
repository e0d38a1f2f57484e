#include "lib/tools/analysis/media_tally.h"

#include <gtest/gtest.h>

namespace shoal::media_tally_test {

fate_medium_t Fate(const std::string& medium, int32_t hop, const std::string& cause,
                   double delay_s) {
  fate_medium_t fate{};
  fate.kind = "report";
  fate.source = "auv";
  fate.destination = "buoy";
  fate.medium = medium;
  fate.hop = hop;
  fate.cause = cause;
  fate.delay_s = delay_s;
  fate.depth_m = fate.depth_limit_m = fate.range_m = fate.limit_m = -1;
  fate.horizon_m = fate.path_loss_db = fate.path_loss_limit_db = fate.loss_probability = -1;
  return fate;
}

TEST(MediaTally, ShowsEachMediumAndHopApart) {
  MediaTally tally;
  EXPECT_EQ(tally.Text(), "");
  tally.Add(Fate("acoustic", 0, "delivered", 1));
  tally.Add(Fate("acoustic", 0, "delivered", 3));
  tally.Add(Fate("acoustic", 0, "packet_loss", 2));
  tally.Add(Fate("vhf", 1, "delivered", 0.25));
  EXPECT_EQ(
      tally.Text(),
      "Media\n"
      "kind     medium            hop      sent delivered  mean [s]  95 % [s]  lost\n"
      "report   acoustic            0         3         2     2.000     3.000  packet_loss 1\n"
      "report   vhf                 1         1         1     0.250     0.250  -\n\n");
}

TEST(MediaTally, ShowsTheNumbersThatDecidedTheLastFateOfACause) {
  MediaTally tally;
  fate_medium_t submerged = Fate("vhf", 0, "submerged", -1);
  submerged.depth_limit_m = 0.5;
  for (const double depth_m : {3.0, 12.0}) {
    submerged.depth_m = depth_m;
    tally.Add(submerged);
  }
  fate_medium_t weak = Fate("vhf", 0, "weak_signal", -1);
  weak.depth_m = 0;
  weak.depth_limit_m = 0.5;
  weak.range_m = 5000;
  weak.limit_m = 4000;
  weak.horizon_m = 9000;
  weak.path_loss_db = 133.5;
  weak.path_loss_limit_db = 130;
  tally.Add(weak);
  EXPECT_NE(tally.Text().find("  submerged 2 (last: depth 12.00 m of 0.50 m), weak_signal 1 (last: "
                              "5000.0 m of 4000.0 m, path loss 133.5 dB of 130.0 dB (margin -3.5 "
                              "dB), horizon 9000.0 m)\n"),
            std::string::npos)
      << tally.Text();
}

TEST(MediaTally, WritesEachLinkWithTheNumbersThatDecided) {
  MediaTally tally;
  fate_medium_t submerged = Fate("vhf", 0, "submerged", -1);
  submerged.depth_m = 12;
  tally.Add(submerged);
  EXPECT_EQ(tally.Csv(),
            "kind,medium,hop,source,destination,sent,delivered,mean_delay_s,deepest_m,"
            "largest_path_loss_db\n"
            "report,vhf,0,auv,buoy,1,0,,12,-1\n");
}

TEST(MediaTally, LeavesDelaysOutThatNothingHas) {
  MediaTally tally;
  tally.Add(Fate("vhf", 0, "delivered", -1));
  tally.Add(Fate("vhf", 0, "delivered", 1e300));
  EXPECT_TRUE(tally.outcomes().begin()->second.delays_s.empty());
  EXPECT_EQ(tally.outcomes().begin()->second.delivered, 2);
}

}  // namespace shoal::media_tally_test
