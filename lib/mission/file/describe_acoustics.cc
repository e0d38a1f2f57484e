// The table [acoustics].
#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/file/describe.h"
#include "lib/mission/file/find_modem.h"
#include "lib/mission/file/load_modem.h"
#include "lib/sea/acoustics/propagation.h"
#include "lib/sea/acoustics/validate_options.h"

namespace shoal {
namespace {

/// What muNet calls these keys.
constexpr std::pair<std::string_view, std::string_view> kMunetNames[] = {
    {"access_mode", "accessMode"},
    {"channel_order", "orderMode"},
    {"jitter", "jitterType"},
    {"collisions", "collType"},
    {"packet_loss_model", "plrType"},
    {"bit_error_model", "berType"},
    {"sound_speed_mps", "C_WATER"},
    {"base_freq_khz", "BASE_FREQ"},
    {"bandwidth_khz", "BANDWIDTH"},
    {"guard_band_khz", "GUARD_BW"},
    {"channel_bandwidth_khz", "CHAN_MINBW"},
    {"broadcast_address", "BCAST_ADDR"},
    {"data_rate_bps", "DATA_RATE"},
    {"max_jitter_s", "MAX_JITTER"},
    {"nominal_distance_m", "NOM_DIST"},
    {"packet_loss", "PLR"},
    {"packet_loss_distance_m", "PLR_CHARDIST"},
    {"bit_error_rate", "BER"},
    {"bit_error_distance_m", "BER_CHARDIST"},
    {"snr_nominal_db", "SNR_NOMINAL"},
    {"snr_slope", "SNR_SLOPE"},
};

/// One of kChoiceTexts.
template <class E>
void DescribeWord(Fields& fields, std::string_view key, E& choice) {
  std::string word(ChoiceText(choice));
  fields.Word(key, word, kChoiceTexts<E>);
  choice = FindChoice<E>(word).value_or(choice);
}

void Describe(Fields& fields, Sea& sea) {
  fields.Number("temperature_degc", sea.water.temperature_degc,
                Between(kMinTemperature_degc, kMaxTemperature_degc));
  fields.Number("salinity_ppt", sea.water.salinity_ppt,
                Between(kMinSalinity_ppt, kMaxSalinity_ppt));
  fields.Number("depth_m", sea.water.depth_m, Between(0, kMaxDepth_m));
  fields.Number("ph", sea.water.ph, Between(kMinPh, kMaxPh));
  fields.Number("shipping", sea.noise.shipping, Between(0, 1));
  fields.Number("wind_mps", sea.noise.wind_mps, Between(0, kMaxWind_mps));
  fields.Choice("absorption", sea.absorption, kAbsorptionModels);
  fields.Number("spreading_exponent", sea.spreading_exponent,
                Between(kMinSpreadingExponent, kMaxSpreadingExponent));
}

/// A name, or a table with the keys of a modem's file.
void DescribeModem(Fields& fields, std::optional<ModemPreset>& modem,
                   const std::optional<std::string>& folder, std::string_view default_modem) {
  if (!fields.Has("modem", modem.has_value())) {
    const bool has_models =
        fields.Has("packet_loss_model", true) || fields.Has("bit_error_model", true);
    if (!fields.reading() || default_modem.empty() || has_models) return;
    NamedModem named = FindModem(default_modem, "");
    for (const std::string& problem : named.problems) fields.Refuse("", problem);
    if (named.problems.empty()) modem = std::move(named.modem);
    return;
  }
  if (!modem) modem.emplace();
  if (!folder || !fields.HoldsText("modem")) {
    fields.Below("modem", [&](Fields& table) { Describe(table, *modem); });
    return;
  }
  std::string name;
  fields.Text("modem", name, {.max_length = 1000});
  if (!fields.IsSound()) return;
  NamedModem named = FindModem(name, *folder);
  for (const std::string& problem : named.problems) fields.Refuse("modem", problem);
  *modem = std::move(named.modem);
}

/// What a network of modems is unless the file has its own values: one channel as wide as the
/// modem's band, its loss by the modem's signal-to-noise ratio.
void SetDefaults(const ModemPreset& modem, AcousticOptions& options) {
  options.access_mode = AccessMode::kShared;
  options.packet_loss_model = PacketLossModel::kModem;
  options.bit_error_model = BitErrorModel::kOff;
  options.half_duplex = true;
  options.base_freq_khz = (modem.low_khz + modem.high_khz) / 2;
  options.bandwidth_khz = modem.high_khz - modem.low_khz;
  options.guard_band_khz = 0;
  options.data_rate_bps = modem.data_rate_bps;
}

/// The sound speed that the sea has, unless the file names one.
void SetSoundSpeed(Fields& fields, AcousticOptions& options) {
  const std::optional<double> speed_mps = SoundSpeed(options.sea.water);
  if (speed_mps) {
    options.sound_speed_mps = *speed_mps;
  } else if (!fields.Has("sound_speed_mps", true)) {
    fields.Refuse("sea",
                  fmt::format("no sound speed is known for water of {} ppt, since Mackenzie's "
                              "equation begins at {}: write sound_speed_mps = 1450, or "
                              "the measured speed, in [acoustics]",
                              options.sea.water.salinity_ppt, kMinSalinityForSoundSpeed_ppt));
  }
}

/// Where sound bends, what needs one speed for all takes the mean of the water column.
void SetMeanSpeed(const Fields& fields, AcousticOptions& options) {
  if (!fields.reading() || !options.rays) return;
  const Result<SoundProfile> profile = SoundProfile::Make(options.rays->profile);
  if (!profile.ok()) return;
  options.sound_speed_mps = profile->MeanSpeed(0, options.rays->bottom_depth_m);
}

}  // namespace

void Describe(Fields& fields, Acoustics& acoustics, const std::optional<std::string>& folder,
              std::string_view default_modem) {
  AcousticOptions& options = acoustics.options;
  for (const auto& [key, munet_name] : kMunetNames) fields.CalledElsewhere(key, munet_name);
  DescribeModem(fields, options.modem, folder, default_modem);
  const bool has_sea = fields.Has("sea", true);
  fields.Below("sea", [&](Fields& sea) { Describe(sea, options.sea); });
  if (fields.reading() && options.modem) SetDefaults(*options.modem, options);
  if (fields.reading() && (options.modem || has_sea)) SetSoundSpeed(fields, options);
  if (fields.Has("channel", options.rays.has_value())) {
    fields.Below("channel", [&](Fields& channel) {
      Describe(channel, options.rays, options.sea.noise.wind_mps, folder);
    });
    SetMeanSpeed(fields, options);
  }
  fields.Flag("crc", acoustics.crc);
  fields.Flag("queue", acoustics.queue);
  fields.Integer("queue_length", acoustics.queue_length, 1, 10'000);
  constexpr std::array<std::string_view, 2> kQueueDrops = {"oldest", "newest"};
  std::string drop(kQueueDrops[static_cast<size_t>(acoustics.queue_drop)]);
  fields.Word("queue_drop", drop, kQueueDrops);
  acoustics.queue_drop =
      drop == kQueueDrops[1] ? Acoustics::QueueDrop::kNewest : Acoustics::QueueDrop::kOldest;
  DescribeWord(fields, "access_mode", options.access_mode);
  DescribeWord(fields, "channel_order", options.channel_order);
  DescribeWord(fields, "jitter", options.jitter);
  DescribeWord(fields, "collisions", options.collisions);
  DescribeWord(fields, "packet_loss_model", options.packet_loss_model);
  DescribeWord(fields, "bit_error_model", options.bit_error_model);
  fields.Flag("half_duplex", options.half_duplex);
  fields.SmallInteger("broadcast_address", options.broadcast_address, 0, kMaxBroadcastAddress);
  for (const OptionRange& range : OptionRanges()) {
    if (fields.reading() && options.modem && range.option == "channel_bandwidth_khz") {
      options.channel_bandwidth_khz = options.bandwidth_khz;
    }
    fields.Number(range.option, options.*range.value,
                  {range.low, range.high, !range.low_is_allowed});
  }
}

}  // namespace shoal
