// How much a Micro-Modem's packet holds and how fast it goes, by rate.
#pragma once

#include <array>

namespace shoal {

struct MicroModemRate {
  int max_frames = 0;
  int max_frame_bytes = 0;
  int bps = 0;  ///< Nominal.
};

/// By the number that CCCYC gives. 0 is frequency-hopping FSK, the others are phase-shift keying.
/// Source of the speeds: the header of WHOI's umodemd.
inline constexpr std::array<MicroModemRate, 6> kMicroModemRates = {{
    {.max_frames = 1, .max_frame_bytes = 32, .bps = 80},
    {.max_frames = 3, .max_frame_bytes = 64, .bps = 250},
    {.max_frames = 3, .max_frame_bytes = 64, .bps = 500},
    {.max_frames = 2, .max_frame_bytes = 256, .bps = 1200},
    {.max_frames = 2, .max_frame_bytes = 256, .bps = 1300},
    {.max_frames = 8, .max_frame_bytes = 256, .bps = 5300},
}};

inline constexpr int kMaxFlexibleBytes = 100;  ///< Of CCTDP.
inline constexpr int kMaxMicroModemFrames = 8;
inline constexpr int kMaxMicroModemFrameBytes = 256;
inline constexpr int kMaxMicroModemAddress = 127;
inline constexpr int kMicroModemBroadcast = 0;  ///< The address of all.
inline constexpr int kMaxMiniPacket = 0x1FFF;   ///< 13 bits.

}  // namespace shoal
