// Settings of the acoustic network, with muNet's defaults. Its names for them stand in brackets.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/base/check/enum_table.h"
#include "lib/sea/acoustics/modem_preset.h"
#include "lib/sea/acoustics/ray_channel_options.h"

namespace shoal {

/// Which nodes send and receive on which channels.
enum class AccessMode : uint8_t {
  kShared,  ///< One channel for all.
  kTdma,    ///< One channel that takes the whole band; the senders share time by themselves.
  kTdmaLf,  ///< Leaders send on the broadcast channel, all others on the one for responses; each
            ///< side receives the other.
  kFdma,    ///< A channel for each sender; every node receives all others.
};

/// How the band is cut into channels.
enum class ChannelOrder : uint8_t {
  kCenterOut,  ///< From the base frequency outwards, above and below in turn.
  kEdgeIn,     ///< From the lowest frequency upwards.
};

enum class JitterModel : uint8_t {
  kUniform,  ///< Between 0 and `max_jitter_s`.
  kOff,
};

/// What becomes of packets that overlap at a receiver on one channel.
enum class CollisionModel : uint8_t {
  kDrop,     ///< All of them are lost.
  kCorrupt,  ///< Each arrives, XORed with the others where they overlap.
  kOff,      ///< Nothing.
};

/// lib/sea/acoustics/loss_models.h has the formulas.
/// kModem: from the signal-to-noise ratio at the receiver, by AcousticOptions::modem and ::sea.
enum class PacketLossModel : uint8_t { kUniform, kExpSimple, kSonarSimple, kOff, kModem };
enum class BitErrorModel : uint8_t { kPoisson, kExpSimple, kSnr, kOff, kModem };

struct AcousticOptions {
  AccessMode access_mode = AccessMode::kFdma;                         ///< [accessMode]
  ChannelOrder channel_order = ChannelOrder::kCenterOut;              ///< [orderMode]
  JitterModel jitter = JitterModel::kUniform;                         ///< [jitterType]
  CollisionModel collisions = CollisionModel::kDrop;                  ///< [collType]
  PacketLossModel packet_loss_model = PacketLossModel::kSonarSimple;  ///< [plrType]
  BitErrorModel bit_error_model = BitErrorModel::kPoisson;            ///< [berType]
  bool half_duplex = false;  ///< True: a node does not receive while it sends.

  double sound_speed_mps = 1500;     ///< [C_WATER]
  double base_freq_khz = 24;         ///< The middle of the band. [BASE_FREQ]
  double bandwidth_khz = 10;         ///< Of the band. [BANDWIDTH]
  double guard_band_khz = 0.25;      ///< Between channels, and at the band's edges. [GUARD_BW]
  double channel_bandwidth_khz = 1;  ///< [CHAN_MINBW]
  int broadcast_address = 255;       ///< Id of the broadcast channel. [BCAST_ADDR]
  double data_rate_bps = 1000;       ///< Of every channel, whatever its width. [DATA_RATE]
  double max_jitter_s = 0.2;         ///< [MAX_JITTER]

  double nominal_distance_m = 1000;  ///< Where loss and errors have their nominal value. [NOM_DIST]
  double packet_loss = 0.02;         ///< Probability, at the nominal distance. [PLR]
  double packet_loss_distance_m = 2000;  ///< Grows e-fold over this distance. [PLR_CHARDIST]
  double bit_error_rate = 1e-3;          ///< Probability, at the nominal distance. [BER]
  double bit_error_distance_m = 3000;    ///< Grows e-fold over this distance. [BER_CHARDIST]
  double snr_nominal_db = 30;  ///< At the nominal distance. Cancels out of the model. [SNR_NOMINAL]
  double snr_slope = 0.1;      ///< Decades of bit error rate per decibel. [SNR_SLOPE]

  std::optional<ModemPreset> modem = std::nullopt;  ///< Present where a model is kModem.
  Sea sea = {};                                     ///< Between the modems.
  /// Sound bends: levels and travel times come from rays, and need the modem. Absent: sound travels
  /// straight at sound_speed_mps, and levels fall by Sea::spreading_exponent.
  std::optional<RayChannelOptions> rays = std::nullopt;

  bool operator==(const AcousticOptions&) const = default;
};

/// What mission files write for each choice, by its number.
template <class Choice>
using ChoiceTable = EnumTable<Choice, std::string_view>;
template <class Choice>
inline constexpr ChoiceTable<Choice> kChoiceTexts = {};
template <>
inline constexpr ChoiceTable<AccessMode> kChoiceTexts<AccessMode> = {"shared", "tdma", "tdma_lf",
                                                                     "fdma"};
template <>
inline constexpr ChoiceTable<ChannelOrder> kChoiceTexts<ChannelOrder> = {"center_out", "edge_in"};
template <>
inline constexpr ChoiceTable<JitterModel> kChoiceTexts<JitterModel> = {"uniform", "off"};
template <>
inline constexpr ChoiceTable<CollisionModel> kChoiceTexts<CollisionModel> = {"drop", "corrupt",
                                                                             "off"};
template <>
inline constexpr ChoiceTable<PacketLossModel> kChoiceTexts<PacketLossModel> = {
    "uniform", "exp_simple", "sonar_simple", "off", "modem"};
template <>
inline constexpr ChoiceTable<BitErrorModel> kChoiceTexts<BitErrorModel> = {"poisson", "exp_simple",
                                                                           "snr", "off", "modem"};

/// Returns what mission files write for this choice.
template <class Choice>
constexpr std::string_view ChoiceText(Choice choice) {
  return kChoiceTexts<Choice>[choice];
}

/// Returns the choice that is written so; capitals matter.
template <class Choice>
constexpr std::optional<Choice> FindChoice(std::string_view text) {
  return kChoiceTexts<Choice>.Find(text);
}

}  // namespace shoal
