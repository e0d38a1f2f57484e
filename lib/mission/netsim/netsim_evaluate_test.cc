#include "lib/mission/netsim/netsim_evaluate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/mission/netsim/netsim_testing.h"

namespace shoal::netsim_evaluate_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

NetsimVerdict EvaluateNavs(const std::vector<NetsimNav>& navs,
                           const std::string& address = "127.0.0.1") {
  return EvaluateRequest({.id = 1, .navs = navs, .stats = {}, .is_whole = true}, address,
                         TwoNetsimVehicles());
}

NetsimNav With(double NetsimNav::*member, double value) {
  NetsimNav nav = AliceNav();
  nav.*member = value;
  return nav;
}

NetsimNav WithPort(int32_t port) {
  NetsimNav nav = AliceNav();
  nav.modem_tcp_port = port;
  return nav;
}

TEST(EvaluateRequest, AcceptsAPositionInTheRegion) {
  const NetsimVerdict verdict = EvaluateNavs({AliceNav()});
  EXPECT_EQ(verdict.status, NetsimStatus::kAccepted);
  ASSERT_EQ(verdict.positions.size(), 1U);
  EXPECT_EQ(verdict.positions[0].vehicle, "alice");
  EXPECT_EQ(verdict.positions[0].nav.lat_deg, 41.5);
  EXPECT_EQ(verdict.problem, "");
}

TEST(EvaluateRequest, AcceptsNothingAtAll) {
  EXPECT_EQ(EvaluateNavs({}).status, NetsimStatus::kAccepted);
}

TEST(EvaluateRequest, RefusesAPortOfNoVehicle) {
  for (const int32_t port : {0, -1, 61999, 62002, std::numeric_limits<int32_t>::min()}) {
    const NetsimVerdict verdict = EvaluateNavs({WithPort(port)});
    EXPECT_EQ(verdict.status, NetsimStatus::kInvalidModemTcpPort);
    EXPECT_TRUE(verdict.positions.empty());
    EXPECT_NE(verdict.problem.find(std::to_string(port)), std::string::npos);
  }
}

TEST(EvaluateRequest, RefusesAnotherHostsPosition) {
  const NetsimVerdict verdict = EvaluateNavs({AliceNav()}, "127.0.0.2");
  EXPECT_EQ(verdict.status, NetsimStatus::kInvalidSourceAddress);
  EXPECT_TRUE(verdict.positions.empty());
}

TEST(EvaluateRequest, TakesAnyHostWhereAnyMay) {
  NetsimNav nav = WithPort(62001);
  nav.lat_deg = 0;
  nav.lon_deg = 180;
  EXPECT_EQ(EvaluateNavs({nav}, "192.168.1.7").status, NetsimStatus::kAccepted);
}

TEST(EvaluateRequest, LooksAtThePortThenTheAddressThenTheRegion) {
  NetsimNav nav = With(&NetsimNav::lat_deg, 0);
  EXPECT_EQ(EvaluateNavs({nav}, "127.0.0.2").status, NetsimStatus::kInvalidSourceAddress);
  nav.modem_tcp_port = 62002;
  EXPECT_EQ(EvaluateNavs({nav}, "127.0.0.2").status, NetsimStatus::kInvalidModemTcpPort);
}

TEST(EvaluateRequest, CountsTheBoundsToTheRegion) {
  for (const double depth_m : {0.0, -0.0, 100.0}) {
    EXPECT_EQ(EvaluateNavs({With(&NetsimNav::depth_m, depth_m)}).status, NetsimStatus::kAccepted);
  }
  const double beyond[] = {std::nextafter(0.0, -1.0), std::nextafter(100.0, 101.0), 1e300};
  for (const double depth_m : beyond) {
    EXPECT_EQ(EvaluateNavs({With(&NetsimNav::depth_m, depth_m)}).status,
              NetsimStatus::kOutOfDefinedRegion);
  }
}

TEST(EvaluateRequest, DoesNotCareForTheTimeNorTheTurnOfAHeading) {
  for (const double value : {-1e18, 0.0, 720.0, 1e300}) {
    EXPECT_EQ(EvaluateNavs({With(&NetsimNav::time_s, value)}).status, NetsimStatus::kAccepted);
    EXPECT_EQ(EvaluateNavs({With(&NetsimNav::heading_deg, value)}).status, NetsimStatus::kAccepted);
    EXPECT_EQ(EvaluateNavs({With(&NetsimNav::speed_mps, value)}).status, NetsimStatus::kAccepted);
  }
}

TEST(EvaluateRequest, LetsNoNumberInThatIsNone) {
  for (const double value : {kNotGiven, kInfinity, -kInfinity}) {
    for (double NetsimNav::*member :
         {&NetsimNav::time_s, &NetsimNav::lat_deg, &NetsimNav::lon_deg, &NetsimNav::depth_m,
          &NetsimNav::speed_mps, &NetsimNav::heading_deg}) {
      const NetsimVerdict verdict = EvaluateNavs({With(member, value)});
      EXPECT_EQ(verdict.status, NetsimStatus::kOutOfDefinedRegion);
      EXPECT_TRUE(verdict.positions.empty());
    }
  }
}

TEST(EvaluateRequest, StopsAtTheFirstThatFails) {
  const NetsimVerdict verdict =
      EvaluateNavs({AliceNav(), With(&NetsimNav::lat_deg, 43), WithPort(62002), AliceNav()});
  EXPECT_EQ(verdict.status, NetsimStatus::kOutOfDefinedRegion);
  EXPECT_EQ(verdict.positions.size(), 1U);
}

TEST(EvaluateRequest, TakesStatsWhateverBecameOfThePositions) {
  const NetsimRequest request{
      .id = 1, .navs = {WithPort(1)}, .stats = {NetsimReceiveStats{}}, .is_whole = true};
  const NetsimVerdict verdict = EvaluateRequest(request, "127.0.0.1", TwoNetsimVehicles());
  EXPECT_EQ(verdict.status, NetsimStatus::kInvalidModemTcpPort);
  EXPECT_EQ(verdict.stats.size(), 1U);
}

TEST(EvaluateRequest, TakesNothingOfARequestThatIsNotWhole) {
  const NetsimRequest request{.id = 1,
                              .navs = {AliceNav(), With(&NetsimNav::heading_deg, kNotGiven)},
                              .stats = {NetsimReceiveStats{}},
                              .is_whole = false};
  const NetsimVerdict verdict = EvaluateRequest(request, "127.0.0.1", TwoNetsimVehicles());
  EXPECT_EQ(verdict.status, NetsimStatus::kOutOfDefinedRegion);
  EXPECT_TRUE(verdict.positions.empty());
  EXPECT_TRUE(verdict.stats.empty());
}

TEST(EvaluateRequest, GivesNoStatusWhereOnlyStatsAreNotWhole) {
  const NetsimRequest request{
      .id = 1, .navs = {AliceNav()}, .stats = {NetsimReceiveStats{}}, .is_whole = false};
  const NetsimVerdict verdict = EvaluateRequest(request, "127.0.0.1", TwoNetsimVehicles());
  EXPECT_EQ(verdict.status, std::nullopt);
  EXPECT_TRUE(verdict.positions.empty());
  EXPECT_TRUE(verdict.stats.empty());
  EXPECT_NE(verdict.problem, "");
}

RC_GTEST_PROP(EvaluateRequest, AcceptsAllUpToTheFirstThatFails, ()) {
  const auto lats_deg = *rc::gen::container<std::vector<double>>(
      rc::gen::element(40.9, 41.0, 41.5, 42.0, 42.1, kNotGiven, kInfinity));
  std::vector<NetsimNav> navs;
  for (const double lat_deg : lats_deg) navs.push_back(With(&NetsimNav::lat_deg, lat_deg));
  const auto is_right = [](double lat_deg) { return lat_deg >= 41 && lat_deg <= 42; };
  size_t num_right = 0;
  while (num_right < lats_deg.size() && is_right(lats_deg[num_right])) ++num_right;
  const NetsimVerdict verdict = EvaluateNavs(navs);
  RC_ASSERT(verdict.positions.size() == num_right);
  RC_ASSERT((verdict.status == NetsimStatus::kAccepted) == (num_right == navs.size()));
}

}  // namespace shoal::netsim_evaluate_test
