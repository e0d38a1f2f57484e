#include "lib/sea/modem/micromodem_cst.h"

#include <gtest/gtest.h>

#include <limits>

#include "lib/base/time/utc_time.h"
#include "lib/sea/modem/two_modems.h"

namespace shoal::micromodem_cst_test {

TEST(CstText, HasTheFieldsOfVersion0) {
  const std::string text =
      CstText({.mode = CstMode::kBadCrc,
               .arrived_utc_us = *ToUtc({.hour = 2, .minute = 25, .second = 53}) + 492'599,
               .rate = 2,
               .source = 1,
               .destination = 102,
               .type = CstPacketType::kPsk,
               .num_frames = 3,
               .num_bad_frames = 1,
               .snr_db = 11.6});
  EXPECT_EQ(text,
            "CACST,1,022553.4925,1,1440,25,0175,0166,75,01,01,01,03,2,001,102,0,3,3,1,146,12,12,"
            "10,-11.6,000,0.0,45,10000,2000");
  EXPECT_EQ(FieldsOf(text).size(), 30U) << "29 and the name";
}

TEST(CstText, IsAsLongWhateverTheSignalToNoiseRatioIs) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<std::optional<double>, const char*> ratios[] = {
      {{}, "00"}, {nan, "00"}, {infinity, "999"}, {-infinity, "-99"}, {-3.2, "-3"}, {1e300, "999"}};
  for (const auto& [snr_db, text] : ratios) {
    const auto fields = FieldsOf(CstText({.type = CstPacketType::kPsk, .snr_db = snr_db}));
    ASSERT_EQ(fields.size(), 30U);
    EXPECT_EQ(fields[21], text);
    EXPECT_EQ(fields[22], text);
  }
}

}  // namespace shoal::micromodem_cst_test
