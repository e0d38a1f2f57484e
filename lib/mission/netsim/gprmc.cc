#include "lib/mission/netsim/gprmc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/base/check/check.h"
#include "lib/base/codec/nmea_sentence.h"
#include "lib/base/time/utc_time.h"

namespace shoal {

namespace {

constexpr double kKnotsPerMps = 1.94384;  // As netsim rounds it.
constexpr double kMax = 99'999.9;
constexpr double kTenThousandths = 1e4;

/// "4130.0000,N": whole degrees, then minutes.
std::string Coordinate(double value_deg, int num_degree_digits, char positive, char negative) {
  SHOAL_CHECK(std::abs(value_deg) < 1000, "latitude and longitude are below 1000 degrees");
  const double whole_deg = std::floor(std::abs(value_deg));
  const double minutes = (std::abs(value_deg) - whole_deg) * 60;
  const double cut_minutes = std::floor(minutes * kTenThousandths) / kTenThousandths;
  return fmt::format("{:0{}.0f}{:07.4f},{}", whole_deg, num_degree_digits, cut_minutes,
                     value_deg < 0 ? negative : positive);
}

/// NaN does not come here.
double Bounded(double value) { return std::clamp(value, -kMax, kMax); }

}  // namespace

std::string GprmcSentence(const NetsimNav& nav, int64_t unix_us) {
  const CalendarTime time = ToCalendar(unix_us);
  return NmeaSentence(fmt::format(
      "GPRMC,{:02}{:02}{:02}.{:06},A,{},{},{:.1f},{:.1f},{:02}{:02}{:02},000.0,E", time.hour,
      time.minute, time.second, time.microsecond, Coordinate(nav.lat_deg, 2, 'N', 'S'),
      Coordinate(nav.lon_deg, 3, 'E', 'W'), Bounded(nav.speed_mps * kKnotsPerMps),
      Bounded(nav.heading_deg), time.day, time.month, time.year % 100));
}

}  // namespace shoal
