#include "apps/shoal/host_doctor.h"

#include <gtest/gtest.h>

namespace shoal::host_doctor_test {

TEST(HostDoctor, FindsTheOffsetOfAClockWhoseWaysAreAlike) {
  // 20 ms there, 20 ms back; the host's clock is 3 s ahead.
  EXPECT_EQ(ClockOffset_us(1'000'000, 4'020'000, 1'040'000), 3'000'000);
  EXPECT_EQ(ClockOffset_us(4'000'000, 1'020'000, 4'040'000), -3'000'000);
}

HostFacts Facts(int64_t round_trip_us) {
  HostFacts facts{.load_bytes = 32 << 20, .load_us = 1'000'000};
  for (int i = 0; i < 100; ++i) {
    facts.round_trips_us.push_back(round_trip_us + i);
    facts.offsets_us.push_back(i == 0 ? 200'000 : 0);
  }
  return facts;
}

TEST(HostDoctor, NamesTheWarpThatTheRoundTripAllows) {
  const auto diagnoses = DiagnoseHost(Facts(20'000), 0.1);
  ASSERT_EQ(diagnoses.size(), 4U);
  EXPECT_EQ(diagnoses[0].text, "round trip: 20.00 ms at least, 20.05 ms (median), 20.10 ms (99 %)");
  EXPECT_EQ(diagnoses[1].health, Health::kOk);
  EXPECT_NE(diagnoses[1].text.find("allows 5.0 at steps of 0.1 s"), std::string::npos);
  EXPECT_NE(diagnoses[3].text.find("67.1 MB/s"), std::string::npos) << diagnoses[3].text;
}

TEST(HostDoctor, WarnsWhereTheWayIsTooLongForRealTime) {
  EXPECT_EQ(DiagnoseHost(Facts(200'000), 0.1)[1].health, Health::kWarn);
}

TEST(HostDoctor, TakesTheOffsetOfTheShortestWay) {
  const auto diagnoses = DiagnoseHost(Facts(1'000), 0.1);
  EXPECT_EQ(diagnoses[2].health, Health::kWarn);
  EXPECT_NE(diagnoses[2].text.find("200.00 ms ahead (within 0.50 ms)"), std::string::npos)
      << diagnoses[2].text;
}

}  // namespace shoal::host_doctor_test
