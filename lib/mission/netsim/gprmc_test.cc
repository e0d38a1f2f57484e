#include "lib/mission/netsim/gprmc.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>

#include "lib/base/codec/nmea_sentence.h"
#include "lib/mission/netsim/netsim_testing.h"
#include "tests/golden/read_golden.h"

namespace shoal::gprmc_test {

/// The time that a recorded sentence was made at, from its own fields.
int64_t UnixTime_us(const std::string& sentence) {
  const auto parsed = ParseNmea(sentence);
  EXPECT_TRUE(parsed);
  const std::string& time = parsed->fields.at(0);
  const std::string& date = parsed->fields.at(8);
  const auto number = [](const std::string& text, size_t begin, size_t size) {
    return std::stoi(text.substr(begin, size));
  };
  const std::chrono::year_month_day day(
      std::chrono::year(2000 + number(date, 4, 2)),
      std::chrono::month(static_cast<unsigned>(number(date, 2, 2))),
      std::chrono::day(static_cast<unsigned>(number(date, 0, 2))));
  const int64_t num_days = std::chrono::sys_days(day).time_since_epoch().count();
  const int64_t seconds =
      (num_days * 24 + number(time, 0, 2)) * 3600 + number(time, 2, 2) * 60 + number(time, 4, 2);
  return seconds * 1'000'000 + number(time, 7, 6);
}

NetsimNav NavOf(const nlohmann::json& given) {
  NetsimNav nav = AliceNav();
  nav.lat_deg = given.value("lat", nav.lat_deg);
  nav.lon_deg = given.value("lon", nav.lon_deg);
  nav.speed_mps = given.value("speed", nav.speed_mps);
  nav.heading_deg = given.value("heading", nav.heading_deg);
  return nav;
}

TEST(GprmcSentence, IsThatOfTheOriginal) {
  int num_compared = 0;
  const nlohmann::json golden = ReadGoldenJson("netsim/gps.json");
  for (const auto& recorded : golden["cases"]) {
    if (recorded["nav"].contains("lat") && recorded["nav"]["lat"].is_string()) continue;  // NaN.
    for (const char* port : {"gps_62000", "gps_62002"}) {
      const std::string sentence = recorded[port];
      if (sentence.empty()) continue;
      EXPECT_EQ(GprmcSentence(NavOf(recorded["nav"]), UnixTime_us(sentence)), sentence);
      ++num_compared;
    }
  }
  EXPECT_EQ(num_compared, 7);
}

TEST(GprmcSentence, CountsTheTimeFrom1970) {
  EXPECT_EQ(GprmcSentence(AliceNav(), 0).substr(0, 20), "$GPRMC,000000.000000");
  EXPECT_NE(GprmcSentence(AliceNav(), 0).find(",010170,"), std::string::npos);
  EXPECT_EQ(GprmcSentence(AliceNav(), 86'399'999'999).substr(0, 20), "$GPRMC,235959.999999");
}

TEST(GprmcSentence, StaysShortForAbsurdNumbers) {
  NetsimNav nav = AliceNav();
  nav.speed_mps = 1e308;
  nav.heading_deg = -1e308;
  const std::string sentence = GprmcSentence(nav, 0);
  EXPECT_NE(sentence.find(",99999.9,-99999.9,"), std::string::npos) << sentence;
}

RC_GTEST_PROP(GprmcSentence, GivesThePlaceToAFewDecimetres, ()) {
  NetsimNav nav = AliceNav();
  nav.lat_deg = *rc::gen::inRange(-90'000'000, 90'000'001) / 1e6;
  nav.lon_deg = *rc::gen::inRange(-360'000'000, 360'000'001) / 1e6;
  const auto sentence = ParseNmea(GprmcSentence(nav, 0));
  RC_ASSERT(sentence && sentence->fields.size() == 11U);
  const auto degrees = [&](size_t field, size_t num_degree_digits, const char* negative) {
    const std::string& text = sentence->fields[field];
    const double minutes = std::stod(text.substr(num_degree_digits));
    RC_ASSERT(minutes < 60);
    const double value = std::stod(text.substr(0, num_degree_digits)) + minutes / 60;
    return sentence->fields[field + 1] == negative ? -value : value;
  };
  RC_ASSERT(std::abs(degrees(2, 2, "S") - nav.lat_deg) < 2e-6);
  RC_ASSERT(std::abs(degrees(4, 3, "W") - nav.lon_deg) < 2e-6);
}

}  // namespace shoal::gprmc_test
