#include "lib/sea/modem/micromodem_cst.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/base/text/numbers.h"
#include "lib/base/time/utc_time.h"
#include "lib/sea/modem/sentence_text.h"

namespace shoal {
namespace {

/// Absent for what is no number, else within three digits.
std::optional<double> Sane(std::optional<double> snr_db) {
  if (!snr_db || std::isnan(*snr_db)) return std::nullopt;
  return std::clamp(*snr_db, -99.0, 999.0);
}

std::string SnrText(std::optional<double> snr_db) {
  return ZeroPadded(std::lround(snr_db.value_or(0)), 2);
}

std::string EqualizerErrorText(CstPacketType type, std::optional<double> snr_db) {
  const bool is_psk = type == CstPacketType::kPsk || type == CstPacketType::kFlexible;
  if (!is_psk || !snr_db) return "-1";
  return "-" + FixedText(std::clamp(*snr_db, 0.0, 15.0), 1);
}

}  // namespace

std::string CstText(const ReceptionStatistics& statistics, int modem_version) {
  const std::optional<double> snr_db = Sane(statistics.snr_db);
  std::vector<std::string> fields = {
      modem_version == 1 ? "CACST" : "CACST,6", std::to_string(static_cast<int>(statistics.mode)),
      ClockText(statistics.arrived_utc_us, 4),
      "1",  // Clock mode.
  };
  // Peak, power and ratio of the detector; sound pressure; five gains.
  for (const char* field : {"1440", "25", "0175", "0166", "75", "01", "01", "01", "03"}) {
    fields.emplace_back(field);
  }
  fields.push_back(std::to_string(statistics.rate));
  fields.push_back(ZeroPadded(statistics.source, 3));
  fields.push_back(ZeroPadded(statistics.destination, 3));
  fields.emplace_back("0");  // PSK error.
  fields.push_back(std::to_string(static_cast<int>(statistics.type)));
  fields.push_back(std::to_string(statistics.num_frames));
  fields.push_back(std::to_string(statistics.num_bad_frames));
  fields.emplace_back("146");  // Received level.
  fields.push_back(SnrText(snr_db));
  fields.push_back(SnrText(snr_db));
  fields.emplace_back("10");  // Symbol SNR.
  fields.push_back(EqualizerErrorText(statistics.type, snr_db));
  // Data quality, Doppler, noise, carrier, bandwidth.
  for (const char* field : {"000", "0.0", "45", "10000", "2000"}) fields.emplace_back(field);
  return JoinFields(fields);
}

}  // namespace shoal
