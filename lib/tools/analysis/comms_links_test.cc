#include "lib/tools/analysis/comms_links.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace shoal::comms_links_test {

fate_t Fate(const std::string& destination, const std::string& cause, double delay_s = -1) {
  fate_t fate{};
  fate.kind = "packet";
  fate.source = "alpha";
  fate.destination = destination;
  fate.cause = cause;
  fate.count = 1;
  if (delay_s < 0) return fate;
  acoustic_path_t path{};
  path.air_s = delay_s / 2;
  path.travel_s = delay_s / 4;
  path.jitter_s = delay_s / 4;
  fate.num_paths = 1;
  fate.path.push_back(path);
  return fate;
}

TEST(LinkStatistics, CountWhatCameWhatWasDamagedAndWhatWasLostByCause) {
  LinkStatistics links;
  for (int i = 0; i < 6; ++i) links.Add(Fate("bravo", "delivered", 0.5));
  links.Add(Fate("bravo", "damaged", 1.0));
  links.Add(Fate("bravo", "collision", 7.0));
  links.Add(Fate("bravo", "packet_loss", 7.0));
  links.Add(Fate("bravo", "packet_loss", 7.0));
  const LinkOutcome& link = links.links().at({3, "alpha", "bravo"});
  EXPECT_EQ(link.sent, 10);
  EXPECT_EQ(link.delivered, 6);
  EXPECT_EQ(link.damaged, 1);
  EXPECT_EQ(link.NumLost(), 3);
  EXPECT_EQ(link.lost.at("packet_loss"), 2);
  EXPECT_EQ(link.delays_s.size(), 7U) << "of what was handed over, and of nothing else";
}

TEST(LinkStatistics, ShowATableWithTheTotalsFirst) {
  LinkStatistics links;
  for (int i = 0; i < 19; ++i) links.Add(Fate("bravo", "delivered", 0.5));
  links.Add(Fate("bravo", "damaged", 1.5));
  links.Add(Fate("charlie", "delivered"));
  links.Add(Fate("charlie", "collision"));
  links.Add(Fate("charlie", "half_duplex"));
  links.Add(Fate("charlie", "half_duplex"));
  EXPECT_EQ(
      links.Text(50),
      R"(Packets                   sent      delivered damaged    lost  delay s     95 %  lost by
  all links                 24      20  83.3%       1       3    0.550    0.500  half_duplex 2
                                                                               collision 1
  alpha -> bravo            20      19  95.0%       1       0    0.550    0.500
  alpha -> charlie           4       1  25.0%       0       3        -        -  half_duplex 2
                                                                               collision 1

)");
}

TEST(LinkStatistics, ShowTheWorstLinksWhereThereAreMany) {
  LinkStatistics links;
  for (const char* name : {"bravo", "charlie", "delta"}) {
    links.Add(Fate(name, "delivered"));
    links.Add(Fate(name, name == std::string("charlie") ? "dropped" : "delivered"));
  }
  const std::string text = links.Text(1);
  EXPECT_NE(text.find("alpha -> charlie"), std::string::npos) << text;
  EXPECT_EQ(text.find("alpha -> bravo"), std::string::npos) << text;
  EXPECT_NE(text.find("  (2 links that lost less not shown; --all shows them)\n"),
            std::string::npos);
}

TEST(LinkStatistics, AreTablesForOtherPrograms) {
  LinkStatistics links;
  links.Add(Fate("bravo", "delivered", 0.5));
  links.Add(Fate("bravo", "collision"));
  links.Add(Fate("a \"b\"", "out_of_range"));
  EXPECT_EQ(links.LinksCsv(),
            "kind,source,destination,sent,delivered,damaged,lost,delay_mean_s,delay_95_s\n"
            "packet,alpha,\"a \"\"b\"\"\",1,0,0,1,,\n"
            "packet,alpha,bravo,2,1,0,1,0.500000,0.500000\n");
  EXPECT_EQ(links.LossesCsv(),
            "kind,source,destination,cause,count\n"
            "packet,alpha,\"a \"\"b\"\"\",out_of_range,1\n"
            "packet,alpha,bravo,collision,1\n");
}

TEST(LinkStatistics, AreNotHarmedByWhatCannotBe) {
  LinkStatistics links;
  fate_t fate = Fate("\x1b[2J", "no such cause\n");
  fate.kind = "made up";
  fate.count = -5;
  links.Add(fate);
  EXPECT_TRUE(links.links().empty());
  fate.count = std::numeric_limits<int32_t>::max();
  links.Add(fate);
  for (const double delay_s :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e9}) {
    fate_t delivered = Fate("bravo", "delivered", 1);
    delivered.path.front().travel_s = delay_s;
    links.Add(delivered);
  }
  EXPECT_EQ(links.num_impossible(), 3);
  const std::string text = links.Text(50);
  EXPECT_NE(text.find("Of other kinds"), std::string::npos) << text;
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(LinkStatistics().Text(50), "");
}

TEST(Percentile, IsTheNearestRank) {
  EXPECT_EQ(Percentile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(Percentile({7}, 0.95), 7);
  std::vector<double> hundred;
  for (int i = 100; i > 0; --i) hundred.push_back(i);
  EXPECT_EQ(Percentile(hundred, 0.95), 95);
  EXPECT_EQ(Percentile(hundred, 1), 100);
}

RC_GTEST_PROP(LinkStatistics, SumUpToWhatWasSent, ()) {
  const auto causes = *rc::gen::container<std::vector<std::string>>(
      rc::gen::element<std::string>("delivered", "damaged", "collision", "packet_loss"));
  LinkStatistics links;
  for (const std::string& cause : causes) {
    links.Add(Fate(*rc::gen::element<std::string>("bravo", "charlie"), cause, 1));
  }
  int64_t sum = 0;
  for (const auto& [key, link] : links.links()) {
    int64_t num_lost = 0;
    for (const auto& [cause, count] : link.lost) num_lost += count;
    RC_ASSERT(num_lost == link.NumLost());
    sum += link.sent;
  }
  RC_ASSERT(sum == static_cast<int64_t>(causes.size()));
}

}  // namespace shoal::comms_links_test
