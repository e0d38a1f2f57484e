#include "lib/sea/acoustics/acoustic_statistics.h"

#include <string_view>

#include "lib/sea/acoustics/number_text.h"

namespace shoal {

namespace {

constexpr size_t kNameWidth = 24;
constexpr size_t kCountWidth = 10;

void AddLine(std::string_view name, int64_t count, int64_t whole, std::string* text) {
  const std::string digits = std::to_string(count);
  *text += name;
  text->append(name.size() < kNameWidth ? kNameWidth - name.size() : 1, ' ');
  text->append(digits.size() < kCountWidth ? kCountWidth - digits.size() : 0, ' ');
  *text += digits;
  if (whole > 0) {
    *text +=
        "  " + RoundedText(100 * static_cast<double>(count) / static_cast<double>(whole)) + " %";
  }
  *text += '\n';
}

}  // namespace

std::string_view AcousticFateText(AcousticFate fate) {
  static constexpr EnumTable<AcousticFate, std::string_view> kTexts = {
      "not_listening", "no_path",     "shadow_zone",          "half_duplex",
      "collision",     "packet_loss", "damaged_by_collision", "damaged_by_bit_errors",
      "delivered"};
  return kTexts[fate];
}

int64_t AcousticStatistics::NumHandedOver() const {
  return NumOf(AcousticFate::kDamagedByCollision) + NumOf(AcousticFate::kDamagedByBitErrors) +
         NumOf(AcousticFate::kDelivered);
}

std::string StatisticsText(const AcousticStatistics& statistics) {
  const int64_t to_listeners =
      statistics.num_offered - statistics.NumOf(AcousticFate::kNotListening);
  std::string text;
  AddLine("transmissions", statistics.num_transmissions, 0, &text);
  AddLine("offered to listeners", to_listeners, 0, &text);
  for (size_t i = 0; i < kNumAcousticFates; ++i) {
    const auto fate = static_cast<AcousticFate>(i);
    // Seas in which sound does not bend have no shadows.
    if (fate == AcousticFate::kShadowZone && statistics.NumOf(fate) == 0) continue;
    const bool counts = fate != AcousticFate::kNotListening;
    AddLine(AcousticFateText(fate), statistics.NumOf(fate), counts ? to_listeners : 0, &text);
  }
  AddLine("in transit", statistics.num_in_transit, to_listeners, &text);
  AddLine("overlapped by others", statistics.num_collided, to_listeners, &text);
  AddLine("with bits flipped", statistics.num_bit_errors, to_listeners, &text);
  AddLine("bits flipped", statistics.num_bits_flipped, 0, &text);
  AddLine("rejected by receivers", statistics.num_rejected, statistics.NumHandedOver(), &text);
  return text;
}

}  // namespace shoal
