#include "lib/helm/behaviors/contact_ledger.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace shoal::contact_ledger_test {

const Eigen::Vector2d kOwn_m = Eigen::Vector2d::Zero();

ContactReport Report(const std::string& name, double made_s, const Eigen::Vector2d& position_m) {
  return {.name = name,
          .motion = {.position_m = position_m, .heading_deg = 90, .speed_mps = 2},
          .made_s = made_s,
          .received_s = made_s};
}

TEST(ContactLedger, ExtrapolatesAlongTheReportedHeading) {
  ContactLedger ledger("alpha");
  EXPECT_EQ(ledger.Take(Report("bravo", 10, {5, 7}), kOwn_m), ContactIntake::kTaken);
  const ContactView contact = ledger.At(14, kOwn_m).at("bravo");
  EXPECT_NEAR(contact.now.position_m.x(), 13, 1e-9);
  EXPECT_NEAR(contact.now.position_m.y(), 7, 1e-9);
  EXPECT_EQ(contact.reported.position_m, Eigen::Vector2d(5, 7));
  EXPECT_EQ(contact.age_s, 4);
}

TEST(ContactLedger, LetsTheSpeedOfAnOldContactDecay) {
  const ContactLimits limits;
  EXPECT_NEAR(ExtrapolatedDistance(2, 15, limits), 30, 1e-9);
  // 15 s at 2 m/s, then 7.5 s in which the speed falls to 1 m/s.
  EXPECT_NEAR(ExtrapolatedDistance(2, 22.5, limits), 30 + 7.5 * 1.5, 1e-9);
  EXPECT_NEAR(ExtrapolatedDistance(2, 30, limits), 45, 1e-9);
  EXPECT_NEAR(ExtrapolatedDistance(2, 300, limits), 45, 1e-9);
  EXPECT_EQ(ExtrapolatedDistance(2, 10, {.decay_start_s = 0, .decay_end_s = 0}), 0);
}

TEST(ContactLedger, NeverHasANegativeAge) {
  ContactLedger ledger("alpha");
  // The reporter's clock is a minute ahead: the report is as old as its reception.
  ContactReport report = Report("bravo", 70, {5, 7});
  report.received_s = 10;
  EXPECT_EQ(ledger.Take(report, kOwn_m), ContactIntake::kTaken);
  EXPECT_EQ(ledger.At(12, kOwn_m).at("bravo").age_s, 2);
  EXPECT_EQ(ledger.At(9, kOwn_m).at("bravo").age_s, 0);
}

TEST(ContactLedger, CountsTheTimeOnTheWay) {
  ContactLedger ledger("alpha");
  ContactReport report = Report("bravo", 10, {0, 0});
  report.received_s = 13;
  (void)ledger.Take(report, kOwn_m);
  EXPECT_EQ(ledger.At(13, kOwn_m).at("bravo").age_s, 3);
  EXPECT_NEAR(ledger.At(13, kOwn_m).at("bravo").now.position_m.x(), 6, 1e-9);
}

TEST(ContactLedger, ForgetsAContactOnceAtTheAgeLimitAndTakesItBack) {
  ContactLedger ledger("alpha");
  (void)ledger.Take(Report("bravo", 10, {5, 7}), kOwn_m);
  EXPECT_EQ(ledger.At(55, kOwn_m).size(), 1U);
  EXPECT_TRUE(ledger.TakeForgotten().empty());
  EXPECT_TRUE(ledger.At(55.1, kOwn_m).empty());
  EXPECT_EQ(ledger.TakeForgotten(), std::vector<std::string>{"bravo"});
  EXPECT_TRUE(ledger.At(56, kOwn_m).empty());
  EXPECT_TRUE(ledger.TakeForgotten().empty());
  EXPECT_EQ(ledger.Take(Report("bravo", 57, {9, 9}), kOwn_m), ContactIntake::kTaken);
  EXPECT_EQ(ledger.At(57, kOwn_m).size(), 1U);
}

TEST(ContactLedger, RefusesWhatIsNoReport) {
  ContactLedger ledger("alpha");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ledger.Take(Report("", 0, {0, 0}), kOwn_m), ContactIntake::kNoName);
  EXPECT_EQ(ledger.Take(Report("alpha", 0, {0, 0}), kOwn_m), ContactIntake::kOwnName);
  EXPECT_EQ(ledger.Take(Report("bravo", 0, {nan, 0}), kOwn_m), ContactIntake::kNotFinite);
  EXPECT_EQ(ledger.Take(Report("bravo", infinite, {0, 0}), kOwn_m), ContactIntake::kNotFinite);
  EXPECT_EQ(ledger.Take(Report("bravo", 0, {0, 1e300}), kOwn_m), ContactIntake::kNotFinite);
  ContactReport turning = Report("bravo", 0, {0, 0});
  turning.motion.heading_deg = nan;
  EXPECT_EQ(ledger.Take(turning, kOwn_m), ContactIntake::kNotFinite);
  ContactReport stale = Report("bravo", 0, {0, 0});
  stale.received_s = 46;
  EXPECT_EQ(ledger.Take(stale, kOwn_m), ContactIntake::kTooOld);
  EXPECT_EQ(ledger.Take(Report("bravo", 0, {2001, 0}), kOwn_m), ContactIntake::kTooFar);
  EXPECT_EQ(ledger.size(), 0U);
  EXPECT_FALSE(IsTaken(ContactIntake::kTooFar));
}

TEST(ContactLedger, KeepsTheNewestOfReportsThatOvertookEachOther) {
  ContactLedger ledger("alpha");
  (void)ledger.Take(Report("bravo", 10, {20, 0}), kOwn_m);
  EXPECT_EQ(ledger.Take(Report("bravo", 9, {18, 0}), kOwn_m), ContactIntake::kOutOfOrder);
  EXPECT_EQ(ledger.At(10, kOwn_m).at("bravo").now.position_m.x(), 20);
}

TEST(ContactLedger, TakesAJumpAndStatesIt) {
  ContactLedger ledger("alpha");
  (void)ledger.Take(Report("bravo", 10, {0, 0}), kOwn_m);
  // 2 m/s for 1 s: up to 3 x 2 m, and 20 m.
  EXPECT_EQ(ledger.Take(Report("bravo", 11, {26, 0}), kOwn_m), ContactIntake::kTaken);
  EXPECT_EQ(ledger.Take(Report("bravo", 12, {53, 0}), kOwn_m), ContactIntake::kJumped);
  EXPECT_EQ(ledger.At(12, kOwn_m).at("bravo").now.position_m.x(), 53);
}

TEST(ContactLedger, ForgetsWhatIsFarAway) {
  ContactLedger ledger("alpha");
  (void)ledger.Take(Report("bravo", 0, {1990, 0}), kOwn_m);
  EXPECT_EQ(ledger.At(1, {-100, 0}).size(), 1U);
  EXPECT_EQ(ledger.At(1, {-120, 0}).size(), 0U);
}

TEST(ContactLedger, DropsTheOldestAndThenTheFarthest) {
  ContactLedger ledger("alpha", {.max_contacts = 3});
  (void)ledger.Take(Report("near", 30, {10, 0}), kOwn_m);
  (void)ledger.Take(Report("far", 30, {500, 0}), kOwn_m);
  (void)ledger.Take(Report("farther", 30, {900, 0}), kOwn_m);
  (void)ledger.Take(Report("old", 1, {1, 0}), kOwn_m);
  EXPECT_FALSE(ledger.At(30, kOwn_m).contains("old"));
  (void)ledger.Take(Report("next", 30, {20, 0}), kOwn_m);
  const Contacts& contacts = ledger.At(30, kOwn_m);
  EXPECT_EQ(contacts.size(), 3U);
  EXPECT_FALSE(contacts.contains("farther"));
}

RC_GTEST_PROP(ContactLedger, ExtrapolatesWithoutJumpsAndNeverBackward, ()) {
  const double age_s = *rc::gen::inRange(0, 6000) / 100.0;
  const double step_s = 0.01;
  const double here_m = ExtrapolatedDistance(2, age_s, {});
  const double next_m = ExtrapolatedDistance(2, age_s + step_s, {});
  RC_ASSERT(next_m >= here_m - 1e-12);
  RC_ASSERT(next_m - here_m <= 2 * step_s + 1e-12);
}

}  // namespace shoal::contact_ledger_test
