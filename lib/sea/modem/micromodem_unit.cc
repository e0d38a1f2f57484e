#include "lib/sea/modem/micromodem_unit.h"

#include <algorithm>

#include "lib/base/check/check.h"
#include "lib/base/codec/nmea_sentence.h"
#include "lib/base/time/utc_time.h"
#include "lib/sea/modem/micromodem_rate.h"

namespace shoal {

namespace {

constexpr int64_t kYear2200_us = 7'258'118'400'000'000;

}  // namespace

MicroModemUnit::MicroModemUnit(const MicroModemOptions& initial) : options(initial) {
  SHOAL_CHECK(options.address >= 0 && options.address <= kMaxMicroModemAddress,
              "options.address is 0 to kMaxMicroModemAddress");
  SHOAL_CHECK(options.version == 1 || options.version == 2, "options.version is 1 or 2");
  settings.src = options.address;
  SetClock(options.utc_at_zero_us, 0);
}

void MicroModemUnit::SetClock(int64_t utc_us, int64_t time_us) {
  clock_offset_us = std::clamp<int64_t>(utc_us, 0, kYear2200_us) - time_us;
}

void MicroModemUnit::Write(std::string_view body) { output.to_host += NmeaSentence(body); }

void MicroModemUnit::WriteError(std::string_view module, MicroModemError code,
                                std::string_view reason) {
  Write("CAERR," + ClockText(Utc_us()) + "," + std::string(module) + "," +
        std::to_string(static_cast<int>(code)) + "," + std::string(reason));
}

void MicroModemUnit::WriteRevision() {
  const std::string_view firmware = options.version == 1 ? "0.94.0.00" : "2.0.17047";
  if (settings.rev == 0) return;
  for (const char* part : {"INIT", "AUV"}) {
    Write("CAREV," + ClockText(Utc_us()) + "," + part + "," + std::string(firmware));
  }
}

void MicroModemUnit::WriteStatistics(const ReceptionStatistics& statistics) {
  if (settings.cst == 1) Write(CstText(statistics, options.version));
}

}  // namespace shoal
