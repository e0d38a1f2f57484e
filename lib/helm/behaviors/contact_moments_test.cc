#include "lib/helm/behaviors/contact_moments.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shoal::contact_moments_test {

/// Returns which variables are set, in order, while own vessel goes by a contact that rests or
/// moves; one step a second.
std::vector<std::string> Set(const std::vector<std::string>& flags, VesselMotion own,
                             VesselMotion contact, int seconds) {
  const auto parsed = ParseMomentFlags(flags);
  EXPECT_TRUE(parsed.ok()) << parsed.error();
  ContactMoments moments;
  std::vector<std::string> set;
  for (int i = 0; i < seconds; ++i) {
    for (const Flag* flag : moments.Update(own, contact, *parsed)) set.push_back(flag->variable());
    own.position_m += VelocityOf(own);
    contact.position_m += VelocityOf(contact);
  }
  return set;
}

using Names = std::vector<std::string>;

TEST(ContactMoments, ComeInTheOrderOfAnOvertaking) {
  const VesselMotion own = {.position_m = {10, -100.5}, .heading_deg = 0, .speed_mps = 4};
  const VesselMotion contact = {.position_m = {0, 0}, .heading_deg = 0, .speed_mps = 2};
  EXPECT_EQ(Set({"@>40 FAR = 1", "@os_passes_cn PASSES = 1", "@os_passes_cn_star STAR = 1",
                 "@os_passes_cn_port PORT = 1", "@cpa CPA = 1", "@<30 NEAR = 1"},
                own, contact, 100),
            (Names{"NEAR", "PASSES", "STAR", "CPA", "FAR"}));
}

TEST(ContactMoments, KnowCrossingAheadFromAstern) {
  const VesselMotion contact = {.position_m = {0, 0}, .heading_deg = 0, .speed_mps = 0};
  const Names flags = {"@os_crosses_cn CROSSES = 1", "@os_crosses_cn_bow BOW = 1",
                       "@os_crosses_cn_stern STERN = 1"};
  EXPECT_EQ(Set(flags, {.position_m = {-20.5, 30}, .heading_deg = 90, .speed_mps = 2}, contact, 30),
            (Names{"CROSSES", "BOW"}));
  EXPECT_EQ(
      Set(flags, {.position_m = {-20.5, -30}, .heading_deg = 90, .speed_mps = 2}, contact, 30),
      (Names{"CROSSES", "STERN"}));
}

TEST(ContactMoments, LookFromTheContactToo) {
  const VesselMotion own = {.position_m = {0, 0}, .heading_deg = 0, .speed_mps = 0};
  EXPECT_EQ(Set({"@cn_crosses_os CROSSES = 1", "@cn_crosses_os_bow BOW = 1"}, own,
                {.position_m = {-20.5, 30}, .heading_deg = 90, .speed_mps = 2}, 30),
            (Names{"CROSSES", "BOW"}));
  EXPECT_EQ(Set({"@cn_passes_os PASSES = 1", "@cn_passes_os_port PORT = 1"}, own,
                {.position_m = {-20, -30.5}, .heading_deg = 0, .speed_mps = 2}, 30),
            (Names{"PASSES", "PORT"}));
}

TEST(ContactMoments, AreNoneInTheFirstIterationAndAfterAGap) {
  const auto flags = ParseMomentFlags({"@<30 NEAR = 1"});
  const VesselMotion own = {};
  ContactMoments moments;
  EXPECT_TRUE(moments.Update(own, {.position_m = {20, 0}}, *flags).empty());
  EXPECT_TRUE(moments.Update(own, {.position_m = {50, 0}}, *flags).empty());
  moments.Forget();
  EXPECT_TRUE(moments.Update(own, {.position_m = {20, 0}}, *flags).empty());
}

TEST(MomentFlags, StateWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"PASSED = true", "write it as @MOMENT VARIABLE = value"},
      {"@cpa", "write it as @MOMENT VARIABLE = value"},
      {"@soon PASSED = true", "unknown moment 'soon'"},
      {"@<near PASSED = true", "is a number, like @<50"},
      {"@cpa PASSED", "write it as VARIABLE = value"}};
  for (const auto& [text, expected] : cases) {
    const auto flags = ParseMomentFlags({text});
    ASSERT_FALSE(flags.ok()) << text;
    EXPECT_NE(flags.error().find(expected), std::string::npos) << flags.error();
  }
}

}  // namespace shoal::contact_moments_test
