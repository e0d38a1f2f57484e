// Reports, messages and acks over the acoustic network: unchanged, damaged, or discarded.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_air_test {

class CalmReports : public AcousticFixture {
 protected:
  CalmReports() : AcousticFixture(AcousticReports()) {}
};

TEST_F(CalmReports, WithGiantTextsAreNotSent) {
  Begin();
  for (int i = 0; i < 20; ++i) Step();
  node_report_t report = ReportFrom("bravo", 150);
  report.mode.assign(200'000, 'z');
  Send(report);
  Step();
  ASSERT_EQ(Fates(), std::vector<std::string>(1, "bravo>alpha too_long"));
  EXPECT_GT(fates_[0].length_bytes, 200'000);
  EXPECT_EQ(fates_[0].length_limit_bytes, AcousticTraffic::kMaxMessage_bytes);
}

TEST_F(CalmReports, TakeTheTimeOf37BytesAndArriveUnchanged) {
  Begin();
  EXPECT_TRUE(received_["alpha"].empty());
  for (int i = 0; i < 20; ++i) Step();
  const node_report_t report = ReportFrom("bravo", 150);
  Send(report);
  EXPECT_EQ(StepUntilFates(), 5) << "0.328 s and 0.1 s";
  ASSERT_EQ(received_["alpha"].size(), 1U);
  node_report_t received;
  ASSERT_TRUE(Decode(received_["alpha"][0], &received));
  EXPECT_EQ(received.x_m, 150);
  EXPECT_EQ(received.extra.size(), 1U) << "the user's own fields too";
  EXPECT_EQ(fates_[0].kind, "report");
  EXPECT_EQ(fates_[0].path.at(0).num_bytes, 41);
  EXPECT_EQ(fates_[0].age_limit_s, 5);
}

TEST_F(CalmReports, CarryMessagesAsTheirTextAndTheirAcks) {
  Begin();
  for (int i = 0; i < 20; ++i) Step();
  Send(MessageFrom("alpha", "bravo"));
  StepUntilFates();
  ASSERT_EQ(messages_["bravo"].size(), 1U);
  const std::string text = "src_node=alpha,dest_node=bravo,var_name=FOOBAR,string_val=hello";
  EXPECT_EQ(fates_[0].path.at(0).num_bytes, static_cast<int32_t>(text.size()) + 4);
  ack_message_t ack = {};
  ack.src_node = "bravo";
  ack.dest_node = "alpha";
  ack.ack_id = "m1";
  Send(ack);
  StepUntilFates();
  EXPECT_EQ(acks_["alpha"].size(), 1U);
  EXPECT_EQ(Fates(), std::vector<std::string>{"bravo>alpha delivered"});
}

Mission WithBitErrors(bool crc) {
  Mission mission = AcousticReports();
  mission.acoustics.crc = crc;
  mission.acoustics.options.bit_error_model = BitErrorModel::kPoisson;
  mission.acoustics.options.bit_error_rate = 0.01;
  return mission;
}

/// Counts what becomes of 400 reports of alpha at bravo.
struct ReportCounts {
  std::map<std::string, int> causes;
  int num_received = 0;
  int num_wrong = 0;  ///< Received, and not as they were sent.
};

class DamagingNetwork : public AcousticFixture {
 protected:
  explicit DamagingNetwork(bool crc) : AcousticFixture(WithBitErrors(crc)) {}

  ReportCounts SendReports() {
    ReportCounts counts;
    Begin();
    while (broker_.traffic().num_in_transit() > 0) Step();
    for (int i = 0; i < 400; ++i) {
      Send(ReportFrom("bravo", 150));  // So that it is not stale.
      while (broker_.traffic().num_in_transit() > 0) Step();
      Send(ReportFrom("alpha", 100));
      bool is_decided = false;
      while (!is_decided) {
        Step();
        for (const Bytes& bytes : received_["bravo"]) {
          node_report_t received;
          EXPECT_TRUE(Decode(bytes, &received));
          ++counts.num_received;
          for (const double number :
               {received.x_m, received.y_m, received.depth_m, received.lat_deg, received.lon_deg,
                received.speed_mps, received.heading_deg}) {
            EXPECT_TRUE(std::isfinite(number));
          }
          if (received.name != "alpha" || received.x_m != 100 || received.speed_mps != 0 ||
              received.depth_m != 0 || received.y_m != 0 || received.utime != 0) {
            ++counts.num_wrong;
          }
        }
        for (const fate_t& fate : fates_) {
          if (fate.source != "alpha") continue;
          is_decided = true;
          ++counts.causes[fate.cause];
          const bool has_flips = !fate.path.empty() && fate.path[0].bits_flipped > 0;
          EXPECT_EQ(has_flips, fate.cause != "delivered");
        }
      }
    }
    return counts;
  }
};

class CheckedReports : public DamagingNetwork {
 protected:
  CheckedReports() : DamagingNetwork(true) {}
};

TEST_F(CheckedReports, ThatAreDamagedAreThrownAwayForTheirBitErrors) {
  const ReportCounts counts = SendReports();
  // 328 bits are all right with probability 0.99^328 = 0.037: 14.8 of 400; 5 sigma: 19.
  EXPECT_EQ(counts.causes.size(), 2U);
  EXPECT_NEAR(counts.causes.at("delivered"), 14.8, 19);
  EXPECT_EQ(counts.causes.at("bit_errors"), 400 - counts.causes.at("delivered"));
  EXPECT_EQ(counts.num_received, counts.causes.at("delivered"));
  EXPECT_EQ(counts.num_wrong, 0);
  EXPECT_TRUE(PageHas("Bit Errors: "));
}

class UncheckedReports : public DamagingNetwork {
 protected:
  UncheckedReports() : DamagingNetwork(false) {}
};

TEST_F(UncheckedReports, ThatAreDamagedArriveWrongOrAreRejected) {
  const ReportCounts counts = SendReports();
  EXPECT_EQ(counts.causes.size(), 3U);
  EXPECT_GT(counts.causes.at("damaged"), 20);
  EXPECT_GT(counts.causes.at("rejected"), 20);
  EXPECT_EQ(counts.num_received, counts.causes.at("delivered") + counts.causes.at("damaged"));
  EXPECT_GT(counts.num_wrong, counts.causes.at("damaged") / 2);
}

}  // namespace shoal::broker_air_test
