#include "lib/routing/router.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace shoal {
namespace {

constexpr int64_t kSecond = 1'000'000;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Router MakeRouter(const RoutingRules& rules = {}) {
  const std::vector<std::string> vehicles = {"bravo", "alpha"};
  return Router(rules, vehicles);
}

ReportFacts ReportFrom(std::string_view name, double x_m) {
  return {.name = name, .group = "", .position_m = {x_m, 0, 0}};
}

/// Admits and routes one report.
std::vector<Decision> Send(Router& router, const ReportFacts& report, int64_t utime) {
  std::vector<Decision> decisions;
  const Admission admission = router.Admit(report, utime);
  if (!admission.refused) router.Route(admission, report.position_m, utime, &decisions);
  return decisions;
}

int64_t Total(const CauseCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), int64_t{0});
}

TEST(Router, KnowsNobodyBeforeTheFirstReport) {
  Router router = MakeRouter();
  EXPECT_EQ(router.num_known(), 0);
  EXPECT_TRUE(Send(router, ReportFrom("alpha", 0), 0).empty());
  EXPECT_EQ(router.num_known(), 1);
}

TEST(Router, SendsAReportToEachOtherKnownVehicleInOrderOfNames) {
  Router router = MakeRouter({.comms_range_m = 100});
  Send(router, ReportFrom("charlie", 150), 0);
  Send(router, ReportFrom("bravo", 99), 0);
  const std::vector<Decision> fates = Send(router, ReportFrom("alpha", 0), 0);
  ASSERT_EQ(fates.size(), 2U);
  EXPECT_EQ(router.contact(fates[0].source).name, "alpha");
  EXPECT_EQ(router.contact(fates[0].destination).name, "bravo");
  EXPECT_EQ(fates[0].cause, Cause::kDelivered);
  EXPECT_EQ(router.contact(fates[1].destination).name, "charlie");
  EXPECT_EQ(fates[1].cause, Cause::kOutOfRange);
  EXPECT_EQ(router.contact(fates[0].destination).num_heard, 1);
}

TEST(Router, NumbersTheReportsOfEachSource) {
  Router router = MakeRouter();
  Send(router, ReportFrom("bravo", 0), 0);
  for (int64_t number = 0; number < 3; ++number) {
    EXPECT_EQ(Send(router, ReportFrom("alpha", 0), 0).front().number, number);
  }
}

TEST(Router, TakesNamesWithoutRegardToCase) {
  Router router = MakeRouter();
  Send(router, ReportFrom("BRAVO", 0), 0);
  Send(router, ReportFrom("Bravo", 5), 0);
  EXPECT_EQ(router.num_known(), 1);
  EXPECT_EQ(router.contact(0).name, "bravo");
  EXPECT_EQ(router.contact(0).position_m.x(), 5);
}

TEST(Router, RefusesImpossibleReportsAndKeepsWhatItKnew) {
  Router router = MakeRouter();
  Send(router, ReportFrom("alpha", 1), 0);
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    const Admission admission = router.Admit(ReportFrom("alpha", bad), kSecond);
    EXPECT_EQ(admission.refused, Cause::kInvalid);
    EXPECT_EQ(router.contact(admission.source).name, "alpha");
  }
  EXPECT_EQ(router.Admit(ReportFrom("no spaces", 0), 0).refused, Cause::kInvalid);
  EXPECT_EQ(router.Admit(ReportFrom("all", 0), 0).source, kNobody);
  EXPECT_EQ(router.Admit(ReportFrom("nemo", kNan), 0).source, kNobody);
  EXPECT_EQ(router.num_known(), 1);
  EXPECT_EQ(router.contacts().at("alpha").position_m.x(), 1);
  EXPECT_EQ(router.contacts().at("alpha").received_utime, 0);
  EXPECT_EQ(router.counts()[static_cast<size_t>(Cause::kInvalid)], 5);
}

TEST(Router, ForgetsAVehicleSilentForTheForgetTime) {
  Router router = MakeRouter({.stale_forget_s = 100});
  Send(router, ReportFrom("bravo", 0), 0);
  router.ForgetSilent(100 * kSecond - 1);
  EXPECT_EQ(Send(router, ReportFrom("alpha", 0), 100 * kSecond).size(), 1U) << "stale, but known";
  std::vector<int32_t> forgotten;
  router.ForgetSilent(100 * kSecond, &forgotten);
  ASSERT_EQ(forgotten.size(), 1U);
  EXPECT_EQ(router.contact(forgotten[0]).name, "bravo");
  EXPECT_TRUE(Send(router, ReportFrom("alpha", 0), 100 * kSecond).empty());
}

TEST(Router, GoesOnCountingWhenAForgottenVehicleComesBack) {
  Router router = MakeRouter({.stale_forget_s = 10});
  Send(router, ReportFrom("bravo", 0), 0);
  router.ForgetSilent(10 * kSecond);
  EXPECT_EQ(router.Admit(ReportFrom("bravo", 0), 11 * kSecond).number, 1);
  EXPECT_EQ(router.num_known(), 1);
}

TEST(Router, NeverForgetsWhereTheForgetTimeIsNegative) {
  Router router = MakeRouter({.stale_forget_s = -1});
  Send(router, ReportFrom("bravo", 0), 0);
  router.ForgetSilent(1'000'000 * kSecond);
  EXPECT_EQ(router.num_known(), 1);
}

TEST(Router, KeepsRoomForTheMissionsVehiclesInAFloodOfNames) {
  Router router = MakeRouter({.stale_forget_s = 10});
  for (int i = 0; i < 2 * Router::kMaxStrangers; ++i) {
    const std::string name = "made_up_" + std::to_string(i);
    const Admission admission = router.Admit(ReportFrom(name, i), 0);
    EXPECT_EQ(admission.refused.has_value(), i >= Router::kMaxStrangers);
  }
  EXPECT_EQ(router.num_known(), Router::kMaxStrangers);
  EXPECT_EQ(router.counts()[static_cast<size_t>(Cause::kTooManyVehicles)], Router::kMaxStrangers);
  EXPECT_FALSE(router.Admit(ReportFrom("alpha", 0), 0).refused);
}

TEST(Router, GivesAForgottenStrangersPlaceToANewOne) {
  Router router = MakeRouter({.stale_forget_s = 10});
  for (int i = 0; i < Router::kMaxStrangers; ++i) {
    router.Admit(ReportFrom("made_up_" + std::to_string(i), i), 0);
  }
  router.Admit(ReportFrom("made_up_7", 0), 9 * kSecond);
  router.ForgetSilent(10 * kSecond);
  EXPECT_EQ(router.num_known(), 1);
  for (int i = 0; i < Router::kMaxStrangers - 1; ++i) {
    EXPECT_FALSE(
        router.Admit(ReportFrom("newcomer_" + std::to_string(i), i), 11 * kSecond).refused);
  }
  EXPECT_TRUE(router.Admit(ReportFrom("one_too_many", 0), 11 * kSecond).refused);
  EXPECT_EQ(router.num_known(), Router::kMaxStrangers);
  for (const auto& [key, contact] : router.contacts()) {
    EXPECT_EQ(&router.contact(contact.index), &contact);
  }
}

// What was offered is what has a fate, whatever comes in and however the rules change.
RC_GTEST_PROP(Router, GivesEveryReportOneFatePerOtherKnownVehicle, ()) {
  Router router = MakeRouter();
  const std::vector<std::string> names = {"alpha", "ALPHA", "bravo", "nemo", "dory", "", "a b"};
  int64_t offered = 0;
  int64_t utime = 0;
  const int num_events = *rc::gen::inRange(0, 60);
  for (int i = 0; i < num_events; ++i) {
    utime += *rc::gen::inRange<int64_t>(0, 4 * kSecond);
    router.rules().comms_range_m = *rc::gen::inRange(-1, 100);
    router.rules().stale_time_s = *rc::gen::inRange(-1, 8);
    router.rules().stale_forget_s = *rc::gen::inRange(-1, 20);
    const std::string& name = names[*rc::gen::inRange<size_t>(0, names.size())];
    const double x_m = *rc::gen::inRange(0, 10) == 0 ? kNan : *rc::gen::inRange(0, 100);
    const int64_t refused_before = Total(router.counts());
    std::vector<Decision> fates;
    const Admission admission = router.Admit(ReportFrom(name, x_m), utime);
    if (admission.refused) {
      offered += 1;
      RC_ASSERT(Total(router.counts()) == refused_before + 1);
    } else {
      offered += router.num_known() - 1;
      router.Route(admission, {x_m, 0, 0}, utime, &fates);
      RC_ASSERT(fates.size() == static_cast<size_t>(router.num_known()) - 1);
    }
    router.ForgetSilent(utime);
    RC_ASSERT(Total(router.counts()) == offered);
  }
}

}  // namespace
}  // namespace shoal
