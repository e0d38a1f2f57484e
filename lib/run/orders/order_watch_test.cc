#include "lib/run/orders/order_watch.h"

#include <gtest/gtest.h>

#include "lib/run/run/appcast.h"

namespace shoal::order_watch_test {

constexpr int64_t kSecond_us = 1'000'000;

OrderTrace Trace(const std::string& vehicle, const std::string& command) {
  return {.app = "helm_" + vehicle,
          .participant = vehicle,
          .taken = "command: " + command,
          .refused = "HELM_COMMAND refused: " + command};
}

/// A helm of which only the page matters.
struct Helm {
  std::string vehicle;
  StatusLog log;
  int64_t step = 10;

  appcast_t Page() const {
    StatusPage page;
    page.text = "State: DRIVE\n    [not an event]: command: goto\n";
    log.AppendTo(&page);
    return ToAppcast(page, "helm_" + vehicle, step * 100'000, step);
  }
  void Take(const std::string& text) { log.Event(step * 100'000, "command: " + text); }
  void Refuse(const std::string& text) {
    log.Warn("HELM_COMMAND refused: " + text);
    log.Event(step * 100'000, "HELM_COMMAND refused: " + text);
  }
};

OrderWatch SentTo(const Helm& helm, const std::string& command,
                  const std::vector<const OrderWatch*>& earlier = {}) {
  OrderWatch watch({Trace(helm.vehicle, command)});
  watch.Due(0);
  watch.OnPage(helm.Page(), 0);
  EXPECT_TRUE(watch.IsReady(0));
  watch.Sent(0, earlier);
  return watch;
}

TEST(OrderWatch, ReportsThatAnOrderWasTaken) {
  Helm helm{.vehicle = "alpha", .log = {}};
  helm.Take("goto");
  OrderWatch watch = SentTo(helm, "goto");
  watch.OnPage(helm.Page(), kSecond_us);
  EXPECT_FALSE(watch.IsSettled());  // That goto was an earlier one.
  helm.Take("goto");
  helm.log.Event(0, "DRIVE goto (clear)");
  watch.OnPage(helm.Page(), kSecond_us);
  ASSERT_TRUE(watch.IsSettled());
  EXPECT_EQ(watch.answers()[0].outcome, OrderOutcome::kTaken);
}

TEST(OrderWatch, ReportsWhyAnOrderWasRefusedAlsoForTheSecondTime) {
  Helm helm{.vehicle = "alpha", .log = {}};
  helm.Refuse("speed: no task runs");
  OrderWatch watch = SentTo(helm, "speed");
  helm.Refuse("speed: no task runs");
  watch.OnPage(helm.Page(), 0);
  ASSERT_TRUE(watch.IsSettled());
  EXPECT_EQ(watch.answers()[0].outcome, OrderOutcome::kRefused);
  EXPECT_EQ(watch.answers()[0].reason, "speed: no task runs");
}

TEST(OrderWatch, DistinguishesOverlappingOrdersOfOneKind) {
  Helm helm{.vehicle = "alpha", .log = {}};
  OrderWatch first = SentTo(helm, "speed");
  OrderWatch second = SentTo(helm, "speed", {&first});
  OrderWatch other = SentTo(helm, "return", {&first, &second});
  OrderWatch third = SentTo(helm, "speed", {&first, &second, &other});
  helm.Refuse("speed needs a number");
  helm.Take("speed");
  const appcast_t page = helm.Page();
  for (OrderWatch* watch : {&first, &second, &third, &other}) watch->OnPage(page, kSecond_us);
  EXPECT_EQ(first.answers()[0].outcome, OrderOutcome::kRefused);
  EXPECT_EQ(second.answers()[0].outcome, OrderOutcome::kTaken);
  EXPECT_FALSE(third.IsSettled());
  EXPECT_FALSE(other.IsSettled());
}

TEST(OrderWatch, DistinguishesOrdersOfOneKindThatAreSentTogether) {
  Helm helm{.vehicle = "alpha", .log = {}};
  OrderWatch watch({Trace("alpha", "set"), Trace("alpha", "set")});
  watch.Due(0);
  watch.OnPage(helm.Page(), 0);
  watch.Sent(0, {});
  helm.Take("set");
  watch.OnPage(helm.Page(), kSecond_us);
  EXPECT_EQ(watch.answers()[0].outcome, OrderOutcome::kTaken);
  EXPECT_EQ(watch.answers()[1].outcome, OrderOutcome::kOpen);
  helm.Refuse("set needs VARIABLE=value");
  watch.OnPage(helm.Page(), kSecond_us);
  EXPECT_EQ(watch.answers()[1].outcome, OrderOutcome::kRefused);
}

TEST(OrderWatch, JudgesByWarningsWhereMoreHappenedThanAPageLists) {
  Helm helm{.vehicle = "alpha", .log = {}};
  helm.Refuse("goto: all-stop");
  OrderWatch refused = SentTo(helm, "goto");
  OrderWatch taken = SentTo(helm, "return");
  helm.Refuse("goto: all-stop");
  helm.Take("return");
  for (int i = 0; i < 30; ++i) helm.log.Event(0, "something else");
  for (OrderWatch* watch : {&refused, &taken}) {
    watch->OnPage(helm.Page(), kSecond_us);
    EXPECT_FALSE(watch->IsSettled());  // Still in the step of before: it cannot have been handled.
  }
  helm.step += 2;
  for (OrderWatch* watch : {&refused, &taken}) watch->OnPage(helm.Page(), kSecond_us);
  EXPECT_EQ(refused.answers()[0].outcome, OrderOutcome::kRefused);
  EXPECT_EQ(refused.answers()[0].reason, "goto: all-stop");
  EXPECT_EQ(taken.answers()[0].outcome, OrderOutcome::kTaken);
}

TEST(OrderWatch, WaitsForPagesFromBeforeButNotForever) {
  OrderWatch watch({Trace("alpha", "goto"), Trace("bravo", "goto")});
  EXPECT_FALSE(watch.IsReady(kSecond_us));  // No participant was asked yet.
  EXPECT_EQ(watch.Due(0).size(), 2U);
  EXPECT_TRUE(watch.Due(50'000).empty());
  const Helm alpha{.vehicle = "alpha", .log = {}};
  watch.OnPage(alpha.Page(), 60'000);
  EXPECT_FALSE(watch.IsReady(60'000));
  EXPECT_EQ(watch.Due(100'000), std::vector<std::string>{"helm_bravo"});
  EXPECT_TRUE(watch.IsReady(300'000));
  watch.Sent(300'000, {});
  EXPECT_EQ(watch.Due(300'000), std::vector<std::string>{"helm_alpha"});
  EXPECT_FALSE(watch.IsSettled());
}

TEST(OrderWatch, JudgesAParticipantThatBeganAnewByItsNewPage) {
  Helm helm{.vehicle = "alpha", .log = {}};
  for (int i = 0; i < 5; ++i) helm.Take("return");
  OrderWatch watch = SentTo(helm, "goto");
  Helm again{.vehicle = "alpha", .log = {}, .step = 12};
  again.Take("goto");
  watch.OnPage(again.Page(), kSecond_us);
  EXPECT_EQ(watch.answers()[0].outcome, OrderOutcome::kTaken);
}

TEST(OrderWatch, SurvivesAWarningWhoseCountHasNoBeginning) {
  Helm helm{.vehicle = "alpha", .log = {}};
  OrderWatch watch = SentTo(helm, "goto");
  for (int i = 0; i < 30; ++i) helm.log.Event(0, "something else");
  helm.step += 2;
  appcast_t page = helm.Page();
  page.run_warnings = {"HELM_COMMAND refused: goto: 3 times)"};
  watch.OnPage(page, kSecond_us);
  EXPECT_EQ(watch.answers()[0].reason, "goto: 3 times)");
}

TEST(OrderWatch, SurvivesPagesThatNoAppWrites) {
  Helm helm{.vehicle = "alpha", .log = {}};
  for (const std::string& text :
       {std::string(), std::string("\nMost recent events ("),
        std::string("\nMost recent events (5"),
        std::string("\nMost recent events (99999999999999999999999):\n    [x"),
        std::string("\nMost recent events (-9223372036854775808):\n    [1]: command: goto"),
        std::string("\nMost recent events (9223372036854775807):\n    [1]: \n    [2]: x\n")}) {
    OrderWatch watch = SentTo(helm, "goto");
    appcast_t page = helm.Page();
    page.page = text;
    watch.OnPage(page, kSecond_us);
    OrderWatch other({Trace("alpha", "goto")});
    other.OnPage(page, 0);
    other.Sent(0, {});
    other.OnPage(helm.Page(), kSecond_us);
  }
}

TEST(OrderWatch, NamesWhatWasDoneWhereAPartWasRefused) {
  Helm alpha{.vehicle = "alpha", .log = {}};
  Helm bravo{.vehicle = "bravo", .log = {}};
  OrderWatch watch({Trace("alpha", "set"), Trace("alpha", "deploy"), Trace("bravo", "deploy")});
  watch.Due(0);
  watch.OnPage(alpha.Page(), 0);
  watch.OnPage(bravo.Page(), 0);
  watch.Sent(0, {});
  alpha.Take("set");
  alpha.Refuse("deploy: all-stop by command, send resume");
  watch.OnPage(alpha.Page(), kSecond_us);
  EXPECT_EQ(DoneBesideRefusals(watch.answers()), "alpha: set");
  bravo.Take("deploy");
  watch.OnPage(bravo.Page(), kSecond_us);
  EXPECT_EQ(DoneBesideRefusals(watch.answers()), "alpha: set; bravo: deploy");
  OrderWatch all_taken = SentTo(bravo, "deploy");
  bravo.Take("deploy");
  all_taken.OnPage(bravo.Page(), kSecond_us);
  EXPECT_EQ(DoneBesideRefusals(all_taken.answers()), "") << "nothing was refused";
}

}  // namespace shoal::order_watch_test
