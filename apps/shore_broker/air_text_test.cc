#include "apps/shore_broker/air_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "lib/comms/swarm/report_message.h"

namespace shoal::air_text_test {

constexpr int64_t kStart_utime = 7'000'000;

node_report_t Report() {
  node_report_t report = {};
  report.utime = kStart_utime + 2'500'000;
  report.name = "alpha";
  report.group = "red";
  report.x_m = 10.1;
  report.y_m = -20;
  report.depth_m = 5;
  report.lat_deg = 43;
  report.speed_over_ground_mps = 2;
  report.course_over_ground_deg = 90;
  report.speed_mps = 1.5;
  return report;
}

ReportContext Context() {
  return {.receiver = "bravo",
          .start_utime = kStart_utime,
          .now_utime = kStart_utime + 10'000'000,
          .origin = {.lat_deg = 43.8, .lon_deg = -70.3},
          .vehicle_at = [](uint32_t address) -> std::string_view {
            if (address == 1) return "alpha";
            if (address == 2) return "bravo";
            if (address == 3) return "charlie";
            return {};
          }};
}

std::vector<uint8_t> Sent() { return AirBytes(Report(), 1, kStart_utime); }

/// What bravo makes of the report with one byte changed.
std::optional<node_report_t> WithByte(size_t place, uint8_t byte) {
  std::vector<uint8_t> arrived = Sent();
  arrived[place] = byte;
  return UnderstandDamaged(Report(), Sent(), arrived, Context());
}

std::optional<node_report_t> WithFloat(size_t place, float number) {
  std::vector<uint8_t> arrived = Sent();
  std::memcpy(&arrived[place], &number, sizeof number);
  return UnderstandDamaged(Report(), Sent(), arrived, Context());
}

TEST(AirBytes, OfAReportMayHaveAnyTime) {
  node_report_t report = Report();
  for (const int64_t utime :
       {std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()}) {
    report.utime = utime;
    const std::optional<ReportMessage> sent = DecodeReport(AirBytes(report, 1, kStart_utime));
    ASSERT_TRUE(sent.has_value());
    EXPECT_FLOAT_EQ(sent->time_stamp_s, static_cast<float>(utime) / 1e6F);
  }
}

TEST(AirBytes, OfAReportAreMuNets) {
  const std::optional<ReportMessage> report = DecodeReport(Sent());
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(Sent().size(), 37U);
  EXPECT_EQ(report->flag, kReportFlag);
  EXPECT_EQ(report->group_id, 'r');
  EXPECT_EQ(report->reporter_id, 1U);
  EXPECT_EQ(report->position_m, Eigen::Vector3f(10.1F, -20, 5));
  EXPECT_NEAR(report->velocity_mps.x(), 2, 1e-6) << "East";
  EXPECT_NEAR(report->velocity_mps.y(), 0, 1e-6);
  EXPECT_EQ(report->time_stamp_s, 2.5F);
}

TEST(DamagedReport, ChangesWhatWasHitAndNothingElse) {
  const auto deeper = WithFloat(17, 50);
  ASSERT_TRUE(deeper.has_value());
  EXPECT_EQ(deeper->depth_m, 50);
  EXPECT_EQ(deeper->speed_mps, 1.5);
  EXPECT_EQ(deeper->utime, Report().utime);
  EXPECT_NEAR(deeper->lat_deg, 43.8, 0.01) << "latitude and longitude follow";
  const auto slower = WithFloat(21, 1);
  ASSERT_TRUE(slower.has_value());
  EXPECT_NEAR(slower->speed_over_ground_mps, 1, 1e-6);
  EXPECT_NEAR(slower->course_over_ground_deg, 90, 1e-4);
  EXPECT_EQ(slower->x_m, 10.1) << "not rounded to a float";
  EXPECT_EQ(WithFloat(33, 2)->utime, kStart_utime + 2'000'000);
  EXPECT_EQ(WithByte(4, 'b')->group, "b");
  EXPECT_EQ(WithByte(5, 3)->name, "charlie");
}

TEST(DamagedReport, IsRejectedWhereAReceiverSeesThatItIsWrong) {
  EXPECT_FALSE(WithByte(0, 'X')) << "no report";
  EXPECT_FALSE(WithByte(4, 1)) << "no letter";
  EXPECT_FALSE(WithByte(5, 2)) << "the receiver itself";
  EXPECT_FALSE(WithByte(5, 4)) << "an unused address";
  EXPECT_FALSE(WithFloat(9, 100'001));
  EXPECT_TRUE(WithFloat(9, -100'000));
  EXPECT_FALSE(WithFloat(9, NAN));
  EXPECT_FALSE(WithFloat(13, INFINITY));
  EXPECT_FALSE(WithFloat(29, -100.1F));
  EXPECT_FALSE(WithFloat(33, 10.1F)) << "the future";
  EXPECT_FALSE(WithFloat(33, -1));
  EXPECT_FALSE(WithFloat(33, NAN));
}

RC_GTEST_PROP(DamagedReport, NeverHoldsANumberThatIsNotFinite, ()) {
  std::vector<uint8_t> arrived = Sent();
  const int num_changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < num_changes; ++i) {
    arrived[static_cast<size_t>(*rc::gen::inRange(4, 37))] = *rc::gen::arbitrary<uint8_t>();
  }
  const auto understood = UnderstandDamaged(Report(), Sent(), arrived, Context());
  if (!understood) return;
  for (const double number :
       {understood->x_m, understood->y_m, understood->depth_m, understood->lat_deg,
        understood->lon_deg, understood->speed_mps, understood->heading_deg,
        understood->speed_over_ground_mps, understood->course_over_ground_deg}) {
    RC_ASSERT(std::isfinite(number));
  }
}

node_message_t NodeMessage() {
  node_message_t message = {};
  message.src_node = "alpha";
  message.dest_node = "bravo";
  message.var_name = "SPEED";
  message.is_double = 1;
  message.double_val = 1.5;
  return message;
}

std::vector<uint8_t> BytesOf(std::string_view text) { return {text.begin(), text.end()}; }

TEST(AirBytes, OfMessagesAndAcksAreTheirText) {
  EXPECT_EQ(AirBytes(NodeMessage()),
            BytesOf("src_node=alpha,dest_node=bravo,var_name=SPEED,double_val=1.5"));
  ack_message_t ack = {};
  ack.src_node = "bravo";
  ack.dest_node = "alpha";
  ack.ack_id = "7";
  EXPECT_EQ(AirBytes(ack), BytesOf("src_node=bravo,dest_node=alpha,ack_id=7"));
}

TEST(AirBytes, OfAMessageHoldEveryDigitOfItsNumber) {
  node_message_t message = NodeMessage();
  message.double_val = 1.0 / 3;
  const auto understood = UnderstandDamaged(NodeMessage(), AirBytes(message));
  ASSERT_TRUE(understood.has_value());
  EXPECT_EQ(understood->double_val, message.double_val);
}

TEST(DamagedMessage, HasTheContentOfItsText) {
  const auto understood = UnderstandDamaged(
      NodeMessage(), BytesOf("src_node=alpha,dest_node=bravo,var_name=SPEED,double_val=9.5"));
  ASSERT_TRUE(understood.has_value());
  EXPECT_EQ(understood->double_val, 9.5);
  for (const char* nonsense :
       {"src_node=alpha,dest_node=bravo,var_name=SPEED,double_val=1x5", "src_node=al pha", "",
        "src_node=alpha,dest_node=bravo,string_val=1"}) {
    EXPECT_FALSE(UnderstandDamaged(NodeMessage(), BytesOf(nonsense))) << nonsense;
  }
}

TEST(DamagedAck, NeedsItsThreeFields) {
  const ack_message_t ack = {};
  const auto understood =
      UnderstandDamaged(ack, BytesOf("src_node=bravo,dest_node=alpha,ack_id=8"));
  ASSERT_TRUE(understood.has_value());
  EXPECT_EQ(understood->ack_id, "8");
  for (const char* nonsense : {"src_node=bravo,dest_node=alpha", "src_node=,dest_node=a,ack_id=1",
                               "src_node=b,dest_node=a!,ack_id=1", "x"}) {
    EXPECT_FALSE(UnderstandDamaged(ack, BytesOf(nonsense))) << nonsense;
  }
}

}  // namespace shoal::air_text_test
